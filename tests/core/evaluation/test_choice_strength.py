"""Which curves and surfaces matter: worked out by hand on a few examples."""

from __future__ import annotations

import numpy as np
import pytest

from scenegen_core.evaluation.choice_strength import (
    curve_spreads,
    joint_shares,
    shares,
    strongest,
    surface_spreads,
)
from scenegen_core.graph.relations import Column
from scenegen_core.knowledge.choice import BINS, MISSING, Choice

GAP = Column("W", "", "continuous", "nearest")
SOFA = Column("N", "Sofa", "continuous", "gap")
WIDTH = Column("SZ", "", "continuous", "width")


def spread(column: Column, curve: dict[int, float], bins: list[int]) -> float:
    table = np.zeros((1, BINS), dtype=np.float32)
    for place, value in curve.items():
        table[0, place] = value
    often = shares(np.array(bins, dtype=np.uint8)[:, None])
    return float(curve_spreads((column,), table, often)[0])


def pair(one: Column, two: Column, surface: dict[tuple[int, int], float], rows: object) -> Choice:
    table = np.zeros((1, BINS, BINS), dtype=np.float32)
    for place, value in surface.items():
        table[0][place] = value
    return Choice(
        columns=(one, two),
        curves=np.zeros((2, BINS), dtype=np.float32),
        pairs=np.array([[0, 1]]),
        surfaces=table,
        examples=np.array(rows, dtype=np.uint8),
        rooms=("a",) * len(np.array(rows)),
    )


def test_shares_of_a_column_are_those_of_its_examples() -> None:
    found = shares(np.array([[1], [1], [3], [MISSING]], dtype=np.uint8))
    assert found[0, [1, 3, MISSING]].tolist() == [0.5, 0.25, 0.25]
    assert found.sum() == 1


def test_spread_is_the_standard_deviation_over_the_examples() -> None:
    assert spread(GAP, {0: 2.0}, [0, 1, 2, 3]) == pytest.approx(np.std([2, 0, 0, 0]))


def test_a_curve_that_all_examples_get_alike_does_not_matter() -> None:
    assert spread(GAP, {5: 3.0}, [5, 5, 5]) == 0


def test_a_jump_where_no_example_is_does_not_matter() -> None:
    assert spread(GAP, {9: 3.0}, [0, 1, 2]) == 0


def test_rooms_without_a_sofa_do_not_count_as_far_from_one() -> None:
    assert spread(SOFA, {MISSING: 5.0}, [0, 0, MISSING, MISSING]) == 0
    assert spread(SOFA, {0: 2.0}, [0, 1, MISSING, MISSING]) == pytest.approx(
        np.sqrt((1**2 + 1**2) / 4)
    )


def test_sizes_decide_nothing_by_themselves() -> None:
    assert spread(WIDTH, {3: 2.0}, [3, 4, 5]) == 0


def test_a_surface_with_a_size_matters_by_what_it_says_for_each_size() -> None:
    rows = [[3, 0], [3, 1], [4, 0], [4, 1]]
    the_same_everywhere = pair(WIDTH, GAP, {(3, 0): 1.0, (3, 1): 1.0}, rows)
    by_the_wall_if_wide = pair(WIDTH, GAP, {(3, 0): 2.0}, rows)
    assert surface_spreads(the_same_everywhere, joint_shares(the_same_everywhere)).tolist() == [0]
    assert surface_spreads(by_the_wall_if_wide, joint_shares(by_the_wall_if_wide)) == (
        pytest.approx([np.sqrt((1 + 1) / 4)])
    )


def test_a_surface_still_speaks_where_one_of_its_two_is_missing() -> None:
    choice = pair(SOFA, GAP, {(MISSING, 0): 2.0}, [[MISSING, 0], [MISSING, 1]])
    assert surface_spreads(choice, joint_shares(choice)) == pytest.approx([1.0])


def test_the_strongest_come_first_and_none_that_says_nothing() -> None:
    assert strongest(np.array([0.1, 0.0, 0.5, 0.3]), 3).tolist() == [2, 3, 0]
    assert strongest(np.array([0.1, 0.0]), 5).tolist() == [0]
