"""Retrieval: put the object where one stood in the most similar room that taught.

Similar rooms have furniture of the same groups, the same type and about the same area; the three
count alike. The room found is laid over ours, long side on long side, in whichever of the four
ways (as it is, mirrored, turned) brings furniture of the same groups nearest to ours.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np
import shapely

from scenegen_core.evaluation.cases import Case
from scenegen_core.placement.proposals import main_direction
from scenegen_core.scene.geometry import Floats
from scenegen_core.scene.model import Box, Point, Room, Scene

REMEMBERED = 5  # rooms; the paper's count of answers
WAYS = tuple(product((1.0, -1.0), (1.0, -1.0)))
"""Signs of the two sides: as it is, mirrored, mirrored the other way, turned by half."""


@dataclass(frozen=True, slots=True)
class Lesson:
    """A room that taught, and what it is compared by."""

    scene: Scene
    groups: Counter[str]
    area: float


@dataclass(frozen=True, slots=True)
class Remembered:
    """Where the object would stand as it did in a similar room."""

    center: Point
    heading: float


@dataclass(frozen=True, eq=False)
class Frame:
    """A room's own frame: its middle is 0, its sides along the long axis and across are ±1."""

    turn: float
    middle: Floats
    half: Floats

    @classmethod
    def of(cls, room: Room) -> Frame:
        """The frame of a room, from the rectangle about it along its longest wall."""
        turn = main_direction(np.array(room.walls, dtype=float))
        corners = _turned(np.array(room.corners, dtype=float), -turn)
        extent = np.ptp(corners, axis=0)
        if extent[1] > extent[0]:
            turn += np.pi / 2
            corners = _turned(np.array(room.corners, dtype=float), -turn)
        low, high = corners.min(axis=0), corners.max(axis=0)
        return cls(turn, (low + high) / 2, (high - low) / 2)

    def inside(self, points: Floats) -> Floats:
        """Points (n, 2) of the room in its frame."""
        return (_turned(points, -self.turn) - self.middle) / self.half

    def outside(self, points: Floats) -> Floats:
        """Points (n, 2) of the frame in the room, metres."""
        return _turned(points * self.half + self.middle, self.turn)


def lessons_of(scenes: Sequence[Scene]) -> tuple[Lesson, ...]:
    """The rooms that taught, ready to be compared."""
    return tuple(Lesson(scene, _groups(scene), _area(scene.room)) for scene in scenes)


def recall(case: Case, lessons: Sequence[Lesson]) -> list[Remembered]:
    """Where it would stand as in the most similar rooms that have one, the most similar first."""
    ours, area = _groups(case.scene), _area(case.scene.room)
    fitting = [
        (_similarity(case, ours, area, lesson), lesson)
        for lesson in lessons
        if lesson.groups[case.box.category]
    ]
    fitting.sort(key=lambda pair: -pair[0])
    return [_laid_over(lesson.scene, case) for _, lesson in fitting[:REMEMBERED]]


def _similarity(case: Case, ours: Counter[str], area: float, lesson: Lesson) -> float:
    theirs = lesson.groups - Counter([case.box.category])
    shared = (ours & theirs).total() / max((ours | theirs).total(), 1)
    same_type = case.scene.room.room_type.lower() == lesson.scene.room.room_type.lower()
    return shared + same_type + min(area, lesson.area) / max(area, lesson.area)


def _laid_over(lesson: Scene, case: Case) -> Remembered:
    """The pose of the lesson's object of the category, in the room of the case."""
    theirs, ours = Frame.of(lesson.room), Frame.of(case.scene.room)
    there = next(box for box in lesson.boxes if box.category == case.box.category)
    others = [box for box in lesson.boxes if box is not there]
    way = min(WAYS, key=lambda signs: _mismatch(case.scene, ours, others, theirs, signs))
    (center,) = ours.outside(theirs.inside(_points([there])) * way)
    along = np.array([np.cos(there.heading - theirs.turn), np.sin(there.heading - theirs.turn)])
    heading = float(np.arctan2(*(along * way)[::-1]) + ours.turn)
    return Remembered((float(center[0]), float(center[1])), heading)


def _mismatch(
    scene: Scene, ours: Frame, others: list[Box], theirs: Frame, signs: tuple[float, float]
) -> float:
    """How far their furniture is from ours of the same group, metres in all."""
    laid = ours.outside(theirs.inside(_points(others)) * signs)
    total = 0.0
    for box, point in zip(others, laid, strict=True):
        same = _points([our for our in scene.boxes if our.category == box.category])
        if len(same):
            total += float(np.hypot(*(same - point).T).min())
    return total


def _points(boxes: Sequence[Box]) -> Floats:
    return np.array([box.center[:2] for box in boxes], dtype=float).reshape(-1, 2)


def _turned(points: Floats, angle: float) -> Floats:
    cos, sin = np.cos(angle), np.sin(angle)
    return np.asarray(points @ np.array([[cos, sin], [-sin, cos]]), dtype=np.float64)


def _groups(scene: Scene) -> Counter[str]:
    return Counter(box.category for box in scene.boxes)


def _area(room: Room) -> float:
    return float(shapely.Polygon(room.corners).area)
