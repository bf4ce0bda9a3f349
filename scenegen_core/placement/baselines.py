"""Baselines: placements that know nothing, to measure against (levels I and II of the study)."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from scenegen_core.placement.proposals import Proposals
from scenegen_core.scene.geometry import Bools, Ints

Baseline = Callable[[Proposals, Bools, int, np.random.Generator], Ints]
"""(proposals, possible (n,), count, rng) -> indices of the poses drawn, at most count."""


def random(_: Proposals, possible: Bools, count: int, rng: np.random.Generator) -> Ints:
    """Anywhere in the room, whatever stands there (level I)."""
    return _draw(np.ones_like(possible), count, rng)


def random_open(_: Proposals, possible: Bools, count: int, rng: np.random.Generator) -> Ints:
    """Anywhere that is possible (level II)."""
    return _draw(possible, count, rng)


def along_walls(
    proposals: Proposals, possible: Bools, count: int, rng: np.random.Generator
) -> Ints:
    """Pushed against a wall, its back to it, anywhere that is possible; if nowhere, as level II."""
    flush = possible & proposals.flush
    return _draw(flush if flush.any() else possible, count, rng)


def _draw(which: Bools, count: int, rng: np.random.Generator) -> Ints:
    poses = np.flatnonzero(which)
    return rng.choice(poses, size=min(count, len(poses)), replace=False)


BASELINES: dict[str, Baseline] = {
    "random": random,
    "random_open": random_open,
    "along_walls": along_walls,
}
