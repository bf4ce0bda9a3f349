"""Tables of choices: where values fall, and what curves and surfaces add up to."""

from __future__ import annotations

from math import inf, nan

import numpy as np
import pytest

from scenegen_core.graph.relations import Column
from scenegen_core.knowledge.choice import (
    BINS,
    MISSING,
    Choice,
    binned,
    choice_columns,
    edges_of,
    without_examples,
)
from scenegen_core.scene.geometry import Floats
from scenegen_core.scene.model import PAPER_CATEGORIES


def column(relation: str, part: str) -> Column:
    return next(
        c for c in choice_columns(PAPER_CATEGORIES) if (c.relation, c.part) == (relation, part)
    )


GAP, TURN, FLUSH, HEIGHT = (
    column(*named) for named in (("W", "nearest"), ("W", "turn"), ("W", "flush"), ("H", ""))
)


def bin_of(value: float, named: Column) -> int:
    return int(binned(np.array([[value]]), (named,))[0, 0])


@pytest.mark.parametrize(
    ("value", "named", "expected"),
    [
        (0.04, GAP, 11),  # past −3 −2 −1.5 −1 −0.6 −0.3 −0.2 −0.1 −0.05 0 0.03
        (-10.0, GAP, 0),
        (99.0, GAP, 33),  # past all 33 edges
        (inf, GAP, 33),
        (nan, GAP, 35),
        (0.0, FLUSH, 0),
        (1.0, FLUSH, 1),
        (2.0, FLUSH, 2),
        (0.0, TURN, 0),
        (np.pi / 2, TURN, 12),  # past 4°, 11.5°, …, 86.5°
        (np.pi, TURN, 24),
        (0.0, HEIGHT, 0),
        (0.9, HEIGHT, 7),  # past 0.05 0.2 0.35 0.5 0.65 0.75 0.85
    ],
)
def test_a_value_falls_between_the_edges_about_it(
    value: float, named: Column, expected: int
) -> None:
    assert bin_of(value, named) == expected


@pytest.mark.parametrize("round_number", [0.1, 0.5, 1.0, 2.4])
def test_rounding_does_not_decide_where_a_round_number_falls(round_number: float) -> None:
    bins = {bin_of(round_number + dust, GAP) for dust in (-1e-12, 0.0, 1e-12)}
    assert len(bins) == 1


def test_every_column_has_edges_that_rise_and_leaves_a_bin_for_what_is_missing() -> None:
    for named in choice_columns(PAPER_CATEGORIES):
        edges = edges_of(named)
        assert list(edges) == sorted(set(edges))
        assert len(edges) < MISSING


def test_bins_are_those_of_a_search_among_the_edges() -> None:
    """Each edge and a hair beside it: the bin is found at once, so no two may be too close."""
    named = choice_columns(PAPER_CATEGORIES)
    edges = [np.array(edges_of(column)) for column in named]
    beside = np.array([-2e-6, -1e-9, 0.0, 1e-9, 0.004, 0.009])
    far = (-np.inf, -1e9, 1e9, np.inf)
    values = [np.sort([*(own[:, None] + beside).ravel(), *far]) for own in edges]
    longest = max(len(own) for own in values)
    table = np.array([np.pad(own, (0, longest - len(own)), mode="edge") for own in values])
    expected = [
        np.searchsorted(own - 1e-6, row, side="right")
        for own, row in zip(edges, table, strict=True)
    ]
    assert np.array_equal(binned(table.T.copy(), named), np.array(expected).T)


def test_each_group_has_a_column_for_each_part_of_a_neighbor() -> None:
    groups = [c.group for c in choice_columns(PAPER_CATEGORIES) if c.relation == "N"]
    assert len(groups) == 9 * 12
    assert set(groups) == {group.name for group in PAPER_CATEGORIES}


def drawn() -> tuple[Choice, Floats]:
    """Curves of two columns and a surface of both, by hand; three poses."""
    curves = np.zeros((2, BINS), dtype=np.float32)
    curves[0, :12] = 1.5  # nearer to a wall than 6 cm
    curves[1, 0], curves[1, MISSING] = 0.5, -0.25
    surfaces = np.zeros((1, BINS, BINS), dtype=np.float32)
    surfaces[0, 11, 0] = 2.0  # 3 to 6 cm from a wall and straight before it
    choice = Choice(
        columns=(GAP, TURN),
        curves=curves,
        pairs=np.array([[0, 1]]),
        surfaces=surfaces,
        examples=np.zeros((1, 2), dtype=np.uint8),
        rooms=("r",),
    )
    return choice, np.array([[0.04, 0.01], [0.04, nan], [3.0, 0.01]])


def test_a_score_is_the_sum_of_the_curves_and_surfaces_where_the_pose_is() -> None:
    choice, poses = drawn()
    assert choice.score(poses).tolist() == [1.5 + 0.5 + 2.0, 1.5 - 0.25, 0.5]


def test_terms_say_what_each_curve_and_then_each_surface_adds() -> None:
    choice, poses = drawn()
    assert choice.terms(poses).tolist() == [[1.5, 0.5, 2.0], [1.5, -0.25, 0.0], [0.0, 0.5, 0.0]]


def test_curves_alone_have_no_surfaces_and_no_examples() -> None:
    choice, poses = drawn()
    alone = without_examples(choice.columns, choice.curves)
    assert alone.score(poses).tolist() == [2.0, 1.25, 0.5]
    assert (alone.examples.shape, alone.rooms) == ((0, 2), ())
