"""Tables as plain data: cells with intervals, the best of each comparison marked."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Literal

from scenegen_core.evaluation.summary import Means

Unit = Literal["m", "rad", "nats", "share", "change", "count", "score"]
Better = Literal["low", "high", ""]


@dataclass(frozen=True, slots=True)
class Cell:
    """A number, perhaps with its 95 % interval; None where there is nothing to say."""

    value: float | None = None
    low: float | None = None
    high: float | None = None
    best: bool = False


@dataclass(frozen=True, slots=True)
class Column:
    """What the numbers of a column are; neighbors of one group stand under its name."""

    name: str
    unit: Unit
    group: str = ""
    better: Better = "low"


@dataclass(frozen=True, slots=True)
class Row:
    """A name and a cell for each column."""

    name: str
    cells: tuple[Cell, ...]


@dataclass(frozen=True, slots=True)
class Table:
    """A table of the report."""

    id: str
    """Names its files."""
    title: str
    note: str
    head: str
    """What the rows are."""
    columns: tuple[Column, ...]
    rows: tuple[Row, ...]


def cell(means: Means, measure: str) -> Cell:
    """The mean of a measure with its interval; empty if it was not measured."""
    if measure not in means:
        return Cell()
    return Cell(means[measure], *means.get("ci", {}).get(measure, (None, None)))


def text(one: Cell, unit: Unit) -> str:
    """The value of a cell in words of its unit; empty if it has none."""
    return "" if one.value is None else number(one.value, unit)


def interval_text(one: Cell, unit: Unit) -> str:
    """The interval of a cell, such as "0.91 to 1.02"; empty if it has none."""
    if one.low is None or one.high is None:
        return ""
    return f"{number(one.low, unit)} to {number(one.high, unit)}"


def number(value: float, unit: Unit) -> str:
    """A number as it is printed."""
    match unit:
        case "m" | "rad" | "nats":
            return f"{round(value, 2) + 0.0:.2f}".replace("-", "−")  # + 0.0: no negative zero
        case "share":
            return f"{100 * value:.1f} %"
        case "change":
            return f"{100 * value:+.1f} %".replace("-", "−")
        case "count":
            return f"{value:.0f}"
        case "score":
            return f"{value:.3f}"


def best_of_column(table: Table, apart: Iterable[str] = ()) -> Table:
    """Mark the best of each column; rows named in ``apart`` do not compete."""
    out = set(apart)
    competing = [i for i, row in enumerate(table.rows) if row.name not in out]
    marks = {
        (i, j)
        for j, column in enumerate(table.columns)
        for i in _best({i: table.rows[i].cells[j].value for i in competing}, column)
    }
    return _marked(table, marks)


def best_of_row(table: Table) -> Table:
    """Mark the best of each row within each group of columns."""
    marks = set[tuple[int, int]]()
    for i, row in enumerate(table.rows):
        for group in dict.fromkeys(column.group for column in table.columns):
            within = [j for j, column in enumerate(table.columns) if column.group == group]
            values = {j: row.cells[j].value for j in within}
            marks |= {(i, j) for j in _best(values, table.columns[within[0]])}
    return _marked(table, marks)


def _best(values: dict[int, float | None], column: Column) -> list[int]:
    """The places of the best value, and of those that print alike; none where none competes."""
    known = {place: value for place, value in values.items() if value is not None}
    if len(known) < 2 or not column.better:  # noqa: PLR2004 (one alone is not the best of anything)
        return []
    best = min(known.values()) if column.better == "low" else max(known.values())
    printed = number(best, column.unit)
    return [place for place, value in known.items() if number(value, column.unit) == printed]


def _marked(table: Table, marks: set[tuple[int, int]]) -> Table:
    rows: Sequence[Row] = [
        Row(row.name, tuple(replace(c, best=(i, j) in marks) for j, c in enumerate(row.cells)))
        for i, row in enumerate(table.rows)
    ]
    return replace(table, rows=tuple(rows))
