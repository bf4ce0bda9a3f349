"""May it stand there? Hard facts about poses, never part of a score.

The rules are tried in the order of ``RULES``; a pose carries the index of the first that forbids
it, or ALLOWED. The path rule is not here: it is tried for the poses on offer only (``walking``).
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass

import numpy as np

from scenegen_core.graph.candidates import Candidates
from scenegen_core.graph.situation import Situation
from scenegen_core.graph.surroundings import Surroundings
from scenegen_core.placement.mounts import RUG_HEIGHT, SUPPORTS, Mount, mounts
from scenegen_core.placement.proposals import stands_on
from scenegen_core.scene.compiled import all_collisions
from scenegen_core.scene.geometry import (
    Bools,
    Floats,
    Ints,
    Rectangles,
    directions,
    distances_to_segments,
    separations,
    within,
    wrapped,
)
from scenegen_core.scene.model import Opening
from scenegen_core.scene.resting import RESTS

ALLOWED = -1
RULES = ("room", "mount", "collision", "door", "window", "path")

SINK = 0.002  # metres that a footprint may pass into a wall (rounding of outlines)
PRESS = 0.001  # metres that two things may press into each other (rounding of boxes)
LAYER = 0.01  # metres of common height below which two things do not meet
TUCK = 0.45  # metres that a chair goes under a table, all but its back
SEAT_ROOM = 0.6  # metres; under lower things, as coffee tables, no seat goes
DOOR_DEPTH = 1.5  # metres; a wider opening has no leaf that swings further
WINDOW_DEPTH = 0.5  # metres in front of a window that tall things leave free
HANGING_TURN = np.pi / 16  # radians that what hangs may be turned from its wall

GOES_UNDER: dict[tuple[str, str], float] = {("Chair", "Table"): TUCK}
"""(What goes under, what it goes under) -> how deep, metres: the natural overlaps."""


@dataclass(frozen=True, slots=True)
class Space:
    """What limits poses in a scene besides its walls: clear spaces before doors and windows."""

    around: Surroundings
    doors: Rectangles
    door_tops: Floats
    windows: Rectangles
    window_heights: Floats
    """(windows, 2): bottom and top."""

    @classmethod
    def of(cls, around: Surroundings, relaxed: Collection[str] = ()) -> Space:
        """The space of a scene; of the rules that do not count, windows is one."""
        doors, windows = around.scene.room.doors, around.scene.room.windows
        windows = () if "window" in relaxed else windows
        return cls(
            around=around,
            doors=_clear(around, doors, None),
            door_tops=np.array([door.top for door in doors], dtype=float),
            windows=_clear(around, windows, WINDOW_DEPTH),
            window_heights=np.array([(w.bottom, w.top) for w in windows]).reshape(-1, 2),
        )


def _clear(around: Surroundings, openings: tuple[Opening, ...], depth: float | None) -> Rectangles:
    """The space before openings, on the inner side; without a depth as deep as they are wide."""
    segments = np.array([(o.start, o.end) for o in openings], dtype=float).reshape(-1, 2, 2)
    middles = segments.mean(axis=1)
    widths = np.hypot(*(segments[:, 1] - segments[:, 0]).T)
    wall = distances_to_segments(middles, around.walls).argmin(axis=1)
    looks = around.inward[wall]
    depths = np.minimum(widths, DOOR_DEPTH) if depth is None else np.full(len(widths), depth)
    centers = middles + directions(looks) * depths[:, None] / 2
    return Rectangles(centers, np.stack([depths, widths], axis=1) / 2, looks)


def verdicts(situation: Situation, space: Space) -> Ints:
    """The rule that forbids each pose, as an index of RULES, or ALLOWED: (n,)."""
    verdict = np.full(len(situation.candidates), ALLOWED, dtype=np.int64)
    left = np.arange(len(verdict))
    for index, forbids in enumerate(_FORBIDS):
        forbidden = forbids(situation, space)
        if forbidden.any():
            verdict[left[forbidden]] = index
            still = np.flatnonzero(~forbidden)
            left, situation = left[still], situation[still]
    return verdict


def _leaves_room(situation: Situation, space: Space) -> Bools:
    candidates = situation.candidates
    inside = within(candidates.centers[:, :2], space.around.walls)
    through = (situation.wall_overlaps < -SINK).any(axis=1)
    height = space.around.scene.room.height
    too_tall = (candidates.tops > height + RESTS) | (candidates.bottoms < -RESTS)
    return np.asarray(~inside | through | too_tall, dtype=np.bool_)


def _floats(situation: Situation, _: Space) -> Bools:
    """Does it rest on nothing that may carry it?"""
    candidates, around = situation.candidates, situation.surroundings
    kinds = mounts(candidates.category, candidates.size)
    rests = np.zeros(len(candidates), dtype=np.bool_)
    if Mount.FLOOR in kinds:
        rests |= np.abs(candidates.bottoms) <= RESTS
    if Mount.WALL in kinds:
        turned = np.abs(wrapped(candidates.headings[:, None] - around.inward))
        hangs = (situation.wall_gaps <= RESTS) & (turned <= HANGING_TURN)
        rests |= hangs.any(axis=1) & (candidates.bottoms > RESTS)
    if Mount.TOP in kinds:
        carriers = SUPPORTS.get(candidates.category, ())
        carries = np.array([box.category in carriers for box in around.scene.boxes], dtype=bool)
        hovering = np.flatnonzero(~rests)
        level = np.abs(candidates.bottoms[hovering, None] - around.tops[carries]) <= RESTS
        standing = stands_on(situation.shapes[hovering], around.footprints[carries])
        rests[hovering] = (level & standing).any(axis=1)
    return ~rests


def _collides(situation: Situation, _: Space) -> Bools:
    return np.asarray(collisions(situation).any(axis=1), dtype=np.bool_)


def collisions(situation: Situation) -> Bools:
    """Which boxes each pose runs into, natural overlaps left out: (n, m)."""
    candidates, around = situation.candidates, situation.surroundings
    if candidates.size[2] <= RUG_HEIGHT:
        return np.zeros((len(candidates), len(around)), dtype=np.bool_)
    out = np.empty((len(around), len(candidates)), dtype=np.bool_)
    all_collisions(
        situation.shapes.columns, candidates.bottoms, candidates.tops, around.footprints.rows,
        around.bottoms, around.tops, *_allowances(candidates, around), SEAT_ROOM, LAYER, out,
    )  # fmt: skip
    return out.T


def _allowances(candidates: Candidates, around: Surroundings) -> tuple[Floats, Floats]:
    """How far poses may reach into each box, seen from above, metres: (m,) each.

    Those that are lower than seats need, then those that seats go under.
    """
    category, boxes = candidates.category, around.scene.boxes
    solid = around.tops - around.bottoms > RUG_HEIGHT
    under = np.array([GOES_UNDER.get((category, box.category), PRESS) for box in boxes])
    over = np.array([GOES_UNDER.get((box.category, category), PRESS) for box in boxes])
    under = np.where(around.tops >= SEAT_ROOM, under, PRESS)
    return np.where(solid, under, np.inf), np.where(solid, np.maximum(under, over), np.inf)


def _blocks_door(situation: Situation, space: Space) -> Bools:
    candidates = situation.candidates
    if candidates.size[2] <= RUG_HEIGHT:
        return np.zeros(len(candidates), dtype=np.bool_)
    meets = separations(situation.shapes, space.doors) < -PRESS
    below = candidates.bottoms[:, None] < space.door_tops
    return np.asarray((meets & below).any(axis=1), dtype=np.bool_)


def _covers_window(situation: Situation, space: Space) -> Bools:
    candidates = situation.candidates
    meets = separations(situation.shapes, space.windows) < -PRESS
    sill, lintel = space.window_heights.T
    across = (candidates.tops[:, None] > sill + LAYER) & (candidates.bottoms[:, None] < lintel)
    return np.asarray((meets & across).any(axis=1), dtype=np.bool_)


_FORBIDS = (_leaves_room, _floats, _collides, _blocks_door, _covers_window)
"""What each of RULES forbids, but for the path: each is asked only of what is left."""
