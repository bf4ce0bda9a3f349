"""From every pose at every box, in compiled loops (scan.py says how they go)."""

from __future__ import annotations

import math

import numpy as np

from scenegen_core.graph.scan import (
    COMMON_HEIGHT,
    DEEP,
    FAR,
    FLAT,
    IN_VIEW,
    NEAR,
    NEIGHBOR_PARTS,
    PARALLEL,
    STANDS,
    TOUCHING,
    between,
    fold,
    turn_between,
)
from scenegen_core.scene.compiled import compiled
from scenegen_core.scene.geometry import TIE, Bools, Floats, Ints


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
    """NEIGHBOR_PARTS of the nearest member of each group: (groups * 12, poses).

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
        nearest, near, on, top, long = rows[0], rows[1], rows[9], rows[10], rows[11]
        nearest[:], near[:], on[:], which[:] = math.inf, 0.0, 0.0, 0
        for k in range(len(boxes)):
            if group_of[k] != group:
                continue
            upper, longer = box_tops[k], 2 * max(boxes[k, 4], boxes[k, 5])
            for n in range(len(headings)):
                away = gaps[k, n]
                near[n] += 1.0 if away < NEAR - TIE else 0.0
                stands = (away < -COMMON_HEIGHT) & (abs(bottoms[n] - box_tops[k]) < STANDS)
                on[n] = 1.0 if stands else on[n]
                nearer = away < nearest[n] - TIE
                which[n] = k if nearer else which[n]
                nearest[n] = away if nearer else nearest[n]
                top[n] = upper if nearer else top[n]
                long[n] = longer if nearer else long[n]
        for n in range(len(headings)):
            in_view = nearest[n] < IN_VIEW - TIE
            top[n] = top[n] if in_view else math.nan
            long[n] = long[n] if in_view else math.nan
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
