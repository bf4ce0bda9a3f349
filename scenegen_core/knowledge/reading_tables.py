"""Reads tables of a choice that people have edited; says what is wrong with them, and where."""

from __future__ import annotations

import csv
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from math import isfinite
from pathlib import Path

import numpy as np

from scenegen_core.errors import KnowledgeError
from scenegen_core.graph.relations import Column
from scenegen_core.knowledge.choice import BINS, MISSING, Choice
from scenegen_core.knowledge.knowledge import Knowledge
from scenegen_core.knowledge.writing_tables import (
    CURVES,
    HEADS,
    NAMES,
    NONE,
    STRETCH,
    SURFACES,
    file_stem,
    limits_of,
    named,
)
from scenegen_core.scene.geometry import Floats

SAME = 1e-3  # of any unit; edges lie further apart, and spreadsheets round
MOST = 1000.0  # nats; so much settles any choice


def read_tables(knowledge: Knowledge, folder: Path) -> Knowledge:
    """The knowledge with the tables of a folder in place of its own.

    A category without a file keeps its table. KnowledgeError names file and line of what is wrong.
    """
    readers = {
        f"{file_stem(name)}-{kind}.csv": (name, read)
        for name in knowledge.choices
        for kind, read in ((CURVES, _with_curves), (SURFACES, _with_surfaces))
    }
    choices = dict(knowledge.choices)
    for path in _files(folder, readers):
        name, read = readers[path.name]
        choices[name] = read(choices[name], path)
    return replace(knowledge, choices=choices, made_with=f"{knowledge.made_with}; tables edited")


def _files(folder: Path, known: Iterable[str]) -> list[Path]:
    """The tables in a folder, all of which must be known."""
    found = sorted(folder.glob("*.csv"))
    if not known:
        raise KnowledgeError(
            "This knowledge has no curves that tables could replace; learn it again without "
            "--without-choices."
        )
    if not found:
        raise KnowledgeError(
            f"There are no tables in {folder}; write some with: "
            "scenegen inspect knowledge.npz --out DIR --tables, and give DIR/tables."
        )
    for path in found:
        if path.name not in known:
            raise KnowledgeError(
                f"{path} is no table of this knowledge; rename it to one of "
                f"{', '.join(known)}, or take it out of the folder."
            )
    return found


@dataclass(frozen=True, slots=True)
class _Row:
    """A row of a file, to be read and to be complained about."""

    path: Path
    line: int
    cells: dict[str, str]

    def wrong(self, what: str) -> KnowledgeError:
        return KnowledgeError(f"{self.path}, line {self.line}: {what}")


def _with_curves(choice: Choice, path: Path) -> Choice:
    curves = np.zeros((len(choice.columns), BINS), dtype=np.float32)
    for (place,), filling in _filled(choice, path, CURVES).items():
        curves[place] = filling
    return replace(choice, curves=curves)


def _with_surfaces(choice: Choice, path: Path) -> Choice:
    found = _filled(choice, path, SURFACES)
    return replace(
        choice,
        pairs=np.array(list(found), dtype=np.int64).reshape(-1, 2),
        surfaces=np.array(list(found.values()), dtype=np.float32).reshape(-1, BINS, BINS),
    )


def _filled(choice: Choice, path: Path, kind: str) -> dict[tuple[int, ...], Floats]:
    """Every curve or surface that a file names, by the columns that it is of."""
    places = {
        (NAMES[column.relation], column.group, column.part): i
        for i, column in enumerate(choice.columns)
    }
    ends = ("", " 2") if kind == SURFACES else ("",)
    tables: dict[tuple[int, ...], Floats] = {}
    first: dict[tuple[int, ...], _Row] = {}
    for row in _rows(path, HEADS[kind]):
        about = tuple(_place(row, places, end) for end in ends)
        if len(set(about)) < len(ends):
            raise row.wrong("a surface is of two columns; name another one on the right.")
        where = tuple(_stretch(row, choice.columns[i], e) for i, e in zip(about, ends, strict=True))
        table = tables.setdefault(about, np.full((BINS,) * len(ends), np.nan))
        first.setdefault(about, row)
        if not np.isnan(table[where]).all():
            raise row.wrong("an earlier row says what this adds already; take one of them out.")
        table[where] = _nats(row)
    for about, table in tables.items():
        _check_whole(first[about], [choice.columns[i] for i in about], table)
    return tables


def _rows(path: Path, head: Sequence[str]) -> Iterator[_Row]:
    try:
        with path.open(encoding="utf-8-sig", newline="") as file:
            reader = csv.reader(file, strict=True)
            if tuple(next(reader, ())) != tuple(head):
                raise KnowledgeError(f"{path}, line 1: the first line must be {','.join(head)}")
            for cells in reader:
                row = _Row(path, reader.line_num, dict(zip(head, cells, strict=False)))
                if len(cells) == len(head) and any(cells):
                    yield row
                elif any(cells):
                    raise row.wrong(
                        f"there are {len(cells)} values; give {len(head)}, with commas between."
                    )
    except (UnicodeDecodeError, csv.Error) as error:
        raise KnowledgeError(
            f"{path} is no table ({error}); save it as CSV in UTF-8, with commas."
        ) from None
    except OSError as error:
        raise KnowledgeError(f"Cannot open {path} ({error.strerror}); check the file.") from None


def _place(row: _Row, places: dict[tuple[str, str, str], int], end: str) -> int:
    relation, group, part = (row.cells[name + end].strip() for name in STRETCH[:3])
    if (relation, group, part) in places:
        return places[relation, group, part]
    raise row.wrong(_unknown(relation, group, part, places))


def _unknown(relation: str, group: str, part: str, known: Iterable[tuple[str, str, str]]) -> str:
    """What is wrong with the name of a column."""
    if relation not in NAMES.values():
        return f"there is no relation {relation!r}; write one of {', '.join(NAMES.values())}."
    groups = {key[1] for key in known if key[0] == relation}
    parts = {key[2] for key in known if key[0] == relation}
    what, given, there = ("part", part, parts) if group in groups else ("group", group, groups)
    words = ", ".join(sorted(there - {""})) or "nothing there"
    return f"{relation} has no {what} {given!r}; write {words}."


def _stretch(row: _Row, column: Column, end: str) -> slice:
    """The bins between two edges, above the last edge all that are left."""
    start, stop = row.cells["from" + end].strip(), row.cells["to" + end].strip()
    if start == stop == NONE:
        return slice(MISSING, BINS)
    limits = limits_of(column)
    one, two = (_limit(row, text, limits) for text in (start, stop))
    if one >= two:
        raise row.wrong(f"it goes from {start} to {stop}; the lesser comes first.")
    return slice(one, MISSING if two == len(limits) - 1 else two)


def _limit(row: _Row, text: str, limits: tuple[float, ...]) -> int:
    """Which of the limits a text is."""
    value = _number(text)
    for index, limit in enumerate(limits):
        if value == limit or (isfinite(limit) and abs(value - limit) < SAME):
            return index
    known = ", ".join(f"{limit:.6g}" for limit in limits)
    raise row.wrong(f"{text!r} is no edge of this column; write {NONE} twice, or two of {known}.")


def _nats(row: _Row) -> float:
    value = _number(row.cells["nats"])
    if not abs(value) <= MOST:
        raise row.wrong(
            f"{row.cells['nats']!r} is no number of nats; write one from {-MOST:g} to {MOST:g}."
        )
    return value


def _number(text: str) -> float:
    """The number that a text is; NaN if it is none."""
    try:
        return float(text)
    except ValueError:
        return np.nan


def _check_whole(row: _Row, about: list[Column], table: Floats) -> None:
    """Nothing is left out between the first edge and the last, and of what is not there."""
    gaps = np.argwhere(np.isnan(table))
    if not len(gaps):
        return
    where = (
        named(column, slice(at, at + 1))[3:]
        for column, at in zip(about, gaps[0].tolist(), strict=True)
    )
    there = " and ".join(NONE if a == NONE else f"{a} to {b}" for a, b in where)
    kind = "curve" if len(about) == 1 else "surface"
    raise row.wrong(
        f"the {kind} that begins here says nothing for {there}; add a row for that, with 0 if it "
        f"should add nothing, or take out all rows of the {kind}."
    )
