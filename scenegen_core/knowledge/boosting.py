"""Learns the tables of a choice: boosting of small trees on the log-likelihood of what was chosen.

First trees of one split, which add up to curves; then, over the pairs of columns that promise most,
trees of two levels, which add up to surfaces. Newton steps with shrinkage, as in gradient boosting
machines; the gradient of a conditional choice is P(pose) − chosen.
"""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass

import numpy as np

from scenegen_core.knowledge.choice import BINS, Bins, Choice, Table
from scenegen_core.knowledge.splits import (
    Sums,
    best_pair_tree,
    best_split,
    goes_left,
    histograms,
    pair_histograms,
)
from scenegen_core.scene.geometry import Floats, Ints

RATE = 0.05  # share of a Newton step taken
DAMPING = 8.0  # added to each curvature: steps on little evidence are small
LEAST = 0.5  # curvature on either side of a split: fewer choices say nothing
SHARE = 0.3  # of the columns that a tree may look at: spreads what correlated columns say
CURVE_TREES = 300
TRIAL_TREES = 80  # that look for pairs
SURFACE_TREES = 400
SURFACES = 80


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
        sums = histograms(self._bins, columns, gradient, curvature, self._everyone)
        best, cut, missing_left, gain = best_split(sums, DAMPING, LEAST)
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
        sums = pair_histograms(self._bins, pairs[some], gradient, curvature)
        best, steps, gain = best_pair_tree(sums, DAMPING, LEAST)
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
        sums = histograms(self._bins, columns, gradient, curvature, self._everyone)
        best, cut, missing_left, gain = best_split(sums, DAMPING, LEAST)
        if gain <= 0:
            return
        root = int(columns[best])
        left = goes_left(self._bins[root], cut, missing_left)
        for side in (left, ~left):
            rows = np.flatnonzero(side)
            below = histograms(self._bins, columns, gradient, curvature, rows)
            child, child_cut, child_left, child_gain = best_split(below, DAMPING, LEAST)
            if child_gain <= 0:
                continue
            other = int(columns[child])
            if other != root:
                gains[min(root, other), max(root, other)] += child_gain
            steps = _leaf_steps(below[child], child_cut, child_left)
            self._scores[rows] += steps[self._bins[other][rows]]


def _leaf_steps(sums: Sums, cut: int, missing_left: bool) -> Floats:  # noqa: FBT001
    """What each bin's score moves by: (BINS,)."""
    left = goes_left(np.arange(BINS), cut, missing_left)
    steps = np.empty(BINS)
    for side in (left, ~left):
        gradient, curvature = sums[side].sum(axis=0)
        steps[side] = -RATE * gradient / (curvature + DAMPING)
    return steps
