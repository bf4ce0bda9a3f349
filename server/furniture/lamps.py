"""Lamps."""

from __future__ import annotations

from scenegen_core.scene.model import Vector3
from server.furniture.design import Design, Parts, named
from server.furniture.materials import BRASS, SHADE, STONEWARE
from server.furniture.parts import lathe, tube

STANDING = 0.7  # metres; taller lamps stand on the floor


def choose(size: Vector3, label: str) -> Design | None:
    """The lamp for the size (depth, width, height) and label; None if it is none."""
    if named(label, "pendant", "chandelier", "ceiling"):
        return PENDANT
    if named(label, "lamp", "light"):
        return FLOOR_LAMP if size[2] > STANDING else TABLE_LAMP
    return None


def floor_lamp(w: float, h: float, d: float) -> Parts:
    """A shade on a slim stem."""
    r, squash = w / 2, d / w
    shade = min(0.2 * h, 1.1 * w)
    foot = 0.75 * r
    yield (
        BRASS,
        lathe(
            [(0, 0), (foot, 0), (foot, 0.012), (0.9 * foot, 0.02), (0.016, 0.03)],
            sides=28,
            squash=squash,
        ),
    )
    yield BRASS, tube((0, 0.01, 0), (0, h - 0.5 * shade, 0), 0.011, 0.009)
    yield from _shade(r, h - shade, h, squash)


def table_lamp(w: float, h: float, d: float) -> Parts:
    """A shade on a round ceramic foot."""
    r, squash = w / 2, d / w
    body, b = 0.5 * h, 0.55 * r
    rows = [
        (0, 0),
        (0.5, 0),
        (0.55, 0.04),
        (0.85, 0.2),
        (1.0, 0.42),
        (0.9, 0.65),
        (0.55, 0.85),
        (0.25, 0.95),
        (0.2, 1.0),
        (0, 1.0),
    ]
    yield STONEWARE, lathe([(b * a, body * y) for a, y in rows], squash=squash)
    yield BRASS, tube((0, body - 0.005, 0), (0, 0.75 * h, 0), 0.05 * r, 0.05 * r)
    yield from _shade(r, 0.53 * h, h, squash)


def pendant(w: float, h: float, d: float) -> Parts:
    """A shade on a cord from the ceiling."""
    shade = min(0.6 * h, 0.7 * w)
    yield BRASS, tube((0, 0.5 * shade, 0), (0, h - 0.02, 0), 0.006, 0.006)
    yield BRASS, lathe([(0, h - 0.025), (0.05, h - 0.025), (0.05, h), (0, h)])
    yield from _shade(w / 2, 0, shade, d / w)


def _shade(r: float, low: float, high: float, squash: float) -> Parts:
    """A cone of cloth, open below and above."""
    cone = lathe([(r, low), (0.7 * r, high)], sides=28, squash=squash)
    yield SHADE, cone.both_sides()


FLOOR_LAMP = Design("floor lamp", floor_lamp, (0.15, 0.15, 0.6), (1.2, 1.2, 2.4))
TABLE_LAMP = Design("table lamp", table_lamp, (0.08, 0.08, 0.1), (0.8, 0.8, 0.9))
PENDANT = Design("pendant lamp", pendant, (0.15, 0.15, 0.15), (1.2, 1.2, 1.5))
