"""What our own relations say of a pose, in plain words: "its back against a wall"."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from math import isnan, pi

from scenegen_core.graph.scan import FAR, FLUSH, TOUCHING
from scenegen_core.graph.wording import metres, noun, spoken
from scenegen_core.scene.model import OTHER, Box

Measured = Mapping[str, float]
"""The columns of a relation by their parts; NaN where there is nothing to measure to."""

ALIGNED = pi / 8  # radians; less turned than this looks straight
AHEAD = pi / 4  # radians to either side that people call "in front"
CLOSE = 0.3  # metres that people still call "close to" a wall
CENTRAL = 0.2  # of the side of a square as large as the room: so far reaches its middle
MIRRORED = 0.3  # metres; places nearer than this are the same to the eye
CORNER = 2  # walls that one touches in a corner


def walls(seen: Measured, *, fronted: bool) -> str:
    """How it stands to the walls."""
    if seen["flush"] >= CORNER:
        return "in a corner"
    if seen["nearest"] >= CLOSE:
        return f"{metres(seen['nearest'])} from the nearest wall"
    how = "against" if seen["nearest"] < FLUSH else "close to"
    if not fronted:
        return f"{how} a wall"
    if seen["turn"] < ALIGNED:
        return f"its back {how} a wall"
    return f"its {'front' if pi - seen['turn'] < ALIGNED else 'side'} {how} a wall"


def free_space(seen: Measured, *, fronted: bool) -> str:
    """How much room is left about it."""
    if seen["side"] < TOUCHING and seen["far side"] < TOUCHING:
        return "fits between what is at its sides"
    if not fronted:
        near = round(seen["within a metre"])
        return f"{near} thing{'s'[: near != 1]} within 1 m" if near else "nothing within 1 m"
    beside = "right beside something, " if seen["side"] < TOUCHING else ""
    if seen["ahead"] < TOUCHING:
        return f"{beside}no room in front"
    more = "more than " if seen["ahead"] >= FAR else ""
    return f"{beside}{more}{metres(seen['ahead'])} free in front"


def middle(seen: Measured, *, fronted: bool) -> str:
    """How it stands to the middle of the room."""
    if seen["distance"] < CENTRAL:
        return "in the middle of the room"
    return f"away from the middle of the room{_turned(seen, fronted=fronted)}"


def opening(name: str) -> Callable[..., str]:
    """How it stands to the nearest door or window."""

    def told(seen: Measured, *, fronted: bool) -> str:
        if isnan(seen["gap"]):
            return f"no {name} in the room"
        where = f"at a {name}" if seen["gap"] < TOUCHING else f"{metres(seen['gap'])} from a {name}"
        return f"{where}{_turned(seen, fronted=fronted)}"

    return told


def height(seen: Measured, *, fronted: bool) -> str:  # noqa: ARG001 (as all of them are called)
    """How high it stands or hangs."""
    return "on the floor" if seen[""] < TOUCHING else f"{metres(seen[''])} above the floor"


def twin(seen: Measured, *, fronted: bool) -> str:  # noqa: ARG001
    """How it stands to the nearest of its size."""
    if isnan(seen["gap"]):
        return "no other just like it"
    if seen["gap"] < TOUCHING:
        return "side by side with another just like it"
    return f"{metres(seen['gap'])} from another just like it"


def mirror(seen: Measured, *, fronted: bool) -> str:  # noqa: ARG001
    """Whether it completes a pair."""
    if isnan(seen["distance"]):
        return "nothing to make a pair with"
    return "makes a pair" if seen["distance"] < MIRRORED else "makes no pair"


def neighbor(group: str, seen: Measured, members: Sequence[Box], *, fronted: bool) -> str:
    """How it stands to the nearest member of a group."""
    if isnan(seen["gap"]):
        kind = "thing of any other kind" if group == OTHER else noun(group)
        return f"no {kind} in the room"
    name = f"the {spoken(members[0])}" if len(members) == 1 else f"the nearest {noun(group)}"
    if seen["on"]:
        return f"on {name}"
    turned = _turned(seen, fronted=fronted)
    at = seen["gap"] < TOUCHING
    if seen["faced"] == 1:
        return f"{'right' if at else metres(seen['gap'])} in front of {name}{turned}"
    return f"{'right at' if at else metres(seen['gap']) + ' from'} {name}{turned}"


def _turned(seen: Measured, *, fronted: bool) -> str:
    """Whether it looks there or away from there."""
    if not fronted or AHEAD <= seen["bearing"] <= pi - AHEAD:
        return ""
    return ", facing it" if seen["bearing"] < AHEAD else ", its back to it"


TEXTS: dict[str, Callable[..., str]] = {
    "W": walls, "FS": free_space, "M": middle, "DR": opening("door"), "WN": opening("window"),
    "H": height, "TW": twin, "MI": mirror,
}  # fmt: skip
"""The relations that are about no group, by their abbreviations."""
