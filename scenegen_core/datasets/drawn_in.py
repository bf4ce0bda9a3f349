"""Outlines drawn in: for sources whose outlines run behind the faces of the walls."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from scenegen_core.scene.geometry import Floats, distances_to_segments, left_of
from scenegen_core.scene.model import Opening, Point, Scene

STRAIGHT = 1e-3  # radians; walls that differ less go straight on


def drawn_in(scene: Scene, by: float) -> Scene:
    """The scene with every wall moved into the room, metres, and doors and windows with it."""
    walls = np.array(scene.room.walls, dtype=float)
    run = walls[:, 1] - walls[:, 0]
    along = run / np.hypot(run[:, 0], run[:, 1])[:, None]
    moved = walls + by * left_of(along)[:, None, :]
    corners = np.array([_corner(moved, along, i) for i in range(len(moved))])
    inner = np.stack([corners, np.roll(corners, -1, axis=0)], axis=1)

    def on_wall(opening: Opening) -> Opening:
        middle = np.mean([opening.start, opening.end], axis=0)[None]
        wall = inner[distances_to_segments(middle, walls)[0].argmin()]
        return replace(
            opening, start=_nearest(opening.start, wall), end=_nearest(opening.end, wall)
        )

    room = replace(
        scene.room,
        corners=tuple((float(x), float(y)) for x, y in corners),
        doors=tuple(map(on_wall, scene.room.doors)),
        windows=tuple(map(on_wall, scene.room.windows)),
    )
    return scene.with_room(room)


def _corner(moved: Floats, along: Floats, i: int) -> Floats:
    """Where the moved wall i begins: where it meets the one before it."""
    one, two = along[i - 1], along[i]
    cross = one[0] * two[1] - one[1] * two[0]
    start: Floats = moved[i, 0]
    if abs(cross) < STRAIGHT:
        return start
    offset = moved[i - 1, 0] - start
    far = (one[0] * offset[1] - one[1] * offset[0]) / cross
    return np.asarray(start + far * two, dtype=np.float64)


def _nearest(point: Point, wall: Floats) -> Point:
    """The point of a wall nearest to a point."""
    run = wall[1] - wall[0]
    share = float(np.clip((point - wall[0]) @ run / (run @ run), 0, 1))
    x, y = (wall[0] + share * run).tolist()
    return (x, y)
