"""The shapes of the elements of an IFC file, by ifcopenshell, which is loaded when it is needed."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np

from scenegen_core.datasets.contents import content
from scenegen_core.datasets.remarks import Report, Skipped
from scenegen_core.errors import DataError
from scenegen_core.scene.geometry import Floats

SURVEYED = 500.0  # metres; models further from their origin have the coordinates of a survey

Element = Any  # ifcopenshell has no types for what a schema defines


@dataclass(frozen=True, slots=True)
class Shape:
    """The surface of an element in the frame of the building, which is ours but for its origin."""

    element: Element
    points: Floats
    """Its corners, (n, 3) metres."""
    triangles: Floats
    """The corners of its triangles, (m, 3, 3) metres."""
    axes: Floats
    """The directions of its own x, y and z, as columns."""


def model_of(path: Path) -> Any:
    """The model of a file; DataError if it or the package that reads it is not usable."""
    try:
        ifcopenshell = import_module("ifcopenshell")
    except ImportError:
        raise DataError(
            "IFC files are read with the package ifcopenshell; "
            'install it: pip install "scenegen[ifc]".'
        ) from None
    try:
        model = ifcopenshell.file.from_string(content(path).decode(errors="replace"))
        model.by_type("IfcSpace")  # without a known schema it cannot say what it has
    except (RuntimeError, ifcopenshell.Error) as error:
        raise DataError(f"{path} cannot be read ({error}); export it again.") from None
    return model


def shapes_of(model: Any, kinds: Iterable[str], path: Path, report: Report) -> Iterator[Shape]:
    """The shapes of all elements of some kinds; those without one are reported."""
    geometry = import_module("ifcopenshell.geom")
    settings = geometry.settings()
    for kind in kinds:
        for element in model.by_type(kind):
            try:
                shape = geometry.create_shape(settings, element)
            except RuntimeError as error:
                report(Skipped(path, named(element), f"it has no usable shape ({error})"))
                continue
            local = np.array(shape.geometry.verts).reshape(-1, 3)
            placement = np.array(shape.transformation.matrix).reshape(4, 4).T
            points = local @ placement[:3, :3].T + placement[:3, 3]
            corners = np.array(shape.geometry.faces).reshape(-1, 3)
            yield Shape(element, points, points[corners], placement[:3, :3])


def named(element: Element) -> str:
    """What people call an element: its class and its name, or else its id."""
    return f"{element.is_a()} {element.Name or element.GlobalId!r}"


def origin_of(spaces: Iterable[Shape]) -> Floats:
    """What to take off all positions: nothing, or the corner of a model that was surveyed."""
    corner = np.min([space.points.min(axis=0) for space in spaces], axis=0)
    return np.floor(corner) if np.abs(corner).max() > SURVEYED else np.zeros(3)
