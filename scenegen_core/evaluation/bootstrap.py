"""Intervals: rooms drawn again with replacement, since objects of one room hang together."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from scenegen_core.scene.geometry import Floats

RESAMPLES = 1000
LEVEL = 0.95


def interval(
    values: Sequence[tuple[str, float]], *, rng: np.random.Generator
) -> tuple[float, float]:
    """The 95 % bootstrap interval of a mean, rooms drawn with replacement.

    Queries of one room hang together, so rooms are drawn, not queries.
    """
    sums, counts = _drawn([(room, (value,)) for room, value in values], rng)
    return _middle(sums[:, 0] / counts)


def relative(
    values: Sequence[tuple[str, tuple[float, float]]], *, rng: np.random.Generator
) -> tuple[float, float, float]:
    """mean(one) / mean(other) − 1 of (room, (one, other)) pairs, with its interval by rooms."""
    one, other = np.array([pair for _, pair in values]).mean(axis=0)
    totals, _ = _drawn(values, rng)
    safe = totals[totals[:, 1] > 0]
    return float(one / other - 1), *_middle(safe[:, 0] / safe[:, 1] - 1)


def _drawn(
    values: Sequence[tuple[str, tuple[float, ...]]], rng: np.random.Generator
) -> tuple[Floats, Floats]:
    """Rooms drawn with replacement: sums (draws, values), and how many values (draws,)."""
    rooms, index = np.unique([room for room, _ in values], return_inverse=True)
    numbers = np.array([number for _, number in values])
    sums = np.zeros((len(rooms), numbers.shape[1]))
    np.add.at(sums, index, numbers)
    drawn = rng.integers(len(rooms), size=(RESAMPLES, len(rooms)))
    counts = np.bincount(index).astype(float)
    return sums[drawn].sum(axis=1), counts[drawn].sum(axis=1)


def _middle(resampled: Floats) -> tuple[float, float]:
    low, high = np.quantile(resampled, ((1 - LEVEL) / 2, (1 + LEVEL) / 2))
    return float(low), float(high)
