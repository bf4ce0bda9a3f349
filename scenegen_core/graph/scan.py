"""How poses are looked round from: what the loops of scan_walls and scan_boxes have in common.

Poses are columns (x, y, cos, sin, half depth, half width) × poses; rectangles are rows of the same,
one after the other; ``gaps`` are the signed gaps of both, (rectangles, poses). Results are columns
× poses. The innermost loops run over poses and only choose between values, so that a processor
works on several poses at once; bearings are left as (y, x) for NumPy, whose arctangent does so too.
Poses on grids lie on round numbers, so whatever is a choice is made the same way within TIE:
rounding decides nothing. The loops are compiled once and kept on disk.
"""

from __future__ import annotations

import math

import numpy as np

from scenegen_core.scene.compiled import inlined

FAR = 4.0  # metres; what is further than across a small room says no more
DEEP = 0.5  # metres; how deep in something a pose lies says no more
TOUCHING = 0.1  # metres; nearer things touch (bounding boxes err)
FLUSH = 0.12  # metres; nearer to a wall is against it (skirting)
NEAR = 1.0  # metres; the paper's ε
IN_VIEW = 2.0  # metres; how large a thing is that is further away does not count
COMMON_HEIGHT = 0.01  # metres; things that share less height pass over each other
FLAT = 0.05  # metres; flatter things lie under everything (rugs)
STANDS = 0.06  # metres; an underside this close to an upper side stands on it
PARALLEL = 1e-12  # of a ray and a side

QUARTER, HALF = math.pi / 2, math.pi

WALL_PARTS = (
    "behind", "ahead", "side", "far side", "nearest", "second", "flush", "turn", "centered",
)  # fmt: skip
FREE_PARTS = (
    "behind", "ahead", "side", "far side", "centered", "nearest", "touching", "within a metre",
)  # fmt: skip
NEIGHBOR_PARTS = (
    "gap", "near", "before", "offset", "bearing", "turn", "faced", "lateral", "beside", "on", "top",
    "long",
)  # fmt: skip
OPENING_PARTS = ("gap", "bearing", "offset")


@inlined
def fold(angle: float) -> float:
    """The turn between axes that repeat every quarter: 0 to π/4."""
    return float(abs(angle - QUARTER * np.rint(angle / QUARTER)))


@inlined
def turn_between(angle: float) -> float:
    """An angle wrapped and without its sign: 0 to π."""
    return float(abs(angle - 2 * HALF * np.rint(angle / (2 * HALF))))


@inlined
def between(low: float, value: float, high: float) -> float:
    """A value kept between two bounds."""
    return min(max(value, low), high)
