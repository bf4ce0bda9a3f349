"""Rooms scanned by a Quest headset, as the npm package @iwer/sem holds them, as scenes.

What the headset saw through an open door is left out and counted.

    python -m scenegen_core.datasets.quest CAPTURES_DIRECTORY ROOMS_DIRECTORY
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import msgspec
import numpy as np
from shapely import Point as ShapelyPoint
from shapely import Polygon

from scenegen_core.datasets.contents import Head, content
from scenegen_core.datasets.labels import category_of, faces_somewhere
from scenegen_core.datasets.outlines import NEAR_OUTLINE, OUTSIDE, on_outline, outline_of
from scenegen_core.datasets.quest_capture import (
    Capture,
    Entity,
    extent_of,
    floor_of,
    heading_of,
    placed,
    segment_of,
    vector_of,
)
from scenegen_core.datasets.remarks import Remark, Report, Skipped, usable_boxes
from scenegen_core.errors import DataError
from scenegen_core.scene.files import write_scene
from scenegen_core.scene.model import (
    Box,
    Opening,
    Room,
    Scene,
    Vector3,
)

FLOOR_SLACK = 0.1  # metres; a headset's boxes miss the floor by less, things on tables by more
PICTURE_DEPTH = 0.02  # metres; a headset measures pictures as planes
ROOMS = {
    "living_room": ("Living room (scan)", "living room"),
    "meeting_room": ("Meeting room (scan)", "meeting room"),
    "music_room": ("Music room (scan)", "music room"),
    "office_large": ("Large office (scan)", "office"),
    "office_small": ("Small office (scan)", "office"),
}


def recognizes(head: Head) -> bool:
    """Whether the file lists what a headset saw."""
    return "spatialEntities" in head.fields


def read_scenes(path: Path, report: Report) -> Iterator[Scene]:
    """The one room of a capture, named after its file; DataError says what is wrong with it."""
    name, room_type = ROOMS.get(path.stem, (_in_words(path.stem), ""))
    try:
        entities = msgspec.json.decode(content(path), type=Capture).entities
    except (msgspec.DecodeError, UnicodeDecodeError) as error:
        raise DataError(f"{path} is not a capture of a room: {error}.") from None
    scene = _scene(entities, room_type, path, report)
    yield replace(scene, id=path.stem, name=name)


def _scene(entities: tuple[Entity, ...], room_type: str, path: Path, report: Report) -> Scene:
    """The room that the entities show; what lies too far outside of it is reported."""
    floor = floor_of(entities)
    walls = [entity for entity in entities if entity.label == "WALL_FACE"]
    corners = outline_of([segment_of(wall) for wall in walls])
    outline = Polygon(corners)
    room = Room(
        corners=corners,
        height=round(max(extent_of(wall).height for wall in walls), 3),
        doors=_openings(entities, "DOOR_FRAME", floor, outline, path, report),
        windows=_openings(entities, "WINDOW_FRAME", floor, outline, path, report),
        room_type=room_type,
    )
    boxes = usable_boxes(_boxes(entities, floor, path, report), path, report)
    near = tuple(b for b in boxes if outline.distance(ShapelyPoint(b.center[:2])) <= NEAR_OUTLINE)
    for box in boxes:
        if box not in near:
            report(Skipped(path, f"object {box.id!r}", OUTSIDE))
    return Scene(room, near, source="quest")


def _openings(
    entities: tuple[Entity, ...],
    label: str,
    floor: float,
    outline: Polygon,
    path: Path,
    report: Report,
) -> tuple[Opening, ...]:
    """The doors or windows on the outline; the others are reported."""
    kind = label.removesuffix("_FRAME").lower()
    numbered = enumerate((e for e in entities if e.label == label), start=1)
    found = [_opening(entity, f"{kind}-{i}", floor) for i, entity in numbered]
    kept = on_outline(found, outline)
    for opening in found:
        if opening.id not in {other.id for other in kept}:
            report(Skipped(path, f"{kind} {opening.id!r}", OUTSIDE))
    return kept


def _opening(entity: Entity, opening_id: str, floor: float) -> Opening:
    start, end = segment_of(entity)
    height = extent_of(entity).height
    middle = entity.pose.position.y - floor
    bottom, top = max(middle - height / 2, 0.0), middle + height / 2
    return Opening(start, end, bottom=round(bottom, 3), top=round(top, 3), id=opening_id)


def _boxes(
    entities: tuple[Entity, ...], floor: float, path: Path, report: Report
) -> tuple[Box, ...]:
    """The furniture; a table's top is also there as a plane, so planes count for pictures only."""
    boxes: list[Box] = []
    for entity in entities:
        category = category_of("quest", entity.label, path, report)
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
        front_known=faces_somewhere(category),
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
    for stem, (name, _) in ROOMS.items():
        scene_id = f"scan-{stem.replace('_', '-')}"  # sample rooms have ids of the same kind
        left_out: list[Remark] = []
        (scan,) = read_scenes(options.captures / f"{stem}.json", left_out.append)
        scan = replace(scan, id=scene_id)
        (options.rooms / f"{scene_id}.json").write_bytes(write_scene(scan))
        sys.stdout.write(f"{name}: {len(scan.boxes)} boxes, left out {len(left_out)}\n")


if __name__ == "__main__":
    main()
