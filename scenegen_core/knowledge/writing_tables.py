"""The tables of a choice as files that people can read, edit in a spreadsheet, and give back.

Two files a category, ``<category>-curves.csv`` and ``<category>-surfaces.csv``. A row says what a
stretch of a column adds, from one edge of the column's bins to another; stretches of equal value
are one row. "none" stands for what is not there. A file says all: what it does not name adds
nothing.
"""

from __future__ import annotations

import csv
import re
from collections.abc import Iterator
from itertools import pairwise
from math import inf
from pathlib import Path

import numpy as np

from scenegen_core.graph.own_relations import OWN_RELATIONS
from scenegen_core.graph.relations import Column
from scenegen_core.knowledge.choice import BINS, MISSING, Choice, Table, edges_of
from scenegen_core.knowledge.knowledge import Knowledge

CURVES, SURFACES = "curves", "surfaces"
STRETCH = ("relation", "group", "part", "from", "to")
HEADS = {
    CURVES: (*STRETCH, "nats"),
    SURFACES: (*STRETCH, *(f"{name} 2" for name in STRETCH), "nats"),
}
NONE = "none"

NAMES = {relation.short: relation.name for relation in OWN_RELATIONS}


def file_stem(category: str) -> str:
    """What the files of a category are called, whatever signs its name has."""
    return re.sub(r"\W+", "-", category.lower())


def write_tables(knowledge: Knowledge, folder: Path) -> None:
    """Write the tables of every category into a folder; OSError if that fails."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, choice in knowledge.choices.items():
        curves, surfaces = _curve_rows(choice), _surface_rows(choice)
        for kind, rows in ((CURVES, curves), (SURFACES, surfaces)):
            path = folder / f"{file_stem(name)}-{kind}.csv"
            with path.open("w", encoding="utf-8", newline="") as file:
                csv.writer(file, lineterminator="\n").writerows([HEADS[kind], *rows])


def _curve_rows(choice: Choice) -> Iterator[tuple[str, ...]]:
    for column, curve in zip(choice.columns, choice.curves, strict=True):
        if curve.any():
            for where in _runs(column, curve[None]):
                yield *named(column, where), str(curve[where.start])


def _surface_rows(choice: Choice) -> Iterator[tuple[str, ...]]:
    for (one, two), surface in _summed(choice).items():
        if not surface.any():
            continue
        first, second = choice.columns[one], choice.columns[two]
        across = list(_runs(second, surface))
        for where in _runs(first, surface.T):
            for other in across:
                value = str(surface[where.start, other.start])
                yield *named(first, where), *named(second, other), value


def _summed(choice: Choice) -> dict[tuple[int, int], Table]:
    """The surface of each pair: learning on top gives a pair a second one."""
    found: dict[tuple[int, int], Table] = {}
    for (one, two), surface in zip(choice.pairs.tolist(), choice.surfaces, strict=True):
        before = found.get((one, two))
        found[one, two] = surface if before is None else before + surface
    return found


def _runs(column: Column, rows: Table) -> Iterator[slice]:
    """Stretches of bins over which no row changes, then the one of what is not there."""
    bins = len(edges_of(column)) + 1
    changes = (rows[:, 1:bins] != rows[:, : bins - 1]).any(axis=0)
    starts = [0, *(np.flatnonzero(changes) + 1).tolist(), bins]
    for start, stop in pairwise(starts):
        yield slice(start, stop)
    yield slice(MISSING, BINS)


def named(column: Column, where: slice) -> tuple[str, ...]:
    """A stretch of a column in the words of a file."""
    about = (NAMES[column.relation], column.group, column.part)
    if where.start == MISSING:
        return *about, NONE, NONE
    limits = limits_of(column)
    return *about, f"{limits[where.start]:.6g}", f"{limits[where.stop]:.6g}"


def limits_of(column: Column) -> tuple[float, ...]:
    """Where the stretches of a column can begin and end."""
    return (-inf, *edges_of(column), inf)
