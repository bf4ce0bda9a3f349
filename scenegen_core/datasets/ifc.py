"""Building models (IFC files) with furniture as scenes, one a space.

Read with ifcopenshell (``pip install "scenegen[ifc]"``), which takes care of units and placements.
A space is a room; furniture and openings belong to the spaces that they stand in or lead to. IFC
does not say where the front of furniture is: libraries draw it with the front along -y of its own
axes, so that is its heading, and the front counts as unknown.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import replace
from math import atan2
from pathlib import Path
from typing import Any

from shapely import Polygon, get_coordinates, get_parts, union_all

from scenegen_core.datasets.contents import Head
from scenegen_core.datasets.ifc_shapes import (
    Element,
    Shape,
    model_of,
    named,
    origin_of,
    shapes_of,
)
from scenegen_core.datasets.labels import categories_of, category_of
from scenegen_core.datasets.outlines import point_of
from scenegen_core.datasets.plans import (
    checked_room,
    furnished,
    scene_id,
    upright_box,
    with_openings,
)
from scenegen_core.datasets.remarks import Report, Skipped, usable_boxes
from scenegen_core.errors import DataError, SceneError
from scenegen_core.scene.geometry import Floats
from scenegen_core.scene.model import Box, Opening, Scene

SOURCE = "ifc"
FURNITURE = ("IfcFurnishingElement", "IfcFlowTerminal")  # the second: bathtubs, lamps, fridges
WITHOUT_TYPE = ("NOTDEFINED", "USERDEFINED")
STOREY = 1.5  # metres; floors that differ by less belong to one storey
SLACK = 0.1  # metres; what stands on a floor reaches no further below it
UPRIGHT = 1e-6  # square metres; triangles that small as seen from above stand upright


def recognizes(head: Head) -> bool:
    """Whether the file is an exchange file of an IFC schema."""
    is_exchange = head.start.lstrip().startswith(b"ISO-10303-21")
    return is_exchange and re.search(rb"FILE_SCHEMA\s*\(\s*\(\s*'IFC", head.start) is not None


def read_scenes(path: Path, report: Report) -> Iterator[Scene]:
    """The spaces of a model, storey by storey; DataError if it has none or cannot be read."""
    model = model_of(path)
    spaces = list(shapes_of(model, ("IfcSpace",), path, report))
    if not spaces:
        raise DataError(f"{path} has no space with a shape; export it with its rooms (IfcSpace).")
    origin = origin_of(spaces)
    rooms = [
        (float((space.points - origin)[:, 2].min()), scene)
        for space in spaces
        for scene in _room(space, origin, path, report)
    ]
    boxes = usable_boxes(_boxes(model, origin, path, report), path, report)
    doors = list(_openings(model, "IfcDoor", origin, path, report))
    windows = list(_openings(model, "IfcWindow", origin, path, report))
    bases = _storeys(floor for floor, _ in rooms)
    for base in bases:
        here = [(floor, scene) for floor, scene in rooms if _below(floor, bases) == base]
        inside = furnished(
            [scene for _, scene in here],
            [box for box in boxes if _below(box.bottom + SLACK, bases) == base],
            path,
            report,
        )
        opened = with_openings(
            inside,
            [_lowered(o, base) for o in doors if _below(o.bottom + SLACK, bases) == base],
            [_lowered(o, base) for o in windows if _below(o.bottom + SLACK, bases) == base],
            path,
            report,
        )
        for (floor, _), scene in zip(here, opened, strict=True):
            yield replace(scene, boxes=tuple(_on_floor(box, floor) for box in scene.boxes))


def _room(space: Shape, origin: Floats, path: Path, report: Report) -> Iterator[Scene]:
    """The room of a space, without what is in it; nothing, and a report, if it is not usable."""
    plan = [Polygon(triangle) for triangle in (space.triangles - origin)[:, :, :2]]
    seen = union_all([triangle for triangle in plan if triangle.area > UPRIGHT])
    parts = [part for part in get_parts(seen) if isinstance(part, Polygon)]
    largest = max(parts, key=lambda part: part.area, default=Polygon())
    outline = Polygon(largest.exterior).simplify(0)
    corners = [point_of(corner) for corner in get_coordinates(outline)[:-1]]
    low, high = space.points[:, 2].min(), space.points[:, 2].max()
    element = space.element
    name = str(element.LongName or element.Name or "")
    try:
        room = checked_room(corners, height=float(high - low), room_type=name)
    except SceneError as error:
        report(Skipped(path, named(element), str(error)))
        return
    yield Scene(room, id=scene_id(path, element.GlobalId), name=name, source=SOURCE)


def _boxes(model: Any, origin: Floats, path: Path, report: Report) -> Iterator[Box]:
    for shape in shapes_of(model, FURNITURE, path, report):
        category = category_of(SOURCE, _word(shape.element), path, report)
        if category is None:
            continue
        across, along = -shape.axes[:2, 1]
        yield upright_box(
            shape.element.GlobalId,
            category,
            shape.points - origin,
            atan2(along, across),
            label=str(shape.element.Name or shape.element.is_a()),
            front_known=False,
        )


def _word(element: Element) -> str:
    """The word of its type or its names that the list knows, the last first; else its name."""
    known = categories_of(SOURCE)
    kind = getattr(element, "PredefinedType", None)
    kinds = [] if kind in WITHOUT_TYPE else [kind]
    texts = [str(text) for text in (*kinds, element.ObjectType, element.Name) if text]
    for text in (*texts, element.is_a()):
        for word in reversed(re.findall(r"[a-z]+", text.split(":")[0].lower())):
            for form in (str(word), str(word).removesuffix("s")):
                if form in known:
                    return form
    return texts[-1] if texts else str(element.is_a())


def _openings(
    model: Any, kind: str, origin: Floats, path: Path, report: Report
) -> Iterator[Opening]:
    """Doors or windows: they reach along their own x."""
    for shape in shapes_of(model, (kind,), path, report):
        points = shape.points - origin
        along = shape.axes[:2, 0]
        reach = points[:, :2] @ along
        middle = (points[:, :2].min(axis=0) + points[:, :2].max(axis=0)) / 2
        across = middle - (middle @ along) * along
        yield Opening(
            point_of(across + reach.min() * along),
            point_of(across + reach.max() * along),
            bottom=float(points[:, 2].min()),
            top=float(points[:, 2].max()),
            id=shape.element.GlobalId,
        )


def _storeys(floors: Iterable[float]) -> list[float]:
    """The heights of the lowest floors of each storey, metres, rising."""
    bases: list[float] = []
    for floor in sorted(floors):
        if not bases or floor - bases[-1] >= STOREY:
            bases.append(floor)
    return bases


def _below(height: float, bases: list[float]) -> float:
    """The storey that a height belongs to: the last that begins below it, or the first."""
    return max((base for base in bases if base <= height), default=bases[0])


def _lowered(opening: Opening, floor: float) -> Opening:
    bottom, top = round(opening.bottom - floor, 4), round(opening.top - floor, 4)
    return replace(opening, bottom=bottom, top=top)


def _on_floor(box: Box, floor: float) -> Box:
    x, y, z = box.center
    return replace(box, center=(x, y, round(z - floor, 4)))
