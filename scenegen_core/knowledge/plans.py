"""Plans: the rooms that were learned from, as small as it takes to draw them."""

from __future__ import annotations

from math import degrees

from msgspec import Struct

from scenegen_core.scene.model import Box, Opening, Point, Scene

CENTIMETRES = 100  # in a metre; plans are rounded to centimetres and degrees

Segment = tuple[int, int, int, int]
"""x, y of the start and of the end, centimetres."""


class PlanBox(Struct, frozen=True, array_like=True):
    """The footprint of a box: centimetres, and degrees anticlockwise from +x."""

    category: str
    x: int
    y: int
    depth: int
    width: int
    heading: int
    top: int
    """Above the floor: what is higher covers what is lower."""


class Plan(Struct, frozen=True, array_like=True):
    """A room from above, in centimetres."""

    source: str
    """The id of the corpus that it is from."""
    corners: tuple[tuple[int, int], ...]
    doors: tuple[Segment, ...]
    windows: tuple[Segment, ...]
    boxes: tuple[PlanBox, ...]


def plan_of(scene: Scene) -> Plan:
    """The plan of a scene."""
    return Plan(
        source=scene.source,
        corners=tuple(map(_point, scene.room.corners)),
        doors=tuple(map(_segment, scene.room.doors)),
        windows=tuple(map(_segment, scene.room.windows)),
        boxes=tuple(map(_footprint, scene.boxes)),
    )


def _footprint(box: Box) -> PlanBox:
    x, y = _point(box.center[:2])
    depth, width = _point(box.size[:2])
    heading = round(degrees(box.heading)) % 360
    return PlanBox(box.category, x, y, depth, width, heading, round(box.top * CENTIMETRES))


def _segment(opening: Opening) -> Segment:
    return (*_point(opening.start), *_point(opening.end))


def _point(metres: Point) -> tuple[int, int]:
    x, y = metres
    return round(x * CENTIMETRES), round(y * CENTIMETRES)
