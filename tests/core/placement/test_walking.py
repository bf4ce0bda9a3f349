"""Can people still walk? Corridors, seats, two doors, no doors."""

from __future__ import annotations

import pytest

from scenegen_core.graph.surroundings import Surroundings
from scenegen_core.placement.walking import Walking
from scenegen_core.scene.model import PAPER_CATEGORIES, Box, Opening, Point, Scene
from tests.core.placement.drawn import (
    DOOR,
    NORTH,
    SOUTH,
    WEST,
    moved,
    moved_box,
    room,
    thing,
)

CORRIDOR: tuple[Point, ...] = ((0, 0), (8, 0), (8, 1.5), (0, 1.5))
WEST_DOOR = Opening((0, 1.2), (0, 0.3), 0, 2, "west")
EAST_DOOR = Opening((8, 0.3), (8, 1.2), 0, 2, "east")
BED = thing("Bed", 6.5, 0.5, (2, 1, 0.5))


def wardrobe(x: float, depth: float) -> Box:
    """A wardrobe of that depth at the north wall of the corridor."""
    return thing("Storage", x, 1.5 - depth / 2, (depth, 1.0, 2.0), heading=SOUTH)


def counter(x: float) -> Box:
    """A table across the corridor, reached from either side."""
    return thing("Table", x, 0.75, (0.4, 1.5, 0.9))


def blocked_by(scene: Scene, box: Box) -> str | None:
    """What the box closes the way to."""
    return Walking(Surroundings(scene, PAPER_CATEGORIES)).blocked_by(box)


ONE_DOOR = room(BED, corners=CORRIDOR, doors=(WEST_DOOR,))
TWO_DOORS = room(corners=CORRIDOR, doors=(WEST_DOOR, EAST_DOOR))
NO_DOORS = room(BED, corners=CORRIDOR)
DESK = thing("Table", 4.5, 2, (0.8, 4.0, 0.75), label="Long desk")
CASES: dict[str, tuple[Scene, Box, str | None]] = {
    "a corridor of 1.5 m keeps 90 cm": (ONE_DOOR, wardrobe(3, 0.6), None),
    "a corridor of 1.5 m keeps 40 cm": (ONE_DOOR, wardrobe(3, 1.1), "the bed"),
    "two doors that a wardrobe parts": (TWO_DOORS, wardrobe(4, 1.1), "the door"),
    "two doors that a narrow one does not": (TWO_DOORS, wardrobe(4, 0.6), None),
    # without doors the larger part stays: the bed is in it or not
    "no doors, the bed in the larger part": (NO_DOORS, counter(1.5), None),
    "no doors, the bed cut off": (
        room(thing("Bed", 6.8, 0.5, (2, 1, 0.5)), corners=CORRIDOR),
        counter(5.2),
        "the bed",
    ),
    "a table from wall to wall before a seat": (
        room(thing("Sofa", 4.5, 3.5, (0.9, 2.0, 0.8), heading=SOUTH, label="Couch"), doors=(DOOR,)),
        thing("Table", 2.5, 2.2, (0.8, 5.0, 0.75), heading=NORTH),
        "the couch",
    ),
    "a seat that nobody reached before": (
        room(
            DESK, thing("Chair", 4.95, 2, (0.1, 0.1, 0.9)), doors=(DOOR,)
        ),  # the desk leaves 10 cm behind it
        thing("Table", 2.5, 3.5, (0.8, 0.8, 0.75)),
        None,
    ),
    "a thing that nobody can get at": (
        room(thing("Table", 2.5, 2.2, (0.8, 5.0, 0.75), heading=NORTH), doors=(DOOR,)),
        thing("Chair", 2.5, 3.7, (0.5, 0.5, 0.9), label="Stool"),
        "the stool itself",
    ),
    "a table before the doors of a cupboard": (
        room(thing("Storage", 0.3, 2, (0.6, 1.0, 2.0)), doors=(DOOR,)),
        thing("Table", 1.1, 2, (0.8, 3.0, 0.75)),
        "the storage piece",
    ),
    "a table behind a cupboard": (
        room(thing("Storage", 2.5, 2, (0.6, 1.0, 2.0)), doors=(DOOR,)),
        thing("Table", 1.8, 2, (0.8, 1.0, 0.75)),
        None,
    ),
    "a cupboard with its doors to the wall": (
        room(doors=(DOOR,)),
        thing("Storage", 0.35, 2, (0.6, 1.0, 2.0), heading=WEST),
        "the storage piece itself",
    ),
    "a rug from wall to wall": (ONE_DOOR, thing("Decor", 3, 0.75, (1.4, 1.4, 0.02)), None),
    "a lamp that hangs high": (
        ONE_DOOR,
        thing("Decor", 3, 0.75, (1.4, 1.4, 0.5), bottom=1.9),
        None,
    ),
    "a beam across at knee height": (
        ONE_DOOR,
        thing("Decor", 3, 0.75, (0.2, 1.5, 0.2), bottom=0.4),
        "the bed",
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_what_could_no_longer_be_reached_is_named(name: str) -> None:
    scene, box, closed = CASES[name]
    assert blocked_by(scene, box) == closed


@pytest.mark.parametrize("name", CASES)
def test_a_turned_and_moved_room_is_walked_alike(name: str) -> None:
    scene, box, closed = CASES[name]
    assert blocked_by(moved(scene), moved_box(box)) == closed


def test_what_is_reached_is_every_door_seat_bed_and_storage_front() -> None:
    scene = room(
        thing("Sofa", 0.5, 3, (0.9, 1.5, 0.8), label="Sofa"),
        thing("Storage", 4.6, 3, (0.6, 1.0, 2.0), heading=WEST, label="Bookcase"),
        thing("Storage", 2.5, 3.85, (0.3, 1.0, 0.5), heading=SOUTH, bottom=1.4, box_id="shelf"),
        thing("Table", 2.5, 2, (0.8, 0.8, 0.7)),
        thing("Decor", 4.5, 0.5, (0.3, 0.3, 1.2)),
        doors=(DOOR, Opening((4, 0), (3.2, 0), 0, 2, "other")),
    )
    targets = Walking(Surroundings(scene, PAPER_CATEGORIES)).targets
    assert [target.name for target in targets] == [
        "the door",
        "the door",
        "the sofa",
        "the bookcase",
    ]


def test_a_door_that_is_shut_off_already_asks_for_nothing() -> None:
    crate = thing("Other", 0.6, 0.75, (1.2, 1.5, 1.0))  # right behind the western door
    scene = room(BED, crate, corners=CORRIDOR, doors=(WEST_DOOR, EAST_DOOR))
    assert blocked_by(scene, counter(3)) is None


def test_a_bed_that_each_of_two_doors_led_to_still_has_to_be_reached_from_both() -> None:
    scene = room(BED, corners=CORRIDOR, doors=(WEST_DOOR, EAST_DOOR))
    assert blocked_by(scene, counter(3)) == "the door"
