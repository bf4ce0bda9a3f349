"""What our own relations say of a pose, in plain words: "back against a wall"."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from math import isnan, pi

from scenegen_core.graph.scan import FLUSH, NEAR, TOUCHING
from scenegen_core.graph.wording import metres, noun, spoken
from scenegen_core.scene.model import Box

Measured = Mapping[str, float]
"""The columns of a relation by their parts; NaN where there is nothing to measure to."""

ALIGNED = pi / 8  # radians; less turned than this looks straight
AHEAD = pi / 4  # radians to either side that people call "in front"
CENTRAL = 0.2  # of the side of a square as large as the room: so far reaches its middle
MIRRORED = 0.3  # metres; places nearer than this are the same to the eye


def walls(seen: Measured) -> str:
    """How it stands to the walls."""
    if seen["flush"] >= 2:  # noqa: PLR2004 (two walls make a corner)
        return "in a corner"
    if seen["nearest"] >= FLUSH:
        return f"{metres(seen['nearest'])} from the nearest wall"
    if seen["turn"] < ALIGNED:
        return "its back against a wall"
    return "its front to a wall" if pi - seen["turn"] < ALIGNED else "its side against a wall"


def free_space(seen: Measured) -> str:
    """How much room is left about it."""
    if seen["side"] < TOUCHING and seen["far side"] < TOUCHING:
        return "fills the gap between what stands at its sides"
    if seen["side"] < TOUCHING:
        return "joins what stands at its side"
    return f"{metres(max(seen['ahead'], 0.0))} free in front of it"


def middle(seen: Measured) -> str:
    """How it stands to the middle of the room."""
    place = "in the middle of the room" if seen["distance"] < CENTRAL else "off the middle"
    if seen["bearing"] < AHEAD:
        return f"{place}, turned to it"
    return f"{place}, turned away from it" if pi - seen["bearing"] < AHEAD else place


def opening(name: str) -> Callable[[Measured], str]:
    """How it stands to the nearest door or window."""

    def told(seen: Measured) -> str:
        if isnan(seen["gap"]):
            return f"no {name} in the room"
        where = "at" if seen["gap"] < TOUCHING else f"{metres(seen['gap'])} from"
        return f"{where} the {name}"

    return told


def height(seen: Measured) -> str:
    """How high it stands or hangs."""
    low = seen[""] < TOUCHING
    return "stands on the floor" if low else f"its underside {metres(seen[''])} above the floor"


def twin(seen: Measured) -> str:
    """How it stands to the nearest of its size."""
    if isnan(seen["gap"]):
        return "no other of its kind and size"
    if seen["gap"] < TOUCHING:
        return "joins another of its size"
    return f"{metres(seen['gap'])} from another of its size"


def mirror(seen: Measured) -> str:
    """Whether it completes a pair."""
    if isnan(seen["distance"]):
        return "nothing to make a pair with"
    return "makes a pair" if seen["distance"] < MIRRORED else "makes no pair"


def neighbor(group: str, seen: Measured, members: Sequence[Box]) -> str:
    """How it stands to the nearest member of a group."""
    if isnan(seen["gap"]):
        return f"no {noun(group)} in the room"
    name = spoken(members[0]) if len(members) == 1 else noun(group)
    if seen["on"]:
        return f"on the {name}"
    at = seen["gap"] < TOUCHING
    place = f"at the {name}" if at else f"{metres(seen['gap'])} from the {name}"
    ways = [place]
    if seen["bearing"] < AHEAD:
        ways.append("facing it")
    elif pi - seen["bearing"] < AHEAD:
        ways.append("its back to it")
    if seen["faced"] == 1 and seen["gap"] < 3 * NEAR:
        ways.append("in front of it")
    return ", ".join(ways)


TEXTS: dict[str, Callable[[Measured], str]] = {
    "W": walls, "FS": free_space, "M": middle, "DR": opening("door"), "WN": opening("window"),
    "H": height, "TW": twin, "MI": mirror,
}  # fmt: skip
"""The relations that are about no group, by their abbreviations."""
