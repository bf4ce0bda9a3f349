"""The values that the elements of a Sweet Home 3D plan stand for; centimetres become metres."""

from __future__ import annotations

import re
from math import cos, sin
from xml.etree.ElementTree import Element

import numpy as np

from scenegen_core.datasets.outlines import point_of, rounded
from scenegen_core.datasets.plans import LONGEST_PART
from scenegen_core.errors import DataError
from scenegen_core.scene.frames import heading_of_sweet_home_turn, sweet_home_to_core
from scenegen_core.scene.model import DEFAULT_HEIGHT, Box, Opening, Point

FARTHEST = 1e6  # centimetres; numbers beyond that are mistakes
FIXED = "fixedWindow"  # in the name of its model in the catalogue
NO_LEVEL = "l0"  # where the things of a home without levels are


def box_of(piece: Element, piece_id: str, category: str) -> Box:
    """The box of a piece; tilted pieces have sizes as seen in the plan."""
    depth, width, height = (
        number_of(piece, f"{side}InPlan", number_of(piece, side))
        for side in ("depth", "width", "height")
    )
    bottom = number_of(piece, "elevation", 0)
    middle = np.array([number_of(piece, "x"), number_of(piece, "y"), bottom + height / 2])
    return Box(
        id=piece_id,
        category=category,
        center=rounded(sweet_home_to_core(middle)),
        size=(depth / 100, width / 100, height / 100),
        heading=heading_of_sweet_home_turn(number_of(piece, "angle", 0)),
        label=piece.get("name", ""),
    )


def opening_of(element: Element, opening_id: str) -> Opening:
    """The opening in the middle of its wall, which open leaves and sills reach out of.

    DataError if a number is missing.
    """
    turn, depth = number_of(element, "angle", 0), number_of(element, "depth")
    along = np.array([cos(turn), sin(turn)]) * number_of(element, "width") / 2
    into_room = np.array([-sin(turn), cos(turn)])
    in_wall = number_of(element, "wallDistance", 0) + number_of(element, "wallThickness", 1) / 2
    middle = np.array([number_of(element, "x"), number_of(element, "y")])
    middle += into_room * depth * (in_wall - 0.5)
    start, end = map(point_of, sweet_home_to_core(np.array([middle - along, middle + along])))
    bottom = number_of(element, "elevation", 0) / 100
    top = bottom + number_of(element, "height") / 100
    return Opening(start, end, bottom=bottom, top=top, id=opening_id)


def is_fixed(element: Element) -> bool:
    """Whether a window cannot be opened, even where it reaches the floor."""
    return FIXED in element.get("catalogId", "")


def level_of(element: Element) -> str:
    """The id of the level that an element is on."""
    return element.get("level", NO_LEVEL)


def id_of(element: Element, number: int) -> str:
    """An id that people recognize: the name and a number, "bedside-table-12"."""
    words = "-".join(re.findall(r"\w+", element.get("name", "").lower()))
    return "-".join(filter(None, (words[:LONGEST_PART], str(number))))


def height_of(home: Element, level: str) -> float:
    """The height of the rooms of a level, metres."""
    usual = number_of(home, "wallHeight", DEFAULT_HEIGHT * 100)
    levels = (element for element in home.iter("level") if element.get("id") == level)
    return next((number_of(element, "height", usual) for element in levels), usual) / 100


def room_type_of(name: str) -> str:
    """What a room is called, without its number: "Bedroom #1" is a bedroom."""
    return name.rstrip("#0123456789 ").lower()


def point_at(element: Element, x: str, y: str) -> Point:
    """The point that two attributes of an element give, metres; DataError if they do not."""
    point = np.array([number_of(element, x), number_of(element, y)])
    return point_of(sweet_home_to_core(point))


def number_of(element: Element, name: str, usual: float | None = None) -> float:
    """A number of an element; DataError if it is no number, or missing and there is no usual."""
    text = element.get(name)
    if text is None and usual is not None:
        return usual
    try:
        number = float(text or "")
    except ValueError:
        raise DataError(f"its {name} is missing or not a number") from None
    if not abs(number) <= FARTHEST:
        raise DataError(f"its {name} is far too large")
    return number
