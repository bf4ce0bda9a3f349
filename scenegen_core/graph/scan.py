"""Compiled loops that look from every pose at every wall, opening and box.

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

from scenegen_core.scene.compiled import compiled, inlined
from scenegen_core.scene.geometry import TIE, Bools, Floats, Ints

FAR = 4.0  # metres; what is further than across a small room says no more
DEEP = 0.5  # metres; how deep in something a pose lies says no more
TOUCHING = 0.1  # metres; nearer things touch (bounding boxes err)
FLUSH = 0.12  # metres; nearer to a wall is against it (skirting)
NEAR = 1.0  # metres; the paper's ε
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
    "gap", "near", "before", "offset", "bearing", "turn", "faced", "lateral", "beside", "on",
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


@compiled
def look_round(
    poses: Floats,
    bottoms: Floats,
    tops: Floats,
    symmetric: bool,  # noqa: FBT001
    walls_reach: Floats,
    boxes: Floats,
    box_bottoms: Floats,
    box_tops: Floats,
    gaps: Floats,
    out: Floats,
) -> None:
    """FREE_PARTS of every pose, walls and boxes of a common height in the way: (8, poses)."""
    depth, width = poses[4], poses[5]
    reach = walls_reach.copy()
    behind, ahead, side, far_side = out[0], out[1], out[2], out[3]
    centered, nearest, touching, close = out[4], out[5], out[6], out[7]
    nearest[:], touching[:], close[:] = FAR, 0.0, 0.0
    for k in range(len(boxes)):
        low, high = box_bottoms[k], box_tops[k]
        solid = high - low > FLAT
        for n in range(len(depth)):
            away = gaps[k, n]
            level = solid & (min(tops[n], high) - max(bottoms[n], low) > COMMON_HEIGHT)
            close[n] += 1.0 if away < NEAR - TIE else 0.0
            touching[n] += 1.0 if level & (away < TOUCHING - TIE) else 0.0
            nearest[n] = min(nearest[n], away if level else FAR)
        if solid:
            _rays_to_box(poses, bottoms, tops, boxes[k], low, high, reach)
    for n in range(len(depth)):
        before = between(-0.2, reach[0, n] - depth[n], FAR)
        after = between(-0.2, reach[1, n] - depth[n], FAR)
        left = between(-0.2, reach[2, n] - width[n], FAR)
        right = between(-0.2, reach[3, n] - width[n], FAR)
        near, far = min(left, right), max(left, right)
        behind[n] = min(before, after) if symmetric else after
        ahead[n] = max(before, after) if symmetric else before
        side[n], far_side[n] = near, far
        centered[n] = (far - near) / (abs(near) + abs(far) + TOUCHING)
        nearest[n] = max(nearest[n], -DEEP)


@compiled
def _rays_to_box(
    poses: Floats,
    bottoms: Floats,
    tops: Floats,
    box: Floats,
    low: float,
    high: float,
    reach: Floats,
) -> None:
    """Shorten the rays that run into a box of a common height; grazing it is not enough."""
    x, y, cos, sin = poses[0], poses[1], poses[2], poses[3]
    bx, by, bc, bs, half_x, half_y = box[0], box[1], box[2], box[3], box[4] - TIE, box[5] - TIE
    for axis in range(2):
        forth, back = reach[2 * axis], reach[2 * axis + 1]
        for n in range(len(x)):
            dx, dy = x[n] - bx, y[n] - by
            px, py = dx * bc + dy * bs, dy * bc - dx * bs
            c, s = cos[n] * bc + sin[n] * bs, sin[n] * bc - cos[n] * bs
            tx, ty = (c, s) if axis == 0 else (-s, c)
            tx = PARALLEL if abs(tx) < PARALLEL else tx
            ty = PARALLEL if abs(ty) < PARALLEL else ty
            x1, x2 = (-half_x - px) / tx, (half_x - px) / tx
            y1, y2 = (-half_y - py) / ty, (half_y - py) / ty
            enter = max(min(x1, x2), min(y1, y2))
            leave = min(max(x1, x2), max(y1, y2))
            level = min(tops[n], high) - max(bottoms[n], low) > COMMON_HEIGHT
            hits = level & (enter <= leave)
            forth[n] = min(forth[n], max(enter, 0.0) if hits & (leave >= 0) else math.inf)
            back[n] = min(back[n], max(-leave, 0.0) if hits & (enter <= 0) else math.inf)


@compiled
def look_at_neighbors(
    poses: Floats,
    headings: Floats,
    bottoms: Floats,
    symmetric: bool,  # noqa: FBT001
    boxes: Floats,
    gaps: Floats,
    box_headings: Floats,
    box_tops: Floats,
    fronts_known: Bools,
    group_of: Ints,
    groups: int,
    out: Floats,
    beyond: Floats,
) -> None:
    """NEIGHBOR_PARTS of the nearest member of each group: (groups * 10, poses).

    A box of no group (−1) is not looked at; a group without members leaves NaN. Bearings as their
    y, with the x in ``beyond`` (groups, poses).
    """
    parts = len(NEIGHBOR_PARTS)
    which = np.empty(len(headings), dtype=np.int64)
    for group in range(groups):
        rows = out[group * parts : (group + 1) * parts]
        if not (group_of == group).any():
            rows[:], beyond[group] = np.nan, np.nan
            continue
        nearest, near, on = rows[0], rows[1], rows[9]
        nearest[:], near[:], on[:], which[:] = math.inf, 0.0, 0.0, 0
        for k in range(len(boxes)):
            if group_of[k] != group:
                continue
            for n in range(len(headings)):
                away = gaps[k, n]
                near[n] += 1.0 if away < NEAR - TIE else 0.0
                stands = (away < -COMMON_HEIGHT) & (abs(bottoms[n] - box_tops[k]) < STANDS)
                on[n] = 1.0 if stands else on[n]
                nearer = away < nearest[n] - TIE
                which[n] = k if nearer else which[n]
                nearest[n] = away if nearer else nearest[n]
        _look_at_nearest(
            poses,
            headings,
            symmetric,
            boxes,
            box_headings,
            fronts_known,
            which,
            rows,
            beyond[group],
        )


@compiled
def _look_at_nearest(
    poses: Floats,
    headings: Floats,
    symmetric: bool,  # noqa: FBT001
    boxes: Floats,
    box_headings: Floats,
    fronts_known: Bools,
    which: Ints,
    rows: Floats,
    beyond: Floats,
) -> None:
    """How each pose lies in the frame of its box, and the box in the pose's."""
    x, y, cos, sin, width = poses[0], poses[1], poses[2], poses[3], poses[5]
    for n in range(len(headings)):
        k = which[n]
        half_depth, half_width, front = boxes[k, 4], boxes[k, 5], fronts_known[k]
        dx, dy = x[n] - boxes[k, 0], y[n] - boxes[k, 1]
        along = dx * boxes[k, 2] + dy * boxes[k, 3]
        across = dy * boxes[k, 2] - dx * boxes[k, 3]
        end, beside = abs(along) - half_depth, abs(across) - half_width
        ahead, back = max(along - half_depth, -DEEP), min(along + half_depth, DEEP)
        before = (ahead if along >= -TIE else back) if front else max(end, beside)
        aside = abs(across) if front | (end >= beside - TIE) else abs(along)
        faced = (along > half_depth + TIE) & (abs(across) < half_width + width[n] - TIE)
        turn = headings[n] - box_headings[k]
        rows[0, n] = between(-DEEP, rows[0, n], FAR)
        rows[2, n], rows[3, n] = between(-FAR, before, FAR), min(aside, FAR)
        rows[4, n], beyond[n] = dx * sin[n] - dy * cos[n], -(dx * cos[n] + dy * sin[n])
        whole, quarter = turn_between(turn), fold(turn)
        rows[5, n] = whole if front and not symmetric else quarter
        rows[6, n] = (1.0 if faced else 0.0) if front else np.nan
        rows[7, n] = min(abs(dy * cos[n] - dx * sin[n]), FAR)
        rows[8, n] = between(-1.0, beside, FAR)


@compiled
def look_at_twins_places(
    poses: Floats,
    headings: Floats,
    symmetric: bool,  # noqa: FBT001
    places: Floats,
    out: Floats,
) -> None:
    """Distance and turn to the nearest of ``places`` (x, y, heading): (2, poses)."""
    x, y, nearest, least = poses[0], poses[1], out[0], out[1]
    nearest[:], least[:] = math.inf, math.inf
    for k in range(len(places)):
        for n in range(len(x)):
            dx, dy = x[n] - places[k, 0], y[n] - places[k, 1]
            away = math.sqrt(dx * dx + dy * dy)
            turn = headings[n] - places[k, 2]
            turn = fold(turn) if symmetric else turn_between(turn)
            turn = turn if away < nearest[n] - TIE else min(least[n], turn)
            least[n] = turn if away <= nearest[n] + TIE else least[n]
            nearest[n] = min(nearest[n], away)
    for n in range(len(x)):
        nearest[n] = min(nearest[n], FAR / 2) if len(places) else np.nan
        least[n] = least[n] if len(places) else np.nan
