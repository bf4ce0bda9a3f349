"""Compiled loops over pairs of rectangles; compiled once and kept on disk.

Rectangles are rows (x, y, cos, sin, half depth, half width) of center, heading and half sizes.
"""

from __future__ import annotations

import math

import numpy as np
from numba import njit
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Bools = NDArray[np.bool_]

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


@compiled
def separation(
    x: float, y: float, cos: float, sin: float, depth: float, width: float, other: Floats
) -> float:
    """The largest separation along the four edge normals, metres.

    Where it is negative it is the signed gap; where positive, the gap is no less. Much cheaper.
    """
    dx, dy = x - other[0], y - other[1]
    ac = abs(cos * other[2] + sin * other[3])
    as_ = abs(sin * other[2] - cos * other[3])
    return float(
        max(
            abs(dx * other[2] + dy * other[3]) - other[4] - depth * ac - width * as_,
            abs(dy * other[2] - dx * other[3]) - other[5] - depth * as_ - width * ac,
            abs(dx * cos + dy * sin) - depth - other[4] * ac - other[5] * as_,
            abs(dx * sin - dy * cos) - width - other[4] * as_ - other[5] * ac,
        )
    )


@compiled
def all_separations(shapes: Floats, others: Floats, out: Floats) -> None:
    """The separation of every pair: (shapes, others)."""
    for i in range(len(shapes)):
        x, y, cos, sin, depth, width = shapes[i]
        for j in range(len(others)):
            out[i, j] = separation(x, y, cos, sin, depth, width, others[j])


@compiled
def inside(points: Floats, walls: Floats, out: Bools) -> None:
    """Is each point inside the outline that the walls make? Even-odd; an edge is either."""
    for i in range(len(points)):
        x, y = points[i]
        odd = False
        for k in range(len(walls)):
            ax, ay, bx, by = walls[k, 0, 0], walls[k, 0, 1], walls[k, 1, 0], walls[k, 1, 1]
            if (ay > y) != (by > y) and x < ax + (y - ay) * (bx - ax) / (by - ay):
                odd = not odd
        out[i] = odd
