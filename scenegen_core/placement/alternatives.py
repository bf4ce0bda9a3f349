"""Alternatives: poses to offer that differ, best first, none of which closes a way."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from scenegen_core.graph.candidates import Candidates
from scenegen_core.placement.proposals import Proposals
from scenegen_core.placement.walking import Walking
from scenegen_core.scene.geometry import Floats, Ints

APART = 0.75  # metres between two alternatives
TRIES = 300  # poses whose ways are checked before giving up
TIE = 1e-9  # nats; scores this near to each other are equal

BLOCKED_ID = "new"


@dataclass(frozen=True, slots=True)
class Choice:
    """Which poses are on offer, and what the first that was refused would have closed."""

    poses: Ints
    closed: str | None


def choose(
    proposals: Proposals,
    scores: Floats,
    walking: Walking,
    *,
    count: int,
    rng: np.random.Generator,
    keep_going: Callable[[], None],
) -> Choice:
    """Up to ``count`` poses at least APART; ties by ``rng``. ``scores`` (n,) of all proposals.

    ``keep_going`` is called now and then and raises to abandon the work.
    """
    candidates = proposals.candidates
    chosen: list[int] = []
    closed: str | None = None
    for tried, pose in enumerate(_best_of_places(proposals, scores, rng)):
        if len(chosen) == count or tried >= TRIES + count:
            break
        if _near_any(candidates, pose, chosen):
            continue
        keep_going()
        blocked = walking.blocked_by(candidates.box(pose, BLOCKED_ID))
        if blocked is None:
            chosen.append(pose)
        elif closed is None:
            closed = blocked
    return Choice(np.array(chosen, dtype=np.int64), closed)


def _best_of_places(
    proposals: Proposals, scores: Floats, rng: np.random.Generator
) -> Iterator[int]:
    """The best pose of each cell, the best cell first."""
    jittered = scores + rng.random(len(scores)) * TIE
    ranked = np.argsort(-jittered, kind="stable")
    _, first = np.unique(proposals.places[ranked], return_index=True)
    yield from (int(pose) for pose in ranked[np.sort(first)] if np.isfinite(scores[pose]))


def _near_any(candidates: Candidates, pose: int, chosen: list[int]) -> bool:
    offset = candidates.centers[chosen] - candidates.centers[pose]
    return bool((np.hypot(offset[:, 0], offset[:, 1]) < APART).any())
