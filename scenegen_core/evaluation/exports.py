"""Tables as files: JSON with intervals, CSV, LaTeX, Markdown; each says where it comes from."""

from __future__ import annotations

import csv
import io
from dataclasses import asdict

import msgspec

from scenegen_core.evaluation.records import Settings
from scenegen_core.evaluation.tables import Cell, Column, Row, Table, interval_text, text

LATEX = {"&": r"\&", "%": r"\%", "_": r"\_", "#": r"\#", "→": r"$\to$", "−": "--", "°": r"$^\circ$"}


def provenance(settings: Settings) -> str:
    """What numbers were made from, in a line."""
    learned = f"learned from {', '.join(settings.learned)}; " if settings.learned else ""
    folds = f"{settings.folds} folds by home; " if settings.folds else ""
    return (
        f"{', '.join(settings.data)} ({settings.rooms} rooms); {learned}{folds}"
        f"seed {settings.seed}; scenegen {settings.version}; data {settings.digest}"
    )


def as_json(table: Table, origin: str) -> str:
    """A table with its intervals."""
    return msgspec.json.format(
        msgspec.json.encode(
            {
                **asdict(table),
                "origin": origin,
                "rows": [
                    {"name": row.name, "cells": [asdict(cell) for cell in row.cells]}
                    for row in table.rows
                ],
            }
        )
    ).decode()


def as_csv(table: Table) -> str:
    """A line a row; three columns a number: value, low and high of its interval."""
    file = io.StringIO()
    writer = csv.writer(file, lineterminator="\n")
    names = [" ".join(filter(None, [c.group, c.name])) for c in table.columns]
    writer.writerow(
        [table.head, *(part for name in names for part in (name, f"{name} low", f"{name} high"))]
    )
    for row in table.rows:
        numbers = [number for cell in row.cells for number in (cell.value, cell.low, cell.high)]
        writer.writerow([row.name, *("" if n is None else f"{n:.6g}" for n in numbers)])
    return file.getvalue()


def as_latex(table: Table, origin: str) -> str:
    """A tabular, the best in bold."""
    lines = [
        f"% {origin}",
        rf"\begin{{tabular}}{{l{'r' * len(table.columns)}}}",
        r"\hline",
        *_latex_groups(table.columns),
        _latex_line([table.head, *(column.name for column in table.columns)]),
        r"\hline",
        *(_latex_row(table, row) for row in table.rows),
        r"\hline",
        r"\end{tabular}",
    ]
    return "\n".join(lines) + "\n"


def _latex_groups(columns: tuple[Column, ...]) -> list[str]:
    """The line of group names above the names of the columns, where there are any."""
    if not any(column.group for column in columns):
        return []
    parts = [rf"\multicolumn{{{span}}}{{c}}{{{_tex(name)}}}" for name, span in spans(columns)]
    return [" & ".join(["", *parts]) + r" \\"]


def _latex_row(table: Table, row: Row) -> str:
    cells = []
    for one, column in zip(row.cells, table.columns, strict=True):
        value = _tex(text(one, column.unit))
        cells.append(rf"\textbf{{{value}}}" if one.best else value)
    return " & ".join([_tex(row.name), *cells]) + r" \\"


def _latex_line(words: list[str]) -> str:
    return " & ".join(map(_tex, words)) + r" \\"


def _tex(words: str) -> str:
    return "".join(LATEX.get(letter, letter) for letter in words)


def as_markdown(table: Table) -> str:
    """A table for docs: values with their intervals, the best in bold."""
    names = [" ".join(filter(None, [c.group, c.name])) for c in table.columns]
    lines = [
        f"| {' | '.join([table.head or ' ', *names])} |",
        f"| --- {'| ---: ' * len(names)}|",
        *(f"| {' | '.join([row.name, *_markdown_cells(table, row)])} |" for row in table.rows),
    ]
    return "\n".join(lines) + "\n"


def _markdown_cells(table: Table, row: Row) -> list[str]:
    return [_markdown(one, column) for one, column in zip(row.cells, table.columns, strict=True)]


def _markdown(one: Cell, column: Column) -> str:
    value, within = text(one, column.unit), interval_text(one, column.unit)
    value = f"**{value}**" if one.best else value
    return f"{value} ({within})" if within else value


def spans(columns: tuple[Column, ...]) -> list[tuple[str, int]]:
    """(group, how many columns) in order."""
    found: list[tuple[str, int]] = []
    for column in columns:
        if found and found[-1][0] == column.group:
            found[-1] = (column.group, found[-1][1] + 1)
        else:
            found.append((column.group, 1))
    return found
