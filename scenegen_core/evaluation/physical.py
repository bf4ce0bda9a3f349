"""Hard facts about a placement, measured by other means than the rules that made it.

Collision: footprints overlap by more than 2 % of the smaller, with more than 1 cm of common height,
natural overlaps excepted. Outside: more than 1 % of the footprint. Door: the footprint meets a
square before the door as deep as the door is wide. Path: a door, seat, bed or storage front that
was reached by a walker 0.6 m wide no longer is.
"""

from __future__ import annotations

import numpy as np
import shapely

from scenegen_core.evaluation.bench import Bench
from scenegen_core.placement.mounts import RUG_HEIGHT
from scenegen_core.scene.geometry import footprints
from scenegen_core.scene.model import Box, Opening, Room

OVERLAP = 0.02  # share of the smaller footprint
COMMON_HEIGHT = 0.01  # metres
OUTSIDE = 0.01  # share of the footprint
SLIVER = 1e-3  # square metres of a door's square that rounding may touch

PHYSICAL = ("collides", "outside", "blocks_door", "breaks_path")
DECLINED = "declined"
"""1 where the program says that there is no good place: it then puts the object nowhere."""


def physical(bench: Bench, box: Box) -> dict[str, float]:
    """Each fact as 1 (broken) or 0."""
    scene, footprint = bench.case.scene, _polygon(box)
    room = shapely.Polygon(scene.room.corners)
    outside = 1 - footprint.intersection(room).area / footprint.area
    return {
        "collides": float(any(_collide(box, footprint, other) for other in scene.boxes)),
        "outside": float(outside > OUTSIDE),
        "blocks_door": float(any(_blocks(box, footprint, scene.room, d) for d in scene.room.doors)),
        "breaks_path": float(bench.walking.blocked_by(box) is not None),
    }


def _collide(box: Box, footprint: shapely.Polygon, other: Box) -> bool:
    if {box.category, other.category} == {"Chair", "Table"}:
        return False
    if min(box.size[2], other.size[2]) <= RUG_HEIGHT:
        return False
    if min(box.top, other.top) - max(box.bottom, other.bottom) <= COMMON_HEIGHT:
        return False
    shape = _polygon(other)
    shared = footprint.intersection(shape).area
    return bool(shared > OVERLAP * min(footprint.area, shape.area))


def _blocks(box: Box, footprint: shapely.Polygon, room: Room, door: Opening) -> bool:
    if box.bottom >= door.top or box.size[2] <= RUG_HEIGHT:
        return False
    start, end = np.array(door.start), np.array(door.end)
    run = end - start
    normal = np.array([-run[1], run[0]])
    squares = [
        shapely.Polygon([start, end, end + side * normal, start + side * normal])
        for side in (1, -1)
    ]
    polygon = shapely.Polygon(room.corners)
    inner = max(squares, key=lambda square: square.intersection(polygon).area)
    return bool(footprint.intersection(inner).area > SLIVER)


def _polygon(box: Box) -> shapely.Polygon:
    return shapely.Polygon(footprints([box]).corners[0])
