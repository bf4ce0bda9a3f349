"""Tables and desks."""

from __future__ import annotations

from scenegen_core.scene.model import Vector3
from server.furniture.design import Design, Parts, legs, named
from server.furniture.materials import BRASS, MATTE_WHITE, OAK, WALNUT
from server.furniture.parts import block, lathe

COFFEE_HEIGHT = 0.55  # metres; lower tables stand in front of a sofa
DRAWERS = 0.42  # metres, width of the drawers under a desk


def choose(size: Vector3, label: str) -> Design:
    """The table for the size (depth, width, height) and label."""
    if named(label, "round", "pedestal", "bistro", "oval"):
        return ROUND
    if named(label, "desk", "dressing"):
        return DESK
    if named(label, "coffee") or size[2] < COFFEE_HEIGHT:
        return COFFEE
    return TABLE


def table(w: float, h: float, d: float) -> Parts:
    """A top with an apron on four tapered legs."""
    leg = 0.065
    yield OAK, block((-w / 2, w / 2), (h - 0.035, h), (-d / 2, d / 2), 0.01)
    yield from _apron(w - 0.16, d - 0.16, h - 0.035, 0.07)
    yield from legs(w / 2 - 0.1, d / 2 - 0.1, h - 0.03, thickness=leg, material=OAK, splay=0.04)


def coffee(w: float, h: float, d: float) -> Parts:
    """A low table with a shelf under its top."""
    yield WALNUT, block((-w / 2, w / 2), (h - 0.04, h), (-d / 2, d / 2), 0.015)
    yield from legs(
        w / 2 - 0.08, d / 2 - 0.08, h - 0.035, thickness=0.05, material=WALNUT, splay=0.02
    )
    yield (
        OAK,
        block(
            (-w / 2 + 0.06, w / 2 - 0.06), (0.3 * h, 0.3 * h + 0.02), (-d / 2 + 0.06, d / 2 - 0.06)
        ),
    )


def round_table(w: float, h: float, d: float) -> Parts:
    """A round top on a turned pedestal."""
    r = w / 2
    squash = d / w
    yield (
        OAK,
        lathe(
            [
                (0, h - 0.035),
                (r - 0.03, h - 0.035),
                (r - 0.008, h - 0.025),
                (r, h - 0.012),
                (r - 0.006, h),
                (0, h),
            ],
            sides=40,
            squash=squash,
        ),
    )
    foot = 0.55 * r
    yield (
        OAK,
        lathe(
            [
                (0, 0),
                (foot, 0),
                (foot, 0.015),
                (0.5 * foot, 0.035),
                (0.05, 0.09),
                (0.04, 0.45 * h),
                (0.05, h - 0.12),
                (0.3 * r, h - 0.03),
            ],
            sides=28,
            squash=squash,
        ),
    )


def desk(w: float, h: float, d: float) -> Parts:
    """A top with drawers on the right and legs on the left; one sits at its front, +z."""
    box = min(DRAWERS, 0.4 * w)
    yield OAK, block((-w / 2, w / 2), (h - 0.03, h), (-d / 2, d / 2), 0.008)
    x = (w / 2 - box - 0.02, w / 2 - 0.02)
    yield MATTE_WHITE, block(x, (0.12, h - 0.03), (-d / 2 + 0.02, d / 2 - 0.03))
    step = (h - 0.16) / 3
    for number in range(3):
        y = 0.13 + number * step
        yield (
            MATTE_WHITE,
            block(
                (x[0] + 0.008, x[1] - 0.008),
                (y + 0.004, y + step - 0.004),
                (d / 2 - 0.035, d / 2 - 0.015),
                0.004,
            ),
        )
        yield (
            BRASS,
            block(
                (sum(x) / 2 - 0.06, sum(x) / 2 + 0.06),
                (y + 0.7 * step, y + 0.7 * step + 0.012),
                (d / 2 - 0.018, d / 2 - 0.002),
                0.004,
            ),
        )
    yield from legs(w / 2 - 0.06, d / 2 - 0.07, h - 0.03, thickness=0.05, material=OAK)


def _apron(w: float, d: float, top: float, height: float) -> Parts:
    """Four boards on edge under a table top."""
    y = (top - height, top + 0.005)
    for side in (-1, 1):
        z, x = side * d / 2, side * w / 2
        yield OAK, block((-w / 2, w / 2), y, (z - 0.012, z + 0.012), 0.003)
        yield OAK, block((x - 0.012, x + 0.012), y, (-d / 2, d / 2), 0.003)


TABLE = Design("table", table, (0.4, 0.4, 0.4), (2.0, 4.0, 1.2))
COFFEE = Design("coffee table", coffee, (0.35, 0.35, 0.22), (1.6, 2.4, 0.8))
ROUND = Design("round table", round_table, (0.35, 0.35, 0.3), (2.4, 2.4, 1.2))
DESK = Design("desk", desk, (0.4, 0.8, 0.5), (1.2, 2.6, 1.2))
