"""The rooms of a RoomPlan scan: their outlines, and which of them each thing belongs to."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import partial
from math import atan2
from pathlib import Path

import numpy as np
from shapely import Point as ShapelyPoint
from shapely import Polygon

from scenegen_core.datasets.labels import faces_somewhere
from scenegen_core.datasets.outlines import (
    NEAR_OUTLINE,
    on_outline,
    outline_of,
    point_of,
    rounded,
)
from scenegen_core.datasets.plans import STEP, checked_room
from scenegen_core.datasets.remarks import Report, Skipped, problem_of
from scenegen_core.datasets.roomplan_capture import (
    Section,
    Thing,
    corners_of,
    front_of,
    heights_of,
    kind_of,
    placed,
    segment_of,
)
from scenegen_core.errors import SceneGenError
from scenegen_core.scene.model import DEFAULT_HEIGHT, Box, Opening, Room

STRAIGHT = "without a floor, walls count as straight"
STANDS_ON = 0.1  # metres; an underside so near to the top of another thing stands on it


@dataclass(frozen=True, slots=True)
class Shell:
    """A room of a scan before doors, windows and furniture."""

    room: Room
    floor: float
    """Height of the floor in the scan, metres."""
    story: int

    @property
    def outline(self) -> Polygon:
        """The floor seen from above."""
        return Polygon(self.room.corners)


def shells_of(
    floors: Sequence[Thing], walls: Sequence[Thing], path: Path, report: Report
) -> Iterator[Shell]:
    """One room a floor or, without floors, a story; what makes no room is reported."""
    makers: list[Callable[[], Shell]] = [partial(_on_floor, floor, walls) for floor in floors]
    if not makers:
        for wall in walls:
            if wall.curve:
                report(Skipped(path, f"the curve of wall {wall.identifier!r}", STRAIGHT))
        makers = [
            partial(_within, [wall for wall in walls if wall.story == story])
            for story in sorted({wall.story for wall in walls})
        ]
    for number, make in enumerate(makers, start=1):
        try:
            yield make()
        except SceneGenError as error:
            report(Skipped(path, f"room {number}", str(error)))


def home_of(thing: Thing, shells: Iterable[Shell]) -> Shell | None:
    """The room that an object stands in or very near to."""
    middle = ShapelyPoint(point_of(placed(thing, np.zeros(3))))
    distances = {
        distance: shell
        for shell in shells
        if shell.story == thing.story
        and (distance := shell.outline.distance(middle)) <= NEAR_OUTLINE
    }
    return distances[min(distances)] if distances else None


def holds(shell: Shell, section: Section) -> bool:
    """Whether a section is a part of the room."""
    x, _, z = section.center
    return shell.story == section.story and shell.outline.distance(ShapelyPoint(x, -z)) == 0


def with_openings(
    shell: Shell, ways: Iterable[Thing], openings: Iterable[Thing], lights: Iterable[Thing]
) -> Room:
    """The room with what of the doors, openings and windows lies on its outline."""
    doors, windows = _openings(ways, shell), _openings(lights, shell)
    for opening in _openings(openings, shell):
        (doors if opening.bottom <= STEP else windows).append(opening)
    return replace(shell.room, doors=tuple(doors), windows=tuple(windows))


def box_of(thing: Thing, category: str, shell: Shell) -> Box:
    """The box of an object; its parent is what holds it, whether or not it stands on that."""
    x, y, z = placed(thing, np.zeros(3))
    width, height, depth = thing.dimensions
    front = front_of(thing)
    label = kind_of(thing)
    return Box(
        id=thing.identifier,
        category=category,
        center=rounded((x, y, z - shell.floor)),
        size=rounded((depth, width, height)),
        heading=round(atan2(front[1], front[0]), 4),
        label=label[:1].upper() + label[1:],
        front_known=faces_somewhere(category) and not label.startswith("stool"),
        parent=thing.parent_identifier,
    )


def standing(boxes: Sequence[Box]) -> Iterator[Box]:
    """The boxes with a parent only where they stand on it.

    RoomPlan also calls the table the parent of its chairs, and the cupboard that of its oven.
    """
    tops = {box.id: box.top for box in boxes}
    for box in boxes:
        top = tops.get(box.parent or "")
        on_it = top is not None and abs(box.bottom - top) <= STANDS_ON
        yield box if on_it else replace(box, parent=None)


def _on_floor(floor: Thing, walls: Iterable[Thing]) -> Shell:
    corners = corners_of(floor)
    height = float(corners[:, 2].mean())
    tops = [heights_of(wall)[1] for wall in walls if wall.story == floor.story]
    room = checked_room(
        [point_of(corner) for corner in corners],
        height=round(max(tops) - height, 4) if tops else DEFAULT_HEIGHT,
    )
    return Shell(room, height, floor.story)


def _within(walls: Sequence[Thing]) -> Shell:
    edges = [heights_of(wall) for wall in walls]
    floor, ceiling = min(low for low, _ in edges), max(high for _, high in edges)
    outline = outline_of([segment_of(wall) for wall in walls])
    room = checked_room(outline, height=round(ceiling - floor, 4))
    return Shell(room, floor, walls[0].story)


def _openings(things: Iterable[Thing], shell: Shell) -> list[Opening]:
    found = []
    for thing in things:
        if thing.story == shell.story:
            start, end = segment_of(thing)
            low, high = (height - shell.floor for height in heights_of(thing))
            bottom, top = round(max(low, 0.0), 3), round(high, 3)
            found.append(Opening(start, end, bottom=bottom, top=top, id=thing.identifier))
    usable = (opening for opening in found if not problem_of(opening))
    return list(on_outline(usable, shell.outline))
