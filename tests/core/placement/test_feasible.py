"""May it stand there? Every rule in hand-drawn rooms, straight, turned and moved."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import pytest

from scenegen_core.placement.feasible import ALLOWED, RULES, Space, verdicts
from scenegen_core.scene.model import Box, Opening, Scene
from tests.core.placement.drawn import (
    DOOR,
    L_SHAPE,
    NORTH,
    SOUTH,
    WEST,
    WINDOW,
    moved,
    moved_box,
    room,
    situation,
    thing,
)

CUBE = (1.0, 1.0, 1.0)
SIDEBOARD = thing("Storage", 2.5, 0.25, (0.5, 2.0, 0.8), heading=NORTH)
TABLE = thing("Table", 2.5, 2.0, (1.0, 1.6, 0.75))
RUG = thing("Other", 2.5, 2.0, (3.0, 2.0, 0.02))
LAMP = thing("Other", 2.5, 2.0, (0.4, 0.4, 0.5), bottom=2.0)
SCREEN = (0.1, 1.0, 0.6)
PICTURE = (0.04, 0.6, 0.5)
CHAIR = (0.5, 0.5, 0.9)

CASES: dict[str, tuple[Scene, Box, str]] = {
    # the room
    "in the middle": (room(), thing("Storage", 2.5, 2, CUBE), ""),
    "flush in a corner": (room(), thing("Storage", 0.5, 0.5, CUBE), ""),
    "1 mm into the wall, as outlines err": (room(), thing("Storage", 0.499, 2, CUBE), ""),
    "4 mm into the wall": (room(), thing("Storage", 0.496, 2, CUBE), "room"),
    "2 cm into the wall": (room(), thing("Storage", 0.48, 2, CUBE), "room"),
    "half outside": (room(), thing("Storage", 5, 2, CUBE), "room"),
    "far outside": (room(), thing("Storage", 9, 2, CUBE), "room"),
    "through the room from wall to wall": (
        room(),
        thing("Storage", 2.5, 2, (6, 1, 1)),
        "room",
    ),
    "larger than the room": (room(), thing("Storage", 2.5, 2, (9, 9, 1)), "room"),
    "a corner through the wall when turned": (
        room(),  # half the diagonal of the cube is 0.707
        thing("Storage", 0.65, 2, CUBE, heading=pi / 4),
        "room",
    ),
    "turned, and the corner just free": (
        room(),
        thing("Storage", 0.71, 2, CUBE, heading=pi / 4),
        "",
    ),
    "through the inner corner of an L": (
        room(corners=L_SHAPE),
        thing("Storage", 2.6, 1.6, CUBE),
        "room",
    ),
    "beside the inner corner of an L": (
        room(corners=L_SHAPE),
        thing("Storage", 2.5, 2.4, CUBE),
        "",
    ),
    "in the notch of an L": (room(corners=L_SHAPE), thing("Storage", 4.5, 3.5, CUBE), "room"),
    "right under the ceiling": (room(), thing("Storage", 2.5, 2, (1, 1, 2.6)), ""),
    "higher than the room": (room(), thing("Storage", 2.5, 2, (1, 1, 2.8)), "room"),
    "below the floor": (room(), thing("Storage", 2.5, 2, CUBE, bottom=-0.2), "room"),
    # what carries it
    "a cupboard in the air": (room(), thing("Storage", 2.5, 2, CUBE, bottom=0.5), "mount"),
    "a bed on a table": (room(TABLE), thing("Bed", 2.5, 2, CUBE, bottom=0.75), "mount"),
    "a picture that hangs": (
        room(),
        thing("Picture", 0.02, 2, PICTURE, bottom=1.3),
        "",
    ),
    "a picture that hangs in a corner": (
        room(),
        thing("Picture", 0.02, 0.3, PICTURE, bottom=1.3),
        "",
    ),
    "a picture on the floor": (room(), thing("Picture", 0.02, 2, PICTURE), "mount"),
    "a picture in mid-air": (room(), thing("Picture", 2.5, 2, PICTURE, bottom=1.3), "mount"),
    "a picture that faces its wall": (
        room(),
        thing("Picture", 0.02, 2, PICTURE, heading=WEST, bottom=1.3),
        "mount",
    ),
    "a picture edge-on to its wall": (
        room(),
        thing("Picture", 0.3, 2, PICTURE, heading=NORTH, bottom=1.3),
        "mount",
    ),
    "a TV on a sideboard": (
        room(SIDEBOARD),
        thing("TV", 2.5, 0.25, SCREEN, heading=NORTH, bottom=0.8),
        "",
    ),
    "a TV on a table": (
        room(TABLE),
        thing("TV", 2.5, 2, SCREEN, heading=NORTH, bottom=0.75),
        "",
    ),
    "a flat TV on a wall": (room(), thing("TV", 0.05, 2, SCREEN, bottom=0.8), ""),
    "a deep TV on a wall": (room(), thing("TV", 0.3, 2, (0.6, 0.7, 0.6), bottom=0.8), "mount"),
    "a TV on the floor": (room(), thing("TV", 0.05, 2, SCREEN), "mount"),
    "a TV with a foot of its own": (room(), thing("TV", 1, 2, (0.4, 1.0, 1.2)), ""),
    "a TV that sticks out over a sideboard": (
        room(SIDEBOARD),  # which ends at x = 3.5; the TV reaches to 3.9
        thing("TV", 3.4, 0.25, SCREEN, heading=NORTH, bottom=0.8),
        "mount",
    ),
    "a TV that sticks out by 10 cm": (
        room(SIDEBOARD),
        thing("TV", 3.1, 0.25, SCREEN, heading=NORTH, bottom=0.8),
        "",
    ),
    "a vase on a table": (
        room(TABLE),
        thing("Decor", 2.2, 1.8, (0.2, 0.2, 0.3), bottom=0.75),
        "",
    ),
    "a vase on the floor": (room(), thing("Decor", 2.2, 1.8, (0.2, 0.2, 0.3)), ""),
    "a vase on a chair": (
        room(thing("Chair", 2.2, 1.8, CHAIR)),
        thing("Decor", 2.2, 1.8, (0.2, 0.2, 0.3), bottom=0.9),
        "mount",
    ),
    "a tall plant on a table": (
        room(TABLE),
        thing("Decor", 2.2, 1.8, (0.4, 0.4, 1.2), bottom=0.75),
        "mount",
    ),
    # other things
    "in a table": (room(TABLE), thing("Storage", 2.5, 2, CUBE), "collision"),
    "beside a table": (room(TABLE), thing("Storage", 3.5, 2, CUBE), ""),
    "1 cm into a table": (room(TABLE), thing("Storage", 3.49, 2, CUBE), "collision"),
    "on a rug": (room(RUG), thing("Storage", 2.5, 2, CUBE), ""),
    "a rug under a table": (room(TABLE), thing("Decor", 2.5, 2, (2, 2, 0.02)), ""),
    "a rug through a wall": (room(TABLE), thing("Decor", 4.5, 2, (2, 2, 0.02)), "room"),
    "under a hanging lamp": (room(LAMP), thing("Storage", 2.5, 2, CUBE), ""),
    "into a hanging lamp": (
        room(LAMP),
        thing("Storage", 2.5, 2, (1, 1, 2.2)),
        "collision",
    ),
    "a picture above a sideboard": (
        room(SIDEBOARD),
        thing("Picture", 2.5, 0.02, PICTURE, heading=NORTH, bottom=1.3),
        "",
    ),
    "a picture behind a wardrobe": (
        room(thing("Storage", 2.5, 0.3, (0.6, 1.5, 2.1), heading=NORTH)),
        thing("Picture", 2.5, 0.02, PICTURE, heading=NORTH, bottom=1.3),
        "collision",
    ),
    "a vase where another stands": (
        room(TABLE, thing("Decor", 2.2, 1.8, (0.3, 0.3, 0.3), bottom=0.75)),
        thing("Decor", 2.3, 1.8, (0.2, 0.2, 0.3), bottom=0.75),
        "collision",
    ),
    # the table's edge is at x = 3; the chair is 0.5 deep
    "a chair 44 cm under a table": (room(TABLE), thing("Chair", 2.81, 2, CHAIR, heading=WEST), ""),
    "a chair 46 cm under a table": (
        room(TABLE),
        thing("Chair", 2.79, 2, CHAIR, heading=WEST),
        "collision",
    ),
    "a table 44 cm over a chair": (
        room(thing("Chair", 2.81, 2, CHAIR, heading=WEST)),
        replace(TABLE),
        "",
    ),
    "a chair that meets a coffee table": (
        room(thing("Table", 2.5, 2.0, (1.0, 1.6, 0.45))),
        thing("Chair", 3.15, 2, CHAIR, heading=WEST),
        "collision",
    ),
    "a coffee table that meets a chair": (
        room(thing("Chair", 3.15, 2, CHAIR, heading=WEST)),
        thing("Table", 2.5, 2.0, (1.0, 1.6, 0.45)),
        "collision",
    ),
    "a stool under a cupboard": (
        room(thing("Storage", 2.5, 2.0, (1.0, 1.6, 0.75))),
        thing("Chair", 2.91, 2, CHAIR, heading=WEST),
        "collision",
    ),
    # doors and windows
    "before a door": (room(doors=(DOOR,)), thing("Storage", 1.4, 0.5, CUBE), "door"),
    "on the last centimeter before a door": (
        room(doors=(DOOR,)),
        thing("Storage", 1.4, 1.29, CUBE),
        "door",
    ),
    "just behind a door's square": (room(doors=(DOOR,)), thing("Storage", 1.4, 1.31, CUBE), ""),
    "just beside a door's square": (room(doors=(DOOR,)), thing("Storage", 2.31, 0.5, CUBE), ""),
    "a rug before a door": (room(doors=(DOOR,)), thing("Decor", 1.4, 0.5, (0.8, 1, 0.02)), ""),
    "a picture above a door": (
        room(doors=(DOOR,)),
        thing("Picture", 1.4, 0.02, (0.04, 0.6, 0.4), heading=NORTH, bottom=2.1),
        "",
    ),
    "a picture on a door": (
        room(doors=(DOOR,)),
        thing("Picture", 1.4, 0.02, PICTURE, heading=NORTH, bottom=1.3),
        "door",
    ),
    "before a gap in the wall of 3 m, whose square is 1.5 m deep": (
        room(doors=(Opening((1, 0), (4, 0), 0, 2),)),
        thing("Storage", 2.5, 1.9, CUBE),
        "door",
    ),
    "behind a gap in the wall of 3 m": (
        room(doors=(Opening((1, 0), (4, 0), 0, 2),)),
        thing("Storage", 2.5, 2.1, CUBE),
        "",
    ),
    "a wardrobe before a window": (
        room(windows=(WINDOW,)),
        thing("Storage", 2.5, 3.5, (1, 1, 2), heading=SOUTH),
        "window",
    ),
    "a wardrobe half a meter before a window": (
        room(windows=(WINDOW,)),
        thing("Storage", 2.5, 2.99, (1, 1, 2), heading=SOUTH),
        "",
    ),
    "a sideboard below a window": (
        room(windows=(WINDOW,)),
        thing("Storage", 2.5, 3.5, (1, 1, 0.9), heading=SOUTH),
        "",
    ),
    "a picture on a window": (
        room(windows=(WINDOW,)),
        thing("Picture", 2.5, 3.98, PICTURE, heading=SOUTH, bottom=1.3),
        "window",
    ),
    "a picture beside a window": (
        room(windows=(WINDOW,)),
        thing("Picture", 3.4, 3.98, PICTURE, heading=SOUTH, bottom=1.3),
        "",
    ),
    "a picture above a window": (
        room(windows=(WINDOW,)),
        thing("Picture", 2.5, 3.98, (0.04, 0.6, 0.4), heading=SOUTH, bottom=2.15),
        "",
    ),
    "a picture in a room without a ceiling that high": (
        room(height=2.2),
        thing("Picture", 2.5, 3.98, PICTURE, heading=SOUTH, bottom=2.0),
        "room",
    ),
}


def verdict(scene: Scene, pose: Box) -> str:
    """The rule that forbids the pose; empty if none."""
    here = situation(scene, pose)
    (index,) = verdicts(here, Space.of(here.surroundings))
    return "" if index == ALLOWED else RULES[index]


@pytest.mark.parametrize("name", CASES)
def test_a_pose_is_judged_by_the_first_rule_that_it_breaks(name: str) -> None:
    scene, pose, rule = CASES[name]
    assert verdict(scene, pose) == rule


@pytest.mark.parametrize("name", CASES)
def test_a_turned_and_moved_room_judges_alike(name: str) -> None:
    scene, pose, rule = CASES[name]
    assert verdict(moved(scene), moved_box(pose)) == rule


def test_many_poses_are_judged_as_each_alone() -> None:
    scene = room(TABLE, doors=(DOOR,), windows=(WINDOW,))
    poses = [
        thing("Storage", 0.2 + 0.35 * i, 0.3 + 0.27 * j, (1, 1, 2), heading=0.2 * i)
        for i in range(14)
        for j in range(13)
    ]
    here = situation(scene, *poses)
    together = verdicts(here, Space.of(here.surroundings))
    names = ["" if index == ALLOWED else RULES[index] for index in together]
    assert names == [verdict(scene, pose) for pose in poses]
    assert set(names) == {"", "room", "collision", "door", "window"}
