"""Rooms saved by Meta's MR Utility Kit (``SaveSceneToJsonString``) as scenes."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import msgspec

from scenegen_core.datasets.contents import BROKEN_JSON, Head, content, fields_of
from scenegen_core.datasets.headset import WALLS, Block, Panel, Seen, panels_of, scene_of
from scenegen_core.datasets.labels import categories_of
from scenegen_core.datasets.mruk_capture import (
    Anchor,
    Saved,
    SavedRoom,
    block_of,
    corners_of,
    panel_of,
)
from scenegen_core.datasets.outlines import outline_of, point_of
from scenegen_core.datasets.plans import scene_id
from scenegen_core.datasets.remarks import Report, Skipped
from scenegen_core.errors import DataError, SceneGenError
from scenegen_core.scene.model import DEFAULT_HEIGHT, Scene

UNITY = "Unity"
HANGING = ("Picture", "TV")  # what may be there as a plane alone
FLOOR, CEILING = "FLOOR", "CEILING"
LYING = (FLOOR, CEILING, "GLOBAL_MESH")  # neither upright panels nor furniture


def recognizes(head: Head) -> bool:
    """Whether the file lists rooms of anchors."""
    rooms = head.fields.get("Rooms")
    return rooms is not None and "Anchors" in fields_of(rooms)


def read_scenes(path: Path, report: Report) -> Iterator[Scene]:
    """The rooms of a home in order; a broken one is reported. DataError if the file is broken."""
    try:
        saved = msgspec.json.decode(content(path), type=Saved)
    except BROKEN_JSON as error:
        raise DataError(f"{path} is not a scene of MR Utility Kit: {error}.") from None
    if saved.coordinate_system != UNITY:
        raise DataError(
            f"{path} is in the coordinate system {saved.coordinate_system!r}; save it again "
            f"with the coordinate system {UNITY!r}."
        )
    for number, raw in enumerate(saved.rooms, start=1):
        several = len(saved.rooms) > 1
        try:
            scene = _scene(msgspec.json.decode(raw, type=SavedRoom), path, report)
        except (*BROKEN_JSON, SceneGenError) as error:
            report(Skipped(path, f"room {number}", str(error)))
            continue
        yield replace(
            scene,
            id=scene_id(path, str(number)) if several else scene_id(path),
            name=scene_id(path),
        )


def _scene(saved: SavedRoom, path: Path, report: Report) -> Scene:
    """A room; SceneGenError if it has neither a floor nor walls."""
    anchors = list(_anchors(saved, path, report))
    things = tuple(thing for anchor in anchors if (thing := _thing(anchor, path, report)))
    walls = panels_of(things, WALLS)
    floors = [corners_of(anchor) for anchor in anchors if anchor.label == FLOOR]
    ceilings = [corners_of(anchor)[:, 2].mean() for anchor in anchors if anchor.label == CEILING]
    if floors:
        corners = tuple(point_of(corner) for corner in floors[0])
        floor = float(floors[0][:, 2].mean())
    else:
        corners = outline_of([(wall.start, wall.end) for wall in walls])
        floor = min(wall.bottom for wall in walls)
    tops = [*ceilings, *(wall.top for wall in walls)]
    ceiling = float(max(tops)) if tops else floor + DEFAULT_HEIGHT
    return scene_of(Seen(corners, floor, ceiling, things, "mruk"), path, report)


def _anchors(saved: SavedRoom, path: Path, report: Report) -> Iterator[Anchor]:
    """The usable anchors; the others are reported."""
    for number, raw in enumerate(saved.anchors, start=1):
        try:
            yield msgspec.json.decode(raw, type=Anchor)
        except BROKEN_JSON as error:
            report(Skipped(path, f"anchor {number}", str(error)))


def _thing(anchor: Anchor, path: Path, report: Report) -> Panel | Block | None:
    """What an anchor shows, None for floors, meshes and the like."""
    if anchor.label in LYING:
        return None
    if anchor.volume_bounds is not None:
        return block_of(anchor, anchor.volume_bounds)
    category = categories_of("mruk").get(anchor.label)
    if anchor.plane_bounds is not None and (category is None or category in HANGING):
        return panel_of(anchor, anchor.plane_bounds)
    report(Skipped(path, f"{anchor.label} {anchor.uuid!r}", "is no box; draw it again"))
    return None
