"""Several objects one after another; heat maps."""

from __future__ import annotations

import numpy as np
import pytest
from shapely import MultiPoint, Polygon

from scenegen_core.graph.surroundings import Surroundings
from scenegen_core.knowledge import default_knowledge
from scenegen_core.placement.answer import Query
from scenegen_core.placement.arrange import arrange
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
