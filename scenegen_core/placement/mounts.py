"""Where a kind of object can rest: on the floor, on a wall, or on top of furniture."""

from __future__ import annotations

from enum import IntEnum

from scenegen_core.scene.model import Vector3


class Mount(IntEnum):
    """What an object rests on."""

    FLOOR = 0
    WALL = 1
    TOP = 2


SUPPORTS: dict[str, tuple[str, ...]] = {
    "TV": ("Storage", "Table"),
    "Decor": ("Storage", "Table"),
}
"""Which groups carry which: what the training rooms show by parents and heights."""

HANGING_HEIGHT: dict[str, float] = {"Picture": 1.5, "TV": 1.1, "Storage": 1.8}
"""Usual height of the middle of a hanging object, metres: eye level standing and seated, and what
a hand reaches."""
HANGING_RANGE = 0.3  # metres up and down from the usual height

RUG_HEIGHT = 0.05  # metres; flatter things lie under everything else
TOP_HEIGHT = 0.6  # metres; decor up to this height stands on furniture as well as on the floor
FLOOR_TV = 1.0  # metres; a TV this tall has a foot of its own
HANGING_DEPTH = 0.35  # metres; deeper TVs cannot hang
CABINET_DEPTH = 0.45  # metres; deeper storage cannot hang
CABINET_HEIGHT = 1.1  # metres; taller storage stands
REACHABLE_TOP = 1.4  # metres; higher tops are no place for a TV or a vase


def mounts(category: str, size: Vector3) -> tuple[Mount, ...]:
    """What an object of that category and size can rest on, usual first."""
    depth, _, height = size
    if category == "Picture":
        return (Mount.WALL,)
    if category == "TV":
        if height > FLOOR_TV:
            return (Mount.FLOOR,)
        return (Mount.TOP, Mount.WALL) if depth <= HANGING_DEPTH else (Mount.TOP,)
    if category == "Storage" and depth <= CABINET_DEPTH and height <= CABINET_HEIGHT:
        return (Mount.FLOOR, Mount.WALL)
    if category == "Decor" and RUG_HEIGHT < height <= TOP_HEIGHT:
        return (Mount.TOP, Mount.FLOOR)
    return (Mount.FLOOR,)
