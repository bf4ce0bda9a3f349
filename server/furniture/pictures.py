"""Flat things on the wall and on stands: screens, pictures, mirrors.

Those for the wall are built like all others, standing at y = 0; the caller puts their origin.
"""

from __future__ import annotations

from dataclasses import replace
from hashlib import sha256
from math import cos, pi, sin

from scenegen_core.scene.model import Vector3
from server.furniture.cushions import cushion
from server.furniture.design import Design, Parts, named
from server.furniture.materials import COTTON, GRAPHITE, MIRROR, OAK, PAINT, SCREEN, Color, linear
from server.furniture.mesh import Mesh
from server.furniture.parts import Span, block, polygon

FOOT = 0.15  # metres; the least depth on which a screen can stand: thinner ones hang as well
PALETTES = tuple(
    tuple(linear(color) for color in colors)
    for colors in (
        ("#eadfce", "#d3a184", "#8d9f8c", "#b96f50", "#3f5457"),
        ("#e7e2d6", "#a9b7b4", "#d9b98a", "#6d8487", "#c47f5d"),
        ("#f0e4d4", "#c9b59a", "#7f8f74", "#e0a878", "#5d4a42"),
        ("#e3e1da", "#b9c2b2", "#cf9c7c", "#7d8ea0", "#e6c79c"),
    )
)
"""Ground, hill, hill, sun and line of a painting."""
DARK = (linear("#23272b"), linear("#2c3136"))
SILVER = (linear("#cdd8d8"), linear("#dbe4e3"))


def choose_screen(size: Vector3, *, wall: bool) -> Design:
    """A screen, with a foot unless it hangs on the wall or is too thin to stand on one."""
    return WALL_SCREEN if wall or size[0] < FOOT else SCREEN_ON_FOOT


def choose_picture(_size: Vector3, label: str) -> Design:
    """What hangs on the wall."""
    return MIRROR_ON_WALL if named(label, "mirror") else PICTURE


def screen(w: float, h: float, d: float) -> Parts:
    """A flat screen on a foot."""
    yield GRAPHITE, cushion((-0.28 * w, 0.28 * w), (0, 0.02), (-d / 2, d / 2), 0.01)
    yield GRAPHITE, block((-0.05 * w, 0.05 * w), (0.01, 0.3 * h), (-0.03, -0.005))
    yield from _flat_screen(w, 0.1 * h, h, -0.02, min(0.025, d / 2))


def wall_screen(w: float, h: float, d: float) -> Parts:
    """A flat screen whose back touches the wall."""
    yield GRAPHITE, block((-0.25 * w, 0.25 * w), (0.25 * h, 0.75 * h), (-d / 2, d / 2 - 0.012))
    yield from _flat_screen(w, 0.0, h, -d / 2 + 0.3 * d, d / 2)


def _flat_screen(w: float, low: float, high: float, back: float, front: float) -> Parts:
    rim = 0.012
    yield GRAPHITE, block((-w / 2, w / 2), (low, high), (back, front - 0.002), 0.006)
    x, y = (-w / 2 + rim, w / 2 - rim), (low + 1.6 * rim, high - rim)
    for mesh in _glossy(x, y, front - 0.0005, DARK):
        yield SCREEN, mesh


def picture(w: float, h: float, d: float) -> Parts:
    """A framed abstract landscape with a mat round it."""
    rim = min(0.03, 0.08 * min(w, h))
    mat = min(0.09, 0.14 * min(w, h))
    yield from _frame(w, h, d, rim)
    yield (
        COTTON,
        block(
            (-w / 2 + rim / 2, w / 2 - rim / 2), (rim / 2, h - rim / 2), (-d / 2, 0.1 * d), 0.001
        ),
    )
    inset = rim + mat
    for mesh in _painting(w - 2 * inset, h - 2 * inset, f"{w:.2f} {h:.2f}"):
        yield PAINT, mesh.moved(y=inset, z=0.12 * d)


def mirror(w: float, h: float, d: float) -> Parts:
    """A mirror in a thin frame."""
    rim = min(0.025, 0.06 * min(w, h))
    yield from _frame(w, h, d, rim)
    for mesh in _glossy((-w / 2 + rim, w / 2 - rim), (rim, h - rim), 0.0, SILVER):
        yield MIRROR, mesh


def _glossy(x: Span, y: Span, z: float, tones: tuple[Color, Color]) -> list[Mesh]:
    """A flat pane with a slanting reflection in its second tone."""
    low, high = x[0] + 0.3 * (x[1] - x[0]), x[0] + 0.62 * (x[1] - x[0])
    slant = min(0.3 * (x[1] - x[0]), 0.5 * (y[1] - y[0]))
    band = [(low - slant, y[0]), (high - slant, y[0]), (high, y[1]), (low, y[1])]
    pane = [(x[0], y[0]), (x[1], y[0]), (x[1], y[1]), (x[0], y[1])]
    return [
        replace(polygon(corners, z + lift), color=tone)
        for corners, lift, tone in ((pane, 0.0, tones[0]), (band, 0.0005, tones[1]))
    ]


def _frame(w: float, h: float, d: float, rim: float) -> Parts:
    """Four mitred bars."""
    z = (-d / 2, d / 2)
    for side in (-1, 1):
        x = side * (w - rim) / 2
        yield OAK, block((x - rim / 2, x + rim / 2), (0, h), z, 0.004)
        y = h / 2 + side * (h - rim) / 2
        yield OAK, block((-w / 2 + rim, w / 2 - rim), (y - rim / 2, y + rim / 2), z, 0.004)


def _painting(w: float, h: float, seed: str) -> list[Mesh]:
    """Hills under a sun, another for every seed; a picture w × h standing at y = 0."""
    dice = [byte / 255 for byte in sha256(seed.encode()).digest()]
    ground, far, near, sun, line = PALETTES[int(dice[0] * (len(PALETTES) - 0.01))]
    shapes = [(ground, [(-0.5, 0.0), (0.5, 0.0), (0.5, 1.0), (-0.5, 1.0)])]
    shapes.append((sun, _disc(0.5 * dice[1] - 0.25, 0.68 + 0.1 * dice[2], 0.17, w / h)))
    for color, base, roll in ((far, 0.5, dice[3]), (near, 0.3, dice[4]), (line, 0.12, dice[5])):
        left, middle, right = base, base + 0.16 * roll - 0.02, base + 0.14 * (0.5 - roll)
        peak = 0.6 * roll - 0.3
        shapes.append((color, [(-0.5, 0), (0.5, 0), (0.5, right), (peak, middle), (-0.5, left)]))
    layers = []
    for number, (color, corners) in enumerate(shapes):
        flat = polygon([(x * w, y * h) for x, y in corners], 0.0004 * number)
        layers.append(replace(flat, color=color))
    return layers


def _disc(x: float, y: float, radius: float, aspect: float) -> list[tuple[float, float]]:
    """A circle in a picture of width/height ``aspect``, as fractions of its sides."""
    turns = [number * 2 * pi / 24 for number in range(24)]
    across, up = radius / max(aspect, 1.0), radius * min(aspect, 1.0)
    return [(x + across * cos(turn), y + up * sin(turn)) for turn in turns]


SCREEN_ON_FOOT = Design("television", screen, (0.07, 0.4, 0.3), (0.4, 3.0, 1.8))
WALL_SCREEN = Design("wall television", wall_screen, (0.03, 0.4, 0.25), (0.15, 3.0, 1.8))
PICTURE = Design("picture", picture, (0.015, 0.15, 0.15), (0.08, 3.0, 3.0))
MIRROR_ON_WALL = Design("mirror", mirror, (0.015, 0.15, 0.15), (0.08, 3.0, 3.0))
