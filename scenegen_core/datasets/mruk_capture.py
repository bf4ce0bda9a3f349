"""What Meta's MR Utility Kit writes down of a room, and where it lies in the core frame.

A file lists the rooms of a home, each with anchors in Unity's frame: a plane lies in the x and y
of its own frame and its z points into the room; a volume has its z up, its origin in the middle
of its top, and its front along −y, as in the captures of the same headsets.
"""

from __future__ import annotations

from math import atan2

import msgspec
import numpy as np
from msgspec import Struct
from scipy.spatial.transform import Rotation

from scenegen_core.datasets.contents import Measured
from scenegen_core.datasets.headset import Block, Panel
from scenegen_core.datasets.outlines import point_of
from scenegen_core.errors import SceneError
from scenegen_core.scene.frames import unity_to_core
from scenegen_core.scene.geometry import Floats
from scenegen_core.scene.model import Vector3

Pair = tuple[Measured, Measured]
Triple = tuple[Measured, Measured, Measured]


class Transform(Struct, frozen=True, rename="pascal"):
    """Where the anchor's own frame lies in the scene's."""

    translation: Triple
    rotation: Triple
    """Degrees about x, y and z; Unity turns about z first, then x, then y."""
    scale: Triple = (1.0, 1.0, 1.0)


class Rectangle(Struct, frozen=True, rename="pascal"):
    """The lowest and highest corner of a plane in its own frame, metres."""

    min: Pair
    max: Pair


class Cuboid(Struct, frozen=True, rename="pascal"):
    """The lowest and highest corner of a volume in its own frame, metres."""

    min: Triple
    max: Triple


class Anchor(Struct, frozen=True, rename="pascal"):
    """A plane, a volume or both, with its labels."""

    transform: Transform
    uuid: str = msgspec.field(name="UUID", default="")
    semantic_classifications: tuple[str, ...] = ()
    plane_bounds: Rectangle | None = None
    volume_bounds: Cuboid | None = None
    boundary: tuple[Pair, ...] = msgspec.field(name="PlaneBoundary2D", default=())

    @property
    def label(self) -> str:
        """The first of the labels, which says most."""
        return self.semantic_classifications[0] if self.semantic_classifications else "UNKNOWN"


class SavedRoom(Struct, frozen=True, rename="pascal"):
    """A room."""

    anchors: tuple[msgspec.Raw, ...]


class Saved(Struct, frozen=True, rename="pascal"):
    """A whole file."""

    rooms: tuple[msgspec.Raw, ...]
    coordinate_system: str = ""


def panel_of(anchor: Anchor, plane: Rectangle) -> Panel:
    """An anchor as the upright plane that it is."""
    (left, low), (right, high) = plane.min, plane.max
    ends = _placed(anchor, np.array([[left, low, 0.0], [right, high, 0.0]]))
    return Panel(
        label=anchor.label,
        start=point_of(ends[0]),
        end=point_of(ends[1]),
        bottom=float(ends[:, 2].min()),
        top=float(ends[:, 2].max()),
        heading=_heading(anchor, (0.0, 0.0, 1.0)),
    )


def block_of(anchor: Anchor, volume: Cuboid) -> Block:
    """An anchor as the box that it is."""
    low, high = np.array(volume.min), np.array(volume.max)
    x, y, z = (float(value) for value in _placed(anchor, (low + high) / 2))
    width, depth, height = (high - low) * anchor.transform.scale
    return Block(
        label=anchor.label,
        center=(x, y, z),
        size=(float(depth), float(width), float(height)),
        heading=_heading(anchor, (0.0, -1.0, 0.0)),
    )


def corners_of(anchor: Anchor) -> Floats:
    """The corners of a plane in the core frame, (n, 3); SceneError if it has no size."""
    flat = anchor.boundary
    if not flat and anchor.plane_bounds is not None:
        (left, low), (right, high) = anchor.plane_bounds.min, anchor.plane_bounds.max
        flat = ((left, low), (right, low), (right, high), (left, high))
    if not flat:
        raise SceneError(f"its {anchor.label} has no size")
    return _placed(anchor, np.array([(x, y, 0.0) for x, y in flat]))


def _placed(anchor: Anchor, local: Floats) -> Floats:
    """Points (…, 3) of the anchor's own frame in the core frame, floor not yet at 0."""
    place = anchor.transform
    return unity_to_core(_turn(anchor).apply(local * place.scale) + place.translation)


def _heading(anchor: Anchor, front: Vector3) -> float:
    """The heading of a direction of the anchor's own frame, radians."""
    x, y, _ = unity_to_core(_turn(anchor).apply(np.array(front)))
    return atan2(y, x)


def _turn(anchor: Anchor) -> Rotation:
    x, y, z = anchor.transform.rotation
    return Rotation.from_euler("YXZ", [y, x, z], degrees=True)
