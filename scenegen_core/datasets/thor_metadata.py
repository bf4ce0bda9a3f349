"""Rooms of AI2-THOR as its object metadata describes them.

A dump is the list of objects of one room, the metadata of an event that holds the list, or lists
of rooms by kind as in the PyPI package procthor. The metadata tell neither outlines nor doors: the
outline is the rectangle that the objects span on the floor. What belongs to the building itself
(no asset) has boxes along the axes and no front.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from math import cos, pi, sin
from pathlib import Path

import msgspec
import numpy as np
from shapely import Point as ShapelyPoint
from shapely import Polygon

from scenegen_core.datasets.contents import Head
from scenegen_core.datasets.labels import category_of, faces_somewhere
from scenegen_core.datasets.outlines import point_of
from scenegen_core.datasets.plans import (
    checked_room,
    upright_box,
    with_openings,
)
from scenegen_core.datasets.remarks import Report, Skipped, usable_boxes
from scenegen_core.datasets.thor import SOURCE, heading_of
from scenegen_core.datasets.thor_metadata_file import Thing, rooms, things_of
from scenegen_core.errors import SceneError
from scenegen_core.scene.frames import unity_to_core
from scenegen_core.scene.geometry import Floats
from scenegen_core.scene.model import PAPER_CATEGORIES, Box, Opening, Room, Scene, Symmetry

FIRST = 20_000  # bytes of a list of rooms that show what they are: its first objects
IN_WALLS = ("Blinds", "Curtains", "Window")  # these reach further than the room
HEADS_FORWARD = ("Bed",)
"""Models that look along -z: in these rooms pillows lie at the +z end of the beds. In houses of
ProcTHOR they lie at the other end of the same assets."""
_AT_WALLS = {c.name for c in PAPER_CATEGORIES if c.symmetry is Symmetry.INSIDE_FACING}


def recognizes(head: Head) -> bool:
    """Whether the file holds objects of AI2-THOR, of one room or of many."""
    if {"objectId", "axisAlignedBoundingBox"} <= head.fields.keys():
        return True
    first = head.fields.get("objects", next(iter(head.fields.values()), msgspec.Raw()))
    return b'"axisAlignedBoundingBox"' in bytes(first)[:FIRST]


def read_scenes(path: Path, report: Report) -> Iterator[Scene]:
    """The rooms of a dump, one by one; DataError says what is wrong with it."""
    for room_id, room_type, raw in rooms(path):
        things = tuple(things_of(raw, path, report))
        try:
            room = _room(things, room_type)
        except SceneError as error:
            report(Skipped(path, f"room {room_id!r}", str(error)))
            continue
        boxes = usable_boxes(_boxes(things, room, path, report), path, report)
        scene = Scene(room, boxes, id=room_id, name=room_id, source=SOURCE)
        windows = [_window(thing) for thing in things if thing.label == "Window"]
        yield from with_openings([scene], (), windows, path, report)


def _room(things: Iterable[Thing], room_type: str) -> Room:
    """The rectangle that the objects span on the floor; SceneError if none."""
    inside = [thing.corners for thing in things if thing.label not in ("Floor", *IN_WALLS)]
    floors = [thing.corners for thing in things if thing.label == "Floor"] or inside
    if not floors:
        raise SceneError("It has no objects; dump all objects of the room.")
    (west, south), (east, north) = _span(inside or floors)
    (left, low), (right, high) = _span(floors)
    west, south, east, north = max(west, left), max(south, low), min(east, right), min(north, high)
    corners = [(west, south), (east, south), (east, north), (west, north)]
    return checked_room([point_of(corner) for corner in corners], room_type=room_type)


def _span(corners: Iterable[Floats]) -> Floats:
    """The lowest and highest x and y, (2, 2) metres."""
    plan = unity_to_core(np.concatenate(list(corners)))[:, :2]
    return np.array([plan.min(axis=0), plan.max(axis=0)])


def _window(thing: Thing) -> Opening:
    """The longer side of a window's box."""
    points = unity_to_core(thing.corners)
    low, high = points.min(axis=0), points.max(axis=0)
    middle, across = (low + high) / 2, int(high[0] - low[0] < high[1] - low[1])
    along = np.zeros(3)
    along[across] = (high - low)[across] / 2
    start, end = middle - along, middle + along
    return Opening(
        point_of(start),
        point_of(end),
        bottom=round(float(low[2]), 4),
        top=round(float(high[2]), 4),
        id=thing.id,
    )


def _boxes(things: Iterable[Thing], room: Room, path: Path, report: Report) -> Iterator[Box]:
    for thing in things:
        category = category_of(SOURCE, thing.label, path, report)
        if category is None:
            continue
        if thing.asset:
            yield _box(thing, category, _front_of(thing))
        elif category in _AT_WALLS:
            yield _at_wall(thing, category, room)
        else:
            yield replace(_box(thing, category, 0.0), front_known=False)


def _front_of(thing: Thing) -> float:
    """The heading of a model with an asset, radians."""
    return heading_of(thing.rotation) + (pi if thing.label in HEADS_FORWARD else 0.0)


def _box(thing: Thing, category: str, heading: float) -> Box:
    return upright_box(
        thing.id,
        category,
        unity_to_core(thing.corners),
        heading,
        label=thing.label,
        front_known=faces_somewhere(category),
        parent=next(iter(thing.parents or ()), None),
    )


def _at_wall(thing: Thing, category: str, room: Room) -> Box:
    """The box facing away from the wall behind it: the nearest, or of two the longer side's."""
    walls = Polygon(room.corners).exterior

    def behind(box: Box) -> tuple[float, float]:
        x, y, depth = *box.center[:2], box.size[0] / 2
        back = ShapelyPoint(x - depth * cos(box.heading), y - depth * sin(box.heading))
        return round(walls.distance(back), 1), depth

    headings = (0.0, pi / 2, pi, -pi / 2)
    boxes = (_box(thing, category, heading) for heading in headings)
    return replace(min(boxes, key=behind), front_from_wall=True)
