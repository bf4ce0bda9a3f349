"""Calibration: are probabilities right? Of places called 20 %, a fifth should hold the truth."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from scenegen_core.evaluation.bootstrap import interval
from scenegen_core.evaluation.records import Record

BINS = 10  # of equal width: 0 to 10 %, …

Said = tuple[str, float, bool]
"""A place: its room, the probability that it was called with, and does it hold the truth?"""


def calibration(
    records: Sequence[Record], name: str, *, rng: np.random.Generator
) -> dict[str, Any]:
    """How right the probabilities of a system are, over cases where it gave any.

    ``n`` places, what they are ``called`` and the share that ``holds``; ``brier``, the mean of
    (called − holds)², and ``brier_flat`` if all were called by that share; ``ece``, the expected
    calibration error: the mean over places of |called − holds| of their bin; ``log_score`` of the
    true cell and ``log_uniform`` where all possible cells are equally likely, nats; the ``bins``.
    """
    said: list[Said] = [
        (record.room, called, holds)
        for record in records
        for called, holds in zip(
            record.chances[name].called, record.chances[name].holds, strict=True
        )
    ]
    bins = [part for index in range(BINS) if (part := _bin(said, index, rng))]
    squares = [(room, (called - holds) ** 2) for room, called, holds in said]
    scores = [(record.room, record.chances[name].log_score) for record in records]
    share = float(np.mean([holds for _, _, holds in said]))
    return {
        "n": len(said),
        "called": float(np.mean([called for _, called, _ in said])),
        "holds": share,
        "brier": float(np.mean([square for _, square in squares])),
        "brier_flat": share * (1 - share),
        "ece": sum(b["n"] * abs(b["called"] - b["holds"]) for b in bins) / len(said),
        "log_score": float(np.mean([score for _, score in scores])),
        "log_uniform": float(np.mean([record.chances[name].log_uniform for record in records])),
        "ci": {
            "holds": list(interval([(room, float(h)) for room, _, h in said], rng=rng)),
            "brier": list(interval(squares, rng=rng)),
            "log_score": list(interval(scores, rng=rng)),
        },
        "bins": bins,
    }


def _bin(said: Sequence[Said], index: int, rng: np.random.Generator) -> dict[str, Any] | None:
    """The places called between index and index + 1 tenths; None if there is none."""
    part = [one for one in said if min(int(one[1] * BINS), BINS - 1) == index]
    if not part:
        return None
    return {
        "from": index / BINS,
        "to": (index + 1) / BINS,
        "n": len(part),
        "called": float(np.mean([called for _, called, _ in part])),
        "holds": float(np.mean([holds for _, _, holds in part])),
        "ci": {"holds": list(interval([(room, float(h)) for room, _, h in part], rng=rng))},
    }
