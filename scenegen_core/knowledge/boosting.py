"""Learns the tables of a choice: boosting of small trees on the log-likelihood of what was chosen.

First trees of one split, which add up to curves; then, over the pairs of columns that promise most,
trees of two levels, which add up to surfaces. Newton steps with shrinkage, as in gradient boosting
machines; the gradient of a conditional choice is P(pose) − chosen.
"""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass

import numpy as np
from numba import njit
from numpy.typing import NDArray

from scenegen_core.knowledge.choice import BINS, Bins, Choice, Table
from scenegen_core.scene.geometry import Floats, Ints

RATE = 0.05  # share of a Newton step taken
DAMPING = 15.0  # added to each curvature: steps on little evidence are small
LEAST = 0.5  # curvature on either side of a split: fewer choices say nothing
SHARE = 0.3  # of the columns that a tree may look at: spreads what correlated columns say
CURVE_TREES = 300
TRIAL_TREES = 80  # that look for pairs
SURFACE_TREES = 400
SURFACES = 80

Sums = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class ChoiceSets:
    """Choices that people made: the first pose of each set is the one chosen."""

    bins: Bins
    """(poses, columns)."""
    starts: Ints
    """Where each set begins: (sets,)."""
    log_weights: Floats
    """log of how many possible poses each stands for: (poses,)."""
    weights: Floats
    """How much each set counts: (sets,)."""


@dataclass(frozen=True, eq=False)
class Tables:
    """Curves and surfaces that add up to a score."""

    curves: Table
    pairs: Ints
    surfaces: Table


def fit(
    sets: ChoiceSets,
    *,
    rng: np.random.Generator,
    base: Choice | None = None,
    surfaces: int = SURFACES,
) -> Tables:
    """The tables under which the choices are likeliest; with a ``base``, what to add to it."""
    scores = sets.log_weights if base is None else sets.log_weights + base.score_bins(sets.bins)
    boosting = _Boosting(sets, scores, rng)
    curves = np.zeros((sets.bins.shape[1], BINS))
    for _ in range(CURVE_TREES):
        boosting.stump(curves)
    pairs = boosting.promising_pairs(surfaces)
    tables = np.zeros((len(pairs), BINS, BINS))
    for _ in range(SURFACE_TREES if len(pairs) else 0):
        boosting.pair_tree(pairs, tables)
    return Tables(curves.astype(np.float32), pairs, tables.astype(np.float32))


class _Boosting:
    """The state of learning: scores of all poses, and the gradient there."""

    def __init__(self, sets: ChoiceSets, scores: Floats, rng: np.random.Generator) -> None:
        self._bins = np.ascontiguousarray(sets.bins.T)
        self._sets = sets
        self._rng = rng
        lengths = np.diff(np.append(sets.starts, len(sets.bins)))
        self._weights = np.repeat(sets.weights, lengths)
        self._scores = scores.copy()
        self._set_of = np.repeat(np.arange(len(sets.starts)), lengths)
        self._chosen = np.zeros(len(sets.bins))
        self._chosen[sets.starts] = 1.0
        varied = (self._bins != self._bins[:, :1]).any(axis=1)
        self._usable = np.flatnonzero(varied)

    def stump(self, curves: Floats) -> None:
        """Add the best tree of one split to the curves."""
        gradient, curvature = self._derivatives()
        columns = self._some_columns()
        sums = _histograms(self._bins, columns, gradient, curvature, self._everyone)
        best, cut, missing_left, gain = _best_split(sums, DAMPING, LEAST)
        if gain <= 0:
            return
        column = columns[best]
        steps = _leaf_steps(sums[best], cut, missing_left)
        curves[column] += steps
        self._scores += steps[self._bins[column]]

    def promising_pairs(self, count: int) -> Ints:
        """The pairs of columns whose trees of two levels gained most: (pairs, 2)."""
        scores = self._scores.copy()
        gains: defaultdict[tuple[int, int], float] = defaultdict(float)
        for _ in range(TRIAL_TREES if count else 0):
            self._trial_tree(gains)
        self._scores = scores
        chosen = sorted(gains, key=lambda pair: -gains[pair])[:count]
        return np.array(sorted(chosen), dtype=np.int64).reshape(-1, 2)

    def pair_tree(self, pairs: Ints, tables: Floats) -> None:
        """Add the best tree of two levels over one of the pairs to its surface."""
        gradient, curvature = self._derivatives()
        some = self._rng.permutation(len(pairs))[: max(1, len(pairs) // 2)]
        sums = _pair_histograms(self._bins, pairs[some], gradient, curvature)
        best, steps, gain = _best_pair_tree(sums, DAMPING, LEAST)
        if gain <= 0:
            return
        steps *= RATE
        pair = some[best]
        tables[pair] += steps
        one, two = pairs[pair]
        self._scores += steps[self._bins[one], self._bins[two]]

    @property
    def _everyone(self) -> Ints:
        return np.arange(self._bins.shape[1])

    def _derivatives(self) -> tuple[Floats, Floats]:
        """Gradient and curvature of the negative log-likelihood: (poses,) each."""
        starts, set_of = self._sets.starts, self._set_of
        highest = np.maximum.reduceat(self._scores, starts)
        mass = np.exp(self._scores - highest[set_of])
        share = mass / np.add.reduceat(mass, starts)[set_of]
        return (share - self._chosen) * self._weights, share * (1 - share) * self._weights

    def _some_columns(self) -> Ints:
        count = min(len(self._usable), max(1, round(SHARE * len(self._usable))))
        return np.sort(self._rng.choice(self._usable, count, replace=False))

    def _trial_tree(self, gains: defaultdict[tuple[int, int], float]) -> None:
        """Grow a free tree of two levels, note what its second level gains, and keep it."""
        gradient, curvature = self._derivatives()
        columns = self._some_columns()
        sums = _histograms(self._bins, columns, gradient, curvature, self._everyone)
        best, cut, missing_left, gain = _best_split(sums, DAMPING, LEAST)
        if gain <= 0:
            return
        root = int(columns[best])
        left = _goes_left(self._bins[root], cut, missing_left)
        for side in (left, ~left):
            rows = np.flatnonzero(side)
            below = _histograms(self._bins, columns, gradient, curvature, rows)
            child, child_cut, child_left, child_gain = _best_split(below, DAMPING, LEAST)
            if child_gain <= 0:
                continue
            other = int(columns[child])
            if other != root:
                gains[min(root, other), max(root, other)] += child_gain
            steps = _leaf_steps(below[child], child_cut, child_left)
            self._scores[rows] += steps[self._bins[other][rows]]


def _leaf_steps(sums: Sums, cut: int, missing_left: bool) -> Floats:  # noqa: FBT001
    """What each bin's score moves by: (BINS,)."""
    left = _goes_left(np.arange(BINS), cut, missing_left)
    steps = np.empty(BINS)
    for side in (left, ~left):
        gradient, curvature = sums[side].sum(axis=0)
        steps[side] = -RATE * gradient / (curvature + DAMPING)
    return steps


def _goes_left(bins: NDArray[np.integer], cut: int, missing_left: bool) -> NDArray[np.bool_]:  # noqa: FBT001
    return np.where(bins == BINS - 1, missing_left, bins <= cut)


@njit(cache=True, nogil=True)
def _histograms(bins: Bins, columns: Ints, gradient: Floats, curvature: Floats, rows: Ints) -> Sums:
    """Sums of gradient and curvature by bin: (columns, BINS, 2)."""
    sums = np.zeros((len(columns), BINS, 2))
    for i in range(len(columns)):
        column, total = bins[columns[i]], sums[i]
        for row in rows:
            at = column[row]
            total[at, 0] += gradient[row]
            total[at, 1] += curvature[row]
    return sums


@njit(cache=True, nogil=True)
def _worth(gradient: float, curvature: float, damping: float) -> float:
    return gradient * gradient / (curvature + damping)


@njit(cache=True, nogil=True)
def _split(sums: Sums, damping: float, least: float) -> tuple[int, bool, float]:
    """The best cut of one column: after which bin, where what is missing goes, what it gains."""
    all_g, all_h = sums[:, 0].sum(), sums[:, 1].sum()
    best_cut, best_left, best_gain = -1, False, 0.0
    base = _worth(all_g, all_h, damping)
    for side in range(2):
        g, h = (sums[BINS - 1, 0], sums[BINS - 1, 1]) if side == 1 else (0.0, 0.0)
        for cut in range(BINS - 1):
            g += sums[cut, 0]
            h += sums[cut, 1]
            if h < least or all_h - h < least:
                continue
            gain = _worth(g, h, damping) + _worth(all_g - g, all_h - h, damping) - base
            if gain > best_gain + 1e-12:
                best_cut, best_left, best_gain = cut, side == 1, gain
    return best_cut, best_left, best_gain


@njit(cache=True, nogil=True)
def _best_split(sums: Sums, damping: float, least: float) -> tuple[int, int, bool, float]:
    """The best cut over columns: which, after which bin, where missing goes, what it gains."""
    best, best_cut, best_left, best_gain = -1, -1, False, 0.0
    for i in range(len(sums)):
        cut, left, gain = _split(sums[i], damping, least)
        if gain > best_gain:
            best, best_cut, best_left, best_gain = i, cut, left, gain
    return best, best_cut, best_left, best_gain


@njit(cache=True, nogil=True)
def _pair_histograms(bins: Bins, pairs: Ints, gradient: Floats, curvature: Floats) -> Sums:
    """Sums of gradient and curvature by pair of bins: (pairs, BINS, BINS, 2)."""
    sums = np.zeros((len(pairs), BINS, BINS, 2))
    for k in range(len(pairs)):
        one, two, total = bins[pairs[k, 0]], bins[pairs[k, 1]], sums[k]
        for row in range(len(gradient)):
            total[one[row], two[row], 0] += gradient[row]
            total[one[row], two[row], 1] += curvature[row]
    return sums


@njit(cache=True, nogil=True)
def _best_pair_tree(sums: Sums, damping: float, least: float) -> tuple[int, Floats, float]:
    """The best tree of two levels over one pair: which, its Newton steps by bins, its gain."""
    best, best_swap, best_cut, best_left, best_gain = -1, False, -1, False, 0.0
    for k in range(len(sums)):
        for swap in (False, True):
            table = sums[k].transpose(1, 0, 2) if swap else sums[k]
            cut, left, gain = _first_split(table, damping, least)
            if gain > best_gain + 1e-12:
                best, best_swap, best_cut, best_left, best_gain = k, swap, cut, left, gain
    steps = np.zeros((BINS, BINS))
    if best >= 0:
        table = sums[best].transpose(1, 0, 2) if best_swap else sums[best]
        is_left = _left_bins(best_cut, best_left)
        for side in (True, False):
            _second_steps(table, is_left == side, damping, least, steps)
        if best_swap:
            steps = steps.T.copy()
    return best, steps, best_gain


@njit(cache=True, nogil=True)
def _first_split(table: Sums, damping: float, least: float) -> tuple[int, bool, float]:
    """The best first cut of a pair's first column, where the second is cut on either side."""
    whole = table.sum(axis=0)
    base = _worth(whole[:, 0].sum(), whole[:, 1].sum(), damping)
    best_cut, best_left, best_gain = -1, False, 0.0
    for side in (False, True):
        left = table[BINS - 1].copy() if side else np.zeros((BINS, 2))
        for cut in range(BINS - 1):
            left += table[cut]
            gain = _side_worth(left, damping, least) + _side_worth(whole - left, damping, least)
            gain -= base
            if gain > best_gain + 1e-12:
                best_cut, best_left, best_gain = cut, side, gain
    return best_cut, best_left, best_gain


@njit(cache=True, nogil=True)
def _second_steps(
    table: Sums, rows: NDArray[np.bool_], damping: float, least: float, steps: Floats
) -> None:
    """Cut the second column below some bins of the first, and write the Newton steps there."""
    below = np.zeros((BINS, 2))
    for row in np.flatnonzero(rows):
        below += table[row]
    cut, missing_left, _ = _split(below, damping, least)
    is_left = _left_bins(cut, missing_left)
    for side in (True, False):
        g, h = 0.0, 0.0
        for column in range(BINS):
            if is_left[column] == side:
                g += below[column, 0]
                h += below[column, 1]
        for row in np.flatnonzero(rows):
            for column in range(BINS):
                if is_left[column] == side:
                    steps[row, column] = -g / (h + damping)


@njit(cache=True, nogil=True)
def _left_bins(cut: int, missing_left: bool) -> NDArray[np.bool_]:  # noqa: FBT001
    """Which bins lie left of a cut; none where nothing is cut (−1): (BINS,)."""
    left = np.arange(BINS) <= cut
    left[BINS - 1] = missing_left and cut >= 0
    return left


@njit(cache=True, nogil=True)
def _side_worth(sums: Sums, damping: float, least: float) -> float:
    """What one side of a first split is worth, split once more if that gains."""
    g, h = sums[:, 0].sum(), sums[:, 1].sum()
    _, _, gain = _split(sums, damping, least)
    return _worth(g, h, damping) + gain
