"""Tables: the best marked, numbers printed, files that other programs read."""

from __future__ import annotations

import csv
import io
import json

from scenegen_core.evaluation.exports import as_csv, as_json, as_latex, as_markdown, provenance
from scenegen_core.evaluation.tables import (
    Cell,
    Column,
    Row,
    Table,
    best_of_column,
    best_of_row,
    interval_text,
    number,
    text,
)
from tests.core.evaluation.made import SETTINGS

TABLE = Table(
    "small",
    "A small table",
    "",
    "system",
    (Column("AD_1", "m", "top 1"), Column("RP", "m", "top 1"), Column("hits", "share", "", "high")),
    (
        Row("one", (Cell(1.0, 0.9, 1.14), Cell(2.0), Cell(0.5))),
        Row("two", (Cell(1.5), Cell(1.5), Cell(0.25))),
        Row("bound", (Cell(0.1), Cell(0.1), Cell(1.0))),
    ),
)


def best(table: Table) -> list[tuple[str, int]]:
    return [(row.name, j) for row in table.rows for j, cell in enumerate(row.cells) if cell.best]


def test_the_best_of_a_column_is_the_lowest_error_or_the_highest_share() -> None:
    assert best(best_of_column(TABLE, ["bound"])) == [("one", 0), ("one", 2), ("two", 1)]


def test_what_prints_alike_is_equally_good() -> None:
    assert best(best_of_row(TABLE)) == [("one", 0), ("two", 0), ("two", 1), ("bound", 0),
                                        ("bound", 1)]  # fmt: skip


def test_numbers_are_printed_in_their_unit() -> None:
    assert number(1.005, "m") == "1.00"
    assert number(-0.004, "m") == "0.00"
    assert number(-1.5, "rad") == "−1.50"
    assert number(0.125, "share") == "12.5 %"
    assert number(-0.1429, "change") == "−14.3 %"
    assert number(7.0, "count") == "7"
    assert text(Cell(), "m") == ""
    assert interval_text(Cell(1.0, 0.9, 1.14), "m") == "0.90 to 1.14"
    assert interval_text(Cell(1.0), "m") == ""


def test_csv_has_three_columns_a_number() -> None:
    rows = list(csv.DictReader(io.StringIO(as_csv(TABLE))))
    assert rows[0]["system"] == "one"
    assert (rows[0]["top 1 AD_1"], rows[0]["top 1 AD_1 low"]) == ("1", "0.9")
    assert rows[0]["top 1 AD_1 high"] == "1.14"
    assert rows[1]["top 1 AD_1 low"] == ""


def test_json_says_where_it_comes_from() -> None:
    found = json.loads(as_json(TABLE, provenance(SETTINGS)))
    assert found["rows"][0]["cells"][0] == {"value": 1.0, "low": 0.9, "high": 1.14, "best": False}
    assert found["columns"][2] == {"name": "hits", "unit": "share", "group": "", "better": "high"}
    assert found["origin"] == (
        "flats.jsonl (2 rooms); 2 folds by home; seed 1; scenegen 0.1.0; data 0123456789abcdef"
    )


def test_latex_escapes_and_prints_the_best_in_bold() -> None:
    lines = as_latex(best_of_column(TABLE, ["bound"]), "made here").splitlines()
    assert lines[0] == "% made here"
    assert lines[3] == r" & \multicolumn{2}{c}{top 1} & \multicolumn{1}{c}{} \\"
    assert lines[4] == r"system & AD\_1 & RP & hits \\"
    assert lines[6] == r"one & \textbf{1.00} & 2.00 & \textbf{50.0 \%} \\"


def test_markdown_shows_intervals_in_brackets() -> None:
    lines = as_markdown(best_of_column(TABLE, ["bound"])).splitlines()
    assert lines[0] == "| system | top 1 AD_1 | top 1 RP | hits |"
    assert lines[2] == "| one | **1.00** (0.90 to 1.14) | 2.00 | **50.0 %** |"
