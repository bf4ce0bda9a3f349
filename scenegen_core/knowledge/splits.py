"""Splits of bins that lower a loss most, found in compiled loops: what boosting grows trees from.

Sums are of gradients and curvatures by bin, (…, BINS, 2); the last bin is what is not there, and
goes to whichever side gains more. A split is (cut, missing_left, gain): bins up to the cut go left.
"""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

from scenegen_core.knowledge.choice import BINS, Bins
from scenegen_core.scene.geometry import Floats, Ints

Sums = NDArray[np.float64]


def goes_left(bins: NDArray[np.integer], cut: int, missing_left: bool) -> NDArray[np.bool_]:  # noqa: FBT001
    """Which bins go left: of the same shape."""
    return np.where(bins == BINS - 1, missing_left, bins <= cut)


@njit(cache=True, nogil=True)
def histograms(bins: Bins, columns: Ints, gradient: Floats, curvature: Floats, rows: Ints) -> Sums:
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
def best_split(sums: Sums, damping: float, least: float) -> tuple[int, int, bool, float]:
    """The best cut over columns: which, after which bin, where missing goes, what it gains."""
    best, best_cut, best_left, best_gain = -1, -1, False, 0.0
    for i in range(len(sums)):
        cut, left, gain = _split(sums[i], damping, least)
        if gain > best_gain:
            best, best_cut, best_left, best_gain = i, cut, left, gain
    return best, best_cut, best_left, best_gain


@njit(cache=True, nogil=True)
def pair_histograms(bins: Bins, pairs: Ints, gradient: Floats, curvature: Floats) -> Sums:
    """Sums of gradient and curvature by pair of bins: (pairs, BINS, BINS, 2)."""
    sums = np.zeros((len(pairs), BINS, BINS, 2))
    for k in range(len(pairs)):
        one, two, total = bins[pairs[k, 0]], bins[pairs[k, 1]], sums[k]
        for row in range(len(gradient)):
            total[one[row], two[row], 0] += gradient[row]
            total[one[row], two[row], 1] += curvature[row]
    return sums


@njit(cache=True, nogil=True)
def best_pair_tree(sums: Sums, damping: float, least: float) -> tuple[int, Floats, float]:
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
