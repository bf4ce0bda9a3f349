"""Rooms scanned by a Quest headset, as the npm package @iwer/sem holds them, as scenes.

What the headset saw through an open door is left out and counted.

    python -m scenegen_core.datasets.quest CAPTURES_DIRECTORY ROOMS_DIRECTORY
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterable, Iterator
from dataclasses import replace
from pathlib import Path

import msgspec

from scenegen_core.datasets.contents import BROKEN_JSON, Head, content
from scenegen_core.datasets.headset import (
    DOORS,
    WALLS,
    WINDOWS,
    Block,
    Panel,
    Seen,
    in_words,
    panels_of,
    scene_of,
)
from scenegen_core.datasets.labels import categories_of
from scenegen_core.datasets.outlines import outline_of
from scenegen_core.datasets.plans import scene_id
from scenegen_core.datasets.quest_capture import Capture, Entity, block_of, floor_of, panel_of
from scenegen_core.datasets.remarks import Remark, Report, Skipped
from scenegen_core.errors import DataError
from scenegen_core.scene.files import write_scene
from scenegen_core.scene.model import Scene

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
    name, room_type = ROOMS.get(path.stem, (in_words(scene_id(path)), ""))
    try:
        capture = msgspec.json.decode(content(path), type=Capture)
    except BROKEN_JSON as error:
        raise DataError(f"{path} is not a capture of a room: {error}.") from None
    entities = list(_entities(capture, path, report))
    floor = floor_of(entities)
    things = tuple(_things(entities, path, report))
    walls = panels_of(things, WALLS)
    seen = Seen(
        corners=outline_of([(wall.start, wall.end) for wall in walls]),
        floor=floor,
        ceiling=floor + max(wall.top - wall.bottom for wall in walls),
        things=things,
        source="quest",
    )
    scene = scene_of(seen, path, report)
    yield replace(
        scene, id=scene_id(path), name=name, room=replace(scene.room, room_type=room_type)
    )


def _entities(capture: Capture, path: Path, report: Report) -> Iterator[Entity]:
    """The usable entities; the others are reported."""
    for number, raw in enumerate(capture.entities, start=1):
        try:
            yield msgspec.json.decode(raw, type=Entity)
        except BROKEN_JSON as error:
            report(Skipped(path, f"entity {number}", str(error)))


def _things(entities: Iterable[Entity], path: Path, report: Report) -> Iterator[Panel | Block]:
    """What the entities show, without those that have no size, which are reported.

    A table's top is also there as a plane, so of the furniture planes count for pictures only.
    """
    for number, entity in enumerate(entities, start=1):
        hangs = categories_of("quest").get(entity.label, "Picture") == "Picture"
        try:
            if entity.volume is not None:
                yield block_of(entity)
            elif hangs or entity.label in (*WALLS, *DOORS, *WINDOWS):
                yield panel_of(entity)
        except DataError as error:
            report(Skipped(path, f"entity {number}", str(error)))


def main() -> None:
    """Convert every capture of a directory into a scene file of another."""
    parser = argparse.ArgumentParser(prog="python -m scenegen_core.datasets.quest")
    parser.add_argument("captures", type=Path, help="directory of the captures of @iwer/sem")
    parser.add_argument("rooms", type=Path, help="directory for the scene files")
    options = parser.parse_args()
    options.rooms.mkdir(parents=True, exist_ok=True)
    for stem, (name, _) in ROOMS.items():
        scan_id = f"scan-{stem.replace('_', '-')}"  # sample rooms have ids of the same kind
        left_out: list[Remark] = []
        (scan,) = read_scenes(options.captures / f"{stem}.json", left_out.append)
        scan = replace(scan, id=scan_id)
        (options.rooms / f"{scan_id}.json").write_bytes(write_scene(scan))
        sys.stdout.write(f"{name}: {len(scan.boxes)} boxes, left out {len(left_out)}\n")


if __name__ == "__main__":
    main()
