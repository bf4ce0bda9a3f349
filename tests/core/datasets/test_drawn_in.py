"""Outlines that ran behind their walls."""

from __future__ import annotations

import pytest

from scenegen_core.datasets.cleaning import clean
from scenegen_core.datasets.drawn_in import drawn_in
from scenegen_core.scene.model import Opening, Scene
from tests.core.placement.drawn import DOOR, L_SHAPE, WINDOW, moved, room, thing

BED = thing("Bed", 1.2, 1.0, (2.0, 1.4, 0.5))


def same(ones: Scene, others: Scene) -> None:
    """Are the outlines the same, and the doors and windows?"""
    for one, other in zip(ones.room.corners, others.room.corners, strict=True):
        assert one == pytest.approx(other, abs=1e-9)
    for kind in ("doors", "windows"):
        for one, other in zip(getattr(ones.room, kind), getattr(others.room, kind), strict=True):
            assert (*one.start, *one.end) == pytest.approx((*other.start, *other.end), abs=1e-9)


def test_walls_move_in_with_their_doors_and_windows_and_boxes_stay() -> None:
    found = drawn_in(room(BED, doors=(DOOR,), windows=(WINDOW,)), 0.1)
    door, window = Opening((1, 0.1), (1.8, 0.1)), Opening((2, 3.9), (3, 3.9))
    inner = ((0.1, 0.1), (4.9, 0.1), (4.9, 3.9), (0.1, 3.9))
    same(found, room(corners=inner, doors=(door,), windows=(window,)))
    assert found.boxes == (BED,)
    assert found.room.doors[0].top == DOOR.top


def test_an_inner_corner_moves_out_of_the_room_that_is_left() -> None:
    corners = ((0.1, 0.1), (5.9, 0.1), (5.9, 1.9), (2.9, 1.9), (2.9, 4.9), (0.1, 4.9))
    same(drawn_in(room(corners=L_SHAPE), 0.1), room(corners=corners))


def test_a_corner_on_a_straight_wall_moves_with_it() -> None:
    split = ((0, 0), (2, 0), (5, 0), (5, 4), (0, 4))
    corners = ((0.1, 0.1), (2, 0.1), (4.9, 0.1), (4.9, 3.9), (0.1, 3.9))
    same(drawn_in(room(corners=split), 0.1), room(corners=corners))


def test_a_turned_room_is_drawn_in_alike() -> None:
    scene = room(corners=L_SHAPE, doors=(DOOR,))
    same(drawn_in(moved(scene), 0.1), moved(drawn_in(scene, 0.1)))


def test_a_door_in_a_corner_is_no_longer_than_its_wall() -> None:
    found = drawn_in(room(doors=(Opening((0, 0), (0.9, 0)),)), 0.1)
    assert found.room.doors[0].start == pytest.approx((0.1, 0.1))
    assert found.room.doors[0].end == pytest.approx((0.9, 0.1))


def test_only_rooms_of_the_source_that_measures_so_are_drawn_in() -> None:
    flats = [Scene(room().room, (BED,), "a", source=s) for s in ("robot-at-virtualhome", "ithor")]
    (flat, other), _ = clean(flats)
    assert flat.room.corners[0] == pytest.approx((0.08, 0.08))
    assert other.room.corners[0] == (0, 0)
