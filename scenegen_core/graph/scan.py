"""Compiled loops that look from every pose at every wall, opening and box.

One pass over a pose writes all columns of ``own_relations``; nothing is kept in between. The loops
are compiled once and kept on disk. Rectangles are rows (x, y, cos, sin, half depth, half width) of
their center, heading and half sizes; poses are rows (x, y, cos, sin). Poses on grids lie on round
numbers, so whatever is a choice is made the same way within TIE: rounding decides nothing.
"""

from __future__ import annotations

import math

import numpy as np

from scenegen_core.scene.compiled import compiled, gap
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


@compiled
def fold(angle: float) -> float:
    """The turn between axes that repeat every quarter: 0 to π/4."""
    return float(abs((abs(angle) + QUARTER / 2) % QUARTER - QUARTER / 2))


@compiled
def turn_between(angle: float) -> float:
    """An angle wrapped and without its sign: 0 to π."""
    return float(abs((angle + HALF) % (2 * HALF) - HALF))


@compiled
def bearing_of(dx: float, dy: float, cos: float, sin: float) -> float:
    """How far from straight ahead an offset points: 0 to π, and 0 where there is no offset."""
    if abs(dx) < TIE and abs(dy) < TIE:
        return 0.0
    return abs(math.atan2(dy * cos - dx * sin, dx * cos + dy * sin))


@compiled
def between(low: float, value: float, high: float) -> float:
    """A value kept between two bounds."""
    return min(max(value, low), high)


@compiled
def slab(
    x: float, y: float, dx: float, dy: float, half_x: float, half_y: float, hit: Floats
) -> bool:
    """Where a line enters and leaves a rectangle at the origin; False if it only grazes it."""
    half_x, half_y = half_x - TIE, half_y - TIE
    enter, leave = -math.inf, math.inf
    if abs(dx) < PARALLEL:
        if abs(x) > half_x:
            return False
    else:
        one, two = (-half_x - x) / dx, (half_x - x) / dx
        enter, leave = max(enter, min(one, two)), min(leave, max(one, two))
    if abs(dy) < PARALLEL:
        if abs(y) > half_y:
            return False
    else:
        one, two = (-half_y - y) / dy, (half_y - y) / dy
        enter, leave = max(enter, min(one, two)), min(leave, max(one, two))
    hit[0], hit[1] = enter, leave
    return enter <= leave


@compiled
def rays_to_walls(x: float, y: float, cos: float, sin: float, walls: Floats, reach: Floats) -> None:
    """How far the rays ahead, behind, to the left and to the right run to the first wall."""
    reach[:] = math.inf
    for k in range(len(walls)):
        ax, ay = walls[k, 0, 0] - x, walls[k, 0, 1] - y
        ex, ey = walls[k, 1, 0] - walls[k, 0, 0], walls[k, 1, 1] - walls[k, 0, 1]
        for axis in range(2):
            dx, dy = (cos, sin) if axis == 0 else (-sin, cos)
            cross = dx * ey - dy * ex
            if abs(cross) < PARALLEL:
                continue
            where = (ax * dy - ay * dx) / cross
            if where < -TIE or where > 1 + TIE:  # a ray into a corner meets both walls
                continue
            far = (ax * ey - ay * ex) / cross
            if far >= 0:
                reach[2 * axis] = min(reach[2 * axis], far)
            if far <= 0:
                reach[2 * axis + 1] = min(reach[2 * axis + 1], -far)


@compiled
def ordered(one: float, two: float) -> tuple[float, float]:
    """The lesser first."""
    return (one, two) if one <= two else (two, one)


@compiled
def look_at_walls(
    poses: Floats,
    headings: Floats,
    half: Floats,
    symmetric: bool,  # noqa: FBT001 (numba has no keyword-only arguments)
    walls: Floats,
    wall_shapes: Floats,
    inward: Floats,
    out: Floats,
) -> None:
    """WALL_PARTS of every pose: (poses, 9)."""
    reach, gaps = np.empty(4), np.empty(len(wall_shapes))
    depth, width = half
    for n in range(len(poses)):
        x, y, cos, sin = poses[n]
        rays_to_walls(x, y, cos, sin, walls, reach)
        ahead, behind = max(reach[0] - depth, 0.0), max(reach[1] - depth, 0.0)
        side, far_side = ordered(max(reach[2] - width, 0.0), max(reach[3] - width, 0.0))
        if symmetric:
            behind, ahead = ordered(behind, ahead)
        nearest, second, flush = math.inf, math.inf, 0
        for k in range(len(wall_shapes)):
            away = gap(x, y, cos, sin, depth, width, wall_shapes[k])
            gaps[k] = away
            flush += away < FLUSH
            if away < nearest:
                nearest, second = away, nearest
            elif away < second:
                second = away
        turn = HALF
        for k in range(len(wall_shapes)):
            if gaps[k] <= nearest + TIE:
                away = headings[n] - inward[k]
                turn = min(turn, fold(away) if symmetric else turn_between(away))
        out[n, 0], out[n, 1] = min(behind, FAR), min(ahead, FAR)
        out[n, 2], out[n, 3] = min(side, FAR), min(far_side, FAR)
        out[n, 4], out[n, 5] = between(0.0, nearest, FAR), between(0.0, second, FAR)
        out[n, 6] = flush
        out[n, 7] = turn
        out[n, 8] = (far_side - side) / (side + far_side + TOUCHING) if far_side < math.inf else 1.0


@compiled
def look_at_openings(
    poses: Floats,
    half: Floats,
    symmetric: bool,  # noqa: FBT001
    openings: Floats,
    out: Floats,
) -> None:
    """OPENING_PARTS of the nearest opening, as a rectangle without width: (poses, 3)."""
    depth, width = half
    for n in range(len(poses)):
        x, y, cos, sin = poses[n]
        nearest, which = math.inf, -1
        for k in range(len(openings)):
            away = gap(x, y, cos, sin, depth, width, openings[k])
            if away < nearest - TIE:
                nearest, which = away, k
        if which < 0:
            out[n] = np.nan
            continue
        dx, dy = openings[which, 0] - x, openings[which, 1] - y
        bearing = bearing_of(dx, dy, cos, sin)
        out[n, 0] = between(0.0, nearest, FAR)
        out[n, 1] = min(bearing, HALF - bearing) if symmetric else bearing
        out[n, 2] = min(abs(dx * openings[which, 2] + dy * openings[which, 3]), FAR)


@compiled
def look_round(
    poses: Floats,
    half: Floats,
    symmetric: bool,  # noqa: FBT001
    walls: Floats,
    boxes: Floats,
    shares_height: Bools,
    out: Floats,
) -> None:
    """FREE_PARTS of every pose, walls and boxes of a common height in the way: (poses, 8)."""
    reach, hit = np.empty(4), np.empty(2)
    depth, width = half
    for n in range(len(poses)):
        x, y, cos, sin = poses[n]
        rays_to_walls(x, y, cos, sin, walls, reach)
        nearest, touching, close = FAR, 0, 0
        for k in range(len(boxes)):
            away = gap(x, y, cos, sin, depth, width, boxes[k])
            close += away < NEAR - TIE
            if not shares_height[n, k]:
                continue
            touching += away < TOUCHING - TIE
            nearest = min(nearest, away)
            dx, dy = x - boxes[k, 0], y - boxes[k, 1]
            px, py = dx * boxes[k, 2] + dy * boxes[k, 3], dy * boxes[k, 2] - dx * boxes[k, 3]
            c = cos * boxes[k, 2] + sin * boxes[k, 3]
            s = sin * boxes[k, 2] - cos * boxes[k, 3]
            for axis in range(2):
                tx, ty = (c, s) if axis == 0 else (-s, c)
                if not slab(px, py, tx, ty, boxes[k, 4], boxes[k, 5], hit):
                    continue
                if hit[1] >= 0:
                    reach[2 * axis] = min(reach[2 * axis], max(hit[0], 0.0))
                if hit[0] <= 0:
                    reach[2 * axis + 1] = min(reach[2 * axis + 1], max(-hit[1], 0.0))
        ahead, behind = between(-0.2, reach[0] - depth, FAR), between(-0.2, reach[1] - depth, FAR)
        side, far_side = ordered(
            between(-0.2, reach[2] - width, FAR), between(-0.2, reach[3] - width, FAR)
        )
        if symmetric:
            behind, ahead = ordered(behind, ahead)
        out[n, 0], out[n, 1], out[n, 2], out[n, 3] = behind, ahead, side, far_side
        out[n, 4] = (far_side - side) / (abs(side) + abs(far_side) + TOUCHING)
        out[n, 5], out[n, 6], out[n, 7] = max(nearest, -DEEP), touching, close


@compiled
def look_at_neighbors(
    poses: Floats,
    headings: Floats,
    half: Floats,
    bottoms: Floats,
    symmetric: bool,  # noqa: FBT001
    boxes: Floats,
    box_headings: Floats,
    box_tops: Floats,
    fronts_known: Bools,
    group_of: Ints,
    groups: int,
    out: Floats,
) -> None:
    """NEIGHBOR_PARTS of the nearest member of each group: (poses, groups * 10).

    A box of no group (−1) is not looked at; a group without members leaves NaN.
    """
    depth, width = half
    parts = len(NEIGHBOR_PARTS)
    nearest, which = np.empty(groups), np.empty(groups, dtype=np.int64)
    for n in range(len(poses)):
        x, y, cos, sin = poses[n]
        row = out[n]
        row[:] = np.nan
        nearest[:] = math.inf
        for k in range(len(boxes)):
            group = group_of[k]
            if group < 0:
                continue
            at = group * parts
            away = gap(x, y, cos, sin, depth, width, boxes[k])
            if nearest[group] == math.inf:
                row[at + 1], row[at + 9] = 0.0, 0.0
            if away < NEAR - TIE:
                row[at + 1] += 1
            if away < -COMMON_HEIGHT and abs(bottoms[n] - box_tops[k]) < STANDS:
                row[at + 9] = 1.0
            if away < nearest[group] - TIE:
                nearest[group], which[group] = away, k
        for group in range(groups):
            if nearest[group] == math.inf:
                continue
            at, k = group * parts, which[group]
            _neighbor(
                x, y, cos, sin, headings[n], width, symmetric,
                boxes[k], box_headings[k], fronts_known[k], row[at : at + parts],
            )  # fmt: skip
            row[at] = between(-DEEP, nearest[group], FAR)


@compiled
def _neighbor(
    x: float,
    y: float,
    cos: float,
    sin: float,
    heading: float,
    width: float,
    symmetric: bool,  # noqa: FBT001
    box: Floats,
    box_heading: float,
    front_known: bool,  # noqa: FBT001
    row: Floats,
) -> None:
    """How a pose lies in the frame of one box, and the box in the pose's."""
    dx, dy = x - box[0], y - box[1]
    along, across = dx * box[2] + dy * box[3], dy * box[2] - dx * box[3]
    beyond, beside = abs(along) - box[4], abs(across) - box[5]
    turn = heading - box_heading
    if front_known:
        before = max(along - box[4], -DEEP) if along >= -TIE else min(along + box[4], DEEP)
        offset = abs(across)
        ahead = along > box[4] + TIE and abs(across) < box[5] + width - TIE
        row[6] = 1.0 if ahead else 0.0
    else:
        before = max(beyond, beside)
        offset = abs(across) if beyond >= beside - TIE else abs(along)
    bearing = bearing_of(-dx, -dy, cos, sin)
    row[2], row[3] = between(-FAR, before, FAR), min(offset, FAR)
    row[4] = min(bearing, HALF - bearing) if symmetric else bearing
    row[5] = turn_between(turn) if front_known and not symmetric else fold(turn)
    row[7] = min(abs(dy * cos - dx * sin), FAR)
    row[8] = between(-1.0, beside, FAR)


@compiled
def look_at_twins_places(
    poses: Floats,
    headings: Floats,
    symmetric: bool,  # noqa: FBT001
    places: Floats,
    out: Floats,
) -> None:
    """Distance and turn to the nearest of ``places`` (x, y, heading): (poses, 2)."""
    for n in range(len(poses)):
        nearest, least = math.inf, math.inf
        for k in range(len(places)):
            away = math.hypot(poses[n, 0] - places[k, 0], poses[n, 1] - places[k, 1])
            if away > nearest + TIE:
                continue
            turn = headings[n] - places[k, 2]
            turn = fold(turn) if symmetric else turn_between(turn)
            least = turn if away < nearest - TIE else min(least, turn)
            nearest = min(nearest, away)
        out[n, 0] = min(nearest, FAR / 2) if len(places) else np.nan
        out[n, 1] = least if len(places) else np.nan
