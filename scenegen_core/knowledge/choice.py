"""The model of choices: how much likelier people choose a pose than another one of the same room.

A conditional (McFadden) choice among the possible poses of a room, log P = score − log Σ exp score,
whose score is a sum of named curves of one column each and of a few surfaces of two. Columns are
cut into bins by fixed edges, so that a model is plain tables: ``curves[column, bin]`` and
``surfaces[pair, bin, bin]``. The last bin of a column is for what is not there (NaN).
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from zlib import crc32

import numpy as np
from numba import njit
from numpy.typing import NDArray

from scenegen_core.graph import scan
from scenegen_core.graph.own_relations import OWN_RELATIONS
from scenegen_core.graph.relations import Column, columns
from scenegen_core.scene.geometry import Floats, Ints
from scenegen_core.scene.model import Category

Bins = NDArray[np.uint8]
Table = NDArray[np.float32]
Cutting = tuple[Floats, Floats, Bins]
"""Edges, and the cells to start looking from."""

BINS = 36  # of a column, the last for what is not there
MISSING = BINS - 1
CELLS = 512  # of a column; finer than any two edges lie apart, so that a bin is found at once
HAIR = 1e-6  # of any unit; poses on grids lie on round numbers, where rounding must not decide

LENGTHS = (
    -3, -2, -1.5, -1, -0.6, -0.3, -0.2, -0.1, -0.05, 0.0, 0.03, 0.06, 0.1, 0.15, 0.2, 0.25, 0.3,
    0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1, 1.2, 1.4, 1.6, 1.8, 2, 2.4, 2.8, 3.2, 3.6,
)  # fmt: skip
"""Metres: fine where furniture touches."""
ANGLES = tuple(np.deg2rad(np.arange(4, 180, 7.5)).tolist())
"""Radians: the headings tried are 22.5° apart, so three bins a heading."""
COUNTS = (0.5, 1.5, 2.5, 3.5, 4.5, 6.5, 8.5)
FLAG = (0.5,)
SHARES = (
    0.01, 0.03, 0.06, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 0.5, 0.55, 0.6, 0.65, 0.7, 0.75,
    0.8, 0.85, 0.9, 0.95, 1.0,
)  # fmt: skip
HEIGHTS = (
    0.05, 0.2, 0.35, 0.5, 0.65, 0.75, 0.85, 0.95, 1.05, 1.15, 1.25, 1.35, 1.45, 1.55, 1.65, 1.75,
    1.85, 1.95, 2.1, 2.3,
)  # fmt: skip
SIZES = (
    0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1, 1.2, 1.4, 1.6, 1.8, 2, 2.3, 2.7,
)  # fmt: skip
AREAS = (4, 6, 8, 10, 12, 14, 16, 18, 20, 24, 28, 32, 40, 50, 70)

_BY_PART = {
    "turn": ANGLES, "bearing": ANGLES, "near": COUNTS, "flush": COUNTS, "touching": COUNTS,
    "within a metre": COUNTS, "on": FLAG, "faced": FLAG, "centered": SHARES, "top": HEIGHTS,
    "long": SIZES, "depth": SIZES, "width": SIZES, "height": SIZES, "room": AREAS,
}  # fmt: skip
_BY_RELATION = {"H": HEIGHTS}

MEASURED_WITH = {
    "far": scan.FAR,
    "deep": scan.DEEP,
    "touching": scan.TOUCHING,
    "flush": scan.FLUSH,
    "in view": scan.IN_VIEW,
    "edges": float(crc32(repr((_BY_PART, _BY_RELATION, LENGTHS, SHARES)).encode())),
}
"""The constants that tables depend on; of the edges a checksum."""


def edges_of(column: Column) -> tuple[float, ...]:
    """Where the bins of a column meet."""
    if (column.relation, column.part) == ("M", "distance"):
        return SHARES
    return _BY_RELATION.get(column.relation) or _BY_PART.get(column.part, LENGTHS)


@lru_cache(maxsize=8)
def choice_columns(groups: tuple[Category, ...]) -> tuple[Column, ...]:
    """The columns of the model, in their order."""
    return columns(OWN_RELATIONS, groups)


@lru_cache(maxsize=8)
def _edges(named: tuple[Column, ...]) -> Floats:
    """The edges of every column, filled up with NaN, past which nothing is: (columns, BINS − 1)."""
    table = np.full((len(named), BINS - 1), np.nan)
    for row, column in zip(table, named, strict=True):
        edges = edges_of(column)
        row[: len(edges)] = np.array(edges) - HAIR
    return table


@lru_cache(maxsize=8)
def _cells(named: tuple[Column, ...]) -> tuple[Floats, Bins]:
    """Even cells over the edges of every column, to start looking from: (columns, 2 + CELLS).

    Where the cells start and how many there are a unit: (columns, 2); a bin that no value of a
    cell lies below: (columns, CELLS). At most one edge lies in a cell and its leeway.
    """
    edges = _edges(named)
    low, high = edges[:, 0], np.where(np.isfinite(edges), edges, -np.inf).max(axis=1)
    steps = np.maximum(high - low, 1.0) / (CELLS - 2)
    starts = low - steps
    bounds = starts[:, None] + (np.arange(CELLS) - 0.5) * steps[:, None]  # half a cell of leeway
    below = (edges[:, None, :] <= bounds[:, :, None]).sum(axis=2)
    return np.stack([starts, 1 / steps], axis=1), below.astype(np.uint8)


def binned(features: Floats, named: tuple[Column, ...]) -> Bins:
    """The bin of every value: (poses, columns)."""
    return np.ascontiguousarray(_bins(features, _cutting(named)).T)


def _cutting(named: tuple[Column, ...]) -> Cutting:
    return _edges(named), *_cells(named)


def _bins(features: Floats, cutting: Cutting) -> Bins:
    """The same, column by column: (columns, poses)."""
    out = np.empty(features.shape[::-1], dtype=np.uint8)
    _cut(np.ascontiguousarray(features.T), *cutting, out)
    return out


@njit(cache=True, nogil=True)
def _cut(features: Floats, edges: Floats, scales: Floats, cells: Bins, out: Bins) -> None:
    """The bin of every value; without branches, which a processor would often guess wrong."""
    width, poses = features.shape
    for c in range(width):
        start, scale = scales[c]
        for n in range(poses):
            there = not np.isnan(features[c, n])
            value = features[c, n] if there else start
            cell = int(min(max((value - start) * scale, 0.0), CELLS - 1.0))
            found = int(cells[c, cell])
            found += 1 if value >= edges[c, found] else 0
            out[c, n] = found if there else MISSING


@njit(cache=True, nogil=True)
def _sum(bins: Bins, curves: Table, pairs: Ints, surfaces: Table, out: Floats) -> None:
    width, poses = bins.shape
    out[:] = 0.0
    for c in range(width):
        for n in range(poses):
            out[n] += curves[c, bins[c, n]]
    for k in range(len(pairs)):
        one, two = pairs[k]
        for n in range(poses):
            out[n] += surfaces[k, bins[one, n], bins[two, n]]


@dataclass(frozen=True, eq=False)
class Choice:
    """What is chosen of one category, as tables, with the examples that taught it."""

    columns: tuple[Column, ...]
    curves: Table
    """What each bin of each column adds, nats: (columns, BINS)."""
    pairs: Ints
    """Which two columns each surface is of: (surfaces, 2)."""
    surfaces: Table
    """What each pair of bins adds, nats: (surfaces, BINS, BINS)."""
    examples: Bins
    """The chosen poses that taught it: (examples, columns)."""
    rooms: tuple[str, ...]
    """The room of each example."""

    @property
    def without_surfaces(self) -> Choice:
        """The curves alone."""
        none = slice(0, 0)
        return replace(self, pairs=self.pairs[none], surfaces=self.surfaces[none])

    @cached_property
    def _cutting(self) -> Cutting:
        return _cutting(self.columns)

    def score(self, features: Floats) -> Floats:
        """The log of how much likelier each pose is chosen, up to a constant of the room: (n,)."""
        return self._sum(_bins(features, self._cutting))

    def score_bins(self, bins: Bins) -> Floats:
        """The same of columns that are cut already."""
        return self._sum(np.ascontiguousarray(bins.T))

    def _sum(self, bins: Bins) -> Floats:
        out = np.empty(bins.shape[1])
        _sum(bins, self.curves, self.pairs, self.surfaces, out)
        return out

    def terms(self, features: Floats) -> Floats:
        """What every curve, then every surface adds; the sum is the score: (n, curves + pairs)."""
        return self.terms_of_bins(np.ascontiguousarray(_bins(features, self._cutting).T))

    def terms_of_bins(self, bins: Bins) -> Floats:
        """The same of columns that are cut already."""
        curves = self.curves[np.arange(len(self.columns)), bins]
        one, two = bins[:, self.pairs[:, 0]], bins[:, self.pairs[:, 1]]
        surfaces = self.surfaces[np.arange(len(self.pairs)), one, two]
        return np.concatenate([curves, surfaces], axis=1).astype(np.float64)


def without_examples(named: tuple[Column, ...], curves: Table) -> Choice:
    """Curves alone, as what all categories share."""
    return Choice(
        columns=named,
        curves=curves,
        pairs=np.empty((0, 2), dtype=np.int64),
        surfaces=np.empty((0, BINS, BINS), dtype=np.float32),
        examples=np.empty((0, len(named)), dtype=np.uint8),
        rooms=(),
    )
