"""Rooms scanned with Apple's RoomPlan as scenes: JSON, or a zip archive with JSON in it.

Each floor is a room; where a scan has no floors (iOS 16), the walls of each story are one.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from pathlib import Path

import msgspec

from scenegen_core.datasets.contents import BROKEN_JSON, Fields, Head, content, fields_of, members
from scenegen_core.datasets.labels import category_of
from scenegen_core.datasets.outlines import OUTSIDE
from scenegen_core.datasets.plans import scene_id
from scenegen_core.datasets.remarks import Report, Skipped, usable_boxes
from scenegen_core.datasets.roomplan_capture import (
    Capture,
    Section,
    Thing,
    decoded,
    in_words,
    word_of,
)
from scenegen_core.datasets.roomplan_rooms import (
    Shell,
    box_of,
    holds,
    home_of,
    shells_of,
    standing,
    with_openings,
)
from scenegen_core.errors import SceneError
from scenegen_core.scene.model import Room, Scene

NO_WALL = "is in the wall of no room"
LONGEST_TYPE = 120  # characters; RoomPlan's own words for all uses together have half of it
UNIDENTIFIED = "unidentified"  # RoomPlan's word for parts of a floor that it cannot tell the use of


def recognizes(head: Head) -> bool:
    """Whether the file is what RoomPlan writes, or an archive that holds such a file."""
    if not head.members:
        return _is_capture(head.fields)
    return any(_is_capture(fields_of(text)) for _, text in members(head.path, ".json"))


def read_scenes(path: Path, report: Report) -> Iterator[Scene]:
    """The rooms of a scan, in the order of its floors."""
    scenes = [
        scene
        for where, capture in _captures(path, report)
        for scene in _scenes(capture, where, report)
    ]
    for number, scene in enumerate(scenes, start=1):
        several = len(scenes) > 1
        yield replace(
            scene,
            id=scene_id(path, str(number)) if several else scene_id(path),
            name=scene_id(path),
            source="roomplan",
        )


def _is_capture(fields: Fields) -> bool:
    return {"walls", "doors", "windows", "openings", "objects"} <= fields.keys()


def _captures(path: Path, report: Report) -> Iterator[tuple[Path, Capture]]:
    """The rooms that were scanned, each with the file it is in; a structure has several."""
    for where, text in _texts(path):
        capture = _capture(msgspec.Raw(text), where, report)
        if capture is None:
            continue
        rooms = [_capture(raw, where, report) for raw in capture.rooms] or [capture]
        yield from ((where, room) for room in rooms if room is not None)


def _texts(path: Path) -> Iterator[tuple[Path, bytes]]:
    if Head(path).members:
        for name, text in members(path, ".json"):
            if _is_capture(fields_of(text)):
                yield path / name, text
    else:
        yield path, content(path)


def _capture(raw: msgspec.Raw, path: Path, report: Report) -> Capture | None:
    try:
        return msgspec.json.decode(raw, type=Capture)
    except BROKEN_JSON as error:
        report(Skipped(path, "a scanned room", str(error)))
        return None


def _scenes(capture: Capture, path: Path, report: Report) -> Iterator[Scene]:
    """The rooms of one capture with what stands in them."""

    def usable(kind: str, raws: tuple[msgspec.Raw, ...]) -> list[Thing]:
        return list(_things(kind, raws, path, report))

    doors, openings = usable("door", capture.doors), usable("opening", capture.openings)
    windows, objects = usable("window", capture.windows), usable("object", capture.objects)
    floors, walls = usable("floor", capture.floors), usable("wall", capture.walls)
    sections = list(_sections(capture.sections, path, report))
    shells = list(shells_of(floors, walls, path, report))
    rooms = [with_openings(shell, doors, openings, windows) for shell in shells]
    homes = {thing.identifier: home_of(thing, shells) for thing in objects}
    _report_strays([*doors, *openings, *windows], rooms, path, report)
    for thing in objects:
        if homes[thing.identifier] is None:
            report(Skipped(path, f"object {thing.identifier!r}", OUTSIDE))
    for shell, room in zip(shells, rooms, strict=True):
        boxes = [
            box_of(thing, category, shell)
            for thing in objects
            if homes[thing.identifier] is shell
            and (category := category_of("roomplan", word_of(thing.category), path, report))
        ]
        yield Scene(
            replace(room, room_type=_room_type(shell, sections)),
            usable_boxes(standing(boxes), path, report),
        )


def _report_strays(
    things: Iterable[Thing], rooms: Iterable[Room], path: Path, report: Report
) -> None:
    """Report the doors, openings and windows that are in the wall of no room."""
    kept = {opening.id for room in rooms for opening in (*room.doors, *room.windows)}
    for thing in things:
        if thing.identifier not in kept:
            report(Skipped(path, f"{word_of(thing.category)} {thing.identifier!r}", NO_WALL))


def _things(
    kind: str, raws: tuple[msgspec.Raw, ...], path: Path, report: Report
) -> Iterator[Thing]:
    """The usable things of a kind, each with an identifier; the others are reported."""
    for number, raw in enumerate(raws, start=1):
        try:
            thing = decoded(raw, Thing)
        except SceneError as error:
            report(Skipped(path, f"{kind} {number}", str(error)))
            continue
        identifier = thing.identifier or f"{kind}-{number}"
        yield msgspec.structs.replace(thing, identifier=identifier)


def _sections(raws: tuple[msgspec.Raw, ...], path: Path, report: Report) -> Iterator[Section]:
    for number, raw in enumerate(raws, start=1):
        try:
            yield decoded(raw, Section)
        except SceneError as error:
            report(Skipped(path, f"section {number}", str(error)))


def _room_type(shell: Shell, sections: Iterable[Section]) -> str:
    """What the room is used for: the words of the sections in it, each once."""
    words = [word_of(section.label) for section in sections if holds(shell, section)]
    known = dict.fromkeys(in_words(word) for word in words if word != UNIDENTIFIED)
    return "/".join(known)[:LONGEST_TYPE]
