"""Homes drawn in Sweet Home 3D, as ``.sh3d`` files or as the XML inside of them.

A home has levels; on them rooms, walls, doors, windows and pieces of furniture, some in groups. A
piece belongs to the room of its level that contains its center. Homes of versions before 5.3 hold
a Java object instead of XML and are refused.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from math import cos, sin
from pathlib import Path
from typing import TypeVar
from xml.etree.ElementTree import Element, ParseError, fromstring

import numpy as np

from scenegen_core.datasets.contents import Head, content, member
from scenegen_core.datasets.labels import categories_of, category_of
from scenegen_core.datasets.plans import (
    LONGEST_NAME,
    between_walls,
    checked_room,
    furnished,
    rounded,
    scene_id,
    with_openings,
)
from scenegen_core.datasets.remarks import Report, Skipped, usable_boxes
from scenegen_core.errors import DataError, SceneError
from scenegen_core.scene.frames import heading_of_sweet_home_turn, sweet_home_to_core
from scenegen_core.scene.model import DEFAULT_HEIGHT, Box, Opening, Point, Room, Scene

SOURCE = "sweethome3d"
PIECES = ("pieceOfFurniture", "light", "shelfUnit")
FARTHEST = 1e6  # centimetres; numbers beyond that are mistakes
STEP = 0.3  # metres; who walks through an opening steps no higher: higher ones are windows
FIXED = "fixedWindow"  # in the name of its model in the catalogue
HOME = "Home.xml"
OLD_HOME = "Home"
NO_LEVEL = "l0"  # where the things of a home without levels are

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
        level, name = _level(element), element.get("name", "")
        if element.get("floorVisible") == "false":
            continue  # a ceiling, drawn above other rooms
        try:
            corners = [_point(corner, "x", "y") for corner in element.iter("point")]
            room = checked_room(corners, height=_height(home, level), room_type=_room_type(name))
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
            ends = _point(element, "xStart", "yStart"), _point(element, "xEnd", "yEnd")
            walls.append((_level(element), (*ends, _number(element, "thickness") / 100)))
        except DataError as error:
            report(Skipped(path, f"wall {number}", str(error)))
    rooms: _OnLevels[Scene] = []
    for level in sorted({level for level, _ in walls}):
        for number, corners in enumerate(between_walls(_of(level, walls))):
            try:
                room = checked_room(corners, height=_height(home, level))
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
        piece_id = _id(piece, number)
        if piece.get("visible") == "false":
            report(Skipped(path, f"object {piece_id!r}", "it is hidden in the home"))
            continue
        category = _category(piece, path, report)
        if category is None:
            continue
        try:
            boxes.append((_level(piece), _box(piece, piece_id, category)))
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


def _box(piece: Element, piece_id: str, category: str) -> Box:
    """The box of a piece; tilted pieces have sizes as seen in the plan."""
    depth, width, height = (
        _number(piece, f"{side}InPlan", _number(piece, side))
        for side in ("depth", "width", "height")
    )
    bottom = _number(piece, "elevation", 0)
    middle = np.array([_number(piece, "x"), _number(piece, "y"), bottom + height / 2])
    x, y, z = rounded(sweet_home_to_core(middle))
    return Box(
        id=piece_id,
        category=category,
        center=(x, y, z),
        size=(depth / 100, width / 100, height / 100),
        heading=heading_of_sweet_home_turn(_number(piece, "angle", 0)),
        label=piece.get("name", ""),
    )


def _openings(
    home: Element, path: Path, report: Report
) -> tuple[_OnLevels[Opening], _OnLevels[Opening]]:
    """The doors and the windows."""
    doors: _OnLevels[Opening] = []
    windows: _OnLevels[Opening] = []
    for number, element in enumerate(home.iter("doorOrWindow")):
        opening_id = _id(element, number)
        try:
            opening = _opening(element, opening_id)
        except DataError as error:
            report(Skipped(path, f"opening {opening_id!r}", str(error)))
        else:
            kind = doors if opening.bottom < STEP and not _is_fixed(element) else windows
            kind.append((_level(element), opening))
    return doors, windows


def _opening(element: Element, opening_id: str) -> Opening:
    """The opening in the middle of its wall, which open leaves and sills reach out of."""
    turn, depth = _number(element, "angle", 0), _number(element, "depth")
    along = np.array([cos(turn), sin(turn)]) * _number(element, "width") / 2
    into_room = np.array([-sin(turn), cos(turn)])
    in_wall = _number(element, "wallDistance", 0) + _number(element, "wallThickness", 1) / 2
    middle = np.array([_number(element, "x"), _number(element, "y")])
    middle += into_room * depth * (in_wall - 0.5)
    (x, y), (u, v) = map(rounded, sweet_home_to_core(np.array([middle - along, middle + along])))
    bottom = _number(element, "elevation", 0) / 100
    top = bottom + _number(element, "height") / 100
    return Opening((x, y), (u, v), bottom=bottom, top=top, id=opening_id)


def _is_fixed(element: Element) -> bool:
    """Whether a window cannot be opened, even where it reaches the floor."""
    return FIXED in element.get("catalogId", "")


def _empty(room: Room, path: Path, level: str, number: int, name: str) -> Scene:
    return Scene(room, id=scene_id(path, level, f"r{number}"), name=name, source=SOURCE)


def _id(element: Element, number: int) -> str:
    """An id that people recognize: the name and a number, "bedside-table-12"."""
    words = "-".join(re.findall(r"\w+", element.get("name", "").lower()))
    return "-".join(filter(None, (words[:LONGEST_NAME], str(number))))


def _level(element: Element) -> str:
    return element.get("level", NO_LEVEL)


def _height(home: Element, level: str) -> float:
    """The height of the rooms of a level, metres."""
    usual = _number(home, "wallHeight", DEFAULT_HEIGHT * 100)
    levels = (element for element in home.iter("level") if element.get("id") == level)
    return next((_number(element, "height", usual) for element in levels), usual) / 100


def _room_type(name: str) -> str:
    """What a room is called, without its number: "Bedroom #1" is a bedroom."""
    return name.rstrip("#0123456789 ").lower()


def _point(element: Element, x: str, y: str) -> Point:
    point = np.array([_number(element, x), _number(element, y)])
    across, up = rounded(sweet_home_to_core(point))
    return across, up


def _number(element: Element, name: str, usual: float | None = None) -> float:
    """A number of an element; DataError if it is no number, or missing and there is no usual."""
    text = element.get(name)
    if text is None and usual is not None:
        return usual
    try:
        number = float(text or "")
    except ValueError:
        raise DataError(f"its {name} is missing or not a number") from None
    if not abs(number) <= FARTHEST:
        raise DataError(f"its {name} is far too large")
    return number
