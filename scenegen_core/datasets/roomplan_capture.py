"""What Apple's RoomPlan writes down of a scan, and where it lies in the core frame.

RoomPlan encodes a ``CapturedRoom`` or a ``CapturedStructure`` as JSON: surfaces (walls, doors,
windows, openings, floors) and objects, each with a size [width, height, depth] and a 4 × 4 matrix,
column by column, in a right-handed frame with y up. The first column points along the width, the
second along the height; the third is the normal of a surface, and of an object where it looks.
A floor lies on its back: its normal points up.
"""

from __future__ import annotations

import re
from typing import Any, TypeVar

import msgspec
import numpy as np
from msgspec import Struct

from scenegen_core.datasets.contents import BROKEN_JSON, Measured
from scenegen_core.datasets.outlines import point_of
from scenegen_core.errors import SceneError
from scenegen_core.scene.frames import to_core
from scenegen_core.scene.geometry import Floats
from scenegen_core.scene.model import Point

SKEW = 0.01  # how far the axes of a matrix may be from unit length and right angles

_Element = TypeVar("_Element", "Thing", "Section")


class Thing(Struct, frozen=True, rename="camel"):
    """A surface or an object."""

    category: str | dict[str, Any]
    """A word, or a word with what else is known: {"door": {"isOpen": true}}."""
    dimensions: tuple[Measured, Measured, Measured]
    """Width, height, depth, metres."""
    transform: tuple[Measured | tuple[Measured, ...], ...]
    """Sixteen numbers, or four columns of four."""
    identifier: str = ""
    parent_identifier: str | None = None
    polygon_corners: tuple[tuple[Measured, Measured, Measured], ...] | None = None
    """The outline in the surface's own frame, where it is no rectangle."""
    attributes: dict[str, Any] | tuple[Any, ...] | None = None
    """What is known of its kind: {"TableType": "coffee"}."""
    curve: dict[str, Any] | None = None
    """How a wall bends, where it does."""
    story: int = 0


class Section(Struct, frozen=True):
    """What a part of the floor is used for."""

    label: str | dict[str, Any]
    center: tuple[Measured, Measured, Measured]
    story: int = 0


class Capture(Struct, frozen=True):
    """A room; of a structure, the rooms it was made from and what they have together."""

    walls: tuple[msgspec.Raw, ...] = ()
    doors: tuple[msgspec.Raw, ...] = ()
    windows: tuple[msgspec.Raw, ...] = ()
    openings: tuple[msgspec.Raw, ...] = ()
    floors: tuple[msgspec.Raw, ...] = ()
    objects: tuple[msgspec.Raw, ...] = ()
    sections: tuple[msgspec.Raw, ...] = ()
    rooms: tuple[msgspec.Raw, ...] = ()


def decoded(raw: msgspec.Raw, kind: type[_Element]) -> _Element:
    """An element of a capture; SceneError says what is wrong with it."""
    try:
        element = msgspec.json.decode(raw, type=kind)
    except BROKEN_JSON as error:
        raise SceneError(str(error)) from None
    if isinstance(element, Thing):
        _matrix(element)
    return element


def word_of(value: str | dict[str, Any]) -> str:
    """The word of a category or a label, as RoomPlan writes it."""
    return value if isinstance(value, str) else next(iter(value), "")


def kind_of(thing: Thing) -> str:
    """What an object is, in words, with its kind where that is known: "coffee table"."""
    word = word_of(thing.category)
    known = thing.attributes if isinstance(thing.attributes, dict) else {}
    kind = known.get(f"{word[:1].upper()}{word[1:]}Type", "")
    is_known = isinstance(kind, str) and kind not in {"", "unidentified"}
    return in_words(f"{kind} {word}" if is_known else word)


def in_words(camel_case: str) -> str:
    """Names like "washerDryer" as people write them."""
    return re.sub(r"(?<=[a-z])(?=[A-Z])", " ", camel_case).lower()


def placed(thing: Thing, local: Floats) -> Floats:
    """Points (…, 3) of the thing's own frame in the core frame, floor not yet at 0."""
    matrix = _matrix(thing)
    return to_core(local @ matrix[:3, :3].T + matrix[:3, 3])


def front_of(thing: Thing) -> Floats:
    """Where an object looks, a direction (3,) of the core frame."""
    return to_core(_matrix(thing)[:3, 2])


def segment_of(thing: Thing) -> tuple[Point, Point]:
    """The two ends of a wall, door, window or opening seen from above."""
    half = thing.dimensions[0] / 2
    ends = placed(thing, np.array([[-half, 0.0, 0.0], [half, 0.0, 0.0]]))
    return point_of(ends[0]), point_of(ends[1])


def heights_of(thing: Thing) -> tuple[float, float]:
    """The lower and upper edge of an upright thing, floor not yet at 0, metres."""
    middle, half = float(placed(thing, np.zeros(3))[2]), thing.dimensions[1] / 2
    return middle - half, middle + half


def corners_of(floor: Thing) -> Floats:
    """The corners of a floor in the core frame, (n, 3)."""
    if floor.polygon_corners:
        return placed(floor, np.array(floor.polygon_corners))
    x, y = floor.dimensions[0] / 2, floor.dimensions[1] / 2
    return placed(floor, np.array([[-x, -y, 0.0], [x, -y, 0.0], [x, y, 0.0], [-x, y, 0.0]]))


def _matrix(thing: Thing) -> Floats:
    """The matrix of a thing, (4, 4), its columns as columns; SceneError if it is not rigid."""
    columns = (column if isinstance(column, tuple) else (column,) for column in thing.transform)
    numbers = [number for column in columns for number in column]
    if len(numbers) != 16:  # noqa: PLR2004 (four columns of four)
        raise SceneError(f"its transform has {len(numbers)} numbers instead of 16")
    matrix = np.reshape(numbers, (4, 4)).T
    turn = matrix[:3, :3]
    if not np.allclose(turn.T @ turn, np.eye(3), atol=SKEW) or np.linalg.det(turn) < 0:
        raise SceneError("its transform is not a turn and a shift")
    return matrix
