"""Rooms as neutral rows, one JSON object a line, plain or gzipped: the form all corpora share.

Frame of the core: metres, z up, anticlockwise outlines. ``half`` is half the (depth along the
heading, width, height); ``yaw`` is the heading; a ``category`` of null is clutter and is left out.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path

import msgspec
from msgspec import Struct

from scenegen_core.datasets.contents import BROKEN_JSON, Head, Measured, lines
from scenegen_core.datasets.remarks import Report, Skipped, log
from scenegen_core.errors import SceneError
from scenegen_core.scene.files import Length, OpeningRecord, RoomRecord, room_of
from scenegen_core.scene.model import DEFAULT_HEIGHT, Box, Opening, Scene

DOOR = (0.0, 2.0)  # metres; low and high edge of a door where the source gives none
WINDOW = (0.9, 2.1)  # metres; a usual sill and head, where the source gives none

Corner = tuple[Measured, Measured]
Triple = tuple[Measured, Measured, Measured]


class OpeningRow(Struct, frozen=True, omit_defaults=True):
    """A door or a window of a row."""

    segment: tuple[Corner, Corner]
    z: Corner | None = None
    """Low and high edge above the floor, metres; None where the source does not say."""


class ObjectRow(Struct, frozen=True):
    """An object of a row."""

    id: str
    label: str
    category: str | None
    center: Triple
    half: Triple
    yaw: Measured
    front_known: bool = True
    front_from_wall: bool = False
    parent: str | None = None


class RoomRow(Struct, frozen=True, kw_only=True):
    """A row: one room with its objects."""

    id: str
    source: str
    room_type: str
    polygon: tuple[Corner, ...]
    height: Length | None = None
    doors: tuple[OpeningRow, ...] = ()
    windows: tuple[OpeningRow, ...] = ()
    objects: tuple[ObjectRow, ...]


def recognizes(head: Head) -> bool:
    """Whether the first row is one of a room."""
    return {"id", "polygon", "objects"} <= head.fields.keys()


def read_scenes(path: Path, report: Report = log) -> Iterator[Scene]:
    """The rooms of a file of rows, one by one; a broken row is reported and left out."""
    for number, line in enumerate(lines(path), start=1):
        if not line.strip():
            continue
        try:
            yield scene_of(msgspec.json.decode(line, type=RoomRow))
        except (*BROKEN_JSON, SceneError) as error:
            report(Skipped(path, f"line {number}", str(error)))


def scene_of(row: RoomRow) -> Scene:
    """The scene of a row; SceneError if its outline, an opening or a box is not usable."""
    kept = {thing.id for thing in row.objects if thing.category is not None}
    room = RoomRecord(
        corners=row.polygon,
        height=DEFAULT_HEIGHT if row.height is None else row.height,
        doors=tuple(_opening(f"d{i}", door, DOOR) for i, door in enumerate(row.doors)),
        windows=tuple(_opening(f"w{i}", window, WINDOW) for i, window in enumerate(row.windows)),
        room_type=row.room_type,
    )
    return Scene(
        room=room_of(room),
        boxes=tuple(
            _box(thing, thing.category, kept) for thing in row.objects if thing.category is not None
        ),
        id=row.id,
        name=row.id,
        source=row.source,
    )


def row_of(scene: Scene) -> RoomRow:
    """The row of a scene; its name and which of its boxes were placed have no place in it."""
    room = scene.room
    return RoomRow(
        id=scene.id,
        source=scene.source,
        room_type=room.room_type,
        polygon=room.corners,
        height=room.height,
        doors=tuple(map(_opening_row, room.doors)),
        windows=tuple(map(_opening_row, room.windows)),
        objects=tuple(map(_object_row, scene.boxes)),
    )


def write_rows(scenes: Iterable[Scene]) -> bytes:
    """The bytes of a file of rows, a line a room."""
    return b"".join(msgspec.json.encode(row_of(scene)) + b"\n" for scene in scenes)


def _opening(opening_id: str, row: OpeningRow, usual: tuple[float, float]) -> OpeningRecord:
    start, end = row.segment
    bottom, top = row.z or usual
    return OpeningRecord(id=opening_id, start=start, end=end, bottom=bottom, top=top)


def _box(row: ObjectRow, category: str, kept: set[str]) -> Box:
    depth, width, height = (2 * half for half in row.half)
    return Box(
        id=row.id,
        category=category,
        center=row.center,
        size=(depth, width, height),
        heading=row.yaw,
        label=row.label,
        front_known=row.front_known,
        front_from_wall=row.front_from_wall,
        parent=row.parent if row.parent in kept else None,
    )


def _opening_row(opening: Opening) -> OpeningRow:
    return OpeningRow(segment=(opening.start, opening.end), z=(opening.bottom, opening.top))


def _object_row(box: Box) -> ObjectRow:
    depth, width, height = (size / 2 for size in box.size)
    return ObjectRow(
        id=box.id,
        label=box.label,
        category=box.category,
        center=box.center,
        half=(depth, width, height),
        yaw=box.heading,
        front_known=box.front_known,
        front_from_wall=box.front_from_wall,
        parent=box.parent,
    )
