"""Short names of places that tell them from one another: "by the window", "opposite the TV"."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from math import atan2, cos, pi

import numpy as np

from scenegen_core.graph.situation import Situation
from scenegen_core.graph.wording import spoken
from scenegen_core.placement.words import (
    AGAINST,
    BESIDE,
    CLOSE_BY,
    UNTOLD_GROUPS,
    carrier_of,
    compass,
    corner_of,
    faced_from,
    is_by,
    is_central,
    lies_to,
    nearest_wall,
    wall_behind,
)
from scenegen_core.scene.model import Box, Category, Point, Symmetry

LOOKS_BACK = pi / 4  # radians that a front may be turned from those whom it is "opposite"
SIDES = (("west", "east"), ("south", "north"))
"""The low and the high end of each axis of the plan."""
TWO = 2
ORDINALS = ("first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth")
UNFACED = ("Picture",)
"""What people look at, but do not sit opposite."""


def names(situation: Situation, category: Category) -> tuple[str, ...]:
    """A name for each pose of a situation, as different as the facts allow.

    The most telling fact that holds for one pose alone; else two facts that only it has together;
    else on which side it lies of those that are told by the same.
    """
    around = situation.surroundings
    told = [
        tuple(dict.fromkeys(_facts(Situation(situation.candidates[i : i + 1], around), category)))
        for i in range(len(situation.candidates))
    ]
    points = [(x, y) for x, y, _ in situation.candidates.centers.tolist()]
    own = [_alone(facts, told) or _together(facts, told) for facts in told]
    rest = {i: told[i] for i, name in enumerate(own) if not name}
    return tuple(name or _aside(i, rest, points) for i, name in enumerate(own))


def _alone(facts: Sequence[str], told: Sequence[Sequence[str]]) -> str:
    return next((fact for fact in facts if sum(fact in other for other in told) == 1), "")


def _together(facts: Sequence[str], told: Sequence[Sequence[str]]) -> str:
    pairs = ((one, two) for i, one in enumerate(facts) for two in facts[i + 1 :])
    return next(
        (
            f"{one}, {two}"
            for one, two in pairs
            if sum(one in other and two in other for other in told) == 1
        ),
        "",
    )


def _aside(index: int, told: Mapping[int, Sequence[str]], points: Sequence[Point]) -> str:
    """The first fact, and where the pose lies among those that it holds for."""
    fact = told[index][0]
    alike = [i for i, facts in told.items() if fact in facts]
    if len(alike) == 1:
        return fact
    spread = np.ptp([points[i] for i in alike], axis=0)
    axis = int(spread[1] > spread[0])
    ordered = sorted(alike, key=lambda i: (points[i][axis], i))
    place, (low, high) = ordered.index(index), SIDES[axis]
    if len(alike) == TWO:
        return f"{fact}, further {high if place else low}"
    if place in (0, len(alike) - 1):
        return f"{fact}, furthest {high if place else low}"
    return f"{fact}, {ORDINALS[place]} from the {low}"


def _facts(single: Situation, category: Category) -> Iterator[str]:
    """What can be said of a single pose, the most telling first; at least one."""
    room = single.surroundings.scene.room
    carrier = carrier_of(single)
    if carrier is not None:
        yield f"on {_named(single, carrier)}"
    yield from _facing(single, category)
    if is_by(single, room.windows):
        yield "by the window" if len(room.windows) == 1 else "by a window"
    hangs = carrier is None and single.candidates.bottoms[0] > AGAINST
    corner = corner_of(single.surroundings.walls, single.wall_gaps[0])
    if corner and not hangs:
        yield f"in the {corner} corner"
    yield from _beside(single, carrier, hangs=hangs)
    if is_by(single, room.doors):
        yield "by the door" if len(room.doors) == 1 else "by a door"
    yield _at_the_walls(single, hangs=hangs)
    if category.symmetry is Symmetry.ASYMMETRIC:
        yield f"facing {compass(float(single.candidates.headings[0]))}"


def _facing(single: Situation, category: Category) -> Iterator[str]:
    box = faced_from(single) if category.symmetry is Symmetry.ASYMMETRIC else None
    if box is not None and box.category not in UNFACED:
        yield f"{'opposite' if _looks_back(single, box) else 'facing'} {_named(single, box)}"


def _looks_back(single: Situation, box: Box) -> bool:
    """Does the front of a box look at the pose?"""
    x, y, _ = single.candidates.centers[0].tolist()
    seen_at = atan2(y - box.center[1], x - box.center[0])
    kind = next((g for g in single.surroundings.groups if g.name == box.category), None)
    fronted = kind is not None and kind.symmetry is not Symmetry.SYMMETRIC and box.front_known
    return fronted and cos(seen_at - box.heading) >= cos(LOOKS_BACK)


def _beside(single: Situation, carrier: Box | None, *, hangs: bool) -> Iterator[str]:
    """What it stands next to, at, under or above, the nearest first."""
    boxes = single.surroundings.scene.boxes
    for index in np.argsort(single.gaps[0], kind="stable"):
        box, gap = boxes[index], single.gaps[0, index]
        if box is carrier or box.category in UNTOLD_GROUPS or gap >= BESIDE:
            continue
        lies = lies_to(single, box)
        beside = gap > 0 and not (hangs and lies == "above")
        yield f"{'next to' if beside else lies} {_named(single, box)}"


def _named(single: Situation, box: Box) -> str:
    """What a box is called: "the bed", but "a chair" where there are several."""
    name = spoken(box)
    alone = sum(spoken(other) == name for other in single.surroundings.scene.boxes) == 1
    return f"the {name}" if alone else f"{'an' if name[0] in 'aeiou' else 'a'} {name}"


def _at_the_walls(single: Situation, *, hangs: bool) -> str:
    if hangs:
        return f"on the {wall_behind(single)} wall" if wall_behind(single) else "hanging"
    near = single.wall_gaps[0].min()
    if near < CLOSE_BY:
        return f"{'at' if near < AGAINST else 'near'} the {nearest_wall(single)} wall"
    return "in the middle" if is_central(single) else "out in the room"
