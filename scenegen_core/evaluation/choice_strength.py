"""How much each curve and surface of a model of choices matters among its examples.

By the spread of what it adds over the examples. What is the same at every pose of a room decides
nothing there, so spread counts only among examples that could differ in it within a room: the size
of the object and whether there is anything to measure are given.
"""

from __future__ import annotations

import numpy as np

from scenegen_core.graph.own_relations import SIZE
from scenegen_core.graph.relations import Column
from scenegen_core.knowledge.choice import BINS, MISSING, Bins, Choice, Table
from scenegen_core.scene.geometry import Floats, Ints


def shares(examples: Bins) -> Floats:
    """The share of the examples in each bin of each column: (columns, BINS)."""
    counts = [np.bincount(column, minlength=BINS) for column in examples.T]
    return np.array(counts, dtype=np.float64) / max(len(examples), 1)


def joint_shares(choice: Choice) -> Floats:
    """The share of the examples in each bin of each surface: (surfaces, BINS, BINS)."""
    found = np.zeros((len(choice.pairs), BINS, BINS))
    for share, (one, two) in zip(found, choice.pairs, strict=True):
        np.add.at(share, (choice.examples[:, one], choice.examples[:, two]), 1.0)
    return np.asarray(found / max(len(choice.examples), 1), dtype=np.float64)


def curve_spreads(columns: tuple[Column, ...], curves: Table, often: Floats) -> Floats:
    """How much every curve matters, nats: (columns,). ``often`` (columns, BINS), see ``shares``."""
    return np.array(
        [
            _spread(curve, share, given(column))
            for column, curve, share in zip(columns, curves, often, strict=True)
        ]
    )


def surface_spreads(choice: Choice, often: Floats) -> Floats:
    """How much every surface matters, nats: (surfaces,). ``often`` see ``joint_shares``."""
    return np.array(
        [
            _spread(
                surface.ravel(),
                share.ravel(),
                (given(choice.columns[one])[:, None] * BINS + given(choice.columns[two])).ravel(),
            )
            for (one, two), surface, share in zip(choice.pairs, choice.surfaces, often, strict=True)
        ]
    )


def strongest(spreads: Floats, count: int) -> Ints:
    """The ``count`` that matter most, most first; none that does not matter."""
    ranked = np.argsort(-spreads, kind="stable")[:count]
    return np.asarray(ranked[spreads[ranked] > 0], dtype=np.int64)


def given(column: Column) -> Ints:
    """Which bins of a column one and the same room can have poses in, as a number: (BINS,)."""
    if column.relation == SIZE.short:
        return np.arange(BINS, dtype=np.int64)
    return np.asarray(np.arange(BINS) == MISSING, dtype=np.int64)


def _spread(values: Floats | Table, often: Floats, groups: Ints) -> float:
    """Standard deviation within the groups of bins that one room can have poses in."""
    total = np.bincount(groups, often)
    means = np.bincount(groups, often * values) / np.where(total > 0, total, 1)
    return float(np.sqrt((often * (values - means[groups]) ** 2).sum()))
