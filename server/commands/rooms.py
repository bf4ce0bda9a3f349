"""Opening the room that a command is about."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from scenegen_core.datasets.formats import read_scenes
from scenegen_core.errors import DataError
from scenegen_core.scene.model import Scene

LISTED = 5  # ids named when one has to be chosen


def open_room(path: Path, room_id: str | None = None) -> Scene:
    """The room of a file of any format, or the one of that id.

    SceneGenError if there is no such file or room, or if one has to be chosen.
    """
    return only_room(list(read_scenes(path)), room_id, str(path))


def only_room(rooms: Sequence[Scene], room_id: str | None, where: str) -> Scene:
    """The room of that id, or without one the only room; DataError if that is none or several."""
    if not rooms:
        raise DataError(f"{where} holds no usable room; choose another file.")
    fitting = [room for room in rooms if room_id in (None, room.id)]
    if len(fitting) == 1:
        return fitting[0]
    ids = ", ".join(room.id for room in rooms[:LISTED]) + ", …" * (len(rooms) > LISTED)
    if fitting:
        raise DataError(f"{where} holds {len(fitting)} rooms; choose one with --room-id: {ids}.")
    raise DataError(f"There is no room {room_id!r} in {where}; it holds {ids}.")
