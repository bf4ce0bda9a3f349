"""Alternatives: poses to offer that differ, none of which closes a way.

A model of densities offers its best pose, then the next best that lie apart. A model of
probabilities offers the pose from which the truth is least far on average, then each time the one
that brings the nearest offer closest to it: so several offers cover several places, not one.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from scipy.spatial.distance import cdist
from scipy.special import softmax

from scenegen_core.placement.proposals import Proposals
from scenegen_core.placement.walking import Walking
from scenegen_core.scene.geometry import Bools, Floats, Ints

APART = 0.75  # metres between two alternatives
TRIES = 300  # poses whose ways are checked before giving up
TIE = 1e-9  # nats; scores this near to each other are equal
LIKELIEST = 2000  # cells that expected distances are taken over: all of a room of 20 m²
LIKELY = 2.0  # nats below the best pose; no less likely may the first offer be
WORTH_OFFERING = 4.0  # nats below the best pose; what is less likely comes last
SETTLE = 0.32  # metres that an offer may move to a likelier place; no multiple of a cell
LAPSE = 0.15  # share of furniture that stands where no pose is tried (docs/model.md)

BLOCKED_ID = "new"


@dataclass(frozen=True, slots=True)
class Chosen:
    """Which poses are on offer, and what the first that was refused would have closed."""

    poses: Ints
    closed: str | None


class Offers(Protocol):
    """Poses in the order they should be offered in, as some of them turn out to be taken."""

    def next(self) -> int | None:
        """The next pose to try; None if there is none left."""

    def take(self, pose: int) -> None:
        """The pose is on offer: those to come must differ from it."""


def choose(
    proposals: Proposals,
    scores: Floats,
    walking: Walking,
    *,
    count: int,
    rng: np.random.Generator,
    keep_going: Callable[[], None],
    expects: bool = False,
) -> Chosen:
    """Up to ``count`` poses at least APART; ties by ``rng``. ``scores`` (n,) of all proposals.

    ``expects`` where scores are log-probabilities. ``keep_going`` is called now and then and raises
    to abandon the work.
    """
    jittered = scores + rng.random(len(scores)) * TIE
    offers: Offers = (_Expected if expects else _Ranked)(proposals, jittered)
    chosen: list[int] = []
    closed: str | None = None
    for _ in range(TRIES + count):
        pose = offers.next() if len(chosen) < count else None
        if pose is None:
            break
        keep_going()
        blocked = walking.blocked_by(proposals.candidates.box(pose, BLOCKED_ID))
        if blocked is None:
            chosen.append(pose)
            offers.take(pose)
        elif closed is None:
            closed = blocked
    return Chosen(np.array(chosen, dtype=np.int64), closed)


class _Ranked:
    """The best pose of each cell, the best cell first."""

    def __init__(self, proposals: Proposals, scores: Floats) -> None:
        self._points = proposals.candidates.centers[:, :2]
        self._poses = iter(best_of_places(proposals, scores).tolist())
        self._taken: list[int] = []

    def next(self) -> int | None:
        """The next best that lies apart from those taken."""
        return next((pose for pose in self._poses if self._differs(pose)), None)

    def take(self, pose: int) -> None:
        """Keep away from it."""
        self._taken.append(pose)

    def _differs(self, pose: int) -> bool:
        offset = self._points[self._taken] - self._points[pose]
        return bool((np.hypot(offset[:, 0], offset[:, 1]) >= APART).all())


class _Expected:
    """The pose that leaves the truth least far from the nearest offer, on average."""

    def __init__(self, proposals: Proposals, scores: Floats) -> None:
        best = best_of_places(proposals, scores)
        _, place = np.unique(proposals.places, return_inverse=True)
        mass = np.bincount(place, probabilities(scores, place))
        best = best[np.argsort(-mass[place[best]], kind="stable")]
        self._poses = best[:LIKELIEST]
        self._mass = mass[place[self._poses]]
        points = proposals.candidates.centers[self._poses, :2]
        self._away: Floats = cdist(points, points)
        self._below = scores.max(initial=-np.inf) - scores[self._poses]
        self._left: Bools = np.ones(len(self._poses), dtype=np.bool_)
        self._nearest: Floats = np.full(len(self._poses), np.inf)

    def next(self) -> int | None:
        """The place that helps most, of the likely ones while there are any."""
        first = np.isinf(self._nearest).all()
        for limit in (LIKELY if first else WORTH_OFFERING, np.inf):
            open_ = np.flatnonzero(self._left & (self._below <= limit))
            if len(open_):
                risk = np.minimum(self._away[open_], self._nearest) @ self._mass
                found = self._settled(open_, int(open_[risk.argmin()]))
                self._left[found] = False
                return int(self._poses[found])
        return None

    def _settled(self, open_: Ints, found: int) -> int:
        """The likeliest place close to that: an average of places is flush with nothing."""
        close = open_[self._away[found, open_] <= SETTLE]
        return int(close[self._below[close].argmin()])

    def take(self, pose: int) -> None:
        """What lies near it is served now."""
        away = self._away[np.flatnonzero(self._poses == pose)[0]]
        self._nearest = np.minimum(self._nearest, away)
        self._left &= away >= APART


def probabilities(scores: Floats, place: Ints) -> Floats:
    """How likely each pose is chosen, given log-probabilities (−∞ where impossible): (n,), sum 1.

    People put some things where no pose is tried: for those every possible ``place``, (n,) small
    numbers, is as likely as another.
    """
    possible = np.isfinite(scores)
    if not possible.any():
        return np.zeros(len(scores))
    poses = np.bincount(place[possible], minlength=place.max() + 1)
    lapsed = np.where(possible, 1 / np.maximum(poses[place], 1), 0.0) / np.count_nonzero(poses)
    return np.asarray((1 - LAPSE) * softmax(scores) + LAPSE * lapsed, dtype=np.float64)


def best_of_places(proposals: Proposals, scores: Floats) -> Ints:
    """The best possible pose of each cell, the best cell first."""
    ranked = np.argsort(-scores, kind="stable")
    ranked = ranked[np.isfinite(scores[ranked])]
    _, first = np.unique(proposals.places[ranked], return_index=True)
    return np.asarray(ranked[np.sort(first)], dtype=np.int64)
