"""Plants, lamps, vases and rugs."""

from __future__ import annotations

from dataclasses import replace
from math import cos, pi, sin

from scenegen_core.scene.model import Vector3
from server.furniture.design import Design, Parts, named
from server.furniture.materials import (
    BRASS,
    CERAMIC,
    CLAY,
    LEAF,
    LINEN,
    SHADE,
    SOIL,
    STONEWARE,
    TERRACOTTA,
    WOOL,
    linear,
)
from server.furniture.parts import block, lathe, leaf, tube

RUG_HEIGHT = 0.05  # metres
THIN = 4.0  # height over width; taller things that thin are floor lamps
TALL = 0.6  # metres; what is taller stands on the floor
RUG_STRIPES = (0.0, 0.09, 0.105, 0.13, 0.14)  # metres from the edge, on a rug of a metre or more
LEAVES = 34
GREENS = tuple(linear(color) for color in ("#7f9c66", "#6b8c58", "#90ab74", "#5f8052", "#86a06f"))


def choose(size: Vector3, label: str) -> Design:
    """The piece for the size (depth, width, height) and label."""
    depth, width, height = size
    wide = max(depth, width)
    if named(label, "rug", "carpet", "mat") or (height < RUG_HEIGHT and wide > 4 * height):
        return RUG
    if named(label, "plant", "flower", "tree"):
        return PLANT
    if named(label, "lamp", "light"):
        return FLOOR_LAMP if height > TALL else TABLE_LAMP
    if named(label, "vase"):
        return VASE
    if height > TALL:
        return FLOOR_LAMP if height > THIN * wide else PLANT
    return VASE if height > 1.3 * wide else TABLE_LAMP


def plant(w: float, h: float, d: float) -> Parts:
    """Long leaves out of a pot."""
    pot = min(0.32 * h, 0.6)
    r = min(0.3 * min(w, d), 0.55 * pot)
    yield (
        TERRACOTTA,
        lathe(
            [
                (0, 0),
                (0.68 * r, 0),
                (0.95 * r, 0.82 * pot),
                (r, 0.83 * pot),
                (r, pot),
                (0.88 * r, pot),
                (0.86 * r, 0.88 * pot),
            ]
        ),
    )
    yield SOIL, lathe([(0.88 * r, 0.88 * pot), (0, 0.93 * pot)])
    for number in range(LEAVES):
        turn = number * pi * (3 - 5**0.5)  # the golden angle, as plants do
        rise = 1 - (number / LEAVES) ** 1.2
        spread = 0.25 + 0.75 * (number / LEAVES) ** 0.7
        tip = (
            spread * 0.5 * w * sin(turn),
            pot + (h - pot) * (0.12 + 0.88 * rise),
            spread * 0.5 * d * cos(turn),
        )
        base = (0.3 * r * sin(turn), 0.9 * pot, 0.3 * r * cos(turn))
        droop = 0.25 * (h - pot) * spread * (1 - 0.5 * rise)
        blade = leaf(base, tip, 0.15 * (h - pot) + 0.02, droop).both_sides()
        yield LEAF, replace(blade, color=GREENS[number % len(GREENS)])


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


def vase(w: float, h: float, d: float) -> Parts:
    """A stoneware vase."""
    r = w / 2
    rows = [
        (0, 0),
        (0.55, 0),
        (0.62, 0.03),
        (0.9, 0.2),
        (1.0, 0.4),
        (0.9, 0.58),
        (0.55, 0.76),
        (0.36, 0.86),
        (0.36, 0.94),
        (0.46, 1.0),
        (0.4, 0.995),
        (0.3, 0.93),
        (0.28, 0.84),
        (0, 0.8),
    ]
    yield CERAMIC, lathe([(r * a, h * b) for a, b in rows], sides=28, squash=d / w)


def rug(w: float, h: float, d: float) -> Parts:
    """A flat rug with two thin stripes round it."""
    x, z = w / 2, d / 2
    for number, material in enumerate((LINEN, CLAY, LINEN, WOOL, LINEN)):
        edge = RUG_STRIPES[number] * min(1.0, w, d)
        top = h * (0.8 + 0.05 * number)
        span = ((-x + edge, x - edge), (0.2 * h * min(number, 1), top), (-z + edge, z - edge))
        yield material, block(*span, 0.003)


def _shade(r: float, low: float, high: float, squash: float) -> Parts:
    """A cone of cloth, open below and above."""
    cone = lathe([(r, low), (0.7 * r, high)], sides=28, squash=squash)
    yield SHADE, cone.both_sides()


RUG = Design("rug", rug, (0.3, 0.3, 0.01), (5.0, 5.0, 0.04))
PLANT = Design("plant", plant, (0.15, 0.15, 0.25), (1.6, 1.6, 2.6))
FLOOR_LAMP = Design("floor lamp", floor_lamp, (0.15, 0.15, 0.6), (1.2, 1.2, 2.4))
TABLE_LAMP = Design("table lamp", table_lamp, (0.08, 0.08, 0.1), (0.8, 0.8, 0.9))
VASE = Design("vase", vase, (0.05, 0.05, 0.08), (0.6, 0.6, 1.0))
