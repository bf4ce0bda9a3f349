"""Rooms saved by Meta's MR Utility Kit (``SaveSceneToJsonString``) as scenes.

A file lists the rooms of a home, each with anchors in Unity's frame: a plane lies in the x and y
of its own frame and its z points into the room; a volume has its z up, its origin in the middle
of its top, and its front along −y, as in the captures of the same headsets.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from math import atan2
from pathlib import Path

import msgspec
import numpy as np
from msgspec import Struct
from scipy.spatial.transform import Rotation

from scenegen_core.datasets.contents import BROKEN_JSON, Head, Measured, content, fields_of
from scenegen_core.datasets.headset import WALLS, Block, Panel, Seen, panels_of, scene_of
from scenegen_core.datasets.labels import categories_of
from scenegen_core.datasets.outlines import outline_of, point_of
from scenegen_core.datasets.plans import scene_id
from scenegen_core.datasets.remarks import Report, Skipped
from scenegen_core.errors import DataError, SceneError, SceneGenError
from scenegen_core.scene.frames import Floats, unity_to_core
from scenegen_core.scene.model import DEFAULT_HEIGHT, Scene, Vector3

Pair = tuple[Measured, Measured]
Triple = tuple[Measured, Measured, Measured]

UNITY = "Unity"
HANGING = ("Picture", "TV")  # what may be there as a plane alone
FLOOR, CEILING = "FLOOR", "CEILING"
LYING = (FLOOR, CEILING, "GLOBAL_MESH")  # neither upright panels nor furniture


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


def recognizes(head: Head) -> bool:
    """Whether the file lists rooms of anchors."""
    rooms = head.fields.get("Rooms")
    return rooms is not None and "Anchors" in fields_of(rooms)


def read_scenes(path: Path, report: Report) -> Iterator[Scene]:
    """The rooms of a home in order; a broken one is reported. DataError if the file is broken."""
    try:
        saved = msgspec.json.decode(content(path), type=Saved)
    except BROKEN_JSON as error:
        raise DataError(f"{path} is not a scene of MR Utility Kit: {error}.") from None
    if saved.coordinate_system != UNITY:
        raise DataError(
            f"{path} is in the coordinate system {saved.coordinate_system!r}; save it again "
            f"with the coordinate system {UNITY!r}."
        )
    for number, raw in enumerate(saved.rooms, start=1):
        several = len(saved.rooms) > 1
        try:
            scene = _scene(msgspec.json.decode(raw, type=SavedRoom), path, report)
        except (*BROKEN_JSON, SceneGenError) as error:
            report(Skipped(path, f"room {number}", str(error)))
            continue
        yield replace(
            scene,
            id=scene_id(path, str(number)) if several else scene_id(path),
            name=scene_id(path),
        )


def _scene(saved: SavedRoom, path: Path, report: Report) -> Scene:
    """A room; SceneGenError if it has neither a floor nor walls."""
    anchors = list(_anchors(saved, path, report))
    things = tuple(thing for anchor in anchors if (thing := _thing(anchor, path, report)))
    walls = panels_of(things, WALLS)
    floors = [_corners(anchor) for anchor in anchors if anchor.label == FLOOR]
    ceilings = [_corners(anchor)[:, 2].mean() for anchor in anchors if anchor.label == CEILING]
    if floors:
        corners = tuple(point_of(corner) for corner in floors[0])
        floor = float(floors[0][:, 2].mean())
    else:
        corners = outline_of([(wall.start, wall.end) for wall in walls])
        floor = min(wall.bottom for wall in walls)
    tops = [*ceilings, *(wall.top for wall in walls)]
    ceiling = float(max(tops)) if tops else floor + DEFAULT_HEIGHT
    return scene_of(Seen(corners, floor, ceiling, things, "mruk"), path, report)


def _anchors(saved: SavedRoom, path: Path, report: Report) -> Iterator[Anchor]:
    """The usable anchors; the others are reported."""
    for number, raw in enumerate(saved.anchors, start=1):
        try:
            yield msgspec.json.decode(raw, type=Anchor)
        except BROKEN_JSON as error:
            report(Skipped(path, f"anchor {number}", str(error)))


def _thing(anchor: Anchor, path: Path, report: Report) -> Panel | Block | None:
    """What an anchor shows, None for floors, meshes and the like."""
    if anchor.label in LYING:
        return None
    if anchor.volume_bounds is not None:
        return _block(anchor, anchor.volume_bounds)
    category = categories_of("mruk").get(anchor.label)
    if anchor.plane_bounds is not None and (category is None or category in HANGING):
        return _panel(anchor, anchor.plane_bounds)
    report(Skipped(path, f"{anchor.label} {anchor.uuid!r}", "is no box; draw it again"))
    return None


def _panel(anchor: Anchor, plane: Rectangle) -> Panel:
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


def _block(anchor: Anchor, volume: Cuboid) -> Block:
    low, high = np.array(volume.min), np.array(volume.max)
    x, y, z = (float(value) for value in _placed(anchor, (low + high) / 2))
    width, depth, height = (high - low) * anchor.transform.scale
    return Block(
        label=anchor.label,
        center=(x, y, z),
        size=(float(depth), float(width), float(height)),
        heading=_heading(anchor, (0.0, -1.0, 0.0)),
    )


def _corners(anchor: Anchor) -> Floats:
    """The corners of a plane in the core frame, (n, 3)."""
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
