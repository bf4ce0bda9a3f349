"""Hand-drawn rooms and single poses, for the tests of placement."""

from __future__ import annotations

from math import cos, pi, sin

import numpy as np

from scenegen_core.graph.candidates import Candidates
from scenegen_core.graph.situation import Situation
from scenegen_core.graph.surroundings import Surroundings
from scenegen_core.scene.model import PAPER_CATEGORIES, Box, Category, Opening, Point, Room, Scene

NORTH, WEST, SOUTH = pi / 2, pi, -pi / 2
RECTANGLE: tuple[Point, ...] = ((0, 0), (5, 0), (5, 4), (0, 4))
L_SHAPE: tuple[Point, ...] = ((0, 0), (6, 0), (6, 2), (3, 2), (3, 5), (0, 5))
"""Its inner corner is at (3, 2); nothing can stand at x > 3, y > 2."""
DOOR = Opening((1, 0), (1.8, 0), 0, 2.0, "door")
"""In the south wall; its square is x 1..1.8, y 0..0.8."""
WINDOW = Opening((2, 4), (3, 4), 0.9, 2.1, "window")
"""In the north wall of the rectangle."""

TURN, SHIFT = 0.3, (7.0, -3.0)


def room(
    *boxes: Box,
    corners: tuple[Point, ...] = RECTANGLE,
    doors: tuple[Opening, ...] = (),
    windows: tuple[Opening, ...] = (),
    height: float = 2.6,
) -> Scene:
    """A scene in a room of that outline."""
    return Scene(Room(corners, height, doors, windows), boxes)


def thing(
    category: str,
    x: float,
    y: float,
    size: tuple[float, float, float],
    *,
    heading: float = 0.0,
    bottom: float = 0.0,
    label: str = "",
    box_id: str = "",
) -> Box:
    """A box that stands at that height, named after its category."""
    center = (x, y, bottom + size[2] / 2)
    return Box(box_id or category.lower(), category, center, size, heading, label)


def category(name: str) -> Category:
    """One of the paper's categories."""
    return next(group for group in PAPER_CATEGORIES if group.name == name)


def situation(scene: Scene, *poses: Box) -> Situation:
    """What is measured for poses of one object in a scene."""
    candidates = Candidates(
        poses[0].category,
        poses[0].size,
        np.array([pose.center for pose in poses], dtype=float),
        np.array([pose.heading for pose in poses], dtype=float),
    )
    return Situation(candidates, Surroundings(scene, PAPER_CATEGORIES))


def moved_point(point: Point, turn: float = TURN, shift: Point = SHIFT) -> Point:
    """A point turned about the origin, then moved."""
    x, y = point
    return (x * cos(turn) - y * sin(turn) + shift[0], x * sin(turn) + y * cos(turn) + shift[1])


def moved_box(box: Box, turn: float = TURN, shift: Point = SHIFT) -> Box:
    """A box turned about the origin, then moved."""
    center = (*moved_point(box.center[:2], turn, shift), box.center[2])
    return Box(
        box.id, box.category, center, box.size, box.heading + turn, box.label, box.front_known
    )


def moved(scene: Scene, turn: float = TURN, shift: Point = SHIFT) -> Scene:
    """The whole scene turned about the origin, then moved."""

    def opening(one: Opening) -> Opening:
        ends = (moved_point(one.start, turn, shift), moved_point(one.end, turn, shift))
        return Opening(*ends, one.bottom, one.top, one.id)

    old = scene.room
    return Scene(
        Room(
            tuple(moved_point(corner, turn, shift) for corner in old.corners),
            old.height,
            tuple(map(opening, old.doors)),
            tuple(map(opening, old.windows)),
            old.room_type,
        ),
        tuple(moved_box(box, turn, shift) for box in scene.boxes),
        scene.id,
    )
