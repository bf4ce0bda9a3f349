"""``scenegen convert``: read rooms of any format, write them as a scene file or as rows."""

from __future__ import annotations

import gzip
import sys
from argparse import ArgumentParser, ArgumentTypeError, Namespace
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import asdict, replace
from pathlib import Path

from shapely import Polygon

from scenegen_core.datasets.cleaning import Reductions, clean
from scenegen_core.datasets.formats import FORMATS
from scenegen_core.datasets.remarks import Remark, Skipped
from scenegen_core.datasets.rows import write_rows
from scenegen_core.errors import DataError
from scenegen_core.scene.files import read_scene, write_scene
from scenegen_core.scene.model import Scene
from server.commands.rooms import only_room, read_rooms


def add_arguments(parser: ArgumentParser) -> None:
    """Declare what the command takes."""
    formats = ", ".join(form.description for form in FORMATS)
    parser.add_argument(
        "rooms",
        nargs="+",
        type=Path,
        metavar="IN",
        help=f"files or folders of them; each may be {formats}",
    )
    parser.add_argument(
        "--to",
        type=_target,
        metavar="OUT",
        help="scene.json for one room, rooms.jsonl or rooms.jsonl.gz for rows; else a list",
    )
    parser.add_argument("--room-id", metavar="ID", help="only the room of that id")
    parser.add_argument(
        "--report", action="store_true", help="count what learning would leave out of the rooms"
    )


def run(arguments: Namespace) -> int:
    """Read, say what was left out, write, count."""
    found, remarks = read_rooms(arguments.rooms)
    rooms = list(_told_apart(found))
    if arguments.room_id is not None:
        rooms = [only_room(rooms, arguments.room_id, _where(arguments.rooms))]
    if arguments.to is not None:
        _write(arguments.to, _encoded(arguments.to, rooms, _where(arguments.rooms)))
    elif not arguments.report:
        print("\n".join(_listed(rooms)))
    if arguments.report:
        print("\n".join(_report(rooms, clean(rooms)[1], remarks)))
    return 0


def _target(text: str) -> Path:
    if not text.endswith((".json", ".jsonl", ".jsonl.gz")):
        raise ArgumentTypeError(
            f"{text!r}: name it .json for one room, or .jsonl or .jsonl.gz for rows"
        )
    return Path(text)


def _where(paths: Sequence[Path]) -> str:
    return str(paths[0]) if len(paths) == 1 else "the input"


def _told_apart(rooms: Iterable[Scene]) -> Iterator[Scene]:
    """The rooms; the second of an id has a 2 after it, and so on."""
    seen: dict[str, int] = {}
    for room in rooms:
        seen[room.id] = seen.get(room.id, 0) + 1
        again = seen[room.id] > 1
        yield replace(room, id=f"{room.id}-{seen[room.id]}") if again else room


def _encoded(target: Path, rooms: Sequence[Scene], where: str) -> bytes:
    """The bytes of the file; SceneGenError if a scene file cannot hold it."""
    if target.suffix == ".json":
        content = write_scene(only_room(rooms, None, where))
        read_scene(content)
        return content
    rows = write_rows(rooms)
    return gzip.compress(rows, mtime=0) if target.suffix == ".gz" else rows


def _write(target: Path, content: bytes) -> None:
    try:
        target.write_bytes(content)
    except OSError as error:
        raise DataError(
            f"{target} cannot be written ({error.strerror}); choose another place."
        ) from None
    print(f"Saved {target}.", file=sys.stderr)


def _listed(rooms: Iterable[Scene]) -> Iterator[str]:
    """A line a room."""
    yield f"{'Room':<32} {'type':<24} {'m²':>6} {'things':>6} {'doors':>5} {'windows':>7}"
    for scene in rooms:
        room = scene.room
        yield (
            f"{scene.id:<32} {room.room_type or '-':<24} {Polygon(room.corners).area:>6.1f} "
            f"{len(scene.boxes):>6} {len(room.doors):>5} {len(room.windows):>7}"
        )


def _report(
    rooms: Sequence[Scene], reductions: Reductions, remarks: Sequence[Remark]
) -> Iterator[str]:
    """Everything counted: what was read, and what cleaning takes out before learning."""
    skipped = sum(isinstance(remark, Skipped) for remark in remarks)
    counts = {
        "rooms read": len(rooms),
        "boxes read": sum(len(scene.boxes) for scene in rooms),
        "left out while reading": skipped,
        "unknown labels": len(remarks) - skipped,
    }
    cleaning = asdict(reductions)
    kept = {f"{name} left to learn from": cleaning.pop(name) for name in ("rooms", "boxes")}
    taken = {f"cleaning: {name.replace('_', ' ')}": count for name, count in cleaning.items()}
    for name, count in {**counts, **taken, **kept}.items():
        yield f"{name:<32} {count:>6}"
