"""Houses of Matterport3D (``.house`` files) as scenes, one a region.

Which way things face comes from pose labels (``matterport_poses``); without a label only the axes
of a box are known.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np
from shapely import Polygon, get_parts, make_valid, union_all

from scenegen_core.datasets.contents import Head, content
from scenegen_core.datasets.labels import categories_of, category_of
from scenegen_core.datasets.matterport_file import Category, House, Region, Thing, house_of
from scenegen_core.datasets.matterport_poses import Label, labels_beside, level_axes
from scenegen_core.datasets.outlines import point_of, rounded
from scenegen_core.datasets.plans import checked_room, scene_id, with_openings
from scenegen_core.datasets.remarks import Report, Skipped, usable_boxes
from scenegen_core.errors import SceneError
from scenegen_core.scene.model import Box, Opening, Point, Scene

SOURCE = "matterport"
ROOM_TYPES = {
    "a": "bathroom", "b": "bedroom", "c": "closet", "d": "dining room", "e": "entryway",
    "f": "family room", "g": "garage", "h": "hallway", "i": "library", "j": "laundry room",
    "k": "kitchen", "l": "living room", "m": "meeting room", "n": "lounge", "o": "office",
    "p": "porch", "r": "rec room", "s": "stairs", "t": "toilet", "u": "utility room",
    "v": "TV room", "w": "gym", "x": "outdoor area", "y": "balcony", "z": "other room",
    "B": "bar", "C": "classroom", "D": "dining booth", "S": "spa", "Z": "junk",
}  # fmt: skip
"""The letters of regions, in the words of the paper ("Category reduction") where it has one."""
UNLABELED = Category(-1, "unlabeled", "unlabeled")


def recognizes(head: Head) -> bool:
    """Whether the file begins as a house."""
    return head.start.startswith(b"ASCII 1.") and b"\nH " in head.start


def read_scenes(path: Path, report: Report) -> Iterator[Scene]:
    """The regions of a house, one by one; DataError if it has none."""
    house = house_of(content(path).decode(errors="replace"), path, report)
    labels = labels_beside(path, house, report)
    empty = tuple(_rooms(house, path, report))
    levels = {region.index: region.level for region, _, _ in empty}
    floors = {region.index: floor for region, floor, _ in empty}
    placed = tuple(_placed(house, floors, path, report))
    for level in sorted(set(levels.values())):
        here = [(region.index, scene) for region, _, scene in empty if region.level == level]
        things = [(thing, kind) for thing, kind in placed if levels[thing.region] == level]
        furnished = [
            replace(scene, boxes=_boxes(index, things, floors[index], labels, path, report))
            for index, scene in here
        ]
        doors = [_opening(thing, floors) for thing, kind in things if kind.mpcat40 == "door"]
        windows = [_opening(thing, floors) for thing, kind in things if kind.mpcat40 == "window"]
        yield from with_openings(furnished, doors, windows, path, report)


def _rooms(house: House, path: Path, report: Report) -> Iterator[tuple[Region, float, Scene]]:
    """The regions with the heights of their floors, as scenes without what is in them."""
    for region in house.regions:
        corners, floor = _outline(region, house)
        height = float(region.box[1, 2] - floor)
        room_type = ROOM_TYPES.get(region.label, "")
        try:
            room = checked_room(corners, height=height, room_type=room_type)
        except SceneError as error:
            report(Skipped(path, f"region {region.index}", str(error)))
            continue
        room_id = scene_id(path, f"r{region.index}")
        yield region, floor, Scene(room, id=room_id, name=room_type, source=SOURCE)


def _outline(region: Region, house: House) -> tuple[list[Point], float]:
    """The outline of a region's surfaces and the height of its floor; its box if it has none."""
    surfaces = [surface.index for surface in house.surfaces if surface.region == region.index]
    loops = [[v.position for v in house.vertices if v.surface == index] for index in surfaces]
    loops = [loop for loop in loops if len(loop) >= 3]  # noqa: PLR2004 (a triangle)
    if not loops:
        (west, south, floor), (east, north, _) = region.box.tolist()
        return [(west, south), (east, south), (east, north), (west, north)], floor
    floors = get_parts(union_all([make_valid(Polygon(np.array(loop)[:, :2])) for loop in loops]))
    largest = max(floors, key=lambda part: part.area)
    corners = largest.exterior.coords[:-1] if isinstance(largest, Polygon) else ()
    height = np.mean([position[2] for loop in loops for position in loop])
    return [point_of(corner) for corner in corners], float(height)


def _placed(
    house: House, floors: Mapping[int, float], path: Path, report: Report
) -> Iterator[tuple[Thing, Category]]:
    """The objects in the regions that are left, and what they are."""
    for thing in house.things:
        if thing.region not in floors:
            report(Skipped(path, f"object '{thing.index}'", "it belongs to no usable region"))
        else:
            yield thing, house.categories.get(thing.category, UNLABELED)


def _boxes(
    region: int,
    things: Iterable[tuple[Thing, Category]],
    floor: float,
    labels: Mapping[int, Label],
    path: Path,
    report: Report,
) -> tuple[Box, ...]:
    boxes: list[Box] = []
    for thing, kind in things:
        if thing.region != region:
            continue
        word = kind.name if kind.name in categories_of(SOURCE) else kind.mpcat40
        category = category_of(SOURCE, word, path, report)
        if category is not None:
            boxes.append(_box(thing, kind.name, category, floor, labels.get(thing.index)))
    return usable_boxes(boxes, path, report)


def _box(thing: Thing, name: str, category: str, floor: float, label: Label | None) -> Box:
    """The box with its standard axes: the heading along the labelled one, else the first."""
    axes, sizes = level_axes(thing)
    headings = np.arctan2(axes[:, 1], axes[:, 0])
    axis = 0 if label is None else label.axis_of(headings)
    upright = int(np.argmax(np.abs(thing.axes[:, 2])))
    return Box(
        id=str(thing.index),
        category=category,
        center=rounded(thing.center - [0.0, 0.0, floor]),
        size=rounded([*sizes[axis], 2 * thing.half[upright]]),
        heading=float(headings[axis]),
        label=name,
        front_known=label is not None,
    )


def _opening(thing: Thing, floors: Mapping[int, float]) -> Opening:
    """The longer level side of a door or a window."""
    axes, sizes = level_axes(thing)
    longer = int(np.argmax(sizes[:, 0]))
    reach = axes[longer] * sizes[longer, 0] / 2
    upright = int(np.argmax(np.abs(thing.axes[:, 2])))
    middle = thing.center[2] - floors[thing.region]
    return Opening(
        point_of(thing.center[:2] - reach),
        point_of(thing.center[:2] + reach),
        bottom=round(float(middle - thing.half[upright]), 4),
        top=round(float(middle + thing.half[upright]), 4),
        id=str(thing.index),
    )
