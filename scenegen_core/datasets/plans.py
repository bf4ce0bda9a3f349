"""What the readers of building plans share: rooms checked, openings and furniture given to them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from itertools import chain
from math import cos, inf, isfinite, sin
from pathlib import Path

import msgspec
import numpy as np
from shapely import LineString, Polygon, get_parts, make_valid, union_all
from shapely import Point as ShapelyPoint

from scenegen_core.datasets.outlines import point_of, rounded
from scenegen_core.datasets.remarks import Report, Skipped, usable_openings
from scenegen_core.errors import SceneError
from scenegen_core.scene.files import MAX_ID, RoomRecord, room_of
from scenegen_core.scene.geometry import Floats
from scenegen_core.scene.model import DEFAULT_HEIGHT, Box, Opening, Point, Room, Scene, Vector3

BESIDE = 0.3  # metres; half of a thick wall: openings in it are that far from the rooms' outlines
HALF_HIDDEN = 0.5  # share of an opening's width; with less before it, a room is not beside it
IN_WALL = 0.05  # metres; how far centers of things on sills and in niches are from the floor
STEP = 0.3  # metres; who walks through an opening steps no higher: higher ones are windows
LOOPS = 0.05  # share of the floor; where an outline crosses itself, smaller loops are cut off
LONGEST_PART = 60  # characters of an id; some sources have long names and ids


def checked_room(
    corners: Sequence[Point], *, height: float = DEFAULT_HEIGHT, room_type: str = ""
) -> Room:
    """A room without openings; SceneError if its outline or its height is not usable."""
    record = RoomRecord(corners=_without_loops(corners), height=height, room_type=room_type)
    try:
        return room_of(msgspec.convert(msgspec.to_builtins(record), RoomRecord))
    except msgspec.ValidationError as error:
        raise SceneError(str(error)) from None


def with_openings(
    scenes: Sequence[Scene],
    doors: Iterable[Opening],
    windows: Iterable[Opening],
    path: Path,
    report: Report,
) -> tuple[Scene, ...]:
    """The scenes, each with the openings in its walls, put on its outline; others are reported."""
    doors, windows = (usable_openings(kind, path, report) for kind in (doors, windows))
    opened = tuple(
        replace(
            scene,
            room=replace(
                scene.room,
                doors=_through(scene.room, doors),
                windows=_through(scene.room, windows),
            ),
        )
        for scene in scenes
    )
    in_walls = {opening.id for s in opened for opening in (*s.room.doors, *s.room.windows)}
    for opening in (*doors, *windows):
        if opening.id not in in_walls:
            report(Skipped(path, f"opening {opening.id!r}", "it is in no wall of a room"))
    return opened


def furnished(
    scenes: Sequence[Scene], boxes: Iterable[Box], path: Path, report: Report
) -> tuple[Scene, ...]:
    """The scenes, each with the boxes whose centers its room contains; the others are reported.

    Where rooms overlap, the smaller one has the box.
    """
    outlines = [Polygon(scene.room.corners) for scene in scenes]
    inside: list[list[Box]] = [[] for _ in scenes]
    for box in boxes:
        index = outline_around(box.center, outlines)
        if index is None:
            report(Skipped(path, f"object {box.id!r}", "it stands in no room"))
        else:
            inside[index].append(box)
    return tuple(
        replace(scene, boxes=tuple(found)) for scene, found in zip(scenes, inside, strict=True)
    )


def between_walls(walls: Iterable[tuple[Point, Point, float]]) -> list[list[Point]]:
    """The outlines of the floors that walls enclose; a wall is its middle line and thickness."""
    lines = [(LineString([start, end]), thickness) for start, end, thickness in walls]
    bodies = union_all(
        [line.buffer(thickness / 2, cap_style="square") for line, thickness in lines]
    )
    holes = [Polygon(hole) for body in get_parts(bodies) for hole in body.interiors]
    return [[point_of(corner) for corner in hole.exterior.coords[:-1]] for hole in holes]


def outline_around(center: Vector3, outlines: Sequence[Polygon]) -> int | None:
    """The number of the smallest outline that a center lies in; None if it lies in none."""
    point = ShapelyPoint(center[:2])
    distances = [outline.distance(point) for outline in outlines]
    near = min(distances, default=inf)
    around = [i for i, distance in enumerate(distances) if distance <= near <= IN_WALL]
    return min(around, key=lambda i: outlines[i].area, default=None)


def upright_box(
    box_id: str,
    category: str,
    points: Floats,
    heading: float,
    *,
    label: str = "",
    front_known: bool = True,
    parent: str | None = None,
) -> Box:
    """The smallest upright box of that heading round points (n, 3) of the core frame, metres."""
    forward, left = (cos(heading), sin(heading), 0.0), (-sin(heading), cos(heading), 0.0)
    axes = np.array([forward, left, (0.0, 0.0, 1.0)])
    along = points @ axes.T
    low, high = along.min(axis=0), along.max(axis=0)
    return Box(
        id=box_id,
        category=category,
        center=rounded((low + high) / 2 @ axes),
        size=rounded(high - low),
        heading=heading,
        label=label,
        front_known=front_known,
        parent=parent,
    )


def scene_id(path: Path, *parts: str) -> str:
    """The id of a room of a file: the file's name without endings, then what tells its rooms."""
    rest = "".join(f"/{part}" for part in parts)[-LONGEST_PART:]
    return path.name.split(".")[0][: MAX_ID - len(rest)] + rest


def _without_loops(corners: Sequence[Point]) -> tuple[Point, ...]:
    """The outline, without the small loops where it crosses itself."""
    if len(corners) < 3 or not all(map(isfinite, chain(*corners))):  # noqa: PLR2004 (a triangle)
        return tuple(corners)
    drawn = make_valid(Polygon(corners))
    floors = [part for part in get_parts(drawn) if isinstance(part, Polygon)]
    largest = max(floors, key=lambda floor: floor.area, default=Polygon())
    whole = Polygon(largest.exterior)
    if drawn.equals(whole) or drawn.symmetric_difference(whole).area > LOOPS * whole.area:
        return tuple(corners)
    return tuple(point_of(corner) for corner in whole.exterior.coords[:-1])


def _through(room: Room, openings: Iterable[Opening]) -> tuple[Opening, ...]:
    moved = (_onto(room, opening) for opening in openings)
    return tuple(opening for opening in moved if opening is not None)


def _onto(room: Room, opening: Opening) -> Opening | None:
    """The opening moved onto the outline; None if it is not in a wall of the room."""
    outline = Polygon(room.corners).exterior
    start, end = ShapelyPoint(opening.start), ShapelyPoint(opening.end)
    middle = ShapelyPoint((start.x + end.x) / 2, (start.y + end.y) / 2)
    on_wall = [outline.interpolate(outline.project(point)) for point in (start, end)]
    near = outline.distance(middle) <= BESIDE
    if not near or on_wall[0].distance(on_wall[1]) <= HALF_HIDDEN * start.distance(end):
        return None
    moved_start, moved_end = (point_of((point.x, point.y)) for point in on_wall)
    return replace(opening, start=moved_start, end=moved_end)
