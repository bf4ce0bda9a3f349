"""The paper's numbers, against what its text and tables print."""

from __future__ import annotations

import pytest

from scenegen_core.evaluation.comparison_tables import (
    published_orientation,
    published_position,
    published_steps,
)
from scenegen_core.evaluation.published import ORIENTATION, POSITION


def test_numbers_are_those_of_tables_1_and_2() -> None:
    assert POSITION["AD+S+RP"]["Bed"] == (1.58, 0.87)
    assert POSITION["AD+RP"]["TV"] == (2.39, 1.731)
    assert POSITION["S+RP"]["Decor"] == (3.38, 2.14)
    assert POSITION["RP"]["overall"] == (2.80, 1.96)
    assert ORIENTATION["F+C+RP"]["overall"] == 0.85
    assert ORIENTATION["F+C+NT"]["TV"] == 0.46
    assert ORIENTATION["F+C+DS"]["Bed"] == 1.54


def test_every_system_has_every_category() -> None:
    eight = {"Bed", "Chair", "Storage", "Decor", "Picture", "Table", "Sofa", "TV", "overall"}
    assert {frozenset(values) for values in POSITION.values()} == {frozenset(eight)}
    five = {"Bed", "Chair", "Sofa", "TV", "overall"}
    assert {frozenset(values) for values in ORIENTATION.values()} == {frozenset(five)}


def test_the_relations_are_worth_what_the_paper_says() -> None:
    steps = {row.name: row.cells[0].value for row in published_steps().rows}
    assert steps["RP → AD+S+RP, best pose"] == pytest.approx(-0.143, abs=5e-4)
    assert steps["RP → AD+S+RP, nearest of the best 5"] == pytest.approx(-0.214, abs=5e-4)
    assert steps["F → F+C+RP, angle"] == pytest.approx(-0.448, abs=5e-4)


def bold(row: str, *, orientation: bool = False) -> list[str]:
    table = published_orientation() if orientation else published_position()
    cells = next(found for found in table.rows if found.name == row).cells
    return [
        f"{column.group}: {column.name}"
        for column, cell in zip(table.columns, cells, strict=True)
        if cell.best
    ]


def test_bold_is_where_the_paper_prints_bold() -> None:
    assert bold("Bed") == ["best pose: AD+RP", "nearest of the best 5: AD+S+RP"]
    assert bold("Picture") == ["best pose: AD+S+RP", "nearest of the best 5: S+RP"]
    assert bold("TV", orientation=True) == ["angle: F+C+NT"]
    assert bold("overall", orientation=True) == ["angle: F+C+RP"]
