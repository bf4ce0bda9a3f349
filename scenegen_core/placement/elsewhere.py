"""What it would take: the nearest pose that would do, and the way there in words."""

from __future__ import annotations

from math import atan2, hypot, pi

import numpy as np

from scenegen_core.graph.candidates import Candidates
from scenegen_core.graph.situation import Situation
from scenegen_core.graph.wording import LONG, spoken
from scenegen_core.placement.alternatives import BLOCKED_ID
from scenegen_core.placement.answer import Elsewhere
from scenegen_core.placement.feasible import ALLOWED, Space, collisions, verdicts
from scenegen_core.placement.walking import Walking
from scenegen_core.placement.words import compass, sentence
from scenegen_core.scene.geometry import Floats, Rectangles, gaps, walls_as_rectangles, wrapped
from scenegen_core.scene.model import Category, Opening, Symmetry

STEP = 0.05  # metres between the poses tried near by, as they are turned
REACH = 0.6  # metres as far as they are tried; further off the proposals are fine enough
TURNING = 1 / pi  # metres that a radian of turning is worth: a half turn as a metre
TRIES = 60  # poses whose ways are checked before giving up
APART = 0.1  # metres; poses this near to one that closes a way close it too
STILL = 0.03  # metres and
STRAIGHT = pi / 36  # radians that nobody would tell
MOSTLY = 0.95  # share of a way by which a gap grows or shrinks to be told by it
ASIDE = 0.1  # metres that a way may end beside the one that is told
EIGHTH = pi / 4
LIKELIER = 0.1  # metres further that one would carry a thing to a place e times as likely

Thing = tuple[str, Rectangles]
"""What a way leads from or to: its name and its one footprint."""


def nearest_possible(
    pose: Candidates,
    possible: Candidates,
    scores: Floats,
    space: Space,
    walking: Walking,
    symmetry: Symmetry,
) -> Candidates | None:
    """The pose that is least work to move and turn a single pose to; None if there is none.

    Tried are poses near by that are turned as it is, then the ``possible`` ones with their log
    ``scores``, (n,): for a likelier place one goes a little further.
    """
    around = _poses_around(pose)
    free = around[verdicts(Situation(around, space.around), space) == ALLOWED]
    for candidates, worth in ((free, np.zeros(len(free))), (possible, LIKELIER * scores)):
        refused: list[Floats] = []
        for index in np.argsort(efforts(pose, candidates, symmetry) - worth, kind="stable"):
            single = candidates[index : index + 1]
            center = single.centers[0]
            if any(np.hypot(*(center - old)[:2]) < APART for old in refused):
                continue
            if walking.blocked_by(single.box(0, BLOCKED_ID)) is None:
                return single
            refused.append(center)
            if len(refused) == TRIES:
                break
    return None


def efforts(pose: Candidates, candidates: Candidates, symmetry: Symmetry) -> Floats:
    """How much work it is to get from a single pose to each candidate, metres: (n,)."""
    moved = np.sqrt(((candidates.centers - pose.centers) ** 2).sum(axis=1))
    turned = np.abs(wrapped(candidates.headings - pose.headings))
    if symmetry is Symmetry.SYMMETRIC:
        turned = np.minimum(turned, pi - turned)
    return np.asarray(moved + turned * TURNING, dtype=np.float64)


def elsewhere(start: Situation, end: Candidates, category: Category, by: Thing | None) -> Elsewhere:
    """Another pose, and the way there from a single one, told by a thing if it is about that."""
    center, heading = end.centers[0], float(wrapped(end.headings)[0])
    x, y, z = center.tolist()
    return Elsewhere(
        center=(x, y, z),
        heading=round(heading, 9),  # without rounding dust
        distance=float(np.sqrt(((end.centers - start.candidates.centers) ** 2).sum())),
        text=way(start.candidates, end, category, by),
        sentence=sentence(Situation(end, start.surroundings), category),
    )


def way(start: Candidates, end: Candidates, category: Category, by: Thing | None) -> str:
    """How to get from one pose to another: "30 cm further from the door"."""
    east, north, up = (end.centers - start.centers)[0].tolist()
    moved = float(np.hypot(east, north))
    parts = []
    if moved >= STILL:
        parts.append(_told_by(start, end, moved, by) or _on_the_plan(east, north))
    if abs(up) >= STILL:
        parts.append(f"{length(abs(up))} {'higher' if up > 0 else 'lower'}")
    turned = abs(float(wrapped(end.headings - start.headings)[0]))
    if category.symmetry is Symmetry.SYMMETRIC:
        turned = min(turned, pi - turned)
    if turned >= STRAIGHT:
        faces = category.symmetry is not Symmetry.SYMMETRIC
        parts.append(f"turned to face {compass(float(end.headings[0]))}" if faces else "turned")
    return ", ".join(parts) or "right here"


def length(metres: float) -> str:
    """A length as exact as one would move furniture: 1.1 m, 35 cm."""
    return f"{metres:.1f} m" if metres >= LONG else f"{max(1, round(metres * 20)) * 5} cm"


def _told_by(start: Candidates, end: Candidates, moved: float, by: Thing | None) -> str:
    """The way as one straight to a thing or away from it; empty if it is none."""
    if by is None:
        return ""
    name, shape = by
    grown = float((gaps(end.footprints, shape) - gaps(start.footprints, shape))[0, 0])
    if abs(grown) < MOSTLY * moved:
        return ""
    return f"{length(moved)} {'further from' if grown > 0 else 'closer to'} {name}"


def _on_the_plan(east: float, north: float) -> str:
    """The way by the compass: "1.5 m to the east and 60 cm to the north"."""
    angle = atan2(north, east)
    off = abs(angle - round(angle / EIGHTH) * EIGHTH) * hypot(east, north)
    if off < ASIDE:
        return f"{length(hypot(east, north))} to the {compass(angle)}"
    ways = [
        (abs(east), "east" if east > 0 else "west"),
        (abs(north), "north" if north > 0 else "south"),
    ]
    (most, first), (least, second) = sorted(ways, reverse=True)
    return f"{length(most)} to the {first} and {length(least)} to the {second}"


def in_the_way(rule: str, situation: Situation) -> Thing | None:
    """What makes a rule forbid the single pose of a situation; None if it is nothing in a place."""
    around, room = situation.surroundings, situation.surroundings.scene.room
    if rule == "room":
        wall = int(situation.wall_gaps[0].argmin())
        side = compass(float(around.inward[wall]) + pi)
        return f"the {side} wall", around.wall_shapes[np.array([wall])]
    if rule == "collision":
        hit = np.flatnonzero(collisions(situation)[0])[:1]
        return f"the {spoken(around.scene.boxes[hit[0]])}", around.footprints[hit]
    if rule == "door":
        return "the door", _nearest(situation, room.doors)
    if rule == "window":
        return "the window", _nearest(situation, room.windows)
    return None


def nearest_member(situation: Situation, group: str) -> Thing | None:
    """The nearest box of a group, if there is one."""
    boxes = situation.surroundings.scene.boxes
    members = np.array([i for i, box in enumerate(boxes) if box.category == group], dtype=np.int64)
    if not len(members):
        return None
    nearest = members[situation.gaps[0, members].argmin()]
    return f"the {spoken(boxes[nearest])}", situation.surroundings.footprints[nearest : nearest + 1]


def _nearest(situation: Situation, openings: tuple[Opening, ...]) -> Rectangles:
    shapes = walls_as_rectangles(np.array([(o.start, o.end) for o in openings], dtype=float))
    nearest = int(gaps(situation.candidates.footprints, shapes)[0].argmin())
    return shapes[nearest : nearest + 1]


def _poses_around(pose: Candidates) -> Candidates:
    """Poses on a fine grid about a single one, as high and turned as it is."""
    steps = np.arange(-round(REACH / STEP), round(REACH / STEP) + 1) * STEP
    offsets = np.stack(np.meshgrid(steps, steps, [0.0]), axis=-1).reshape(-1, 3)
    offsets = offsets[np.hypot(offsets[:, 0], offsets[:, 1]) <= REACH]
    heading = float(pose.headings[0])
    cos, sin = np.cos(heading), np.sin(heading)
    along = offsets[:, :1] * (cos, sin, 0) + offsets[:, 1:2] * (-sin, cos, 0)
    return Candidates(
        pose.category, pose.size, pose.centers + along, np.full(len(offsets), heading)
    )
