"""The room that a headset saw: upright panels and boxes, each with a label, round a floor."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from math import cos, dist, sin
from pathlib import Path

from shapely import Point as ShapelyPoint
from shapely import Polygon

from scenegen_core.datasets.labels import category_of, faces_somewhere
from scenegen_core.datasets.outlines import NEAR_OUTLINE, OUTSIDE, on_outline, rounded
from scenegen_core.datasets.plans import checked_room
from scenegen_core.datasets.remarks import Report, Skipped, usable_boxes, usable_openings
from scenegen_core.scene.model import Box, Opening, Point, Scene, Vector3

FLOOR_SLACK = 0.1  # metres; a headset's boxes miss the floor by less, things on tables by more
PANEL_DEPTH = 0.02  # metres; a headset measures pictures and flat screens as planes
WALLS = ("WALL_FACE", "INVISIBLE_WALL_FACE")
DOORS = ("DOOR_FRAME", "OPENING")
WINDOWS = ("WINDOW_FRAME",)


@dataclass(frozen=True, slots=True)
class Panel:
    """A wall, a door, a window or what hangs on a wall, in the core frame, floor not yet at 0."""

    label: str
    start: Point
    end: Point
    bottom: float
    top: float
    heading: float
    """Into the room, radians."""


@dataclass(frozen=True, slots=True)
class Block:
    """A piece of furniture in the core frame, floor not yet at 0; sizes as of a Box."""

    label: str
    center: Vector3
    size: Vector3
    heading: float


@dataclass(frozen=True, slots=True)
class Seen:
    """All that a headset saw of one room, and which list of labels its words are in."""

    corners: tuple[Point, ...]
    floor: float
    ceiling: float
    things: tuple[Panel | Block, ...]
    source: str


def scene_of(seen: Seen, path: Path, report: Report) -> Scene:
    """The room; what lies too far outside of it is reported. SceneError if it has no outline."""
    room = checked_room(seen.corners, height=round(seen.ceiling - seen.floor, 3))
    outline = Polygon(room.corners)
    room = replace(
        room,
        doors=_openings(seen, "door", DOORS, outline, path, report),
        windows=_openings(seen, "window", WINDOWS, outline, path, report),
    )
    boxes = usable_boxes(_boxes(seen, path, report), path, report)
    near = tuple(b for b in boxes if outline.distance(ShapelyPoint(b.center[:2])) <= NEAR_OUTLINE)
    for box in boxes:
        if box not in near:
            report(Skipped(path, f"object {box.id!r}", OUTSIDE))
    return Scene(room, near, source=seen.source)


def panels_of(things: Iterable[Panel | Block], labels: tuple[str, ...]) -> list[Panel]:
    """The panels that have one of the labels, in order."""
    return [thing for thing in things if isinstance(thing, Panel) and thing.label in labels]


def in_words(label: str) -> str:
    """A label as people write it: "Wall art"."""
    return label.replace("_", " ").capitalize()


def _openings(
    seen: Seen, kind: str, labels: tuple[str, ...], outline: Polygon, path: Path, report: Report
) -> tuple[Opening, ...]:
    """The doors or windows on the outline; the others are reported."""
    frames = panels_of(seen.things, labels)
    numbered = (
        Opening(
            frame.start,
            frame.end,
            bottom=round(max(frame.bottom - seen.floor, 0.0), 3),
            top=round(frame.top - seen.floor, 3),
            id=f"{kind}-{number}",
        )
        for number, frame in enumerate(frames, start=1)
    )
    found = usable_openings(numbered, path, report)
    kept = on_outline(found, outline)
    for opening in found:
        if opening.id not in {other.id for other in kept}:
            report(Skipped(path, f"{kind} {opening.id!r}", OUTSIDE))
    return kept


def _boxes(seen: Seen, path: Path, report: Report) -> Iterator[Box]:
    """The furniture, numbered within its category."""
    numbers: dict[str, int] = {}
    for thing in seen.things:
        category = category_of(seen.source, thing.label, path, report)
        if category is None:
            continue
        numbers[category] = numbers.get(category, 0) + 1
        block = thing if isinstance(thing, Block) else _thin(thing)
        yield _box(block, f"{category.lower()}-{numbers[category]}", category, seen.floor)


def _thin(panel: Panel) -> Block:
    """What hangs on a wall as a box that is as good as flat."""
    (x0, y0), (x1, y1) = panel.start, panel.end
    x = (x0 + x1 + PANEL_DEPTH * cos(panel.heading)) / 2
    y = (y0 + y1 + PANEL_DEPTH * sin(panel.heading)) / 2
    size = (PANEL_DEPTH, dist(panel.start, panel.end), panel.top - panel.bottom)
    return Block(panel.label, (x, y, (panel.bottom + panel.top) / 2), size, panel.heading)


def _box(block: Block, box_id: str, category: str, floor: float) -> Box:
    """The box; what almost reaches the floor stands on it, with its top where it was."""
    (x, y, z), (depth, width, height) = block.center, block.size
    bottom, top = z - floor - height / 2, z - floor + height / 2
    if bottom < FLOOR_SLACK:
        bottom = 0.0
    return Box(
        id=box_id,
        category=category,
        center=rounded((x, y, (bottom + top) / 2)),
        size=rounded((depth, width, top - bottom)),
        heading=round(block.heading, 4),
        label=in_words(block.label),
        front_known=faces_somewhere(category),
    )
