"""Sentences and reasons, written by hand for hand-made situations."""

# ruff: noqa: E501 (a situation is a line of its table)

from __future__ import annotations

from math import pi

import pytest

from scenegen_core.graph.wording import metres, noun, spoken
from scenegen_core.placement.reasons import reason_text
from scenegen_core.placement.words import compass, sentence
from scenegen_core.scene.model import Box, Opening, Scene
from tests.core.placement.drawn import (
    L_SHAPE,
    NORTH,
    SOUTH,
    WEST,
    WINDOW,
    category,
    moved,
    moved_box,
    room,
    situation,
    thing,
)

CHAIR, SOFA, CUPBOARD = (0.5, 0.5, 0.9), (0.9, 2.0, 0.8), (0.4, 0.8, 1.8)
PICTURE, SCREEN, VASE = (0.04, 0.6, 0.5), (0.1, 1.0, 0.6), (0.2, 0.2, 0.3)
TABLE = thing("Table", 2.5, 2.0, (0.8, 1.4, 0.75), label="Dining table")
COFFEE = thing("Table", 2.5, 2.0, (0.6, 1.0, 0.4), label="CoffeeTable")
COUCH = thing("Sofa", 2.5, 3.5, SOFA, heading=SOUTH, label="Couch")
SIDEBOARD = thing("Storage", 2.5, 0.25, (0.5, 2.0, 0.8), heading=NORTH, label="Sideboard")
TELLY = thing("TV", 2.5, 0.06, SCREEN, heading=NORTH, bottom=0.8)
BED = thing("Bed", 1.0, 3.0, (2, 1.6, 0.5), label="double_bed")
TWO_WINDOWS = (WINDOW, Opening((5, 1), (5, 2), 0.9, 2.1, "second"))

SITUATIONS: list[tuple[Scene, Box, str]] = [
    # corners and walls
    (room(), thing("Storage", 0.25, 0.45, CUPBOARD), "In the south-west corner"),
    (room(), thing("Storage", 4.75, 3.55, CUPBOARD, heading=WEST), "In the north-east corner"),
    (room(), thing("Storage", 0.22, 2, CUPBOARD), "Against the west wall"),
    (room(), thing("Storage", 0.75, 2, CUPBOARD), "Near the west wall"),
    (room(), thing("Storage", 2.5, 2, CUPBOARD), "In the middle of the room"),
    (room(), thing("Storage", 3.6, 2.6, CUPBOARD), "Out in the room"),
    (room(), thing("Sofa", 2.5, 0.5, SOFA, heading=NORTH), "Against the south wall, facing north"),
    (
        room(corners=L_SHAPE),  # both walls of the inner corner are close, but it is no corner
        thing("Storage", 2.8, 1.8, (0.2, 0.2, 1), heading=WEST),
        "Against the north wall",
    ),
    (
        room(corners=L_SHAPE),
        thing("Storage", 5.78, 1.55, CUPBOARD, heading=WEST),
        "In the north-east corner",
    ),
    # windows
    (
        room(windows=(WINDOW,)),
        thing("Table", 2.5, 3.6, (0.7, 1, 0.7)),
        "Against the north wall by the window",
    ),
    (
        room(windows=TWO_WINDOWS),
        thing("Table", 4.0, 1.5, (0.7, 1, 0.7)),
        "Near the east wall by a window",
    ),
    (
        room(windows=(WINDOW,)),
        thing("Table", 0.8, 3.6, (0.7, 0.6, 0.7)),
        "Against the north wall",
    ),
    # distances
    (room(COUCH), thing("Table", 2.5, 1.45, (0.8, 1, 0.5)), "In the middle of the room, 1.1 m from the couch"),
    (room(COUCH), thing("Table", 2.5, 2.15, (0.8, 1, 0.5)), "In the middle of the room, 40 cm from the couch"),
    (room(COUCH), thing("Table", 2.5, 2.4, (0.8, 1, 0.5)), "In the middle of the room, next to the couch"),
    (room(COUCH), thing("Storage", 2.5, 0.22, CUPBOARD, heading=NORTH), "Against the south wall, 2.6 m from the couch"),
    (room(BED), thing("Storage", 4.78, 0.5, CUPBOARD, heading=WEST), "In the south-east corner, 2.9 m from the double bed"),
    (room(BED), thing("Table", 2.4, 3.5, (0.5, 0.5, 0.5)), "Against the north wall, next to the double bed"),
    # facing
    (room(TABLE), thing("Chair", 3.4, 2, CHAIR, heading=WEST), "Out in the room, facing the dining table"),
    (room(TABLE), thing("Chair", 3.0, 2, CHAIR, heading=WEST), "In the middle of the room, at the dining table, facing it"),
    (room(TABLE), thing("Chair", 3.0, 2, CHAIR), "In the middle of the room, at the dining table, facing east"),
    (room(COFFEE), thing("Sofa", 2.5, 3.5, SOFA, heading=SOUTH), "Against the north wall, facing the coffee table"),
    (room(COFFEE, TELLY), thing("Sofa", 2.5, 3.5, SOFA, heading=SOUTH), "Against the north wall, 60 cm from the coffee table, facing the TV"),
    (room(thing("Table", 1.2, 2, (1, 1, 0.7), box_id="a"), TABLE), thing("Chair", 3.6, 2, CHAIR, heading=WEST), "Out in the room, 1.7 m from the table, facing the dining table"),
    (
        room(thing("Table", 3.0, 3.0, (1, 1, 0.7), box_id="a"), thing("Table", 3.0, 1.0, (1, 1, 0.7), box_id="b")),
        thing("Chair", 3.0, 2.0, CHAIR, heading=SOUTH),
        "In the middle of the room, next to the table, facing another table",
    ),
    (room(), thing("Chair", 2.5, 2, CHAIR, heading=pi / 4), "In the middle of the room, facing north-east"),
    (room(COUCH), thing("TV", 2.5, 0.05, SCREEN, heading=NORTH, bottom=0.8), "On the south wall, facing the couch"),
    # on, above, under
    (room(SIDEBOARD, COUCH), thing("TV", 2.5, 0.25, SCREEN, heading=NORTH, bottom=0.8), "On the sideboard, facing the couch"),
    (room(TABLE), thing("Decor", 2.3, 2, VASE, bottom=0.75), "On the dining table"),
    (room(thing("Storage", 2.5, 2, (0.8, 1.4, 0.75))), thing("Decor", 2.3, 2, VASE, bottom=0.75), "On the storage piece"),
    (room(COUCH), thing("Picture", 2.5, 3.93, PICTURE, heading=SOUTH, bottom=1.2), "On the north wall, above the couch"),
    (room(COUCH), thing("Picture", 0.02, 3.7, PICTURE, bottom=1.2), "On the west wall, 1.5 m from the couch"),
    (room(), thing("Picture", 0.3, 3.98, PICTURE, heading=SOUTH, bottom=1.2), "On the north wall"),
    (room(TELLY), thing("Storage", 2.5, 0.25, (0.5, 1, 0.5), heading=NORTH), "Against the south wall, under the TV"),
    (room(COUCH), thing("Decor", 2.5, 3, (2, 3, 0.02)), "Against the north wall, under the couch"),
    # what nobody measures from
    (room(thing("Other", 3, 2, (0.4, 0.4, 1)), thing("Decor", 2, 2, VASE)), thing("Table", 2.5, 2.5, (0.4, 0.4, 0.4)), "In the middle of the room"),
    (room(thing("Chair", 3, 2, CHAIR)), thing("Chair", 3, 2.6, CHAIR, heading=NORTH), "In the middle of the room, facing north"),
]  # fmt: skip


@pytest.mark.parametrize(
    ("scene", "pose", "text"), SITUATIONS, ids=[text for _, _, text in SITUATIONS]
)
def test_a_sentence_says_where_something_stands(scene: Scene, pose: Box, text: str) -> None:
    assert sentence(situation(scene, pose), category(pose.category)) == text


def test_in_a_room_turned_by_a_quarter_the_walls_have_other_names() -> None:
    scene, pose = room(COUCH), thing("Storage", 0.22, 0.45, CUPBOARD)
    here = situation(moved(scene, pi / 2), moved_box(pose, pi / 2))
    assert sentence(here, category("Storage")) == "In the south-east corner, 2.5 m from the couch"


def test_in_a_room_turned_by_an_eighth_a_corner_points_to_a_side() -> None:
    pose = moved_box(thing("Storage", 0.22, 0.45, CUPBOARD), pi / 4)
    assert sentence(situation(moved(room(), pi / 4), pose), category("Storage")) == (
        "In the south corner"
    )


@pytest.mark.parametrize(
    ("heading", "side"),
    [(0, "east"), (0.3, "east"), (0.5, "north-east"), (pi / 2, "north"), (-pi, "west"),
     (pi, "west"), (-pi / 2, "south"), (-3 * pi / 4, "south-west"), (2 * pi, "east")],
)  # fmt: skip
def test_sides_are_named_as_on_a_map(heading: float, side: str) -> None:
    assert compass(heading) == side


@pytest.mark.parametrize(
    ("length", "text"),
    [(1.1, "1.1 m"), (0.4, "40 cm"), (0.44, "40 cm"), (0.94, "90 cm"), (0.96, "1.0 m"),
     (12.34, "12.3 m"), (0.08, "10 cm")],
)  # fmt: skip
def test_lengths_are_told_as_people_do(length: float, text: str) -> None:
    assert metres(length) == text


@pytest.mark.parametrize(
    ("label", "text"),
    [
        ("", "TV"),
        ("TV unit", "TV unit"),
        ("TVStand", "TV stand"),
        ("Flat_screen", "flat screen"),
        ("Samsung Q60", "samsung Q60"),
        ("LED lamp", "LED lamp"),
    ],
)
def test_things_are_called_by_their_labels(label: str, text: str) -> None:
    assert spoken(thing("TV", 0, 0, SCREEN, label=label)) == text


def test_a_category_is_a_noun() -> None:
    names = ["Bed", "Decor", "Storage", "Other", "TV", "KitchenIsland"]
    assert [noun(name) for name in names] == [
        "bed", "decor piece", "storage piece", "other thing", "TV", "kitchen island",
    ]  # fmt: skip


LAMP = thing("Other", 0, 0, VASE, label="Floor lamp")
PLAIN = thing("Other", 0, 0, VASE)
STOOL = thing("Chair", 0, 0, CHAIR)


@pytest.mark.parametrize(
    ("relation", "group", "value", "members", "text"),
    [
        ("RP", "", 0, [], "middle more than 1 m from any wall"),
        ("RP", "", 1, [], "middle within 1 m of 1 wall"),
        ("RP", "", 2, [], "middle within 1 m of 2 walls"),
        ("AD", "Chair", 1000, [], "no chair in the room"),
        ("AD", "Other", 1000, [], "no other thing in the room"),
        ("AD", "Chair", 1.13, [STOOL], "1.1 m from the chair"),
        ("AD", "Chair", 0.41, [STOOL, STOOL], "40 cm from the chairs"),
        ("AD", "Other", 0.8, [PLAIN, LAMP], "80 cm from the other things"),
        ("AD", "Other", 0.8, [LAMP], "80 cm from the floor lamp"),
        ("AD", "TV", 0.0, [thing("TV", 0, 0, SCREEN)], "right at the TV"),
        ("S", "Other", 2, [PLAIN, LAMP], "2 other things within 1 m"),
        ("S", "Storage", 1, [], "1 storage piece within 1 m"),
        ("S", "Bed", 0, [], "no bed within 1 m"),
        ("SP", "Table", 1, [TABLE], "stands on the dining table"),
        ("SP", "Table", -1, [TABLE, COFFEE], "is under one of the tables"),
        ("SP", "Table", 0, [TABLE], "neither on nor under a table"),
        ("TC", "", 1, [], "faces into the room"),
        ("TC", "", 0, [], "faces a near wall"),
        ("AW", "", 1, [], "has its back to the wall"),
        ("AW", "", 0, [], "no wall right behind it"),
        ("DS", "same", 1, [], "1 neighbor faces the same way"),
        ("DS", "opposite", 3, [], "3 neighbors face the opposite way"),
        ("DS", "same", 0, [], "no neighbor faces the same way"),
        ("F", "TV", 1, [thing("TV", 0, 0, SCREEN)], "faces the TV"),
        ("F", "Chair", 2, [STOOL, STOOL], "faces 2 chairs"),
        ("F", "Sofa", 0, [COUCH], "faces no sofa close by"),
        ("NT", "Chair", 1, [STOOL, STOOL], "next to one of the chairs"),
        ("NT", "Decor", 0, [], "no decor piece at its side"),
    ],
)
def test_a_reason_says_what_its_number_means(
    relation: str, group: str, value: float, members: list[Box], text: str
) -> None:
    assert reason_text(relation, group, {"": value}, members) == text


def test_sentences_do_not_depend_on_where_the_scene_lies() -> None:
    for scene, pose, text in SITUATIONS:
        there = situation(moved(scene, 0, (3.3, -8.1)), moved_box(pose, 0, (3.3, -8.1)))
        assert sentence(there, category(pose.category)) == text
