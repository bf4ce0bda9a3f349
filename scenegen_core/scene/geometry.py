"""Plane geometry on whole arrays; a single shape is n = 1.

Points are (n, 2) metres, segments (m, 2, 2), directions (n, 2) unit vectors. A rectangle is its
center, its half sizes (along and across its heading) and its heading.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from scenegen_core.scene.compiled import all_gaps, all_separations, inside
from scenegen_core.scene.model import Box

Floats = NDArray[np.float64]
Bools = NDArray[np.bool_]
Ints = NDArray[np.int64]

TIE = 1e-9  # metres; distances that differ by rounding only are the same


@dataclass(frozen=True)
class Rectangles:
    """n upright footprints: centers (n, 2), halves (n, 2), headings (n,)."""

    centers: Floats
    halves: Floats
    headings: Floats

    def __len__(self) -> int:
        return len(self.centers)

    def __getitem__(self, index: slice | Ints | Bools) -> Rectangles:
        some = Rectangles(self.centers[index], self.halves[index], self.headings[index])
        if "columns" in self.__dict__:  # known already: sines need not be taken again
            some.__dict__["columns"] = _columns(self.columns, index)
        return some

    @property
    def axes(self) -> Floats:
        """The unit vectors a_k and b_k of each: (n, 2 axes, 2)."""
        along = directions(self.headings)
        return np.stack([along, left_of(along)], axis=1)

    @cached_property
    def columns(self) -> Floats:
        """x, y, cos, sin, half depth, half width, as compiled loops take them: (6, n)."""
        return np.stack(
            [*self.centers.T, np.cos(self.headings), np.sin(self.headings), *self.halves.T]
        )

    @cached_property
    def rows(self) -> Floats:
        """The same, one rectangle after the other: (n, 6)."""
        return np.ascontiguousarray(self.columns.T)

    @property
    def corners(self) -> Floats:
        """Corners anticlockwise: (n, 4, 2)."""
        signs = np.array([[1, 1], [-1, 1], [-1, -1], [1, -1]], dtype=float)
        offsets = (signs * self.halves[:, None, :]) @ self.axes
        return self.centers[:, None, :] + offsets


def _columns(table: Floats, index: slice | Ints | Bools) -> Floats:
    """Some columns of a table, its rows in one piece: ``take`` sees to that, an index does not."""
    if isinstance(index, slice):
        return np.ascontiguousarray(table[:, index])
    return table.take(np.flatnonzero(index) if index.dtype == np.bool_ else index, axis=1)


def directions(headings: Floats) -> Floats:
    """Unit vectors of headings (radians): (n, 2)."""
    return np.stack([np.cos(headings), np.sin(headings)], axis=-1)


def left_of(vectors: Floats) -> Floats:
    """Vectors turned a quarter anticlockwise: b_k of a_k."""
    return np.stack([-vectors[..., 1], vectors[..., 0]], axis=-1)


def wrapped(angles: Floats) -> Floats:
    """Angles in [-π, π)."""
    return (angles + np.pi) % (2 * np.pi) - np.pi


def footprints(boxes: Sequence[Box]) -> Rectangles:
    """The footprints of n boxes."""
    return Rectangles(
        np.array([box.center[:2] for box in boxes], dtype=float).reshape(-1, 2),
        np.array([box.size[:2] for box in boxes], dtype=float).reshape(-1, 2) / 2,
        np.array([box.heading for box in boxes], dtype=float),
    )


def walls_as_rectangles(segments: Floats) -> Rectangles:
    """Segments as rectangles without width, so that gaps to walls are gaps to rectangles."""
    run = segments[:, 1] - segments[:, 0]
    lengths = np.hypot(run[:, 0], run[:, 1])
    halves = np.stack([lengths / 2, np.zeros_like(lengths)], axis=1)
    return Rectangles(segments.mean(axis=1), halves, np.arctan2(run[:, 1], run[:, 0]))


def gaps(shapes: Rectangles, others: Rectangles) -> Floats:
    """Signed gap between every pair, metres: (shapes, others).

    Positive: the shortest distance. Negative: how far one must move to part them.
    """
    out = np.empty((len(others), len(shapes)))
    all_gaps(shapes.columns, others.rows, out)
    return out.T


def separations(shapes: Rectangles, others: Rectangles) -> Floats:
    """Like gaps where footprints overlap; elsewhere positive and no more than the gap, metres."""
    out = np.empty((len(others), len(shapes)))
    all_separations(shapes.columns, others.rows, out)
    return out.T


def within(points: Floats, walls: Floats) -> Bools:
    """Is each point inside the outline of the walls (l, 2, 2)?: (n, 2) -> (n,)."""
    out = np.empty(len(points), dtype=np.bool_)
    inside(np.ascontiguousarray(points), walls, out)
    return out


def _in_frame(offset: Floats, heading: Floats) -> tuple[Floats, Floats]:
    """Coordinates of offsets along and across headings."""
    cos, sin = np.cos(heading), np.sin(heading)
    x, y = offset[..., 0], offset[..., 1]
    return x * cos + y * sin, y * cos - x * sin


def _outside(x: Floats, y: Floats, half_x: Floats, half_y: Floats) -> Floats:
    """Squared distance of points to a rectangle at the origin."""
    beyond_x, beyond_y = np.maximum(np.abs(x) - half_x, 0), np.maximum(np.abs(y) - half_y, 0)
    squared: Floats = beyond_x * beyond_x + beyond_y * beyond_y
    return squared


def distances_to_segments(points: Floats, segments: Floats) -> Floats:
    """Shortest distance of every point to every segment, metres: (points, segments)."""
    start, run = segments[:, 0], segments[:, 1] - segments[:, 0]
    offset = points[:, None, :] - start[None]
    length2 = np.maximum((run**2).sum(axis=1), 1e-18)
    along = np.clip((offset * run).sum(axis=2) / length2, 0, 1)
    distances: Floats = np.linalg.norm(offset - along[..., None] * run, axis=2)
    return distances


def distances_to_rectangles(points: Floats, others: Rectangles) -> Floats:
    """Shortest distance of every point to every rectangle, metres, 0 inside: (points, others)."""
    offset = points[:, None, :] - others.centers[None, :, :]
    x, y = _in_frame(offset, others.headings[None, :])
    return np.sqrt(_outside(x, y, others.halves[:, 0], others.halves[:, 1]))


def ray_lengths(points: Floats, toward: Floats, segments: Floats) -> Floats:
    """How far each ray runs until it meets each segment, metres, inf if never: (rays, segments)."""
    start, run = segments[:, 0], segments[:, 1] - segments[:, 0]
    offset = start[None] - points[:, None, :]
    facing = toward[:, None, :]
    cross = facing[..., 0] * run[:, 1] - facing[..., 1] * run[:, 0]
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        far = (offset[..., 0] * run[:, 1] - offset[..., 1] * run[:, 0]) / cross
        where = (offset[..., 0] * facing[..., 1] - offset[..., 1] * facing[..., 0]) / cross
        meets = (far >= 0) & (where >= 0) & (where <= 1)
    return np.where(meets, far, np.inf)


def rays_hit(points: Floats, toward: Floats, others: Rectangles) -> Bools:
    """Does each ray meet each rectangle (the paper's h)?: (rays, rectangles)."""
    offset = points[:, None, :] - others.centers[None]
    x, y = _in_frame(offset, others.headings[None, :])
    dx, dy = _in_frame(toward[:, None, :], others.headings[None, :])
    enter = np.zeros(x.shape)
    leave = np.full(x.shape, np.inf)
    for position, slope, half in ((x, dx, others.halves[:, 0]), (y, dy, others.halves[:, 1])):
        level = np.abs(slope) < 1e-12  # noqa: PLR2004 (parallel to the slab)
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            one, two = (-half - position) / slope, (half - position) / slope
        inside = np.abs(position) <= half
        near = np.where(level, np.where(inside, -np.inf, np.inf), np.minimum(one, two))
        far = np.where(level, np.where(inside, np.inf, -np.inf), np.maximum(one, two))
        enter, leave = np.maximum(enter, near), np.minimum(leave, far)
    return enter <= leave
