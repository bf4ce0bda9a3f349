"""Homes drawn in Sweet Home 3D, as ``.sh3d`` files or as the XML inside of them.

A home has levels; on them rooms, walls, doors, windows and pieces of furniture, some in groups. A
piece belongs to the room of its level that contains its center. Homes of versions before 5.3 hold
a Java object instead of XML and are refused.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TypeVar
from xml.etree.ElementTree import Element, ParseError, fromstring

from scenegen_core.datasets.contents import Head, content, member
from scenegen_core.datasets.labels import categories_of, category_of
from scenegen_core.datasets.plans import (
    STEP,
    between_walls,
    checked_room,
    furnished,
    scene_id,
    with_openings,
)
from scenegen_core.datasets.remarks import Report, Skipped, usable_boxes
from scenegen_core.datasets.sweethome3d_plan import (
    box_of,
    height_of,
    id_of,
    is_fixed,
    level_of,
    number_of,
    opening_of,
    point_at,
    room_type_of,
)
from scenegen_core.errors import DataError, SceneError
from scenegen_core.scene.model import Box, Opening, Point, Room, Scene

SOURCE = "sweethome3d"
PIECES = ("pieceOfFurniture", "light", "shelfUnit")
HOME = "Home.xml"
OLD_HOME = "Home"

T = TypeVar("T")
_OnLevels = list[tuple[str, T]]


def recognizes(head: Head) -> bool:
    """Whether the file is a home or the XML of one."""
    is_xml = head.start.lstrip().startswith(b"<") and b"<home " in head.start
    return is_xml or bool({HOME, OLD_HOME} & set(head.members))


def read_scenes(path: Path, report: Report) -> Iterator[Scene]:
    """The rooms of a home, level by level; DataError if it cannot be read."""
    home = _home(path)
    drawn = _rooms(home, path, report) or _rooms_between_walls(home, path, report)
    if not drawn:
        raise DataError(f"{path} has neither rooms nor walls around one; draw its rooms.")
    boxes = _boxes(home, path, report)
    doors, windows = _openings(home, path, report)
    for level in sorted({level for level, _ in (*drawn, *boxes, *doors, *windows)}):
        usable = usable_boxes(_of(level, boxes), path, report)
        rooms = furnished(_of(level, drawn), usable, path, report)
        yield from with_openings(rooms, _of(level, doors), _of(level, windows), path, report)


def _of(level: str, things: _OnLevels[T]) -> list[T]:
    return [thing for its_level, thing in things if its_level == level]


def _home(path: Path) -> Element:
    """The XML of a home; DataError if there is none or if it is broken."""
    members = Head(path).members
    if members and HOME not in members:
        raise DataError(
            f"{path} was saved by an old version of Sweet Home 3D, in a form that only it reads; "
            "open the home in version 5.3 or later and save it again."
        )
    text = member(path, HOME) if members else content(path)
    try:
        return fromstring(text)  # noqa: S314 (expat bounds entities and opens no other file)
    except ParseError as error:
        raise DataError(f"{path} is broken XML ({error}); save the home again.") from None


def _rooms(home: Element, path: Path, report: Report) -> _OnLevels[Scene]:
    """The rooms that are drawn, without what is in them."""
    rooms: _OnLevels[Scene] = []
    for number, element in enumerate(home.iter("room")):
        level, name = level_of(element), element.get("name", "")
        if element.get("floorVisible") == "false":
            continue  # a ceiling, drawn above other rooms
        try:
            corners = [point_at(corner, "x", "y") for corner in element.iter("point")]
            room = checked_room(
                corners, height=height_of(home, level), room_type=room_type_of(name)
            )
        except (SceneError, DataError) as error:
            report(Skipped(path, f"room {name or number!r}", str(error)))
        else:
            rooms.append((level, _empty(room, path, level, number, name)))
    return rooms


def _rooms_between_walls(home: Element, path: Path, report: Report) -> _OnLevels[Scene]:
    """The rooms of a home in which only walls are drawn; round walls count as straight."""
    walls: _OnLevels[tuple[Point, Point, float]] = []
    for number, element in enumerate(home.iter("wall")):
        try:
            ends = point_at(element, "xStart", "yStart"), point_at(element, "xEnd", "yEnd")
            walls.append((level_of(element), (*ends, number_of(element, "thickness") / 100)))
        except DataError as error:
            report(Skipped(path, f"wall {number}", str(error)))
    rooms: _OnLevels[Scene] = []
    for level in sorted({level for level, _ in walls}):
        for number, corners in enumerate(between_walls(_of(level, walls))):
            try:
                room = checked_room(corners, height=height_of(home, level))
            except (SceneError, DataError) as error:
                report(Skipped(path, f"room {number} between the walls", str(error)))
            else:
                rooms.append((level, _empty(room, path, level, number, "")))
    return rooms


def _boxes(home: Element, path: Path, report: Report) -> _OnLevels[Box]:
    """The pieces of furniture, those in groups too."""
    boxes: _OnLevels[Box] = []
    pieces = (element for element in home.iter() if element.tag in PIECES)
    for number, piece in enumerate(pieces):
        piece_id = id_of(piece, number)
        if piece.get("visible") == "false":
            report(Skipped(path, f"object {piece_id!r}", "it is hidden in the home"))
            continue
        category = _category(piece, path, report)
        if category is None:
            continue
        try:
            boxes.append((level_of(piece), box_of(piece, piece_id, category)))
        except DataError as error:
            report(Skipped(path, f"object {piece_id!r}", str(error)))
    return boxes


def _category(piece: Element, path: Path, report: Report) -> str | None:
    """The category of a piece by the name it was given, else by its model in the catalogue."""
    name, model = piece.get("name", ""), piece.get("catalogId", "")
    known = categories_of(SOURCE)
    return category_of(
        SOURCE, model if name not in known and model in known else name, path, report
    )


def _openings(
    home: Element, path: Path, report: Report
) -> tuple[_OnLevels[Opening], _OnLevels[Opening]]:
    """The doors and the windows."""
    doors: _OnLevels[Opening] = []
    windows: _OnLevels[Opening] = []
    for number, element in enumerate(home.iter("doorOrWindow")):
        opening_id = id_of(element, number)
        try:
            opening = opening_of(element, opening_id)
        except DataError as error:
            report(Skipped(path, f"opening {opening_id!r}", str(error)))
        else:
            kind = doors if opening.bottom < STEP and not is_fixed(element) else windows
            kind.append((level_of(element), opening))
    return doors, windows


def _empty(room: Room, path: Path, level: str, number: int, name: str) -> Scene:
    return Scene(room, id=scene_id(path, level, f"r{number}"), name=name, source=SOURCE)
