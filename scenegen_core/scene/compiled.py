"""Compiled loops over pairs of rectangles; compiled once and kept on disk.

A rectangle is its center, the cosine and sine of its heading, and its half depth and half width:
``columns`` (6, n) where the loop runs over them, ``rows`` (m, 6) where it looks at one at a time.
The inner loops run over poses, without branches, so that a processor works on several at once.
"""

from __future__ import annotations

import math

import numpy as np
from numba import njit
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Bools = NDArray[np.bool_]

compiled = njit(cache=True, nogil=True, error_model="numpy")
inlined = njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
"""For what inner loops call: one that calls anything works on one pose at a time."""


@inlined
def outside(x: float, y: float, half_x: float, half_y: float) -> float:
    """Squared distance of a point to a rectangle at the origin."""
    beyond_x, beyond_y = max(abs(x) - half_x, 0.0), max(abs(y) - half_y, 0.0)
    return beyond_x * beyond_x + beyond_y * beyond_y


@inlined
def separation(
    dx: float, dy: float, cos: float, sin: float, depth: float, width: float,
    far_cos: float, far_sin: float, far_depth: float, far_width: float,
) -> float:  # fmt: skip
    """The largest separation along the four edge normals, metres.

    ``dx``, ``dy`` lead from the other rectangle to ours. Where it is negative it is the signed
    gap; where positive, the gap is no less. Much cheaper.
    """
    ac, as_ = abs(cos * far_cos + sin * far_sin), abs(sin * far_cos - cos * far_sin)
    return float(
        max(
            abs(dx * far_cos + dy * far_sin) - far_depth - depth * ac - width * as_,
            abs(dy * far_cos - dx * far_sin) - far_width - depth * as_ - width * ac,
            abs(dx * cos + dy * sin) - depth - far_depth * ac - far_width * as_,
            abs(dx * sin - dy * cos) - width - far_depth * as_ - far_width * ac,
        )
    )


@inlined
def corner_distance(
    dx: float, dy: float, cos: float, sin: float, depth: float, width: float,
    far_cos: float, far_sin: float, far_depth: float, far_width: float,
) -> float:  # fmt: skip
    """The least distance from a corner of one rectangle to the other, metres."""
    x2, y2 = dx * far_cos + dy * far_sin, dy * far_cos - dx * far_sin
    x1, y1 = -(dx * cos + dy * sin), dx * sin - dy * cos
    c, s = cos * far_cos + sin * far_sin, sin * far_cos - cos * far_sin
    dc, ws, ds, wc = depth * c, width * s, depth * s, width * c
    fdc, fws, fds, fwc = far_depth * c, far_width * s, far_depth * s, far_width * c
    least = min(
        outside(x2 + dc - ws, y2 + ds + wc, far_depth, far_width),
        outside(x2 + dc + ws, y2 + ds - wc, far_depth, far_width),
        outside(x2 - dc - ws, y2 - ds + wc, far_depth, far_width),
        outside(x2 - dc + ws, y2 - ds - wc, far_depth, far_width),
        outside(x1 + fdc + fws, y1 - fds + fwc, depth, width),
        outside(x1 + fdc - fws, y1 - fds - fwc, depth, width),
        outside(x1 - fdc + fws, y1 + fds + fwc, depth, width),
        outside(x1 - fdc - fws, y1 + fds - fwc, depth, width),
    )
    return math.sqrt(least)


@compiled
def all_gaps(columns: Floats, others: Floats, out: Floats) -> None:
    """The signed gap of every pair, metres: (others, shapes).

    Two that do not meet are nearest at a corner of one of them, so the distance is the least of
    eight distances from a corner to a rectangle. Two that meet have the separating-axis depth: the
    largest (least negative) separation along the four edge normals.
    """
    x, y, cos, sin = columns[0], columns[1], columns[2], columns[3]
    depth, width = columns[4], columns[5]
    for j in range(len(others)):
        ox, oy, oc, os, od, ow = others[j]
        row = out[j]
        for i in range(len(x)):
            dx, dy = x[i] - ox, y[i] - oy
            parted = separation(dx, dy, cos[i], sin[i], depth[i], width[i], oc, os, od, ow)
            away = corner_distance(dx, dy, cos[i], sin[i], depth[i], width[i], oc, os, od, ow)
            row[i] = away if parted > 0 else parted


@compiled
def all_separations(columns: Floats, others: Floats, out: Floats) -> None:
    """The separation of every pair, metres: (others, shapes)."""
    x, y, cos, sin = columns[0], columns[1], columns[2], columns[3]
    depth, width = columns[4], columns[5]
    for j in range(len(others)):
        ox, oy, oc, os, od, ow = others[j]
        row = out[j]
        for i in range(len(x)):
            dx, dy = x[i] - ox, y[i] - oy
            row[i] = separation(dx, dy, cos[i], sin[i], depth[i], width[i], oc, os, od, ow)


@compiled
def all_collisions(
    columns: Floats,
    bottoms: Floats,
    tops: Floats,
    others: Floats,
    other_bottoms: Floats,
    other_tops: Floats,
    allowances: Floats,
    tall_allowances: Floats,
    tall: float,
    layer: float,
    out: Bools,
) -> None:
    """Which shapes reach further into others than allowed, at a common height: (others, shapes).

    ``tall_allowances`` count for shapes whose tops are ``tall`` or more, metres; what shares less
    height than a ``layer`` does not meet.
    """
    x, y, cos, sin = columns[0], columns[1], columns[2], columns[3]
    depth, width = columns[4], columns[5]
    for j in range(len(others)):
        ox, oy, oc, os, od, ow = others[j]
        low, high, some, more = other_bottoms[j], other_tops[j], allowances[j], tall_allowances[j]
        row = out[j]
        for i in range(len(x)):
            dx, dy = x[i] - ox, y[i] - oy
            apart = separation(dx, dy, cos[i], sin[i], depth[i], width[i], oc, os, od, ow)
            shared = min(tops[i], high) - max(bottoms[i], low)
            row[i] = (apart < -(more if tops[i] >= tall else some)) & (shared > layer)


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
