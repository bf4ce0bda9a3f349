"""Heat maps: for every cell the best score of its possible poses, as bytes."""

from __future__ import annotations

import numpy as np

from scenegen_core.placement.answer import HeatMap
from scenegen_core.placement.proposals import SURFACES, Proposals
from scenegen_core.scene.geometry import Floats

SPAN = 0.9  # share of the possible cells that the scale resolves; the worst tenth are all "least"


def scale(scores: Floats) -> tuple[float, float]:
    """The scores at the bottom and the top of the legend."""
    if not len(scores):
        return 0.0, 0.0
    return float(np.quantile(scores, 1 - SPAN)), float(scores.max())


def likelihood(scores: Floats, bounds: tuple[float, float]) -> Floats:
    """Scores on the legend's scale: 0 least to 1 most likely."""
    low, high = bounds
    if high <= low:
        return np.ones_like(scores)
    return np.asarray(((scores - low) / (high - low)).clip(0, 1), dtype=np.float64)


def heat_maps(
    proposals: Proposals, scores: Floats, bounds: tuple[float, float]
) -> tuple[HeatMap, ...]:
    """One map a surface; ``scores`` (n,) of possible poses, −inf for the others."""
    maps = []
    for mount, grid in proposals.grids.items():
        best = np.full(grid.shape[0] * grid.shape[1], -np.inf)
        here = proposals.mounts == mount
        np.maximum.at(best, proposals.cells[here], scores[here])
        shown = np.isfinite(best)
        values = np.zeros(len(best), dtype=np.uint8)
        values[shown] = np.rint(1 + 254 * likelihood(best[shown], bounds)).astype(np.uint8)
        maps.append(
            HeatMap(SURFACES[mount], grid.origin, grid.cell, values.reshape(grid.shape), *bounds)
        )
    return tuple(maps)
