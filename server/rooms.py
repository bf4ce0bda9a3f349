"""Sample rooms: scene files beside the page, by id."""

from __future__ import annotations

import logging
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from shapely import Polygon

from scenegen_core.errors import SceneError
from scenegen_core.scene.files import read_scene
from server.protocol import RoomInfo

FOLDERS: tuple[tuple[str, Literal["sample", "scan"]], ...] = (
    ("rooms", "sample"),
    ("rooms/scans", "scan"),
)
log = logging.getLogger(__name__)


@dataclass(frozen=True, slots=True)
class SampleRoom:
    """A room that can be opened by its id."""

    info: RoomInfo
    path: Path


def sample_rooms(page: Path) -> dict[str, SampleRoom]:
    """The rooms beside a built page, by id, in order; files that are no scenes are left out."""
    rooms: dict[str, SampleRoom] = {}
    for folder, kind in FOLDERS:
        for path in sorted((page / folder).glob("*.json")):
            try:
                info = _info(path, kind)
            except SceneError as error:
                log.warning("%s is left out: %s", path, error)
                continue
            rooms.setdefault(info.id, SampleRoom(info, path))
    return rooms


def _info(path: Path, kind: Literal["sample", "scan"]) -> RoomInfo:
    scene = read_scene(path.read_bytes())
    return RoomInfo(
        id=path.stem,
        name=scene.name or path.stem,
        kind=kind,
        boxes=len(scene.boxes),
        area=round(Polygon(scene.room.corners).area, 1),
    )
