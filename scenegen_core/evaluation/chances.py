"""What probabilities say of one case.

A place is the floor within NEAR of an offered pose. It is called with the probability of all
possible poses there, and holds if the true center is there. Which poses are offered follows from
the room alone, not from the truth, so probabilities that are right hold as often as they call.
"""

from __future__ import annotations

import numpy as np
from scipy.special import logsumexp

from scenegen_core.evaluation.measure import Answer
from scenegen_core.evaluation.records import Chances
from scenegen_core.placement.alternatives import probabilities
from scenegen_core.scene.geometry import Floats

NEAR = 0.5  # metres


def chances(found: Answer, *, expects: bool) -> Chances:
    """What the scores of an answer, taken as logarithms of probabilities, say of the truth.

    The true cell is that of the possible pose nearest to the truth, in space. Of a system that
    ``expects``, the probabilities are those that it offers by.
    """
    centers, cells = found.table.candidates.centers, found.table.cells
    possible = found.table.scored
    truth = np.array([found.bench.case.box.center], dtype=float)
    logs = found.scores - logsumexp(found.scores)
    if expects:
        _, place = np.unique(cells, return_inverse=True)
        logs = np.log(probabilities(found.scores, place), where=np.isfinite(logs), out=logs)
    offered = centers[found.picks.spread, :2]
    within = _distances(centers[:, :2], offered) <= NEAR
    nearest = possible[_distances(centers[possible], truth).argmin()]
    return Chances(
        called=tuple(float(share) for share in np.exp(logs) @ within),
        holds=tuple(bool(away <= NEAR) for away in _distances(offered, truth[:, :2])[:, 0]),
        log_score=float(logsumexp(logs[cells == cells[nearest]])),
        log_uniform=-float(np.log(len(np.unique(cells[possible])))),
    )


def _distances(points: Floats, others: Floats) -> Floats:
    """Between every pair, metres: (points, others)."""
    found: Floats = np.linalg.norm(points[:, None] - others, axis=2)
    return found
