"""Opening the room that a command is about."""

from __future__ import annotations

from pathlib import Path

import msgspec
from msgspec import Struct

from scenegen_core.datasets.rows import find_scene, read_scenes
from scenegen_core.errors import DataError, SceneError
from scenegen_core.scene.files import read_scene
from scenegen_core.scene.model import Scene

GZIP = b"\x1f\x8b"
LISTED = 5  # ids named when one has to be chosen


class _Row(Struct, frozen=True):
    """What tells a row of a file of rooms from a scene file."""

    id: msgspec.Raw
    polygon: msgspec.Raw


def open_room(path: Path, room_id: str | None = None) -> Scene:
    """The room of a scene file, or one of a file of rows; the content says which it is.

    SceneError or DataError if there is no such file or room, or if one has to be chosen.
    """
    try:
        with path.open("rb") as file:
            first = file.readline()
            content = first if _holds_rows(first) else first + file.read()
    except FileNotFoundError:
        raise SceneError(f"There is no file {path}; check its name and folder.") from None
    except IsADirectoryError:
        raise SceneError(f"{path} is a folder; name a file in it.") from None
    except OSError as error:
        raise SceneError(f"{path} cannot be read ({error.strerror}); check its rights.") from None
    if _holds_rows(first):
        return _only_room(path) if room_id is None else find_scene(path, room_id)
    scene = read_scene(content)
    if room_id not in (None, scene.id):
        raise SceneError(f"{path} is one room and its id is {scene.id!r}; leave --room-id out.")
    return scene


def _holds_rows(first: bytes) -> bool:
    if first.startswith(GZIP):
        return True
    try:
        msgspec.json.decode(first, type=_Row)
    except (msgspec.DecodeError, UnicodeDecodeError):
        return False
    return True


def _only_room(path: Path) -> Scene:
    rooms = list(read_scenes(path))
    if not rooms:
        raise DataError(f"{path} holds no usable room; choose another file.")
    if len(rooms) > 1:
        some = ", ".join(room.id for room in rooms[:LISTED])
        more = ", …" if len(rooms) > LISTED else ""
        raise DataError(
            f"{path} holds {len(rooms)} rooms; choose one with --room-id: {some}{more}."
        )
    return rooms[0]
