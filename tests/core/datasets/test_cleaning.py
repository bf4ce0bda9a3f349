"""The paper's reductions, on rooms drawn for the purpose."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import pytest

from scenegen_core.datasets.cleaning import clean
from scenegen_core.scene.model import Box, Room, Scene

SQUARE = ((0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0))
BED = Box("bed", "Bed", (2.0, 2.0, 0.3), (2.0, 1.6, 0.6))


def scene(*boxes: Box, room_type: str = "bedroom", side: float = 4.0) -> Scene:
    corners = tuple((x * side / 4, y * side / 4) for x, y in SQUARE)
    return Scene(Room(corners, room_type=room_type), boxes)


@pytest.mark.parametrize(
    "word",
    [
        "bedroom", "Bedroom", "LivingRoom", "Livingroom", "living_room", "LivingRoom/Kitchen",
        "LivingRoomKitchen", "office large", "TV room", "DiningRoom",
    ],
)  # fmt: skip
def test_the_room_types_of_the_paper_are_kept_however_they_are_spelled(word: str) -> None:
    kept, reductions = clean([scene(BED, room_type=word)])
    assert len(kept) == 1
    assert reductions.other_room_types == 0


@pytest.mark.parametrize("word", ["Bathroom", "Corridor", "Balcony", "garage", "unnamed"])
def test_other_room_types_are_taken_out_and_counted(word: str) -> None:
    kept, reductions = clean([scene(BED, room_type=word), scene(BED)])
    assert len(kept) == 1
    assert (reductions.other_room_types, reductions.rooms, reductions.boxes) == (1, 1, 1)


def test_the_set_of_room_types_can_be_chosen() -> None:
    kept, _ = clean([scene(BED, room_type="atrium"), scene(BED)], room_types=["Atrium"])
    assert [one.room.room_type for one in kept] == ["atrium"]


def test_rooms_of_outlier_areas_are_taken_out_and_counted() -> None:
    small, usual, large = scene(side=1.5), scene(BED), scene(BED, side=11)
    kept, reductions = clean([small, usual, large])
    assert kept == (usual,)
    assert reductions.outlier_areas == 2
    wide, _ = clean([usual, large], areas=(0, 200))
    assert wide == (usual, large)


def test_boxes_without_depth_width_or_height_are_taken_out_and_counted() -> None:
    flat = [replace(BED, id=str(i), size=size) for i, size in enumerate(
        [(0.0, 1.6, 0.6), (2.0, 0.0, 0.6), (2.0, 1.6, 0.0)])]  # fmt: skip
    (kept,), reductions = clean([scene(BED, *flat)])
    assert kept.boxes == (BED,)
    assert reductions.thin_boxes == 3


def test_boxes_more_than_half_outside_are_taken_out_and_counted() -> None:
    nearly = replace(BED, id="nearly", center=(3.9, 2.0, 0.3))
    outside = replace(BED, id="outside", center=(4.2, 2.0, 0.3))
    (kept,), reductions = clean([scene(nearly, outside)])
    assert kept.boxes == (nearly,)
    assert reductions.outside_boxes == 1


def test_the_heading_counts_when_a_box_is_tried_against_the_walls() -> None:
    # a plank of 8.6 m: 4.2 m of it fit straight between the walls, 5.9 m along the diagonal
    straight = Box("straight", "Table", (2.0, 2.0, 0.5), (8.6, 0.1, 1.0))
    diagonal = replace(straight, id="diagonal", heading=pi / 4)
    (kept,), _ = clean([scene(straight, diagonal)])
    assert kept.boxes == (diagonal,)


def test_a_picture_in_the_thickness_of_the_wall_is_kept() -> None:
    picture = Box("p", "Picture", (4.03, 2.0, 1.5), (0.04, 0.6, 0.5), heading=pi)
    (kept,), reductions = clean([scene(picture)])
    assert kept.boxes == (picture,)
    assert reductions.outside_boxes == 0


def test_rooms_in_which_nothing_is_left_are_taken_out_and_counted() -> None:
    kept, reductions = clean([scene(), scene(replace(BED, size=(0.0, 0.0, 0.0)))])
    assert kept == ()
    assert (reductions.empty_rooms, reductions.rooms, reductions.boxes) == (2, 0, 0)


def test_a_room_whose_floor_is_not_at_zero_is_put_on_it_with_all_that_is_in_it() -> None:
    # the bed and the chair stand 0.1 m up, the table on a podium; the picture hangs as high above
    raised = [
        replace(BED, center=(2.0, 2.0, 0.4)),
        Box("chair", "Chair", (1.0, 1.0, 0.6), (0.5, 0.5, 1.0)),
        Box("table", "Table", (3.0, 3.0, 1.5), (0.5, 0.5, 1.0)),
        Box("picture", "Picture", (3.98, 2.0, 1.6), (0.04, 0.6, 0.5)),
    ]
    (kept,), reductions = clean([scene(*raised)])
    assert reductions.uneven_floors == 1
    assert [box.bottom for box in kept.boxes] == pytest.approx([0, 0, 0.9, 1.25])


def test_a_floor_that_is_nearly_at_zero_or_unknown_is_left_alone() -> None:
    nearly = scene(replace(BED, center=(2.0, 2.0, 0.31)))
    hanging = scene(Box("p", "Picture", (3.98, 2.0, 0.4), (0.04, 0.6, 0.5)))
    kept, reductions = clean([nearly, hanging])
    assert kept == (nearly, hanging)
    assert reductions.uneven_floors == 0


def test_rooms_whose_type_nobody_says_are_kept() -> None:
    kept, reductions = clean([scene(BED, room_type=""), scene(BED)])
    assert len(kept) == 2
    assert reductions.other_room_types == 0
