"""Houses of ProcTHOR: rooms with floors, walls, doors, windows, and objects by their assets.

A file is one house, or one house a line as the published houses are. The sizes of the assets come
from the PyPI package procthor (``pip install "scenegen[thor]"``), which holds their database.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cache
from importlib.util import find_spec
from itertools import product
from pathlib import Path
from types import MappingProxyType
from typing import TypeVar

import msgspec
import numpy as np
from msgspec import Struct
from scipy.spatial.transform import Rotation

from scenegen_core.datasets.contents import Head, content, lines
from scenegen_core.datasets.labels import category_of
from scenegen_core.datasets.outlines import point_of
from scenegen_core.datasets.plans import (
    checked_room,
    furnished,
    scene_id,
    upright_box,
    with_openings,
)
from scenegen_core.datasets.remarks import Report, Skipped, usable_boxes
from scenegen_core.datasets.thor import SOURCE, XYZ, heading_of, plan_of, vector_of
from scenegen_core.errors import DataError, SceneError
from scenegen_core.scene.frames import unity_to_core
from scenegen_core.scene.model import DEFAULT_HEIGHT, Box, Opening, Scene

DATABASE = Path("databases", "asset-database.json")
T = TypeVar("T")
_CORNERS = np.array(list(product((-0.5, 0.5), repeat=3)))


class Asset(Struct, frozen=True, rename="camel"):
    """A model: what it shows, and its size in its own axes."""

    asset_id: str
    object_type: str
    bounding_box: XYZ


class Floor(Struct, frozen=True, rename="camel"):
    """A room."""

    id: str
    floor_polygon: tuple[XYZ, ...]
    room_type: str = ""


class Wall(Struct, frozen=True, rename="camel"):
    """One side of a wall: a rectangle."""

    id: str
    polygon: tuple[XYZ, ...]
    room_id: str = ""


class Extent(Struct, frozen=True):
    """The lowest and the highest corner of an opening: x along its wall, y up, metres."""

    min: XYZ
    max: XYZ


class Hole(Struct, frozen=True, rename="camel"):
    """A door or a window in a wall; older houses have a box where newer ones have two corners."""

    id: str
    wall0: str
    hole_polygon: tuple[XYZ, ...] = ()
    bounding_box: Extent | None = None


class Thing(Struct, frozen=True, rename="camel"):
    """An object with what stands on it."""

    id: str
    asset_id: str
    position: XYZ
    rotation: XYZ = XYZ(0, 0, 0)
    children: tuple[msgspec.Raw, ...] = ()


class House(Struct, frozen=True):
    """A whole house; what is listed is decoded one by one, so that broken ones can be left out."""

    rooms: tuple[msgspec.Raw, ...]
    walls: tuple[msgspec.Raw, ...] = ()
    doors: tuple[msgspec.Raw, ...] = ()
    windows: tuple[msgspec.Raw, ...] = ()
    objects: tuple[msgspec.Raw, ...] = ()


def recognizes(head: Head) -> bool:
    """Whether the file, or its first line, is a house."""
    return {"rooms", "walls", "objects"} <= head.fields.keys()


def read_scenes(path: Path, report: Report) -> Iterator[Scene]:
    """The rooms of the houses of a file; DataError if the sizes of assets are not at hand."""
    assets = assets_by_id()
    for number, house in _houses(path, report):
        walls = {wall.id: wall for wall in _each(house.walls, Wall, "wall", path, report)}
        rooms = list(_rooms(house, walls, number, path, report))
        doors = _openings(house.doors, walls, path, report)
        windows = _openings(house.windows, walls, path, report)
        boxes = usable_boxes(_boxes(house.objects, assets, None, path, report), path, report)
        inside = furnished(rooms, boxes, path, report)
        yield from with_openings(inside, doors, windows, path, report)


@cache
def assets_by_id() -> MappingProxyType[str, Asset]:
    """The assets of ProcTHOR's database; DataError says how to get it if it is missing."""
    package = find_spec("procthor")
    folders = package.submodule_search_locations if package is not None else None
    if not folders:
        raise DataError(
            "Houses of ProcTHOR need the sizes of its assets, from the package procthor; "
            'install it: pip install "scenegen[thor]".'
        )
    by_type = msgspec.json.decode(content(Path(folders[0]) / DATABASE), type=dict[str, list[Asset]])
    return MappingProxyType({a.asset_id: a for assets in by_type.values() for a in assets})


def _houses(path: Path, report: Report) -> Iterator[tuple[int, House]]:
    """The houses, one a line, or one over many lines; with their numbers."""
    first = Head(path).start.split(b"\n", 1)[0].strip()
    texts = iter([content(path)]) if first == b"{" else lines(path)
    for number, text in enumerate(texts, start=1):
        if not text.strip():
            continue
        try:
            yield number, msgspec.json.decode(text, type=House)
        except (msgspec.DecodeError, UnicodeDecodeError) as error:
            report(Skipped(path, f"house {number}", str(error)))


def _each(
    raw: Iterable[msgspec.Raw], kind: type[T], what: str, path: Path, report: Report
) -> Iterator[T]:
    """Each thing of a list; the broken ones are reported."""
    for number, text in enumerate(raw):
        try:
            yield msgspec.json.decode(text, type=kind)
        except (msgspec.DecodeError, UnicodeDecodeError) as error:
            report(Skipped(path, f"{what} {number}", str(error)))


def _rooms(
    house: House, walls: dict[str, Wall], number: int, path: Path, report: Report
) -> Iterator[Scene]:
    for floor in _each(house.rooms, Floor, "room", path, report):
        heights = [p.y for wall in walls.values() if wall.room_id == floor.id for p in wall.polygon]
        height = max(heights) - min(heights) if heights else DEFAULT_HEIGHT
        corners = [plan_of(corner) for corner in floor.floor_polygon]
        try:
            room = checked_room(corners, height=height, room_type=floor.room_type)
        except SceneError as error:
            report(Skipped(path, f"room {floor.id!r}", str(error)))
            continue
        room_id = scene_id(path, str(number), floor.id.split("|")[-1])
        yield Scene(room, id=room_id, name=floor.room_type, source=SOURCE)


def _openings(
    raw: Iterable[msgspec.Raw], walls: dict[str, Wall], path: Path, report: Report
) -> Iterator[Opening]:
    for hole in _each(raw, Hole, "opening", path, report):
        try:
            yield _opening(hole, walls)
        except SceneError as error:
            report(Skipped(path, f"opening {hole.id!r}", str(error)))


def _opening(hole: Hole, walls: dict[str, Wall]) -> Opening:
    """The opening; its hole is measured from the foot of the wall's first corner."""
    box = hole.bounding_box
    corners = (box.min, box.max) if box is not None else hole.hole_polygon
    foot = sorted(walls[hole.wall0].polygon, key=lambda p: p.y) if hole.wall0 in walls else []
    ends = [np.array(plan_of(corner)) for corner in foot[:2]]
    if len(corners) != 2 or len(ends) != 2 or not np.any(ends[1] - ends[0]):  # noqa: PLR2004
        raise SceneError("its wall or its hole is missing")
    (low, high), (start, end) = corners, ends
    along = (end - start) / np.linalg.norm(end - start)
    return Opening(
        point_of(start + along * low.x),
        point_of(start + along * high.x),
        bottom=low.y,
        top=high.y,
        id=hole.id,
    )


def _boxes(
    raw: Iterable[msgspec.Raw],
    assets: MappingProxyType[str, Asset],
    parent: str | None,
    path: Path,
    report: Report,
) -> Iterator[Box]:
    """The objects and, after each, what stands on it."""
    for thing in _each(raw, Thing, "object", path, report):
        asset = assets.get(thing.asset_id)
        if asset is None:
            reason = f"its asset {thing.asset_id!r} is not in the database"
            report(Skipped(path, f"object {thing.id!r}", reason))
        else:
            category = category_of(SOURCE, asset.object_type, path, report)
            if category is not None:
                yield _box(thing, asset, category, parent)
        yield from _boxes(thing.children, assets, thing.id, path, report)


def _box(thing: Thing, asset: Asset, category: str, parent: str | None) -> Box:
    """The upright box round a model that is turned about y, then x, then z."""
    turns = vector_of(thing.rotation)
    turn = Rotation.from_euler("YXZ", [turns[1], turns[0], turns[2]], degrees=True)
    corners = turn.apply(_CORNERS * vector_of(asset.bounding_box)) + vector_of(thing.position)
    return upright_box(
        thing.id,
        category,
        unity_to_core(corners),
        heading_of(thing.rotation),
        label=asset.object_type,
        parent=parent,
    )
