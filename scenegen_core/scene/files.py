"""Scenes as versioned JSON: the one schema of files and of the wire.

The records below are what a file holds and what the page sends; :func:`scene_of` and
:func:`record_of` go between them and the values of ``model``. Limits stand in the types, so a
wrong value is refused with its path (``$.boxes[3].size[2]``).
"""

from __future__ import annotations

from math import isfinite
from typing import Annotated, Literal

import msgspec
from msgspec import UNSET, Meta, Struct, UnsetType
from shapely import Polygon
from shapely.validation import explain_validity

from scenegen_core.errors import SceneError
from scenegen_core.scene.model import DEFAULT_HEIGHT, Box, Opening, Room, Scene

VERSION: Literal[1] = 1
MAX_BOXES = 500
MAX_CORNERS = 200
MAX_ID = 80  # characters
MIN_AREA = 0.5  # square metres; below that nobody can stand in it
REACH = 1000.0  # metres; coordinates further out are mistakes

Coordinate = Annotated[float, Meta(ge=-REACH, le=REACH)]
Length = Annotated[float, Meta(gt=0, le=100)]
Height = Annotated[float, Meta(ge=-10, le=100)]
Identifier = Annotated[str, Meta(min_length=1, max_length=MAX_ID)]
Name = Annotated[str, Meta(max_length=120)]
PointRecord = tuple[Coordinate, Coordinate]
CenterRecord = tuple[Coordinate, Coordinate, Coordinate]
SizeRecord = tuple[Length, Length, Length]


class OpeningRecord(Struct, frozen=True, forbid_unknown_fields=True):
    """A door or window: a segment on the outline from ``bottom`` to ``top``, metres."""

    id: Identifier
    start: PointRecord
    end: PointRecord
    bottom: Height = 0.0
    top: Height = 2.0


class RoomRecord(Struct, frozen=True, forbid_unknown_fields=True):
    """The outline of a room: corners in order, metres, with its doors and windows."""

    corners: Annotated[tuple[PointRecord, ...], Meta(min_length=3, max_length=MAX_CORNERS)]
    height: Length = DEFAULT_HEIGHT
    doors: Annotated[tuple[OpeningRecord, ...], Meta(max_length=100)] = ()
    windows: Annotated[tuple[OpeningRecord, ...], Meta(max_length=100)] = ()
    room_type: Name = ""


class BoxRecord(Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True):
    """A piece of furniture: center of the box, full size (depth, width, height), heading."""

    id: Identifier
    category: Identifier
    center: CenterRecord
    size: SizeRecord
    heading: Annotated[float, Meta(ge=-100, le=100)] = 0.0
    label: Name = ""
    front_known: bool = True
    front_from_wall: bool = False
    parent: Identifier | None = None
    placed: bool = False
    item: Identifier | None = None


class SceneRecord(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A scene file."""

    format: Literal["scenegen.scene"] = "scenegen.scene"
    version: Literal[1] = VERSION
    id: Annotated[str, Meta(max_length=MAX_ID)] = ""
    name: Name = ""
    source: Name = ""
    room: RoomRecord
    boxes: Annotated[tuple[BoxRecord, ...], Meta(max_length=MAX_BOXES)] = ()


class _Head(Struct, frozen=True):
    """Just enough of a file to say what is wrong with it."""

    format: str | UnsetType = UNSET
    version: int | UnsetType = UNSET


def read_scene(text: bytes) -> Scene:
    """The scene of a file's bytes; SceneError says what is wrong and where."""
    return scene_of(decode_scene(text))


def decode_scene(text: bytes) -> SceneRecord:
    """The record of a file's bytes; SceneError says what is wrong and where."""
    try:
        head = msgspec.json.decode(text, type=_Head)
    except (msgspec.DecodeError, UnicodeDecodeError) as error:
        raise SceneError(f"This is not a scene file: {error}. Save it again and retry.") from None
    if head.format != "scenegen.scene":
        raise SceneError("This is JSON, but not a scene file: its format is not 'scenegen.scene'.")
    if head.version != VERSION:
        raise SceneError(
            f"This scene file has version {head.version}; this program reads version {VERSION}."
        )
    try:
        return msgspec.json.decode(text, type=SceneRecord)
    except (msgspec.ValidationError, UnicodeDecodeError) as error:
        raise SceneError(f"The scene file is wrong: {error}.") from None


def write_scene(scene: Scene) -> bytes:
    """The bytes of a scene file, indented for people."""
    return msgspec.json.format(msgspec.json.encode(record_of(scene)), indent=2)


def scene_of(record: SceneRecord) -> Scene:
    """The core value of a record; SceneError if the outline is not one of a room."""
    return Scene(
        room=room_of(record.room),
        boxes=tuple(box_of(box) for box in record.boxes),
        id=record.id,
        name=record.name,
        source=record.source,
    )


def record_of(scene: Scene) -> SceneRecord:
    """The record of a core value."""
    return SceneRecord(
        room=RoomRecord(
            corners=scene.room.corners,
            height=scene.room.height,
            doors=tuple(_opening_record(door) for door in scene.room.doors),
            windows=tuple(_opening_record(window) for window in scene.room.windows),
            room_type=scene.room.room_type,
        ),
        boxes=tuple(box_record(box) for box in scene.boxes),
        id=scene.id,
        name=scene.name,
        source=scene.source,
    )


def room_of(record: RoomRecord) -> Room:
    """The core room of a record, turned anticlockwise; SceneError if the outline is not simple."""
    return Room(
        corners=_outline(record.corners),
        height=record.height,
        doors=tuple(_opening_of(door) for door in record.doors),
        windows=tuple(_opening_of(window) for window in record.windows),
        room_type=record.room_type,
    )


def box_of(record: BoxRecord) -> Box:
    """The core box of a record; SceneError if a number is not one."""
    if not all(map(isfinite, (*record.center, *record.size, record.heading))):
        raise SceneError(f"The box {record.id!r} has a number that is not finite; measure again.")
    return Box(**msgspec.structs.asdict(record))


def box_record(box: Box) -> BoxRecord:
    """The record of a core box."""
    return BoxRecord(
        **{name: getattr(box, name) for name in BoxRecord.__struct_fields__},
    )


def _outline(corners: tuple[PointRecord, ...]) -> tuple[PointRecord, ...]:
    """The corners anticlockwise, each once in a row; SceneError if it is no room."""
    after = (*corners[1:], *corners[:1])
    corners = tuple(corner for corner, other in zip(corners, after, strict=True) if corner != other)
    if len(corners) < 3:  # noqa: PLR2004 (a triangle)
        raise SceneError("The outline of the room has fewer than three corners; add some.")
    polygon = Polygon(corners)
    if not polygon.is_valid:
        raise SceneError(
            f"The outline of the room crosses or touches itself ({explain_validity(polygon)}); "
            "move the corners so that the walls do not cross."
        )
    if polygon.area < MIN_AREA:
        raise SceneError(
            f"The room has only {polygon.area:.2f} m² of floor; check the outline (metres)."
        )
    return corners if polygon.exterior.is_ccw else corners[::-1]


def _opening_of(record: OpeningRecord) -> Opening:
    if record.top <= record.bottom:
        raise SceneError(f"The opening {record.id!r} ends below where it begins; swap the heights.")
    return Opening(**msgspec.structs.asdict(record))


def _opening_record(opening: Opening) -> OpeningRecord:
    return OpeningRecord(
        id=opening.id, start=opening.start, end=opening.end, bottom=opening.bottom, top=opening.top
    )
