"""Compiled loops over pairs of rectangles; compiled once and kept on disk.

Rectangles are rows (x, y, cos, sin, half depth, half width) of center, heading and half sizes.
"""

from __future__ import annotations

import math

import numpy as np
from numba import njit
from numpy.typing import NDArray

Floats = NDArray[np.float64]

compiled = njit(cache=True, nogil=True, error_model="numpy")


@compiled
def outside(x: float, y: float, half_x: float, half_y: float) -> float:
    """Squared distance of a point to a rectangle at the origin."""
    beyond_x, beyond_y = max(abs(x) - half_x, 0.0), max(abs(y) - half_y, 0.0)
    return beyond_x * beyond_x + beyond_y * beyond_y


@compiled
def gap(
    x: float, y: float, cos: float, sin: float, depth: float, width: float, other: Floats
) -> float:
    """Signed gap of two rectangles, metres.

    Two that do not meet are nearest at a corner of one of them, so the distance is the least of
    eight distances from a corner to a rectangle. Two that meet have the separating-axis depth: the
    largest (least negative) separation along the four edge normals.
    """
    dx, dy = x - other[0], y - other[1]
    far_depth, far_width = other[4], other[5]
    x2, y2 = dx * other[2] + dy * other[3], dy * other[2] - dx * other[3]
    x1, y1 = -(dx * cos + dy * sin), dx * sin - dy * cos
    c, s = cos * other[2] + sin * other[3], sin * other[2] - cos * other[3]
    ac, as_ = abs(c), abs(s)
    parted: float = max(
        abs(x2) - far_depth - depth * ac - width * as_,
        abs(y2) - far_width - depth * as_ - width * ac,
        abs(x1) - depth - far_depth * ac - far_width * as_,
        abs(y1) - width - far_depth * as_ - far_width * ac,
    )
    if parted <= 0:
        return parted
    least = math.inf
    for i in (-1.0, 1.0):
        for j in (-1.0, 1.0):
            least = min(
                least,
                outside(
                    x2 + i * depth * c - j * width * s, y2 + i * depth * s + j * width * c,
                    far_depth, far_width,
                ),
                outside(
                    x1 + i * far_depth * c + j * far_width * s,
                    y1 - i * far_depth * s + j * far_width * c,
                    depth, width,
                ),
            )  # fmt: skip
    return math.sqrt(least)


@compiled
def all_gaps(shapes: Floats, others: Floats, out: Floats) -> None:
    """The signed gap of every pair: (shapes, others)."""
    for i in range(len(shapes)):
        x, y, cos, sin, depth, width = shapes[i]
        for j in range(len(others)):
            out[i, j] = gap(x, y, cos, sin, depth, width, others[j])
