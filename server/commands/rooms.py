"""Opening the room, or reading all the rooms, that a command is about."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path

from scenegen_core.datasets.formats import read_all, read_scenes
from scenegen_core.datasets.remarks import Remark, told
from scenegen_core.errors import DataError
from scenegen_core.scene.model import Scene
from server.commands.progress import Meter

LISTED = 5  # ids named when one has to be chosen
MANY = 10  # files; below that nobody waits long enough to be told


def read_rooms(paths: Sequence[Path]) -> tuple[list[Scene], list[Remark]]:
    """All rooms of the files and folders, and what was said about them, also on stderr.

    SceneGenError if there is no usable one.
    """
    remarks: list[Remark] = []
    meter = Meter("files")

    def show(done: int, total: int) -> None:
        if total >= MANY:
            meter.show(done, total)
            if done == total:
                meter.end()

    try:
        return list(read_all(paths, remarks.append, progress=show)), remarks
    finally:
        _tell(remarks)


def open_room(path: Path, room_id: str | None = None) -> Scene:
    """The room of a file of any format, or the one of that id; what was left out is on stderr.

    SceneGenError if there is no such file or room, or if one has to be chosen.
    """
    remarks: list[Remark] = []
    try:
        return only_room(list(read_scenes(path, remarks.append)), room_id, str(path))
    finally:
        _tell(remarks)


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


def _tell(remarks: Sequence[Remark]) -> None:
    for line in told(remarks):
        print(line, file=sys.stderr)
