"""Rooms scanned by a Quest headset, as the npm package @iwer/sem holds them, as scenes.

What the headset saw through an open door is left out and counted.

    python -m scenegen_core.datasets.quest CAPTURES_DIRECTORY ROOMS_DIRECTORY
"""

from __future__ import annotations

import argparse
import sys
from dataclasses import dataclass, replace
from math import dist
from pathlib import Path

import msgspec
import numpy as np
from shapely import LineString, Polygon
from shapely import Point as ShapelyPoint

from scenegen_core.datasets.labels import categories_of
from scenegen_core.datasets.quest_capture import (
    Capture,
    Entity,
    extent_of,
    floor_of,
    heading_of,
    placed,
    point_of,
    segment_of,
    vector_of,
)
from scenegen_core.errors import DataError
from scenegen_core.scene.files import write_scene
from scenegen_core.scene.model import (
    PAPER_CATEGORIES,
    Box,
    Opening,
    Point,
    Room,
    Scene,
    Symmetry,
    Vector3,
)

NEAR_OUTLINE = 0.5  # metres; what lies further outside was seen through a door or a window
FLOOR_SLACK = 0.1  # metres; a headset's boxes miss the floor by less, things on tables by more
PICTURE_DEPTH = 0.02  # metres; a headset measures pictures as planes
ROOMS = {
    "living_room": ("Living room (scan)", "living room"),
    "meeting_room": ("Meeting room (scan)", "meeting room"),
    "music_room": ("Music room (scan)", "music room"),
    "office_large": ("Large office (scan)", "office"),
    "office_small": ("Small office (scan)", "office"),
}
_FACES_SOMEWHERE = {c.name for c in PAPER_CATEGORIES if c.symmetry is not Symmetry.SYMMETRIC}


@dataclass(frozen=True, slots=True)
class Scan:
    """A scanned room and the labels of what lay too far outside its outline."""

    scene: Scene
    dropped: tuple[str, ...]


def read_capture(text: bytes, *, name: str = "", room_type: str = "", scene_id: str = "") -> Scan:
    """The room of a capture's JSON; DataError says what is wrong with it."""
    try:
        entities = msgspec.json.decode(text, type=Capture).entities
    except msgspec.DecodeError as error:
        raise DataError(f"This is not a capture of a room: {error}.") from None
    floor = floor_of(entities)
    corners = _outline([segment_of(e) for e in entities if e.label == "WALL_FACE"])
    outline = Polygon(corners)
    doors = [_opening(e, f"door-{i}", floor) for i, e in _numbered(entities, "DOOR_FRAME")]
    windows = [_opening(e, f"window-{i}", floor) for i, e in _numbered(entities, "WINDOW_FRAME")]
    boxes = _boxes(entities, floor)
    room = Room(
        corners=corners,
        height=round(max(extent_of(e).height for e in entities if e.label == "WALL_FACE"), 3),
        doors=_on_outline(doors, outline),
        windows=_on_outline(windows, outline),
        room_type=room_type,
    )
    near = tuple(b for b in boxes if outline.distance(ShapelyPoint(b.center[:2])) <= NEAR_OUTLINE)
    lost = ["DOOR_FRAME"] * (len(doors) - len(room.doors))
    lost += ["WINDOW_FRAME"] * (len(windows) - len(room.windows))
    lost += [box.label for box in boxes if box not in near]
    return Scan(Scene(room, near, id=scene_id, name=name, source="quest"), tuple(lost))


def _numbered(entities: tuple[Entity, ...], label: str) -> enumerate[Entity]:
    return enumerate((e for e in entities if e.label == label), start=1)


def _outline(walls: list[tuple[Point, Point]]) -> tuple[Point, ...]:
    """The corners where walls meet, anticlockwise: each wall goes on with the nearest end."""
    if len(walls) < 3:  # noqa: PLR2004 (a triangle)
        raise DataError("The capture has fewer than three walls; scan the room again.")
    chain, rest = [walls[0]], walls[1:]
    while rest:
        end = chain[-1][1]
        ends = [wall for pair in rest for wall in (pair, pair[::-1])]
        following = min(ends, key=lambda wall: dist(wall[0], end))
        rest = [pair for pair in rest if set(pair) != set(following)]
        chain.append(following)
    meeting = zip(chain, (*chain[1:], chain[0]), strict=True)
    corners = tuple(point_of(np.mean([one[1], other[0]], axis=0)) for one, other in meeting)
    return corners if Polygon(corners).exterior.is_ccw else corners[::-1]


def _opening(entity: Entity, opening_id: str, floor: float) -> Opening:
    start, end = segment_of(entity)
    height = extent_of(entity).height
    middle = entity.pose.position.y - floor
    bottom, top = max(middle - height / 2, 0.0), middle + height / 2
    return Opening(start, end, bottom=round(bottom, 3), top=round(top, 3), id=opening_id)


def _on_outline(openings: list[Opening], outline: Polygon) -> tuple[Opening, ...]:
    """The openings moved onto the outline, without those that are too far from it."""
    walls = outline.exterior

    def moved(point: Point) -> Point:
        on_wall = walls.interpolate(walls.project(ShapelyPoint(point)))
        return round(on_wall.x, 4), round(on_wall.y, 4)

    return tuple(
        replace(opening, start=moved(opening.start), end=moved(opening.end))
        for opening in openings
        if LineString([opening.start, opening.end]).centroid.distance(walls) <= NEAR_OUTLINE
    )


def _boxes(entities: tuple[Entity, ...], floor: float) -> tuple[Box, ...]:
    """The furniture; a table's top is also there as a plane, so planes count for pictures only."""
    categories = categories_of("quest")
    boxes: list[Box] = []
    for entity in entities:
        if entity.label not in categories:
            raise DataError(f"Unknown label {entity.label!r}; give it a row in labels/quest.csv.")
        category = categories[entity.label]
        if category is None or (entity.volume is None and category != "Picture"):
            continue
        make = _furniture if entity.volume is not None else _picture
        box_id = f"{category.lower()}-{1 + sum(b.category == category for b in boxes)}"
        boxes.append(make(entity, box_id, category, floor))
    return tuple(boxes)


def _furniture(entity: Entity, box_id: str, category: str, floor: float) -> Box:
    bounds = entity.volume
    assert bounds is not None
    extent = bounds.extent
    middle = vector_of(bounds.offset) + np.array([extent.width, extent.height, extent.depth]) / 2
    center = placed(entity, middle) - [0.0, 0.0, floor]
    bottom, top = center[2] - extent.depth / 2, center[2] + extent.depth / 2
    if bottom < FLOOR_SLACK:
        bottom = 0.0
    return Box(
        id=box_id,
        category=category,
        center=_rounded((center[0], center[1], (bottom + top) / 2)),
        size=_rounded((extent.height, extent.width, top - bottom)),
        heading=round(heading_of(entity, (0, -1, 0)), 4),
        label=_in_words(entity.label),
        front_known=category in _FACES_SOMEWHERE,
    )


def _picture(entity: Entity, box_id: str, category: str, floor: float) -> Box:
    extent = extent_of(entity)
    center = placed(entity, np.array([0.0, -PICTURE_DEPTH / 2, 0.0])) - [0.0, 0.0, floor]
    return Box(
        id=box_id,
        category=category,
        center=_rounded((center[0], center[1], center[2])),
        size=_rounded((PICTURE_DEPTH, extent.width, extent.height)),
        heading=round(heading_of(entity, (0, -1, 0)), 4),
        label=_in_words(entity.label),
    )


def _in_words(label: str) -> str:
    return label.replace("_", " ").capitalize()


def _rounded(values: tuple[float, float, float]) -> Vector3:
    x, y, z = (round(float(value), 4) for value in values)
    return x, y, z


def main() -> None:
    """Convert every capture of a directory into a scene file of another."""
    parser = argparse.ArgumentParser(prog="python -m scenegen_core.datasets.quest")
    parser.add_argument("captures", type=Path, help="directory of the captures of @iwer/sem")
    parser.add_argument("rooms", type=Path, help="directory for the scene files")
    options = parser.parse_args()
    options.rooms.mkdir(parents=True, exist_ok=True)
    for stem, (name, room_type) in ROOMS.items():
        scene_id = f"scan-{stem.replace('_', '-')}"  # sample rooms have ids of the same kind
        text = (options.captures / f"{stem}.json").read_bytes()
        scan = read_capture(text, name=name, room_type=room_type, scene_id=scene_id)
        (options.rooms / f"{scene_id}.json").write_bytes(write_scene(scan.scene))
        left_out = f", left out {len(scan.dropped)} outside the room" if scan.dropped else ""
        sys.stdout.write(f"{name}: {len(scan.scene.boxes)} boxes{left_out}\n")


if __name__ == "__main__":
    main()
