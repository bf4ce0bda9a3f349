"""Things for one person to sit on."""

from __future__ import annotations

from math import cos, pi, sin

from scenegen_core.scene.model import Vector3
from server.furniture.cushions import cushion
from server.furniture.design import Design, Parts, legs, named
from server.furniture.materials import GRAPHITE, OAK, SAGE, WOOL
from server.furniture.parts import block, lathe, tube

STOOL_HEIGHT = 0.55  # metres; lower seats have no back
ARMCHAIR_WIDTH = 0.7  # metres


def choose(size: Vector3, label: str) -> Design:
    """The chair for the size (depth, width, height) and label."""
    if named(label, "pouf", "ottoman", "hassock"):
        return POUF
    if named(label, "stool", "bench") or size[2] < STOOL_HEIGHT:
        return STOOL
    if named(label, "office", "swivel", "desk"):
        return OFFICE
    if named(label, "arm", "lounge", "recliner") or size[1] >= ARMCHAIR_WIDTH:
        return ARMCHAIR
    return CHAIR


def chair(w: float, h: float, d: float) -> Parts:
    """A dining chair: round tapered legs, a padded seat, a curved back on two posts."""
    seat = 0.54 * h
    x, z = w / 2 - 0.05, d / 2 - 0.05
    yield from legs(x - 0.02, z - 0.02, seat - 0.03, thickness=0.04, material=OAK, splay=0.02)
    yield (
        OAK,
        block(
            (-w / 2 + 0.01, w / 2 - 0.01),
            (seat - 0.055, seat - 0.025),
            (-d / 2 + 0.03, d / 2 - 0.01),
            0.01,
        ),
    )
    yield (
        SAGE,
        cushion((-w / 2, w / 2), (seat - 0.03, seat + 0.025), (-d / 2 + 0.03, d / 2), 0.05, 0.015),
    )
    for side in (-1, 1):
        foot, head = (side * (x - 0.02), seat - 0.05, -z + 0.02), (side * (x - 0.02), 0.95 * h)
        yield OAK, tube(foot, (*head, -d / 2 + 0.014), 0.019, 0.014)
    back = (-d / 2 + 0.018, -d / 2 + 0.06)
    yield OAK, cushion((-w / 2, w / 2), (0.7 * h, h), back, 0.018, 0.006, axis=2)


def armchair(w: float, h: float, d: float) -> Parts:
    """A soft lounge chair."""
    arm, seat = 0.17 * w, 0.5 * h
    yield from legs(w / 2 - 0.09, d / 2 - 0.1, 0.15, thickness=0.04, material=OAK, splay=0.02)
    inner = w / 2 - arm
    for side in (-1, 1):
        low, high = sorted((side * inner, side * w / 2))
        yield WOOL, cushion((low, high), (0.13, 0.7 * h), (-d / 2 + 0.02, d / 2), 0.07, 0.02)
    yield WOOL, cushion((-inner, inner), (0.13, 0.62 * seat), (-d / 2 + 0.05, d / 2 - 0.02), 0.03)
    back = cushion(
        (-w / 2 + 0.02, w / 2 - 0.02), (0.15, h), (-d / 2, -d / 2 + 0.2), 0.08, 0.03, axis=2
    )
    yield WOOL, back
    yield (
        WOOL,
        cushion((-inner, inner), (0.6 * seat, seat), (-d / 2 + 0.17, d / 2 + 0.01), 0.05, 0.025),
    )
    pillow = cushion(
        (-0.6 * inner, 0.6 * inner),
        (seat, seat + 0.42 * h),
        (-d / 2 + 0.22, -d / 2 + 0.34),
        0.05,
        0.045,
        axis=2,
    )
    yield SAGE, pillow.leaning(-0.18, seat, -d / 2 + 0.28)


def stool(w: float, h: float, d: float) -> Parts:
    """A padded seat on four legs."""
    pad = min(0.08, 0.25 * h)
    yield from legs(w / 2 - 0.07, d / 2 - 0.07, h - pad, thickness=0.04, material=OAK, splay=0.03)
    yield (
        OAK,
        block(
            (-w / 2 + 0.015, w / 2 - 0.015),
            (h - pad - 0.03, h - pad + 0.005),
            (-d / 2 + 0.015, d / 2 - 0.015),
            0.01,
        ),
    )
    yield SAGE, cushion((-w / 2, w / 2), (h - pad, h), (-d / 2, d / 2), 0.06, 0.02)


def pouf(w: float, h: float, d: float) -> Parts:
    """A round soft seat with a seam."""
    r = w / 2
    rows = [
        (0, 0),
        (0.8, 0),
        (0.94, 0.08),
        (1.0, 0.25),
        (1.0, 0.48),
        (0.97, 0.5),
        (1.0, 0.52),
        (1.0, 0.75),
        (0.94, 0.9),
        (0.75, 0.97),
        (0.4, 1.0),
        (0, 1.0),
    ]
    yield WOOL, lathe([(r * a, h * b) for a, b in rows], sides=28, squash=d / w)


def office(w: float, h: float, d: float) -> Parts:
    """A desk chair on a star of five castors."""
    seat, reach = 0.48 * h, min(w, d) / 2
    for arm in range(5):
        turn = pi / 2 + arm * 2 * pi / 5
        x, z = (reach - 0.035) * cos(turn), (reach - 0.035) * sin(turn)
        yield GRAPHITE, tube((0, 0.11, 0), (x, 0.075, z), 0.022, 0.014, sides=6)
        yield (
            GRAPHITE,
            lathe(
                [(0, 0), (0.026, 0.004), (0.034, 0.03), (0.026, 0.058), (0, 0.062)], x, z, sides=8
            ),
        )
    yield GRAPHITE, tube((0, 0.08, 0), (0, seat - 0.04, 0), 0.03, 0.024, sides=10)
    yield (
        WOOL,
        cushion(
            (-w / 2 + 0.06, w / 2 - 0.06),
            (seat - 0.05, seat + 0.03),
            (-d / 2 + 0.09, d / 2 - 0.01),
            0.09,
            0.02,
        ),
    )
    yield GRAPHITE, block((-0.04, 0.04), (seat - 0.04, 0.75 * h), (-d / 2 + 0.02, -d / 2 + 0.05))
    yield (
        WOOL,
        cushion(
            (-w / 2 + 0.08, w / 2 - 0.08),
            (seat + 0.12, h),
            (-d / 2 + 0.03, -d / 2 + 0.11),
            0.05,
            0.025,
            axis=2,
        ),
    )
    for side in (-1, 1):
        x = side * (w / 2 - 0.03)
        yield GRAPHITE, tube((x, seat - 0.02, -0.02), (x, seat + 0.2, -0.02), 0.014, 0.014, sides=6)
        yield (
            GRAPHITE,
            cushion((x - 0.03, x + 0.03), (seat + 0.19, seat + 0.225), (-0.16, 0.12), 0.02),
        )


CHAIR = Design("chair", chair, (0.36, 0.34, 0.6), (0.8, 0.8, 1.3))
ARMCHAIR = Design("armchair", armchair, (0.6, 0.6, 0.55), (1.3, 1.4, 1.4))
STOOL = Design("stool", stool, (0.25, 0.25, 0.25), (1.2, 2.0, 0.9))
POUF = Design("pouf", pouf, (0.25, 0.25, 0.2), (1.5, 1.5, 0.8))
OFFICE = Design("office chair", office, (0.45, 0.45, 0.75), (0.9, 0.9, 1.5))
