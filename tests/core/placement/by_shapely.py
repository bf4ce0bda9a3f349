"""Hard facts about a placed box, found with shapely alone: nothing of the rules is used.

Ways are walked twice: before by somebody wide (0.7 m), after by somebody slim (0.4 m). Who keeps a
way 0.6 m wide on a grid of 0.1 m keeps for the slim one what the wide one had.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import cos, sin

from shapely import LineString, Point, Polygon, unary_union
from shapely.geometry.base import BaseGeometry

from scenegen_core.scene.model import Box, Opening, Scene

ERROR = 0.006  # metres that rounding may take
UNDER_TABLE = 0.45
WIDE, SLIM = 0.35, 0.2  # half widths of walkers


def rectangle(box: Box, ahead: float = 0.0) -> Polygon:
    """The footprint; or the floor as far ``ahead`` of its front."""
    x, y, _ = box.center
    depth, width, _ = box.size
    low, high = (depth / 2, depth / 2 + ahead) if ahead else (-depth / 2, depth / 2)
    along, across = (cos(box.heading), sin(box.heading)), (-sin(box.heading), cos(box.heading))
    ends = ((high, width / 2), (low, width / 2), (low, -width / 2), (high, -width / 2))
    return Polygon(
        [(x + u * along[0] + v * across[0], y + u * along[1] + v * across[1]) for u, v in ends]
    )


def shrunk(shape: Polygon, by: float) -> BaseGeometry:
    """The shape without its outermost rim."""
    return shape.buffer(-by, join_style="mitre")


def before(scene: Scene, opening: Opening, depth: float) -> BaseGeometry:
    """The floor of the room before an opening."""
    line = LineString([opening.start, opening.end])
    return line.buffer(depth, cap_style="flat").intersection(Polygon(scene.room.corners))


def faults(scene: Scene, box: Box) -> set[str]:
    """What is wrong with a box that is new in a scene."""
    return {
        *_room_faults(scene, box),
        *_opening_faults(scene, box),
        *(f"is in {other.id}" for other in scene.boxes if _is_in(box, other)),
        *(f"closes the way to {name}" for name in closed_ways(scene, box)),
    }


def _room_faults(scene: Scene, box: Box) -> Iterator[str]:
    if not Polygon(scene.room.corners).contains(
        shrunk(rectangle(box), min(ERROR, box.size[0] / 3))
    ):
        yield "leaves the room"
    if box.bottom < -0.051 or box.top > scene.room.height + 0.051:
        yield "is too high or too low"


def _is_in(box: Box, other: Box) -> bool:
    if min(box.size[2], other.size[2]) <= 0.05:
        return False
    if min(box.top, other.top) - max(box.bottom, other.bottom) <= 0.011:
        return False
    tucked = {box.category, other.category} == {"Chair", "Table"}
    rim = (UNDER_TABLE + ERROR) / 2 if tucked else ERROR / 2
    return bool(shrunk(rectangle(box), rim).intersection(shrunk(rectangle(other), rim)).area > 1e-6)


def _opening_faults(scene: Scene, box: Box) -> Iterator[str]:
    shape = shrunk(rectangle(box), min(ERROR, box.size[0] / 3))
    for door in scene.room.doors:
        width = LineString([door.start, door.end]).length
        square = before(scene, door, min(width, 1.5))
        if box.size[2] > 0.05 and box.bottom < door.top and shape.intersection(square).area > 1e-4:
            yield "blocks a door"
    for window in scene.room.windows:
        tall = box.top > window.bottom + 0.011 and box.bottom < window.top
        if tall and shape.intersection(before(scene, window, 0.5)).area > 1e-4:
            yield "covers a window"


def closed_ways(scene: Scene, box: Box) -> Iterator[str]:
    """What a wide walker reached from a door, and no slim one does with the box there."""
    if not _is_solid(box):
        return
    floor_before, floor_after = _floor(scene, WIDE), _floor(scene.with_box(box), SLIM)
    for door in scene.room.doors:
        start = LineString([door.start, door.end])
        had = _reached(floor_before, start.buffer(0.5))
        has = _reached(floor_after, start.buffer(0.75))
        for other in scene.room.doors:
            way = LineString([other.start, other.end])
            if had.intersects(way.buffer(0.5)) and not has.intersects(way.buffer(0.75)):
                yield "a door"
        for seat in scene.boxes:
            if seat.category not in ("Bed", "Chair", "Sofa", "Storage") or not _is_solid(seat):
                continue
            if had.intersects(_zone(seat, 0.5)) and not has.intersects(_zone(seat, 0.75)):
                yield seat.id


def _is_solid(box: Box) -> bool:
    return box.bottom < 0.6 and box.size[2] > 0.05


def _floor(scene: Scene, half: float) -> list[BaseGeometry]:
    """The parts of the floor where the middle of a walker can be."""
    room = Polygon(scene.room.corners)
    doorways = [
        LineString([door.start, door.end]).centroid.buffer(half) for door in scene.room.doors
    ]
    taken = [rectangle(box).buffer(half) for box in scene.boxes if _is_solid(box)]
    free = unary_union([room.buffer(-half), *doorways]).intersection(room)
    free = free.difference(unary_union([*taken, Point(1e6, 1e6)]))
    return list(getattr(free, "geoms", [free]))


def _reached(parts: list[BaseGeometry], start: BaseGeometry) -> BaseGeometry:
    return unary_union([part for part in parts if part.intersects(start)])


def _zone(box: Box, reach: float) -> BaseGeometry:
    """Where somebody stands who is at a thing: before its doors, or beside it."""
    if box.category == "Storage" and box.front_known:
        return rectangle(box, ahead=0.6).buffer(reach - 0.5)
    return rectangle(box).buffer(reach)
