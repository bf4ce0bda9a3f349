"""From every pose at every wall and opening, in compiled loops (scan.py says how they go)."""

from __future__ import annotations

import math

import numpy as np

from scenegen_core.graph.scan import (
    FAR,
    FLUSH,
    HALF,
    PARALLEL,
    TOUCHING,
    between,
    fold,
    turn_between,
)
from scenegen_core.scene.compiled import compiled
from scenegen_core.scene.geometry import TIE, Floats


@compiled
def rays_to_walls(poses: Floats, walls: Floats, reach: Floats) -> None:
    """How far the rays ahead, behind, to the left and to the right run to a wall: (4, poses)."""
    x, y, cos, sin = poses[0], poses[1], poses[2], poses[3]
    reach[:] = math.inf
    for k in range(len(walls)):
        ax, ay = walls[k, 0]
        ex, ey = walls[k, 1, 0] - ax, walls[k, 1, 1] - ay
        for axis in range(2):
            forth, back = reach[2 * axis], reach[2 * axis + 1]
            for n in range(len(x)):
                px, py = ax - x[n], ay - y[n]
                dx, dy = (cos[n], sin[n]) if axis == 0 else (-sin[n], cos[n])
                cross = dx * ey - dy * ex
                where = (px * dy - py * dx) / cross
                far = (px * ey - py * ex) / cross
                # a ray into a corner meets both walls
                meets = (abs(cross) >= PARALLEL) & (where >= -TIE) & (where <= 1 + TIE)
                forth[n] = min(forth[n], far if meets & (far >= 0) else math.inf)
                back[n] = min(back[n], -far if meets & (far <= 0) else math.inf)


@compiled
def look_at_walls(
    poses: Floats,
    headings: Floats,
    symmetric: bool,  # noqa: FBT001 (numba has no keyword-only arguments)
    reach: Floats,
    gaps: Floats,
    inward: Floats,
    out: Floats,
) -> None:
    """WALL_PARTS of every pose: (9, poses)."""
    depth, width = poses[4], poses[5]
    behind, ahead, side, far_side, nearest = out[0], out[1], out[2], out[3], out[4]
    second, flush, turn, centered = out[5], out[6], out[7], out[8]
    nearest[:], second[:], flush[:], turn[:] = math.inf, math.inf, 0.0, HALF
    for k in range(len(gaps)):
        for n in range(len(depth)):
            away = gaps[k, n]
            flush[n] += 1.0 if away < FLUSH else 0.0
            second[n] = min(max(away, nearest[n]), second[n])
            nearest[n] = min(away, nearest[n])
    for k in range(len(gaps)):
        for n in range(len(depth)):
            facing = headings[n] - inward[k]
            facing = fold(facing) if symmetric else turn_between(facing)
            turn[n] = min(turn[n], facing if gaps[k, n] <= nearest[n] + TIE else HALF)
    for n in range(len(depth)):
        before, after = max(reach[0, n] - depth[n], 0.0), max(reach[1, n] - depth[n], 0.0)
        left, right = max(reach[2, n] - width[n], 0.0), max(reach[3, n] - width[n], 0.0)
        near, far = min(left, right), max(left, right)
        behind[n] = min(min(before, after) if symmetric else after, FAR)
        ahead[n] = min(max(before, after) if symmetric else before, FAR)
        side[n], far_side[n] = min(near, FAR), min(far, FAR)
        nearest[n] = between(0.0, nearest[n], FAR)
        second[n] = between(0.0, second[n], FAR)
        centered[n] = (far - near) / (near + far + TOUCHING) if far < math.inf else 1.0


@compiled
def look_at_openings(
    poses: Floats,
    openings: Floats,
    gaps: Floats,
    out: Floats,
    beyond: Floats,
) -> None:
    """OPENING_PARTS of the nearest opening, as a rectangle without width: (3, poses).

    Bearings as their y, with the x in ``beyond`` (poses,).
    """
    x, y, cos, sin = poses[0], poses[1], poses[2], poses[3]
    which = np.zeros(len(x), dtype=np.int64)
    nearest = np.full(len(x), math.inf)
    for k in range(len(openings)):
        for n in range(len(x)):
            nearer = gaps[k, n] < nearest[n] - TIE
            which[n] = k if nearer else which[n]
            nearest[n] = gaps[k, n] if nearer else nearest[n]
    for n in range(len(x)):
        opening = openings[which[n]]
        dx, dy = opening[0] - x[n], opening[1] - y[n]
        out[0, n] = between(0.0, nearest[n], FAR)
        out[1, n], beyond[n] = dy * cos[n] - dx * sin[n], dx * cos[n] + dy * sin[n]
        out[2, n] = min(abs(dx * opening[2] + dy * opening[3]), FAR)
