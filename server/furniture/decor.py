"""Plants, rugs, vases and the like."""

from __future__ import annotations

from dataclasses import replace
from math import cos, pi, sin

import numpy as np

from scenegen_core.scene.model import Vector3
from server.furniture import lamps
from server.furniture.cushions import cushion
from server.furniture.design import Design, Parts, named
from server.furniture.materials import (
    BRASS,
    CERAMIC,
    CLAY,
    LEAF,
    LINEN,
    PAINT,
    SOIL,
    STONEWARE,
    TERRACOTTA,
    WOOL,
    linear,
)
from server.furniture.parts import block, lathe, leaf, tube

RUG_HEIGHT, RUG_WIDTH = 0.05, 0.3  # metres; rugs are flatter and wider
LOW, SLIM, THIN = 0.7, 1.3, 4.0  # height over width of bowls, vases, floor lamps
FLAT = 0.25  # depth over width of what hangs
TALL = 0.6  # metres; what is taller stands on the floor
RUG_STRIPES = (0.0, 0.09, 0.105, 0.13, 0.14)  # metres from the edge, on a rug of a metre or more
LEAVES = 34
MOST_FOLDS = 14
FRUIT = tuple(linear(color) for color in ("#d9a441", "#c8623f", "#9aa65a"))
GREENS = tuple(linear(color) for color in ("#7f9c66", "#6b8c58", "#90ab74", "#5f8052", "#86a06f"))


def choose(size: Vector3, label: str) -> Design:
    """The piece for the size (depth, width, height) and label."""
    labelled = (design for words, design in NAMED if named(label, *words))
    return next(labelled, None) or lamps.choose(size, label) or _by_proportions(size)


def _by_proportions(size: Vector3) -> Design:
    """What has about these proportions."""
    depth, width, height = size
    wide = max(depth, width)
    if height < RUG_HEIGHT and wide > RUG_WIDTH:
        return RUG
    if height < LOW * wide:
        return BOWL
    if height < TALL:
        return VASE if height > SLIM * wide else lamps.TABLE_LAMP
    if depth < FLAT * width:
        return CURTAIN
    return lamps.FLOOR_LAMP if height > THIN * wide else PLANT


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


def bowl(w: float, h: float, d: float) -> Parts:
    """A bowl with some fruit in it."""
    r = w / 2
    rows = [
        (0, 0),
        (0.4, 0),
        (0.45, 0.06),
        (0.85, 0.45),
        (1.0, 0.8),
        (0.95, 0.8),
        (0.75, 0.45),
        (0, 0.3),
    ]
    yield STONEWARE, lathe([(r * a, h * b) for a, b in rows], sides=28, squash=d / w)
    ball = 0.3 * min(r, 0.8 * h)
    circle = [(ball * sin(turn), ball * (1 - cos(turn))) for turn in np.linspace(0, pi, 9)]
    around = [(0.42 * sin(turn), 0.42 * cos(turn)) for turn in np.arange(5) * 0.4 * pi]
    for number, (x, z) in enumerate([*around, (0.0, 0.0)]):
        low = 0.42 * h if (x, z) in around else h - 2 * ball
        fruit = lathe(circle, x * r, z * d / 2, sides=10).moved(y=low)
        yield PAINT, replace(fruit, color=FRUIT[number % len(FRUIT)])


def curtain(w: float, h: float, d: float) -> Parts:
    """Cloth in folds on a rod."""
    folds = min(MOST_FOLDS, max(4, round(w / 0.11)))
    step = w / folds
    for number in range(folds):
        x = -w / 2 + number * step
        front = (number % 2) * 0.25 * d
        yield (
            LINEN,
            cushion(
                (x - 0.1 * step, x + 1.1 * step),
                (0, h - 0.02),
                (-d / 2 + front, d / 4 + front),
                0.45 * step,
            ),
        )
    yield BRASS, tube((-w / 2, h - 0.015, 0), (w / 2, h - 0.015, 0), 0.015, 0.015)


def rug(w: float, h: float, d: float) -> Parts:
    """A flat rug with two thin stripes round it."""
    x, z = w / 2, d / 2
    for number, material in enumerate((LINEN, CLAY, LINEN, WOOL, LINEN)):
        edge = RUG_STRIPES[number] * min(1.0, w, d)
        top = h * (0.8 + 0.05 * number)
        span = ((-x + edge, x - edge), (0.2 * h * min(number, 1), top), (-z + edge, z - edge))
        yield material, block(*span, 0.003)


RUG = Design("rug", rug, (0.3, 0.3, 0.01), (5.0, 5.0, 0.04))
PLANT = Design("plant", plant, (0.15, 0.15, 0.25), (1.6, 1.6, 2.6))
VASE = Design("vase", vase, (0.05, 0.05, 0.08), (0.6, 0.6, 1.0))
BOWL = Design("bowl", bowl, (0.1, 0.1, 0.05), (0.8, 0.8, 0.4))
CURTAIN = Design("curtain", curtain, (0.04, 0.3, 0.4), (0.4, 3.0, 3.5))
NAMED: tuple[tuple[tuple[str, ...], Design], ...] = (
    (("rug", "carpet"), RUG),
    (("plant", "flower", "tree"), PLANT),
    (("vase",), VASE),
    (("bowl",), BOWL),
    (("curtain", "blind", "drape"), CURTAIN),
)
