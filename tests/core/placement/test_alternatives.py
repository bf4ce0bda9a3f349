"""Which poses are offered: expected distances over cells whose masses are given."""

from __future__ import annotations

from itertools import combinations, pairwise

import numpy as np
import pytest

from scenegen_core.graph.candidates import Candidates
from scenegen_core.graph.surroundings import Surroundings
from scenegen_core.placement.alternatives import best_of_places, choose, probabilities
from scenegen_core.placement.mounts import Mount
from scenegen_core.placement.proposals import Grid, Proposals
from scenegen_core.placement.walking import Walking
from scenegen_core.scene.geometry import Floats
from scenegen_core.scene.model import PAPER_CATEGORIES, Scene
from tests.core.placement.drawn import DOOR, room, thing

FIVE = (0.5, 1.5, 2.5, 3.5, 4.5)
"""Where the cells of a row are, metres."""


def row(places: Floats | tuple[float, ...], cells: tuple[int, ...] | None = None) -> Proposals:
    """Poses of a small chair in a row, each in a cell of its own unless told."""
    count = len(places)
    return Proposals(
        candidates=Candidates(
            "Chair",
            (0.2, 0.2, 0.5),
            np.array([(x, 2.0, 0.25) for x in places]),
            np.zeros(count),
        ),
        mounts=np.full(count, int(Mount.FLOOR)),
        cells=np.array(cells if cells is not None else range(count)),
        flush=np.zeros(count, dtype=bool),
        grids={Mount.FLOOR: Grid((0.0, 0.0), (1, 5), 1.0)},
    )


def offered(
    proposals: Proposals,
    scores: Floats,
    count: int,
    *,
    expects: bool = True,
    scene: Scene | None = None,
) -> list[float]:
    """Where along the row the offers are."""
    around = Surroundings(scene or room(), PAPER_CATEGORIES)
    chosen = choose(
        proposals,
        scores,
        Walking(around),
        count=count,
        rng=np.random.default_rng(0),
        keep_going=lambda: None,
        expects=expects,
    )
    found: list[float] = proposals.candidates.centers[chosen.poses, 0].tolist()
    return found


def logs(*masses: float) -> Floats:
    return np.asarray(np.log(masses), dtype=np.float64)


@pytest.mark.parametrize(
    ("masses", "metres"),
    [
        ((1, 1, 1, 1, 1), (10, 7, 6, 7, 10)),
        ((5, 1, 1, 1, 1), (10, 11, 14, 19, 26)),  # more than half of the mass is there
        ((4, 2, 1, 1, 2), (15, 13, 15, 19, 25)),  # not the likeliest
        ((1, 2, 9, 2, 1), (30, 17, 8, 17, 30)),
    ],
)
def test_the_first_offer_is_where_the_truth_is_least_far_on_average(
    masses: tuple[float, ...], metres: tuple[float, ...]
) -> None:
    """``metres``: mass times distance, summed over the cells, from each."""
    assert offered(row(FIVE), logs(*masses), 1) == [FIVE[metres.index(min(metres))]]


def test_an_offer_settles_on_the_likeliest_place_close_to_the_average() -> None:
    """Half a metre apart it is the place of the average; a quarter apart, the likelier one."""
    far, close = ((1.0, 1.5, 2.0, 2.5, 3.0), (1.0, 1.75, 2.0, 2.25, 3.0))
    assert offered(row(far), logs(4, 5, 6, 7, 4), 1) == [2.0]
    assert offered(row(close), logs(4, 5, 6, 7, 4), 1) == [2.25]


def test_a_share_is_left_for_what_no_pose_comes_near() -> None:
    """Two poses of one cell, one of another, none of a third: 0.85 of theirs, and 0.15 / 2 each."""
    found = probabilities(np.append(logs(2, 1, 1), -np.inf) + 30.0, np.array([7, 7, 9, 4]))
    assert found == pytest.approx([0.4625, 0.25, 0.2875, 0.0])
    assert probabilities(np.full(2, -np.inf), np.array([0, 1])).tolist() == [0, 0]


def test_the_second_offer_serves_what_the_first_leaves_far_away() -> None:
    """Masses 6 1 1 1 4. From 0.5: 22 m in all; from 1.5: 21; from 2.5: 22 …

    With 1.5 taken, distances are 1 0 1 2 3. A second at 4.5 leaves 6 + 1 + 1 = 8, one at 3.5 leaves
    6 + 1 + 4 = 11, one at 2.5 leaves 6 + 1 + 8 = 15, one at 0.5 leaves 1 + 2 + 12 = 15.
    """
    assert offered(row(FIVE), logs(6, 1, 1, 1, 4), 2) == [1.5, 4.5]


def test_densities_are_offered_best_first_though_they_lie_together() -> None:
    assert offered(row(FIVE), logs(6, 5, 4, 1, 2), 3, expects=False) == [0.5, 1.5, 2.5]


def test_all_poses_of_a_cell_count_as_chances_of_that_place() -> None:
    """Three poses of mass 2 in the fifth cell outweigh the one of mass 5 in the first."""
    places = (0.5, 4.5, 4.5, 4.5)
    proposals = row(places, (0, 4, 4, 4))
    assert offered(proposals, logs(5, 2, 2, 2), 1) == [4.5]
    assert offered(proposals, logs(5, 2, 2, 2), 1, expects=False) == [0.5]


def test_a_place_in_the_middle_that_hardly_anyone_chooses_is_not_offered_first() -> None:
    """It would be nearest to both ends on average, but is e^−5 times as likely: e² is allowed."""
    found = offered(row(FIVE), logs(1.0, 1e-9, np.exp(-5.0), 1e-9, 0.9), 1)
    assert found == [0.5]


def test_what_is_far_less_likely_comes_last() -> None:
    """4.5 serves more than 1.5, but is e^−4.1 times as likely as the best: e^−4 goes first."""
    unlikely = np.exp(-4.1)
    masses = logs(1.0, 0.02, unlikely, unlikely, unlikely)
    assert offered(row(FIVE), masses, 2) == [0.5, 1.5]
    assert len(offered(row(FIVE), masses, 5)) == 5


@pytest.mark.parametrize("expects", [False, True])
def test_offers_lie_apart(*, expects: bool) -> None:
    places = np.arange(0.1, 5.0, 0.1)
    rng = np.random.default_rng(1)
    found = offered(row(places), rng.normal(size=len(places)), 5, expects=expects)
    assert len(found) >= 3
    assert all(abs(a - b) >= 0.75 - 1e-9 for a, b in combinations(found, 2))


@pytest.mark.parametrize("expects", [False, True])
def test_impossible_poses_are_never_offered(*, expects: bool) -> None:
    scores = np.array([-np.inf, 0.0, -np.inf, -1.0, -np.inf])
    assert sorted(offered(row(FIVE), scores, 5, expects=expects)) == [1.5, 3.5]
    assert offered(row(FIVE), np.full(5, -np.inf), 5, expects=expects) == []


@pytest.mark.parametrize("expects", [False, True])
def test_what_closes_a_way_is_passed_over(*, expects: bool) -> None:
    """A bed behind a passage of 1 m: a chair in the middle of it closes the way."""
    walls = (
        thing("Storage", 2.5, 0.75, (0.6, 1.5, 2.0)),
        thing("Storage", 2.5, 3.25, (0.6, 1.5, 2)),
    )
    bed = thing("Bed", 4.0, 3.0, (1.0, 1.0, 0.5))
    named = tuple(
        thing(b.category, b.center[0], b.center[1], b.size, box_id=f"{i}")
        for i, b in enumerate((*walls, bed))
    )
    scene = room(*named, doors=(DOOR,))
    found = offered(row(FIVE), logs(1, 1, 50, 1, 1), 5, expects=expects, scene=scene)
    assert 2.5 not in found
    assert found


def test_each_cell_is_known_by_its_best_pose() -> None:
    proposals = row((0.5, 0.6, 1.5, 1.6), (0, 0, 1, 1))
    scores = np.array([0.0, 1.0, 3.0, -np.inf])
    assert best_of_places(proposals, scores).tolist() == [2, 1]


def test_more_offers_bring_the_nearest_one_closer_on_average() -> None:
    masses = np.random.default_rng(4).random(50)
    places = np.linspace(0.05, 4.95, 50)
    risks = []
    for count in range(1, 5):
        found = np.array(offered(row(places), np.log(masses), count))
        nearest = np.abs(places[:, None] - found).min(axis=1)
        risks.append(float(nearest @ masses))
    assert all(later < sooner for sooner, later in pairwise(risks))
