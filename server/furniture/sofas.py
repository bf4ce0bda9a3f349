"""Sofas: straight ones and corner sofas."""

from __future__ import annotations

from math import copysign

from scenegen_core.scene.model import Vector3
from server.furniture.cushions import cushion
from server.furniture.design import Design, Parts, legs, named
from server.furniture.materials import LINEN, OAK, SAGE
from server.furniture.mesh import Mesh
from server.furniture.parts import tube

LEG = 0.12  # metres
ARM = 0.17  # metres, width of an armrest
BACK = 0.20  # metres, thickness of the backrest
SEAT = 0.65  # metres, about the width of one person
CORNER_DEPTH = 1.3  # metres; deeper sofas go round a corner


def choose(size: Vector3, label: str) -> Design:
    """The sofa for the size (depth, width, height) and label."""
    if named(label, "corner", "sectional", "l-shape") or size[0] > CORNER_DEPTH:
        return CORNER
    return STRAIGHT


def straight(w: float, h: float, d: float) -> Parts:
    """Two armrests, a back, a seat and a back cushion a person, slim legs."""
    yield from legs(w / 2 - 0.1, d / 2 - 0.1, LEG + 0.03, thickness=0.045, material=OAK)
    arm = min(ARM, 0.16 * w)
    seat = 0.52 * h
    inner = w / 2 - arm
    for side in (-1, 1):
        low, high = sorted((side * inner, side * w / 2))
        yield LINEN, cushion((low, high), (LEG, 0.74 * h), (-d / 2, d / 2), 0.05, 0.01)
    yield LINEN, cushion((-inner, inner), (LEG, 0.62 * seat), (-d / 2 + 0.02, d / 2 - 0.03), 0.03)
    yield LINEN, cushion((-inner, inner), (LEG, 0.93 * h), (-d / 2, -d / 2 + BACK), 0.05)
    yield from _seats(-inner, inner, seat, h, -d / 2 + BACK, d / 2)
    yield SAGE, _throw(inner, seat, h, -d / 2 + BACK + 0.27)


def corner(w: float, h: float, d: float) -> Parts:
    """A straight sofa along the back with a long seat towards the front at its right end."""
    deep = min(0.95, 0.62 * d)
    long = max(0.8, 0.32 * w)
    split = w / 2 - long
    front = -d / 2 + deep
    seat = 0.52 * h
    inner = -w / 2 + ARM
    for x, z in (
        (-w / 2, -d / 2),
        (w / 2, -d / 2),
        (-w / 2, front),
        (w / 2, d / 2),
        (split, d / 2),
    ):
        spot = (x - copysign(0.1, x), z - copysign(0.1, z))
        yield OAK, tube((spot[0], 0, spot[1]), (spot[0], LEG + 0.03, spot[1]), 0.014, 0.022)
    yield LINEN, cushion((-w / 2, inner), (LEG, 0.74 * h), (-d / 2, front), 0.05, 0.01)
    yield LINEN, cushion((inner, split), (LEG, 0.62 * seat), (-d / 2, front - 0.03), 0.03)
    yield LINEN, cushion((split, w / 2), (LEG, 0.62 * seat), (-d / 2, d / 2 - 0.01), 0.03)
    yield LINEN, cushion((-w / 2, w / 2), (LEG, 0.93 * h), (-d / 2, -d / 2 + BACK), 0.05)
    yield from _seats(inner, split, seat, h, -d / 2 + BACK, front)
    yield LINEN, cushion((split, w / 2), (0.6 * seat, seat), (-d / 2 + BACK, d / 2), 0.045, 0.02)
    yield LINEN, _back_cushion(split, w / 2, seat, h, -d / 2 + BACK)
    yield SAGE, _throw(w / 2 - 0.05, seat, h, -d / 2 + BACK + 0.27)


def _seats(left: float, right: float, seat: float, h: float, back: float, front: float) -> Parts:
    """Seat and back cushions side by side."""
    count = min(4, max(1, round((right - left) / SEAT)))
    width = (right - left) / count
    for number in range(count):
        a = left + number * width
        span = (a + 0.004, a + width - 0.004)
        yield LINEN, cushion(span, (0.6 * seat, seat), (back, front), 0.045, 0.02)
        yield LINEN, _back_cushion(*span, seat, h, back)


def _back_cushion(left: float, right: float, seat: float, h: float, back: float) -> Mesh:
    soft = cushion((left, right), (seat - 0.01, h), (back - 0.02, back + 0.17), 0.06, 0.035, axis=2)
    return soft.leaning(-0.12, seat, back)


def _throw(right: float, seat: float, h: float, z: float) -> Mesh:
    """A small pillow that leans in the right corner."""
    side = min(0.42, 0.5 * h)
    pillow = cushion(
        (right - side, right - 0.02), (seat, seat + side), (z - 0.04, z + 0.09), 0.05, 0.05, axis=2
    )
    return pillow.leaning(-0.3, seat, z).turned(-0.25, right - side / 2, z)


STRAIGHT = Design("sofa", straight, (0.65, 1.1, 0.6), (1.3, 4.0, 1.2))
CORNER = Design("corner sofa", corner, (1.2, 1.8, 0.6), (3.0, 4.5, 1.2))
