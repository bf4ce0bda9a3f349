"""The values of the scene: an edit returns a new one, and the old one stays."""

from __future__ import annotations

from dataclasses import FrozenInstanceError

import pytest

from scenegen_core.errors import SceneError
from scenegen_core.scene.model import OTHER, PAPER_CATEGORIES, Box, Room, Scene, Symmetry

ROOM = Room(((0, 0), (4, 0), (4, 3), (0, 3)))
BED = Box("bed", "Bed", (1, 1, 0.3), (2, 1.4, 0.6))
LAMP = Box("lamp", "Decor", (3, 2, 0.8), (0.3, 0.3, 1.6))


def test_a_box_reaches_from_half_its_height_below_its_center_to_half_above() -> None:
    shelf = Box("shelf", "Storage", (0, 0, 1.5), (0.3, 1.0, 0.4))
    assert (shelf.bottom, shelf.top) == pytest.approx((1.3, 1.7))


def test_walls_join_each_corner_to_the_next_and_the_last_to_the_first() -> None:
    assert ROOM.walls == (
        ((0, 0), (4, 0)),
        ((4, 0), (4, 3)),
        ((4, 3), (0, 3)),
        ((0, 3), (0, 0)),
    )


def test_a_box_is_found_by_its_id() -> None:
    scene = Scene(ROOM, (BED, LAMP))
    assert scene["lamp"] is LAMP
    assert "bed" in scene
    assert "sofa" not in scene


def test_a_box_that_is_not_there_is_an_error_that_names_it() -> None:
    with pytest.raises(SceneError, match="no box 'sofa'"):
        Scene(ROOM, (BED,))["sofa"]


def test_two_boxes_of_one_id_are_an_error_that_names_it() -> None:
    with pytest.raises(SceneError, match="Two boxes have the id 'bed'"):
        Scene(ROOM, (BED, LAMP, BED))


def test_taking_a_box_away_leaves_the_old_scene_as_it_was() -> None:
    scene = Scene(ROOM, (BED, LAMP), id="here")
    assert scene.without("bed") == Scene(ROOM, (LAMP,), id="here")
    assert scene.boxes == (BED, LAMP)


def test_taking_away_what_is_not_there_changes_nothing() -> None:
    assert Scene(ROOM, (BED,)).without("sofa") == Scene(ROOM, (BED,))


def test_a_new_box_comes_last_and_a_moved_one_keeps_its_place() -> None:
    scene = Scene(ROOM, (BED,)).with_box(LAMP)
    assert scene.boxes == (BED, LAMP)
    moved = Box("bed", "Bed", (2, 2, 0.3), (2, 1.4, 0.6))
    assert scene.with_box(moved).boxes == (moved, LAMP)
    assert scene.with_box(moved)["bed"] is moved


def test_another_room_goes_round_the_same_boxes() -> None:
    other = Room(((0, 0), (9, 0), (9, 9)))
    assert Scene(ROOM, (BED,)).with_room(other) == Scene(other, (BED,))


def test_values_cannot_be_changed() -> None:
    with pytest.raises(FrozenInstanceError):
        BED.heading = 1.0  # type: ignore[misc]
    with pytest.raises(FrozenInstanceError):
        ROOM.height = 1.0  # type: ignore[misc]


def test_the_nine_groups_are_sorted_by_symmetry_as_in_the_paper() -> None:
    def named(symmetry: Symmetry) -> set[str]:
        return {
            category.name
            for category in PAPER_CATEGORIES
            if category.symmetry is symmetry and category.name != OTHER
        }

    assert named(Symmetry.ASYMMETRIC) == {"Bed", "Chair", "Sofa", "TV"}
    assert named(Symmetry.SYMMETRIC) == {"Decor", "Table"}
    assert named(Symmetry.INSIDE_FACING) == {"Picture", "Storage"}
    assert len(PAPER_CATEGORIES) == 9
