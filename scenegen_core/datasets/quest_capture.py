"""What a capture of the npm package @iwer/sem holds, and where it lies in the core frame.

A capture lists planes (walls, doors, windows, pictures) and volumes (furniture), each with a pose
in a y-up frame. A plane lies in the x and z of its own frame and its y points out of the room; a
volume is z-up in its own frame and its front looks along −y.
"""

from __future__ import annotations

from collections.abc import Iterable
from math import atan2

import msgspec
import numpy as np
from msgspec import Struct
from scipy.spatial.transform import Rotation

from scenegen_core.datasets.contents import Measured
from scenegen_core.datasets.headset import Block, Panel
from scenegen_core.datasets.outlines import point_of
from scenegen_core.errors import DataError
from scenegen_core.scene.frames import to_core
from scenegen_core.scene.geometry import Floats


class XYZ(Struct, frozen=True):
    """A position or an offset, metres."""

    x: Measured
    y: Measured
    z: Measured = 0.0


class Quaternion(Struct, frozen=True):
    """A turn."""

    x: Measured
    y: Measured
    z: Measured
    w: Measured


class Extent(Struct, frozen=True):
    """Full sizes along the entity's own x, y and z, metres."""

    width: Measured
    height: Measured
    depth: Measured = 0.0


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

    entities: tuple[msgspec.Raw, ...] = msgspec.field(name="spatialEntities")


def floor_of(entities: Iterable[Entity]) -> float:
    """The height of the floor in the capture's frame, metres."""
    heights = [e.pose.position.y for e in entities if e.label == "FLOOR"]
    if not heights:
        raise DataError("The capture has no floor; scan the room again.")
    return heights[0]


def panel_of(entity: Entity) -> Panel:
    """An entity that is an upright plane; DataError if it is none."""
    plane = entity.plane
    if plane is None:
        raise DataError(f"This {entity.label} of the capture is no plane; scan the room again.")
    left, width, height = plane.offset.x, plane.extent.width, plane.extent.height
    ends = _placed(entity, np.array([[left, 0.0, 0.0], [left + width, 0.0, 0.0]]))
    middle = entity.pose.position.y
    return Panel(
        label=entity.label,
        start=point_of(ends[0]),
        end=point_of(ends[1]),
        bottom=middle - height / 2,
        top=middle + height / 2,
        heading=_heading(entity),
    )


def block_of(entity: Entity) -> Block:
    """An entity that is a volume; DataError if it is none."""
    volume = entity.volume
    if volume is None:
        raise DataError(f"This {entity.label} of the capture is no box; scan the room again.")
    extent = volume.extent
    size = np.array([extent.width, extent.height, extent.depth])
    x, y, z = (float(value) for value in _placed(entity, _vector(volume.offset) + size / 2))
    return Block(
        label=entity.label,
        center=(x, y, z),
        size=(extent.height, extent.width, extent.depth),
        heading=_heading(entity),
    )


def _placed(entity: Entity, local: Floats) -> Floats:
    """Points (…, 3) of the entity's own frame in the core frame, floor not yet at 0."""
    return to_core(_turn(entity).apply(local) + _vector(entity.pose.position))


def _turn(entity: Entity) -> Rotation:
    turn = entity.pose.orientation
    try:
        return Rotation.from_quat([turn.x, turn.y, turn.z, turn.w])
    except ValueError:
        raise DataError(f"This {entity.label} of the capture has no direction.") from None


def _vector(value: XYZ) -> Floats:
    """The same as an array (3,)."""
    return np.array([value.x, value.y, value.z])


def _heading(entity: Entity) -> float:
    """Where an entity looks: along its own −y, radians."""
    x, y, _ = to_core(_turn(entity).apply(np.array([0.0, -1.0, 0.0])))
    return atan2(y, x)
