"""What gives a place where there is none, in rooms drawn so that one change alone does."""

from __future__ import annotations

import pytest

from scenegen_core.knowledge import default_knowledge
from scenegen_core.placement.answer import Cancelled, Query
from scenegen_core.placement.remedies import find_remedy
from scenegen_core.placement.solve import solve
from scenegen_core.scene.model import Box, Opening, Scene, Vector3
from tests.core.placement.drawn import room, thing

KNOWLEDGE = default_knowledge()
CLOSET = ((0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0))
LONG = ((0.0, 0.0), (4.0, 0.0), (4.0, 1.5), (0.0, 1.5))


def bed(depth: float, width: float) -> Query:
    return Query("Bed", size=(depth, width, 0.5))


def test_the_least_smaller_size_that_fits_is_offered_first() -> None:
    """Walls are 2 m apart: 0.85 of 2.3 m is the first that fits between them."""
    scene, query = room(corners=CLOSET), bed(2.3, 0.9)
    assert solve(scene, query, KNOWLEDGE).answer.no_good_place is not None
    remedy = find_remedy(scene, query, KNOWLEDGE)
    assert remedy is not None
    assert remedy.kind == "size"
    assert remedy.size == pytest.approx((1.955, 0.765, 0.5), abs=0.006)
    assert "15 % smaller" in remedy.text
    again = solve(scene, Query("Bed", size=remedy.size), KNOWLEDGE).answer
    assert again.poses[0].center == remedy.center


def chest(x: float, y: float, size: Vector3, box_id: str) -> Box:
    return thing("Storage", x, y, size, box_id=box_id, label=box_id)


def test_of_boxes_whose_removal_helps_the_least_one_is_to_go() -> None:
    """The chests leave 1.4 m, and 70 % of 2.1 m are 1.47 m; without one there is a way too."""
    corners = ((0.0, 0.0), (2.6, 0.0), (2.6, 4.4), (0.0, 4.4))
    scene = room(
        chest(1.3, 0.8, (2.4, 1.6, 0.8), "large"),
        chest(1.3, 3.7, (2.4, 1.4, 0.8), "small"),
        corners=corners,
    )
    query = bed(2.3, 2.1)
    remedy = find_remedy(scene, query, KNOWLEDGE)
    assert remedy is not None
    assert (remedy.kind, remedy.box) == ("box", "small")
    assert remedy.text == "There is a place without the small."


def test_what_stands_on_a_box_that_is_to_go_goes_along() -> None:
    """As in the page: the tall vase on the table is not in the way when the table is gone."""
    corners = ((0.0, 0.0), (2.6, 0.0), (2.6, 2.6), (0.0, 2.6))
    table = thing("Table", 1.3, 1.3, (1.6, 1.6, 0.4), box_id="table")
    vase = thing("Decor", 1.3, 1.3, (0.4, 0.4, 0.5), bottom=0.4, box_id="vase")
    query = Query("Bed", size=(2.3, 1.9, 0.5))
    remedy = find_remedy(room(table, vase, corners=corners), query, KNOWLEDGE)
    assert remedy is not None
    assert remedy.box == "table"


def test_living_with_a_covered_window_is_offered_last() -> None:
    """Windows on both long walls leave 0.5 m of 1.5 m: a wardrobe has to stand before one."""
    panes = (
        Opening((0.0, 0.0), (4.0, 0.0), 0.9, 2.0, "s"),
        Opening((4.0, 1.5), (0.0, 1.5), 0.9, 2.0, "n"),
    )
    scene = room(corners=LONG, windows=panes)
    query = Query("Storage", size=(0.8, 0.8, 2.0))
    remedy = find_remedy(scene, query, KNOWLEDGE)
    assert remedy is not None
    assert (remedy.kind, remedy.rule) == ("rule", "window")
    relaxed = Query("Storage", size=query.size, relaxed=("window",))
    assert solve(scene, relaxed, KNOWLEDGE).answer.poses[0].center == remedy.center


def test_where_nothing_helps_there_is_no_remedy() -> None:
    tiny: Scene = room(corners=((0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)))
    assert find_remedy(tiny, bed(2.0, 1.6), KNOWLEDGE) is None


def test_the_search_can_be_abandoned() -> None:
    with pytest.raises(Cancelled):
        find_remedy(room(corners=CLOSET), bed(2.3, 0.9), KNOWLEDGE, cancelled=lambda: True)
