"""What our own relations say of poses in hand-drawn rooms of 5 m by 4 m, written by hand."""

# ruff: noqa: E501 (a situation is a line of its table)

from __future__ import annotations

from math import pi

import pytest

from scenegen_core.graph.own_relations import OWN_RELATIONS
from scenegen_core.graph.relations import columns, measure
from scenegen_core.placement.reasons import reason_text
from scenegen_core.scene.model import PAPER_CATEGORIES, Box, Scene, Symmetry
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

SOFA, CHAIR, TABLE = (1.0, 2.0, 0.8), (0.5, 0.5, 0.9), (0.8, 1.4, 0.75)
TELLY = thing("TV", 2.5, 0.1, (0.2, 1.0, 0.6), heading=NORTH)
LOW = thing("Table", 2.5, 2.0, (0.6, 1.0, 0.4), label="CoffeeTable")
CHAIRS = (thing("Chair", 1.0, 1.0, CHAIR, box_id="a"), thing("Chair", 4.0, 3.0, CHAIR, box_id="b"))


def sofa(y: float, *, x: float = 2.5, heading: float = SOUTH) -> Box:
    return thing("Sofa", x, y, SOFA, heading=heading)


def table(x: float, y: float) -> Box:
    return thing("Table", x, y, TABLE)


def says(scene: Scene, pose: Box, relation: str, group: str = "") -> str:
    seen = measure(OWN_RELATIONS, situation(scene, pose))[0].tolist()
    named = columns(OWN_RELATIONS, PAPER_CATEGORIES)
    about = {
        column.part: value
        for column, value in zip(named, seen, strict=True)
        if (column.relation, column.group) == (relation, group)
    }
    members = [box for box in scene.boxes if box.category == group]
    fronted = category(pose.category).symmetry is not Symmetry.SYMMETRIC
    return reason_text(relation, group, about, members, fronted=fronted)


WALLS: list[tuple[Box, str]] = [
    (sofa(3.45), "its back against a wall"),  # 4 − 3.45 − 0.5 = 5 cm
    (sofa(3.3), "its back close to a wall"),  # 20 cm
    (sofa(3.45, heading=NORTH), "its front against a wall"),
    (sofa(2.95, heading=0.0), "its side against a wall"),
    (sofa(2.8), "70 cm from the nearest wall"),
    (sofa(3.45, x=1.05), "in a corner"),
    (table(0.45, 2.0), "against a wall"),
    (table(0.65, 2.0), "close to a wall"),
]


@pytest.mark.parametrize(("pose", "text"), WALLS)
def test_walls_are_told_by_what_is_turned_to_them(pose: Box, text: str) -> None:
    assert says(room(), pose, "W") == text


NEIGHBORS: list[tuple[Scene, Box, str, str]] = [
    (room(TELLY), sofa(3.0), "TV", "2.3 m in front of the TV, facing it"),  # 2.5 − 0.2
    (room(TELLY), sofa(3.0, heading=NORTH), "TV", "2.3 m in front of the TV, its back to it"),
    (room(TELLY), sofa(3.0, heading=0.0), "TV", "1.8 m in front of the TV"),  # its side is longer
    (room(LOW), sofa(3.3), "Table", "30 cm from the coffee table, facing it"),
    (room(LOW), thing("Chair", 3.07, 2.0, CHAIR, heading=WEST), "Table", "right at the coffee table, facing it"),
    (room(LOW), thing("Decor", 2.5, 2.0, (0.2, 0.2, 0.3), bottom=0.4), "Table", "on the coffee table"),
    (room(*CHAIRS), table(1.0, 2.25), "Chair", "30 cm from the nearest chair"),
    (room(), sofa(3.0), "Bed", "no bed in the room"),
]  # fmt: skip


@pytest.mark.parametrize(("scene", "pose", "group", "text"), NEIGHBORS)
def test_a_neighbor_is_told_by_how_near_it_is_and_who_faces_whom(
    scene: Scene, pose: Box, group: str, text: str
) -> None:
    assert says(scene, pose, "N", group) == text


OTHERS: list[tuple[Scene, Box, str, str]] = [
    (room(LOW), sofa(3.3), "FS", "30 cm free in front"),
    (room(), sofa(3.45), "FS", "3.0 m free in front"),
    (room(LOW), table(1.4, 2.0), "FS", "1 thing within 1 m"),
    (room(LOW), table(0.5, 0.75), "FS", "nothing within 1 m"),
    (room(), sofa(2.0), "M", "in the middle of the room"),
    (room(), sofa(3.45), "M", "away from the middle of the room, facing it"),
    (room(), sofa(3.45, heading=NORTH), "M", "away from the middle of the room, its back to it"),
    (room(), table(0.45, 0.75), "M", "away from the middle of the room"),
    (room(doors=(DOOR,)), table(1.4, 1.9), "DR", "1.2 m from a door"),
    (room(windows=(WINDOW,)), sofa(3.0, heading=NORTH), "WN", "50 cm from a window, facing it"),
    (room(windows=(WINDOW,)), sofa(3.49), "WN", "at a window, its back to it"),
    (room(), sofa(3.0), "DR", "no door in the room"),
    (room(), sofa(3.0), "H", "on the floor"),
    (room(), thing("Picture", 2.5, 3.98, (0.04, 0.6, 0.5), heading=SOUTH, bottom=1.3), "H", "1.3 m above the floor"),
    (room(*CHAIRS), thing("Chair", 2.0, 1.0, CHAIR), "TW", "50 cm from another just like it"),
    (room(*CHAIRS), thing("Chair", 1.55, 1.0, CHAIR), "TW", "side by side with another just like it"),
    (room(), thing("Chair", 1.6, 1.0, CHAIR), "TW", "no other just like it"),
    (room(LOW, thing("Chair", 1.9, 2.0, CHAIR)), thing("Chair", 3.1, 2.0, CHAIR, heading=pi), "MI", "makes a pair"),
    (room(LOW, thing("Chair", 1.9, 2.0, CHAIR)), thing("Chair", 4.5, 3.5, CHAIR), "MI", "makes no pair"),
    (room(), thing("Chair", 4.5, 3.5, CHAIR), "MI", "nothing to make a pair with"),
]  # fmt: skip


@pytest.mark.parametrize(("scene", "pose", "relation", "text"), OTHERS)
def test_the_other_relations_say_what_one_would_measure(
    scene: Scene, pose: Box, relation: str, text: str
) -> None:
    assert says(scene, pose, relation) == text
