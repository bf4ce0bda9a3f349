"""Proposals: the poses that are tried, and the cells of the heat maps that they belong to."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import ceil, pi

import numpy as np

from scenegen_core.graph.candidates import Candidates
from scenegen_core.graph.surroundings import Surroundings
from scenegen_core.placement.answer import Surface
from scenegen_core.placement.mounts import (
    HANGING_HEIGHT,
    HANGING_RANGE,
    REACHABLE_TOP,
    SUPPORTS,
    Mount,
    mounts,
)
from scenegen_core.scene.geometry import (
    TIE,
    Bools,
    Floats,
    Ints,
    Rectangles,
    directions,
    distances_to_segments,
    within,
)
from scenegen_core.scene.model import Category, Point, Symmetry, Vector3

CELL = 0.1  # metres between positions
HEADINGS = 16  # of an asymmetric object, a full turn
WALL_GAP = 0.02  # metres that furniture keeps from the wall it is pushed against (skirting)
SQUEEZE = 0.002  # metres that a niche may be narrower than what goes in (rounding of outlines)
OVERHANG = 0.15  # metres that an object may stick out over what it stands on

MOUNT_STEP = 1 << 40  # more cells than a grid has: cells of different mounts stay apart

SURFACES: tuple[Surface, ...] = ("floor", "walls", "tops")
"""The heat map of each mount, in the order of Mount."""


Poses = tuple[Floats, Floats, bool]
"""Centers (n, 3), headings (n,), and whether they are pushed against a wall."""


@dataclass(frozen=True, slots=True)
class Grid:
    """The cells of a heat map: ``shape`` (rows, columns) of ``cell`` metres from ``origin``."""

    origin: Point
    shape: tuple[int, int]
    cell: float = CELL

    def index(self, points: Floats) -> Ints:
        """The flat index of the cell that each point lies in: (n, 2) -> (n,)."""
        rows, columns = self.shape
        column = ((points[:, 0] - self.origin[0]) / self.cell).clip(0, columns - 1).astype(np.int64)
        row = ((points[:, 1] - self.origin[1]) / self.cell).clip(0, rows - 1).astype(np.int64)
        return row * columns + column

    def middles(self) -> Floats:
        """The middle of every cell, row by row: (rows * columns, 2)."""
        rows, columns = np.mgrid[: self.shape[0], : self.shape[1]]
        corners = np.stack([columns.ravel(), rows.ravel()], axis=1)
        return np.asarray((corners + 0.5) * self.cell + self.origin, dtype=np.float64)


@dataclass(frozen=True, slots=True)
class Proposals:
    """n poses with their ``mounts`` (n,) and ``cells`` (n,), flat in the grid of their mount."""

    candidates: Candidates
    mounts: Ints
    cells: Ints
    flush: Bools
    """Is the pose one that is pushed against a wall? (n,)"""
    grids: dict[Mount, Grid]

    @property
    def places(self) -> Ints:
        """A number for each pose; poses of one cell of one mount share it: (n,)."""
        return np.asarray(self.mounts * MOUNT_STEP + self.cells, dtype=np.int64)


def propose(around: Surroundings, category: Category, size: Vector3) -> Proposals:
    """All poses to try for an object: a grid, and flush along every wall."""
    grids = {mount: _grid(around, mount) for mount in mounts(category.name, size)}
    parts = [(mount, *poses) for mount in grids for poses in _POSES[mount](around, category, size)]
    flat = (
        unrolled(around.walls, centers) if mount is Mount.WALL else centers[:, :2]
        for mount, centers, _, _ in parts
    )
    lengths = [len(centers) for _, centers, _, _ in parts]
    return Proposals(
        candidates=Candidates(
            category=category.name,
            size=size,
            centers=np.concatenate([np.empty((0, 3)), *(part[1] for part in parts)]),
            headings=np.concatenate([np.empty(0), *(part[2] for part in parts)]),
        ),
        mounts=np.repeat([int(part[0]) for part in parts], lengths).astype(np.int64),
        cells=np.concatenate(
            [
                np.empty(0, dtype=np.int64),
                *(grids[part[0]].index(points) for part, points in zip(parts, flat, strict=True)),
            ]
        ),
        flush=np.repeat([part[3] for part in parts], lengths).astype(np.bool_),
        grids=grids,
    )


def unrolled(walls: Floats, points: Floats) -> Floats:
    """(metres along the outline from corner 0, height) of points at walls: (n, 3) -> (n, 2)."""
    run = walls[:, 1] - walls[:, 0]
    lengths = np.hypot(run[:, 0], run[:, 1])
    starts = np.concatenate([[0.0], np.cumsum(lengths)[:-1]])
    wall = nearest_walls(walls, points[:, :2])
    along = ((points[:, :2] - walls[wall, 0]) * run[wall]).sum(axis=1) / lengths[wall]
    return np.stack([starts[wall] + along.clip(0, lengths[wall]), points[:, 2]], axis=1)


def nearest_walls(walls: Floats, points: Floats) -> Ints:
    """The wall nearest to each point, the first of those that tie: (n, 2) -> (n,)."""
    distances = distances_to_segments(points, walls)
    tied = distances <= distances.min(axis=1, keepdims=True) + TIE
    return np.asarray(tied.argmax(axis=1), dtype=np.int64)


def main_direction(walls: Floats) -> float:
    """The heading of the longest wall; grids of headings start from it."""
    run = walls[:, 1] - walls[:, 0]
    longest = int(np.hypot(run[:, 0], run[:, 1]).argmax())
    return float(np.arctan2(run[longest, 1], run[longest, 0]))


def _grid(around: Surroundings, mount: Mount) -> Grid:
    walls = around.walls
    if mount is Mount.WALL:
        length = float(np.hypot(*(walls[:, 1] - walls[:, 0]).T).sum())
        return Grid((0.0, 0.0), (ceil(around.scene.room.height / CELL), ceil(length / CELL)))
    low, high = walls[:, 0].min(axis=0), walls[:, 0].max(axis=0)
    columns, rows = np.ceil((high - low) / CELL - 1e-6).astype(int).clip(1)
    return Grid((float(low[0]), float(low[1])), (int(rows), int(columns)))


def _floor_poses(around: Surroundings, category: Category, size: Vector3) -> Iterator[Poses]:
    """The grid inside the room with its headings, then flush along every wall."""
    points = floor_points(around)
    if category.symmetry is Symmetry.INSIDE_FACING:
        nearest = nearest_walls(around.walls, points)
        yield _raised(points, size[2] / 2), around.inward[nearest], False
    else:
        turns = _headings(around, category, size)
        repeated = np.repeat(points, len(turns), axis=0)
        yield _raised(repeated, size[2] / 2), np.tile(turns, len(points)), False
    for turn in _quarters(category, size):
        depth, width = size[:2] if turn == 0 else (size[1], size[0])
        flush, facing = _along_walls(around, depth, width, WALL_GAP)
        yield _raised(flush, size[2] / 2), facing + turn, True


def floor_points(around: Surroundings) -> Floats:
    """The middles of the floor cells inside the room: (n, 2)."""
    grid = _grid(around, Mount.FLOOR)
    points = grid.middles()
    return np.asarray(points[within(points, around.walls)], dtype=np.float64)


def _headings(around: Surroundings, category: Category, size: Vector3) -> Floats:
    """The headings to try at every position, from the main direction of the room."""
    if category.symmetry is Symmetry.ASYMMETRIC:
        turns = np.arange(HEADINGS, dtype=np.float64) * (2 * pi / HEADINGS)
    else:
        turns = _quarters(category, size)
    return np.asarray(main_direction(around.walls) + turns, dtype=np.float64)


def _quarters(category: Category, size: Vector3) -> Floats:
    """The quarter turns that make a difference to what has no front, 0 alone to others."""
    both = category.symmetry is Symmetry.SYMMETRIC and size[0] != size[1]
    return np.array([0.0, pi / 2] if both else [0.0])


def _along_walls(
    around: Surroundings, depth: float, width: float, gap: float
) -> tuple[Floats, Floats]:
    """Middles of footprints ``gap`` off every wall: a cell apart, in corners, beside boxes.

    A niche as wide as the footprint takes it without the gap. Returns (n, 2) and (n,) headings.
    """
    points, headings = [np.empty((0, 2))], [np.empty(0)]
    off = depth / 2 + gap
    corners = around.footprints.corners
    for (start, end), heading in zip(around.walls, around.inward, strict=True):
        length = float(np.hypot(*(end - start)))
        margin = min(width / 2 + gap, length / 2)
        if length < width - SQUEEZE:
            continue
        run, into = (end - start) / length, directions(np.array([heading]))[0]
        count = max(2, ceil((length - 2 * margin) / CELL) + 1)
        sides = _beside((corners - start) @ run, (corners - start) @ into, depth + gap, width)
        sides = sides[(sides > margin - TIE) & (sides < length - margin + TIE)]
        everywhere = np.concatenate([np.linspace(margin, length - margin, count), sides])
        along = np.unique(everywhere.round(6))
        points.append(start + run * along[:, None] + off * into)
        headings.append(np.full(len(along), heading))
    return np.concatenate(points), np.concatenate(headings)


def _beside(along: Floats, away: Floats, depth: float, width: float) -> Floats:
    """Middles along a wall of what touches the boxes that reach nearer than ``depth`` to it.

    ``along`` the wall and ``away`` from it are the corners of all boxes: (boxes, 4) each.
    """
    near = (away.min(axis=1) < depth - TIE) & (away.max(axis=1) > TIE)
    starts, ends = along[near].min(axis=1), along[near].max(axis=1)
    return np.concatenate([starts - width / 2, ends + width / 2])


def _wall_poses(around: Surroundings, category: Category, size: Vector3) -> Iterator[Poses]:
    """Hanging on every wall, the usual height first."""
    points, headings = _along_walls(around, size[0], size[1], 0.0)
    usual = HANGING_HEIGHT.get(category.name, HANGING_HEIGHT["Picture"])
    steps = np.arange(0, HANGING_RANGE + CELL / 2, CELL)
    for shift in sorted({*steps.round(3), *(-steps).round(3)}, key=abs):
        yield _raised(points, usual + float(shift)), headings, True


def _top_poses(around: Surroundings, category: Category, size: Vector3) -> Iterator[Poses]:
    """On top of each box that carries such things, facing along its axes."""
    asymmetric = category.symmetry is Symmetry.ASYMMETRIC
    turns = np.arange(4) * (pi / 2) if asymmetric else _quarters(category, size)
    grid = _grid(around, Mount.TOP)
    for index, box in enumerate(around.scene.boxes):
        if box.category not in SUPPORTS.get(category.name, ()) or box.top > REACHABLE_TOP:
            continue
        shape = around.footprints[np.array([index])]
        points = _points_on(shape, grid)
        facing_out = box.category == "Storage"  # a TV on a sideboard looks where its doors do
        headings = box.heading + (turns[:1] if facing_out else turns)
        repeated = np.repeat(points, len(headings), axis=0)
        poses = _raised(repeated, box.top + size[2] / 2)
        facing = np.tile(headings, len(points))
        half = np.broadcast_to(np.array(size[:2]) / 2, (len(poses), 2))
        stands = stands_on(Rectangles(repeated, half, facing), shape)[:, 0]
        yield poses[stands], facing[stands], False


def stands_on(shapes: Rectangles, supports: Rectangles) -> Bools:
    """Is every corner of a shape over the support, up to the overhang?: (shapes, supports)."""
    corners = shapes.corners[:, None, :, :] - supports.centers[None, :, None, :]
    along = (corners[:, :, :, None, :] * supports.axes[None, :, None, :, :]).sum(axis=4)
    room = supports.halves[None, :, None, :] + OVERHANG
    over = (np.abs(along) <= room).all(axis=(2, 3))
    inside = (np.abs(along.mean(axis=2)) <= supports.halves[None]).all(axis=2)
    return np.asarray(over & inside, dtype=np.bool_)


def _points_on(shape: Rectangles, grid: Grid) -> Floats:
    """The middle of one footprint, and the middles of the cells over it: (n, 2)."""
    points = np.concatenate([shape.centers, grid.middles()])
    along = (points[:, None, :] - shape.centers) @ shape.axes[0].T
    over = (np.abs(along[:, 0]) <= shape.halves[0]).all(axis=1)
    return np.asarray(points[over], dtype=np.float64)


def _raised(points: Floats, height: float) -> Floats:
    """Plan points at a height: (n, 2) -> (n, 3)."""
    raised = np.empty((len(points), 3))
    raised[:, :2], raised[:, 2] = points, height
    return raised


_POSES = {Mount.FLOOR: _floor_poses, Mount.WALL: _wall_poses, Mount.TOP: _top_poses}
