"""The rooms that speed is measured in: the one of the targets, and how it grows."""

from __future__ import annotations

from dataclasses import replace
from math import cos, pi, sin

import numpy as np

from scenegen_core.scene.model import Box, Opening, Point, Room, Scene

FURNITURE = (
    ("Sofa", (3.0, 0.5), (0.95, 2.0, 0.8), pi / 2, 0.4),
    ("Table", (3.0, 1.9), (0.6, 1.1, 0.4), pi / 2, 0.2),
    ("Storage", (3.0, 4.77), (0.42, 1.6, 0.5), -pi / 2, 0.25),
    ("TV", (3.0, 4.78), (0.1, 1.1, 0.65), -pi / 2, 0.825),
    ("Storage", (0.2, 4.2), (0.35, 0.9, 2.0), 0.0, 1.0),
    ("Table", (4.9, 2.6), (0.9, 0.9, 0.74), 0.0, 0.37),
    ("Chair", (4.2, 2.6), (0.5, 0.45, 0.9), 0.0, 0.45),
    ("Chair", (5.6, 2.6), (0.5, 0.45, 0.9), pi, 0.45),
    ("Chair", (4.9, 3.3), (0.5, 0.45, 0.9), -pi / 2, 0.45),
    ("Decor", (0.35, 0.35), (0.4, 0.4, 1.2), 0.0, 0.6),
    ("Picture", (3.0, 0.02), (0.04, 0.9, 0.7), pi / 2, 1.5),
    ("Other", (1.2, 2.6), (0.5, 0.5, 0.45), 0.3, 0.225),
)
"""Category, middle on the plan, depth × width × height, heading, height of the middle."""

DOOR = Opening((0.0, 1.5), (0.0, 2.4), 0.0, 2.0, "door")
WINDOW = Opening((6.0, 1.0), (6.0, 2.4), 0.9, 2.2, "window")


def living_room() -> Scene:
    """6 × 5 m and 12 boxes: the room of the targets."""
    corners = ((0.0, 0.0), (6.0, 0.0), (6.0, 5.0), (0.0, 5.0))
    room = Room(corners, doors=(DOOR,), windows=(WINDOW,))
    boxes = (
        Box(f"box{i}", category, (x, y, z), size, heading)
        for i, (category, (x, y), size, heading, z) in enumerate(FURNITURE)
    )
    return Scene(room, tuple(boxes))


def changed(scene: Scene, step: int) -> Scene:
    """The scene after a small step of a drag of its last box."""
    box = scene.boxes[-1]
    x, y, z = box.center
    moved = replace(box, center=(x + 0.2 * cos(step), y + 0.2 * sin(step), z))
    return scene.with_box(moved)


def hall(side: float, boxes: int, *, corners: int = 4, seed: int = 1) -> Scene:
    """A square hall with that many boxes of the living room's kinds, apart on a lattice.

    More corners make its far wall a staircase of shallow steps: the same floor, more walls.
    """
    rng = np.random.default_rng(seed)
    room = Room(_outline(side, corners), doors=(Opening((0.0, 1.0), (0.0, 1.9)),))
    lattice = int(np.ceil(np.sqrt(boxes)))
    pitch = (side - 1.5) / lattice
    cells = rng.permutation(lattice * lattice)[:boxes]
    found = []
    for number, cell in enumerate(cells.tolist()):
        category, _, size, _, z = FURNITURE[number % len(FURNITURE)]
        x, y = ((cell % lattice) + 0.5) * pitch, ((cell // lattice) + 0.5) * pitch
        shrink = min(1.0, 0.9 * pitch / max(size[:2]))
        small = (size[0] * shrink, size[1] * shrink, size[2])
        heading = float(rng.integers(4)) * pi / 2
        found.append(Box(f"box{number}", category, (x + 0.5, y + 0.5, z), small, heading))
    return Scene(room, tuple(found))


def _outline(side: float, corners: int) -> tuple[Point, ...]:
    teeth = (corners - 4) // 4
    far: list[Point] = []
    for tooth in range(teeth):
        start = side - (tooth + 0.25) * side / teeth
        end = start - 0.5 * side / teeth
        far += [(start, side), (start, side - 0.2), (end, side - 0.2), (end, side)]
    return ((0.0, 0.0), (side, 0.0), (side, side), *far, (0.0, side))
