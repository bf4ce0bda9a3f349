"""What columns and their bins are called in pictures."""

from __future__ import annotations

import re
from collections import Counter

import pytest

from scenegen_core.evaluation.column_words import bin_words, edge_words, is_counted, words
from scenegen_core.graph.relations import Column
from scenegen_core.knowledge.choice import choice_columns, edges_of
from scenegen_core.scene.model import PAPER_CATEGORIES

COLUMNS = choice_columns(PAPER_CATEGORIES)


def column(relation: str, part: str, group: str = "") -> Column:
    return next(c for c in COLUMNS if (c.relation, c.part, c.group) == (relation, part, group))


@pytest.mark.parametrize(
    ("named", "expected"),
    [
        (column("N", "gap", "Table"), "gap to the nearest table, m"),
        (column("N", "near", "TV"), "TVs within 1 m"),
        (column("N", "faced", "Storage"), "is it in front of the nearest storage piece?"),
        (column("N", "on", "TV"), "does it stand on one of the TVs?"),
        (column("DR", "gap"), "gap to the nearest door, m"),
        (column("WN", "bearing"), "where the nearest window lies (0 ahead, 180 behind), °"),
        (column("TW", "beside"), "beyond the side of another just like it, m"),
        (column("W", "flush"), "walls that it touches"),
        (column("H", ""), "height of its underside, m"),
        (column("SZ", "room"), "size of the room, m²"),
    ],
)
def test_a_column_is_told_in_plain_words_with_its_unit(named: Column, expected: str) -> None:
    assert words(named) == expected


def test_no_two_columns_are_called_the_same() -> None:
    assert [name for name, n in Counter(map(words, COLUMNS)).items() if n > 1] == []


def test_every_column_has_a_unit_unless_it_counts_or_compares() -> None:
    plain = [words(c) for c in COLUMNS if not re.search(r", (m|°|m²)$", words(c))]
    assert all(
        re.search(r"\?$|within 1 m$|touches$|midway, 1 at one\)$|sizes of the room$", one)
        for one in plain
    )


@pytest.mark.parametrize(
    ("named", "some"),
    [
        (column("N", "faced", "TV"), ("no", "yes")),
        (column("W", "flush"), ("0", "1", "2", "3", "4", "5–6", "7–8", "9+")),
        (column("SZ", "room"), ("below 4", "4 to 6", "6 to 8")),
        (column("W", "turn"), ("below 4", "4 to 11.5", "11.5 to 19")),
    ],
)
def test_bins_are_told_by_what_they_hold(named: Column, some: tuple[str, ...]) -> None:
    assert bin_words(named)[: len(some)] == some


def test_each_bin_has_a_name_and_each_edge_a_number() -> None:
    for named in COLUMNS:
        assert len(bin_words(named)) == len(edges_of(named)) + 1
        assert len(edge_words(named)) == len(edges_of(named))
    assert is_counted(column("N", "near", "TV"))
    assert not is_counted(column("N", "gap", "TV"))
