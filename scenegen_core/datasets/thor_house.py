"""Houses of ProcTHOR: rooms with floors, walls, doors, windows, and objects by their assets.

A file is one house, or one house a line as the published houses are. The sizes of the assets come
from the PyPI package procthor (``pip install "scenegen[thor]"``), which holds their database.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import product
from pathlib import Path
from types import MappingProxyType

import msgspec
import numpy as np
from scipy.spatial.transform import Rotation

from scenegen_core.datasets.contents import Head
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
from scenegen_core.datasets.thor import SOURCE, heading_of, plan_of, vector_of
from scenegen_core.datasets.thor_house_file import (
    Asset,
    Floor,
    Hole,
    House,
    Thing,
    Wall,
    assets_by_id,
    each,
    houses,
)
from scenegen_core.errors import SceneError
from scenegen_core.scene.frames import unity_to_core
from scenegen_core.scene.model import DEFAULT_HEIGHT, Box, Opening, Scene

_CORNERS = np.array(list(product((-0.5, 0.5), repeat=3)))


def recognizes(head: Head) -> bool:
    """Whether the file, or its first line, is a house."""
    return {"rooms", "walls", "objects"} <= head.fields.keys()


def read_scenes(path: Path, report: Report) -> Iterator[Scene]:
    """The rooms of the houses of a file; DataError if the sizes of assets are not at hand."""
    assets = assets_by_id()
    for number, house in houses(path, report):
        walls = {wall.id: wall for wall in each(house.walls, Wall, "wall", path, report)}
        rooms = list(_rooms(house, walls, number, path, report))
        doors = _openings(house.doors, walls, path, report)
        windows = _openings(house.windows, walls, path, report)
        boxes = usable_boxes(_boxes(house.objects, assets, None, path, report), path, report)
        inside = furnished(rooms, boxes, path, report)
        yield from with_openings(inside, doors, windows, path, report)


def _rooms(
    house: House, walls: dict[str, Wall], number: int, path: Path, report: Report
) -> Iterator[Scene]:
    for floor in each(house.rooms, Floor, "room", path, report):
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
    for hole in each(raw, Hole, "opening", path, report):
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
    for thing in each(raw, Thing, "object", path, report):
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
