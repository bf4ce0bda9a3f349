"""Everything else: a few things with a shape of their own, and a soft neutral box."""

from __future__ import annotations

from math import pi

from scenegen_core.scene.model import Vector3
from server.furniture.cushions import cushion
from server.furniture.design import Design, Parts, named
from server.furniture.materials import (
    CERAMIC,
    GRAPHITE,
    MATTE_WHITE,
    OAK,
    STEEL,
    WARM_GREY,
)
from server.furniture.parts import block, lathe, tube


def choose(_size: Vector3, label: str) -> Design:
    """The thing of that label; a box where there is none."""
    return next((design for words, design in DESIGNS if named(label, *words)), BOX)


def box(w: float, h: float, d: float) -> Parts:
    """A softly rounded box."""
    yield WARM_GREY, cushion((-w / 2, w / 2), (0, h), (-d / 2, d / 2), 0.12 * min(w, h, d))


def refrigerator(w: float, h: float, d: float) -> Parts:
    """Two doors, the freezer below."""
    split = 0.36 * h
    yield GRAPHITE, block((-w / 2 + 0.02, w / 2 - 0.02), (0, 0.06), (-d / 2, d / 2 - 0.08))
    yield MATTE_WHITE, block((-w / 2, w / 2), (0.04, h), (-d / 2, d / 2 - 0.06), 0.01)
    for low, high, grip in ((0.05, split, split - 0.35), (split + 0.008, h, split + 0.05)):
        yield MATTE_WHITE, block((-w / 2, w / 2), (low, high), (d / 2 - 0.075, d / 2 - 0.02), 0.012)
        yield (
            STEEL,
            block((-w / 2 + 0.04, -w / 2 + 0.06), (grip, grip + 0.3), (d / 2 - 0.03, d / 2), 0.006),
        )


def washing_machine(w: float, h: float, d: float) -> Parts:
    """A box with a round window."""
    r, y = 0.3 * w, 0.46 * h
    yield MATTE_WHITE, block((-w / 2, w / 2), (0, h), (-d / 2, d / 2 - 0.02), 0.015)
    ring = lathe([(0, 0), (r, 0), (1.0 * r, 0.012), (0.9 * r, 0.02), (0.72 * r, 0.012)], sides=28)
    glass = lathe([(0.75 * r, 0.01), (0.5 * r, 0.004), (0, 0.002)], sides=28)
    for material, mesh in ((STEEL, ring), (GRAPHITE, glass)):
        front = mesh.leaning(pi / 2, 0.0, 0.0)
        yield material, front.moved(y=y, z=d / 2 - 0.02)
    yield (
        WARM_GREY,
        block((-0.45 * w, 0.45 * w), (0.86 * h, 0.96 * h), (d / 2 - 0.03, d / 2 - 0.014)),
    )
    yield STEEL, block((0.2 * w, 0.27 * w), (0.88 * h, 0.94 * h), (d / 2 - 0.02, d / 2 - 0.005))


def cooker(w: float, h: float, d: float) -> Parts:
    """An oven under four plates."""
    yield MATTE_WHITE, block((-w / 2, w / 2), (0, h - 0.01), (-d / 2, d / 2 - 0.05), 0.01)
    yield (
        GRAPHITE,
        block((-w / 2 + 0.01, w / 2 - 0.01), (h - 0.02, h - 0.003), (-d / 2, d / 2 - 0.05)),
    )
    for side, end in ((-1, -1), (1, -1), (-1, 1), (1, 1)):
        r = 0.17 * w if side == end else 0.13 * w
        yield (
            STEEL,
            lathe(
                [(r, h - 0.004), (r, h), (0.85 * r, h), (0.8 * r, h - 0.002)],
                0.24 * side * w,
                0.22 * end * d - 0.02,
                sides=24,
            ),
        )
    front = (d / 2 - 0.06, d / 2 - 0.035)
    yield MATTE_WHITE, block((-0.47 * w, 0.47 * w), (0.18 * h, 0.76 * h), front)
    yield (
        GRAPHITE,
        block((-0.38 * w, 0.38 * w), (0.26 * h, 0.64 * h), (d / 2 - 0.05, d / 2 - 0.032)),
    )
    yield STEEL, block((-0.4 * w, 0.4 * w), (0.69 * h, 0.71 * h), (d / 2 - 0.04, d / 2 - 0.005))
    for number in range(5):
        knob = lathe([(0, 0), (0.02, 0), (0.018, 0.025), (0, 0.025)], sides=12)
        x = (number - 2) * 0.16 * w
        yield STEEL, knob.leaning(pi / 2, 0, 0).moved(x, 0.87 * h, d / 2 - 0.055)


def toilet(w: float, h: float, d: float) -> Parts:
    """A bowl with a lid in front of a cistern."""
    tank, seat = 0.28 * d, 0.52 * h
    r = min(w / 2, (d - tank) / 2)
    squash = (d - tank) / 2 / r
    middle = d / 2 - r * squash
    rows = [(0, 0), (0.5, 0), (0.52, 0.1), (0.56, 0.45), (0.8, 0.75), (0.95, 0.9), (0.97, 0.93)]
    yield (
        CERAMIC,
        lathe(
            [*((r * a, seat * y) for a, y in rows), (0.97 * r, seat), (0, seat)],
            0,
            middle,
            sides=28,
            squash=squash,
        ),
    )
    yield (
        MATTE_WHITE,
        lathe(
            [(0, seat), (r, seat), (r, seat + 0.025), (0.9 * r, seat + 0.035), (0, seat + 0.038)],
            0,
            middle,
            sides=28,
            squash=squash,
        ),
    )
    yield CERAMIC, block((-w / 2, w / 2), (0.45 * h, 0.96 * h), (-d / 2, -d / 2 + tank), 0.02)
    yield CERAMIC, block((-w / 2, w / 2), (0.95 * h, h), (-d / 2, -d / 2 + tank), 0.01)
    yield CERAMIC, block((-0.25 * w, 0.25 * w), (0, 0.9 * seat), (-d / 2 + 0.02, middle), 0.02)
    yield (
        STEEL,
        lathe(
            [(0.1 * w, h - 0.002), (0.09 * w, h + 0.004), (0, h + 0.004)],
            0,
            -d / 2 + tank / 2,
            sides=16,
        ),
    )


def bath(w: float, h: float, d: float) -> Parts:
    """A free-standing tub."""
    r, squash = w / 2, d / w
    rows = [
        (0, 0),
        (0.72, 0),
        (0.8, 0.05),
        (0.9, 0.5),
        (0.95, 0.9),
        (1.0, 0.94),
        (1.0, 0.99),
        (0.98, 1.0),
        (0.93, 1.0),
        (0.9, 0.97),
        (0.84, 0.5),
        (0.72, 0.2),
        (0, 0.17),
    ]
    yield CERAMIC, lathe([(r * a, h * b) for a, b in rows], sides=40, squash=squash)
    yield STEEL, lathe([(0.03, 0.172 * h), (0.03, 0.172 * h + 0.004), (0, 0.172 * h + 0.004)])


def sink(w: float, h: float, d: float) -> Parts:
    """A basin on a small cabinet, with a tap."""
    top = h - 0.16
    r = 0.46 * min(w, d)
    yield OAK, block((-w / 2, w / 2), (0, top), (-d / 2, d / 2 - 0.02))
    for side in (-1, 1):
        low, high = sorted((side * 0.003, side * (w / 2 - 0.004)))
        yield OAK, block((low, high), (0.02, top - 0.02), (d / 2 - 0.03, d / 2), 0.004)
    rows = [
        (0, 0),
        (0.6, 0),
        (0.9, 0.6),
        (1.0, 1.0),
        (0.94, 1.0),
        (0.84, 0.65),
        (0.5, 0.2),
        (0, 0.15),
    ]
    yield CERAMIC, lathe([(r * a, top + 0.11 * b) for a, b in rows], 0, 0.02 * d, sides=28)
    z = -d / 2 + 0.04
    yield STEEL, tube((0, top, z), (0, h - 0.008, z), 0.012, 0.012)
    yield STEEL, tube((0, h - 0.012, z - 0.01), (0, h - 0.02, z + 0.14), 0.012, 0.01)


BOX = Design("object", box, (0.05, 0.05, 0.05), (10.0, 10.0, 10.0))
DESIGNS: tuple[tuple[tuple[str, ...], Design], ...] = (
    (
        ("fridge", "refrigerator", "freezer"),
        Design("refrigerator", refrigerator, (0.4, 0.4, 1.0), (1.0, 1.2, 2.4)),
    ),
    (
        ("washing machine", "washer", "dryer"),
        Design("washing machine", washing_machine, (0.35, 0.4, 0.5), (0.9, 0.9, 1.3)),
    ),
    (("cooker", "stove", "oven"), Design("cooker", cooker, (0.4, 0.4, 0.6), (1.0, 1.2, 1.2))),
    (("toilet",), Design("toilet", toilet, (0.45, 0.3, 0.5), (1.0, 0.7, 1.2))),
    (("bath", "tub"), Design("bath", bath, (0.5, 0.5, 0.3), (2.4, 2.4, 1.0))),
    (("sink", "basin"), Design("sink", sink, (0.3, 0.3, 0.5), (0.8, 2.0, 1.3))),
)
