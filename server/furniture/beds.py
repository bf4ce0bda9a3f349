"""Beds: the headboard stands at −z, the feet point to +z."""

from __future__ import annotations

from scenegen_core.scene.model import Vector3
from server.furniture.cushions import cushion
from server.furniture.design import Design, Parts, named
from server.furniture.materials import CLAY, COTTON, LINEN, OAK
from server.furniture.parts import block

BUNK_HEIGHT = 1.4  # metres; a bed that tall has two floors
DOUBLE = 1.2  # metres; from that width on it has two pillows
MATTRESS = 0.2  # metres
POST = 0.07  # metres


def choose(size: Vector3, label: str) -> Design:
    """The bed for the size (depth, width, height) and label."""
    if size[2] >= BUNK_HEIGHT and (named(label, "bunk") or size[1] < DOUBLE):
        return BUNK
    return BED


def bed(w: float, h: float, d: float) -> Parts:
    """A frame on feet, a headboard, and the bedding."""
    top = min(0.32, 0.4 * h)
    head = -d / 2 + 0.06
    for side, end in ((-1, -1), (1, -1), (-1, 1), (1, 1)):
        x, z = side * (w / 2 - 0.08), end * (d / 2 - 0.1)
        yield OAK, block((x - 0.03, x + 0.03), (0, top), (z - 0.03, z + 0.03))
    yield OAK, block((-w / 2, w / 2), (0.4 * top, top), (head, d / 2), 0.012)
    yield OAK, block((-w / 2, w / 2), (0.05, h), (-d / 2, head), 0.015)
    yield from bedding(w - 0.06, top - 0.05, h, head + 0.01, d / 2 - 0.03)


def bunk(w: float, h: float, d: float) -> Parts:
    """Two beds one above the other between four posts, with a ladder at the front end."""
    for side, end in ((-1, -1), (1, -1), (-1, 1), (1, 1)):
        x, z = side * (w - POST) / 2, end * (d - POST) / 2
        yield OAK, block((x - POST / 2, x + POST / 2), (0, h), (z - POST / 2, z + POST / 2))
    for floor in (0.18 * h, 0.66 * h):
        yield (
            OAK,
            block(
                (-w / 2 + 0.01, w / 2 - 0.01),
                (floor - 0.08, floor + 0.04),
                (-d / 2 + 0.01, d / 2 - 0.01),
            ),
        )
        yield from bedding(w - 0.1, floor, h, -d / 2 + POST, d / 2 - POST)
    for rail in (0.82 * h, 0.94 * h):
        yield OAK, block((-w / 2 + 0.015, -w / 2 + 0.04), (rail, rail + 0.06), (-d / 2, d / 2))
        yield OAK, block((-w / 2, w / 2), (rail, rail + 0.06), (-d / 2 + 0.015, -d / 2 + 0.04))
    for step in range(1, 5):
        y = step * 0.14 * h
        yield OAK, block((w / 2 - 0.03, w / 2), (y, y + 0.035), (0.1 * d, d / 2 - POST))


def bedding(w: float, low: float, h: float, back: float, front: float) -> Parts:
    """Mattress, duvet and pillows from z = back to front, the mattress standing on ``low``."""
    top = low + min(MATTRESS, 0.35 * h)
    fold = back + min(0.62, 0.32 * (front - back))
    yield COTTON, cushion((-w / 2, w / 2), (low, top), (back, front), 0.05, 0.01)
    over = min(0.03, 0.02 * w)
    yield (
        LINEN,
        cushion(
            (-w / 2 - over, w / 2 + over),
            (low + 0.4 * (top - low), top + 0.06),
            (fold, front + 0.02),
            0.05,
            0.02,
        ),
    )
    yield (
        CLAY,
        cushion(
            (-w / 2 - over - 0.004, w / 2 + over + 0.004),
            (low + 0.45 * (top - low), top + 0.07),
            (front - 0.32 * (front - fold), front - 0.06),
            0.05,
            0.015,
        ),
    )
    count = 2 if w >= DOUBLE - 0.1 else 1
    width = w / count
    for number in range(count):
        x = -w / 2 + (number + 0.5) * width
        half = 0.42 * width
        pillow = cushion(
            (x - half, x + half), (top - 0.01, top + 0.13), (back + 0.02, fold - 0.02), 0.07, 0.05
        )
        yield COTTON, pillow.leaning(-0.2, top, fold)


BED = Design("bed", bed, (1.2, 0.7, 0.55), (2.6, 2.6, 1.6))
BUNK = Design("bunk bed", bunk, (1.5, 0.8, 1.4), (2.4, 1.6, 2.2))
