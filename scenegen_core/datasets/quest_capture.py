"""What a capture of the npm package @iwer/sem holds, and where it lies in the core frame.

A capture lists planes (walls, doors, windows, pictures) and volumes (furniture), each with a pose
in a y-up frame. A plane lies in the x and z of its own frame and its y points out of the room; a
volume is z-up in its own frame and its front looks along −y.
"""

from __future__ import annotations

from math import atan2

import msgspec
import numpy as np
from msgspec import Struct
from scipy.spatial.transform import Rotation

from scenegen_core.errors import DataError
from scenegen_core.scene.frames import Floats, to_core
from scenegen_core.scene.model import Point


class XYZ(Struct, frozen=True):
    """A position or an offset, metres."""

    x: float
    y: float
    z: float = 0.0


class Quaternion(Struct, frozen=True):
    """A turn."""

    x: float
    y: float
    z: float
    w: float


class Extent(Struct, frozen=True):
    """Full sizes along the entity's own x, y and z, metres."""

    width: float
    height: float
    depth: float = 0.0


class Pose(Struct, frozen=True):
    """Where the entity's own frame lies in the capture's."""

    position: XYZ
    orientation: Quaternion


class Bounds(Struct, frozen=True):
    """The lowest corner of a rectangle or box in the entity's own frame, and its size."""

    offset: XYZ
    extent: Extent


class Entity(Struct, frozen=True):
    """A plane, a volume or a mesh with its label."""

    label: str = msgspec.field(name="semanticLabel_META")
    pose: Pose = msgspec.field(name="locatable_META")
    plane: Bounds | None = msgspec.field(name="bounded2D_META", default=None)
    volume: Bounds | None = msgspec.field(name="bounded3D_META", default=None)


class Capture(Struct, frozen=True):
    """A whole file."""

    entities: tuple[Entity, ...] = msgspec.field(name="spatialEntities")


def floor_of(entities: tuple[Entity, ...]) -> float:
    """The height of the floor in the capture's frame, metres."""
    heights = [e.pose.position.y for e in entities if e.label == "FLOOR"]
    if not heights:
        raise DataError("The capture has no floor; scan the room again.")
    return heights[0]


def extent_of(entity: Entity) -> Extent:
    """The size of a plane or a volume; DataError if it is neither."""
    bounds = entity.plane or entity.volume
    if bounds is None:
        raise DataError(f"A {entity.label} of the capture has no size; scan the room again.")
    return bounds.extent


def placed(entity: Entity, local: Floats) -> Floats:
    """Points (…, 3) of the entity's own frame in the core frame, floor not yet at 0."""
    return to_core(_turn(entity).apply(local) + vector_of(entity.pose.position))


def _turn(entity: Entity) -> Rotation:
    turn = entity.pose.orientation
    return Rotation.from_quat([turn.x, turn.y, turn.z, turn.w])


def vector_of(value: XYZ) -> Floats:
    """The same as an array (3,)."""
    return np.array([value.x, value.y, value.z])


def heading_of(entity: Entity, front: tuple[int, int, int]) -> float:
    """The heading of a direction of the entity's own frame, radians."""
    x, y, _ = to_core(_turn(entity).apply(np.array(front, dtype=float)))
    return atan2(y, x)


def segment_of(entity: Entity) -> tuple[Point, Point]:
    """The two ends of a wall, door or window seen from above."""
    if entity.plane is None:
        raise DataError(f"A {entity.label} of the capture is not a plane; scan the room again.")
    left, width = entity.plane.offset.x, entity.plane.extent.width
    ends = placed(entity, np.array([[left, 0.0, 0.0], [left + width, 0.0, 0.0]]))
    return point_of(ends[0]), point_of(ends[1])


def point_of(position: Floats) -> Point:
    """The plan of a position (2 or 3,), to a tenth of a millimetre."""
    return round(float(position[0]), 4), round(float(position[1]), 4)
