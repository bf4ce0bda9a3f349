"""Several objects one after another; baselines; heat maps."""

from __future__ import annotations

import numpy as np
import pytest
from shapely import MultiPoint, Polygon

from scenegen_core.graph.surroundings import Surroundings
from scenegen_core.knowledge import default_knowledge
from scenegen_core.placement.answer import Query
from scenegen_core.placement.arrange import arrange
from scenegen_core.placement.baselines import BASELINES, along_walls, random, random_open
from scenegen_core.placement.heat_map import heat_maps, likelihood, scale
from scenegen_core.placement.mounts import Mount
from scenegen_core.placement.proposals import propose
from scenegen_core.placement.solve import solve
from scenegen_core.scene.model import PAPER_CATEGORIES, Room, Scene
from tests.core.placement.by_shapely import faults
from tests.core.placement.drawn import DOOR, category, room, thing

KNOWLEDGE = default_knowledge()
SOFA = Query("Sofa", size=(0.9, 1.8, 0.8))
TABLE = Query("Table", size=(0.6, 1.0, 0.45))
HUGE = Query("Bed", size=(6, 6, 0.5))

# --- arrange --------------------------------------------------------------------------------------


def test_each_object_sees_those_placed_before() -> None:
    start = room(doors=(DOOR,))
    furnished, answers = arrange(start, [SOFA, TABLE, SOFA], KNOWLEDGE)
    assert [box.id for box in furnished.boxes] == ["sofa-1", "table-1", "sofa-2"]
    seen = start
    for box, answer in zip(furnished.boxes, answers, strict=True):
        alone = solve(seen, Query(box.category, size=box.size), KNOWLEDGE).answer
        assert alone.poses[0].center == answer.poses[0].center == box.center
        assert box.heading == answer.poses[0].heading
        assert box.placed
        assert faults(seen, box) == set()
        seen = seen.with_box(box)


def test_an_object_without_a_place_is_left_out_and_the_others_go_on() -> None:
    furnished, answers = arrange(room(), [HUGE, TABLE], KNOWLEDGE)
    assert [box.category for box in furnished.boxes] == ["Table"]
    assert [len(answer.poses) > 0 for answer in answers] == [False, True]


def test_names_that_are_taken_are_not_given_again() -> None:
    start = room(thing("Table", 4.5, 3.5, (0.4, 0.4, 0.4), box_id="table-1"))
    furnished, _ = arrange(start, [TABLE], KNOWLEDGE)
    assert [box.id for box in furnished.boxes] == ["table-1", "table-2"]


def test_progress_counts_the_objects() -> None:
    told: list[int] = []
    arrange(room(), [TABLE, HUGE, TABLE], KNOWLEDGE, progress=told.append)
    assert told == [1, 2, 3]


def test_nothing_asked_changes_nothing() -> None:
    start = room()
    assert arrange(start, [], KNOWLEDGE) == (start, ())


# --- baselines ------------------------------------------------------------------------------------

PROPOSALS = propose(Surroundings(room(), PAPER_CATEGORIES), category("Sofa"), (0.9, 1.8, 0.8))
EASTERN = PROPOSALS.candidates.centers[:, 0] > 4


@pytest.mark.parametrize("name", BASELINES)
def test_a_baseline_draws_as_many_different_poses_as_asked(name: str) -> None:
    drawn = BASELINES[name](PROPOSALS, EASTERN, 20, np.random.default_rng(1))
    again = BASELINES[name](PROPOSALS, EASTERN, 20, np.random.default_rng(1))
    assert len(set(drawn.tolist())) == 20
    assert drawn.tolist() == again.tolist()


def test_random_ignores_what_is_possible_and_the_others_do_not() -> None:
    rng = np.random.default_rng(2)
    drawn = random(PROPOSALS, EASTERN, 500, rng)
    share = EASTERN.mean()  # about a fifth
    assert EASTERN[drawn].mean() == pytest.approx(share, abs=4 * np.sqrt(share / 500))
    assert EASTERN[random_open(PROPOSALS, EASTERN, 500, rng)].all()
    assert EASTERN[along_walls(PROPOSALS, EASTERN, 20, rng)].all()


def test_along_walls_has_its_back_to_a_wall() -> None:
    drawn = along_walls(PROPOSALS, EASTERN, 30, np.random.default_rng(3))
    poses = PROPOSALS.candidates[drawn]
    back = poses.centers[:, :2] - 0.47 * np.column_stack(
        [np.cos(poses.headings), np.sin(poses.headings)]
    )
    off = np.minimum.reduce([back[:, 0], 5 - back[:, 0], back[:, 1], 4 - back[:, 1]])
    assert off == pytest.approx(0, abs=1e-9)


def test_along_walls_falls_back_to_anywhere_possible() -> None:
    middle = ~PROPOSALS.flush & EASTERN
    assert middle[along_walls(PROPOSALS, middle, 5, np.random.default_rng(4))].all()


@pytest.mark.parametrize("name", BASELINES)
def test_a_baseline_draws_no_more_than_there_is(name: str) -> None:
    few = np.zeros(len(EASTERN), dtype=bool)
    few[:3] = True
    drawn = BASELINES[name](PROPOSALS, few, 5, np.random.default_rng(5))
    assert len(drawn) == (5 if name == "random" else 3)


# --- heat maps ------------------------------------------------------------------------------------


def test_the_scale_runs_from_the_lowest_tenth_to_the_best() -> None:
    assert scale(np.arange(101.0)) == pytest.approx((10.0, 100.0))
    assert scale(np.array([3.0])) == (3.0, 3.0)
    assert scale(np.empty(0)) == (0.0, 0.0)


def test_likelihood_is_a_score_on_that_scale() -> None:
    scores = np.array([-5.0, 10.0, 55.0, 100.0])
    assert likelihood(scores, (10.0, 100.0)) == pytest.approx([0, 0, 0.5, 1])
    assert likelihood(np.array([3.0]), (3.0, 3.0)) == pytest.approx([1])


def test_a_cell_shows_its_best_possible_pose() -> None:
    scene = Scene(Room(((0, 0), (0.8, 0), (0.8, 0.9), (0, 0.9))))
    found = propose(Surroundings(scene, PAPER_CATEGORIES), category("Table"), (0.1, 0.2, 0.5))
    scores = np.full(len(found.candidates), -np.inf)
    grid = np.flatnonzero(~found.flush)  # two headings for each of 72 cells, row by row
    scores[grid[0]], scores[grid[1]] = 1.0, 3.0
    scores[grid[2 * 71]] = 2.0
    (heat_map,) = heat_maps(found, scores, (1.0, 3.0))
    assert heat_map.values.shape == (9, 8)
    assert (heat_map.values[0, 0], heat_map.values[8, 7]) == (255, 128)
    assert np.count_nonzero(heat_map.values) == 2
    assert (heat_map.surface, heat_map.origin, heat_map.low, heat_map.high) == (
        "floor", (0.0, 0.0), 1.0, 3.0,
    )  # fmt: skip


def test_the_least_likely_possible_cell_is_not_shown_as_impossible() -> None:
    scene = Scene(Room(((0, 0), (1, 0), (1, 1), (0, 1))))
    found = propose(Surroundings(scene, PAPER_CATEGORIES), category("Picture"), (0.02, 0.2, 0.2))
    scores = np.full(len(found.candidates), -1e6)
    scores[0] = 0.0
    (heat_map,) = heat_maps(found, scores, (-10.0, 0.0))
    assert heat_map.surface == "walls"
    assert set(found.grids) == {Mount.WALL}
    assert sorted(set(heat_map.values.ravel().tolist())) == [0, 1, 255]


def test_a_map_of_the_floor_has_zeros_outside_an_uneven_room() -> None:
    corners = ((0, 0), (3, 0), (3, 1), (1, 1), (1, 3), (0, 3))
    answer = solve(room(corners=corners), Query("Decor", size=(0.2, 0.2, 1.0)), KNOWLEDGE).answer
    (heat_map,) = answer.heat_maps
    rows, columns = np.nonzero(heat_map.values)
    middles = MultiPoint((np.column_stack([columns, rows]) * 0.1 + 0.05).tolist())
    assert Polygon(corners).contains(middles)
    assert heat_map.values[20:, 20:].max() == 0
