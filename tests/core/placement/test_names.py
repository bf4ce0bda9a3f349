"""Names of places, written by hand for hand-drawn rooms of 5 m by 4 m."""

# ruff: noqa: E501 (a situation is a line of its table)

from __future__ import annotations

from itertools import pairwise
from math import pi

import pytest

from scenegen_core.placement.names import names
from scenegen_core.scene.model import Box, Scene
from tests.core.placement.drawn import (
    DOOR,
    NORTH,
    SOUTH,
    WEST,
    WINDOW,
    category,
    room,
    situation,
    thing,
)

SOFA, CUPBOARD, CHAIR = (0.9, 2.0, 0.8), (0.4, 0.8, 1.8), (0.5, 0.5, 0.9)
PICTURE, VASE = (0.04, 0.6, 0.5), (0.2, 0.2, 0.3)
TELLY = thing("TV", 2.5, 0.06, (0.1, 1.0, 0.6), heading=NORTH, bottom=0.8)
BED = thing("Bed", 1.0, 1.0, (2, 1.6, 0.5), label="double_bed")
TABLE = thing("Table", 2.5, 2.0, (0.8, 1.4, 0.75))


def cupboard(x: float, y: float, heading: float = 0.0) -> Box:
    return thing("Storage", x, y, CUPBOARD, heading=heading)


def named(scene: Scene, *poses: Box) -> tuple[str, ...]:
    return names(situation(scene, *poses), category(poses[0].category))


def test_each_place_goes_by_what_it_alone_has() -> None:
    scene = room(BED, doors=(DOOR,), windows=(WINDOW,))
    assert named(
        scene,
        cupboard(2.5, 3.7, SOUTH),
        cupboard(4.7, 3.5, WEST),
        cupboard(2.3, 1.0),
        cupboard(0.25, 3.0),
    ) == ("by the window", "in the north-east corner", "next to the double bed", "at the west wall")


def test_what_looks_back_is_opposite_and_what_does_not_is_faced() -> None:
    away = thing("TV", 2.5, 0.06, (0.1, 1.0, 0.6), heading=SOUTH, bottom=0.8)
    sofa = thing("Sofa", 2.5, 3.5, SOFA, heading=SOUTH)
    assert named(room(TELLY), sofa) == ("opposite the TV",)
    assert named(room(away), sofa) == ("facing the TV",)
    assert named(room(TABLE), sofa) == ("facing the table",)


def test_two_facts_name_what_shares_each_of_them_with_another() -> None:
    """Two by the window, two that face west: only one does both."""
    poses = [
        thing("Chair", 2.2, 3.6, CHAIR, heading=WEST),
        thing("Chair", 2.8, 3.6, CHAIR, heading=SOUTH),
        thing("Chair", 4.6, 0.4, CHAIR, heading=WEST),
    ]
    assert named(room(windows=(WINDOW,)), *poses) == (
        "by the window, facing west",
        "facing south",
        "in the south-east corner",
    )


def test_places_of_the_same_facts_are_told_by_their_side() -> None:
    low, high = cupboard(0.25, 1.6), cupboard(0.25, 2.6)
    assert named(room(), low, high) == (
        "at the west wall, further south",
        "at the west wall, further north",
    )
    middle = cupboard(0.25, 2.1)
    assert named(room(), high, low, middle) == (
        "at the west wall, furthest north",
        "at the west wall, furthest south",
        "at the west wall, second from the south",
    )


def test_of_several_alike_none_is_the_one() -> None:
    chairs = [thing("Chair", x, 2.0, CHAIR, box_id=f"{x}") for x in (1.0, 4.0)]
    assert named(room(*chairs), cupboard(1.5, 2.0)) == ("next to a chair",)


@pytest.mark.parametrize(
    ("scene", "pose", "name"),
    [
        (room(TABLE), thing("Decor", 2.5, 2.0, VASE, bottom=0.75), "on the table"),
        (room(), thing("Picture", 2.5, 3.98, PICTURE, heading=SOUTH, bottom=1.4), "on the north wall"),
        (room(doors=(DOOR,)), cupboard(2.6, 0.5, NORTH), "by the door"),
        (room(), cupboard(2.5, 2.0), "in the middle"),
        (room(), cupboard(3.6, 2.6), "out in the room"),
        (room(), cupboard(0.75, 2.0), "near the west wall"),
        (room(BED), thing("Picture", 1.0, 0.02, PICTURE, heading=NORTH, bottom=1.4), "above the double bed"),
    ],
)  # fmt: skip
def test_a_place_alone_goes_by_the_most_telling_fact(scene: Scene, pose: Box, name: str) -> None:
    assert named(scene, pose) == (name,)


def test_five_places_in_a_row_all_have_different_names() -> None:
    row = named(room(), *(cupboard(x, 3.75, SOUTH) for x in (1.0, 1.7, 2.4, 3.1, 3.8)))
    assert len(set(row)) == 5
    assert all(one != other for one, other in pairwise(row))


def test_nothing_depends_on_full_turns() -> None:
    sofa = [thing("Sofa", 2.5, 3.5, SOFA, heading=SOUTH + turn) for turn in (0, 2 * pi)]
    assert len({named(room(TELLY), one) for one in sofa}) == 1
