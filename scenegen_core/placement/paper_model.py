"""The paper's model (Algorithm 1): P(d_p | D_p) of the position, P(d_o | D_o) of the heading there.

The pose recommended is the one of the highest P(d_p) · P(d_o), as Algorithm 1 says. The paper's
program sampled headings at the best position only, to save time (docs/decisions.md).
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from scenegen_core.graph.relations import BY_SHORT, Column, measure
from scenegen_core.graph.situation import Situation
from scenegen_core.knowledge.density import Terms
from scenegen_core.knowledge.knowledge import ORIENTATION, POSITION, Knowledge, Prior
from scenegen_core.placement.parts import Parts, Subject
from scenegen_core.scene.geometry import Floats
from scenegen_core.scene.model import Symmetry

AGREEMENT = "Agreement"
"""What is left of a density after its columns: how many known rooms share the word."""


@dataclass(frozen=True, slots=True)
class Scores:
    """Log scores of n poses: log P(d_p), and log P(d_o), which is 0 for what has no front."""

    position: Floats
    orientation: Floats

    @property
    def total(self) -> Floats:
        """The score of the pose as a whole."""
        return self.position + self.orientation


@dataclass(frozen=True, slots=True)
class Share:
    """The exact split of log scores under one prior."""

    columns: tuple[Column, ...]
    values: Floats
    """The feature vectors: (poses, columns)."""
    terms: Terms
    rooms: tuple[str, ...]
    """The room of each example."""


class PaperModel:
    """The densities of one category, ready to score poses."""

    expects = False

    def __init__(
        self,
        knowledge: Knowledge,
        category: str,
        *,
        position: Sequence[str] = POSITION,
        orientation: Sequence[str] = ORIENTATION,
    ) -> None:
        learnt = knowledge[category]
        self._position = learnt.position(position)
        asymmetric = learnt.category.symmetry is Symmetry.ASYMMETRIC
        self._orientation = learnt.orientation(orientation) if asymmetric else None

    def score(self, situation: Situation) -> Scores:
        """The log scores of all poses of a situation."""
        position = self._position.density.log_density(_features(self._position, situation))
        if self._orientation is None:
            return Scores(position, np.zeros_like(position))
        return Scores(
            position, self._orientation.density.log_density(_features(self._orientation, situation))
        )

    def total(self, situation: Situation) -> Floats:
        """The log of P(d_p) · P(d_o) of all poses: (n,)."""
        return self.score(situation).total

    def parts(self, situation: Situation) -> Parts:
        """The columns of both densities by subject, and how much the examples agree."""
        values: defaultdict[Subject, Floats] = defaultdict(
            lambda: np.zeros(len(situation.candidates))
        )
        measured: dict[Subject, dict[str, float]] = {(AGREEMENT, ""): {}}
        for share in self.shares(situation):
            for i, column in enumerate(share.columns):
                subject = (column.relation, column.about)
                values[subject] = values[subject] + share.terms.columns[:, i]
                measured[subject] = {"": float(share.values[0, i])}
            values[AGREEMENT, ""] = values[AGREEMENT, ""] + share.terms.agreement
        subjects = tuple(values)
        return Parts(
            subjects, np.stack(list(values.values()), axis=1), tuple(measured[s] for s in subjects)
        )

    def rooms(self, situation: Situation) -> tuple[str, ...]:
        """The rooms whose examples carry most of the density of the position."""
        share = self.shares(situation)[0]
        by_room: defaultdict[str, float] = defaultdict(float)
        for room, weight in zip(share.rooms, share.terms.responsibilities[0], strict=True):
            by_room[room] += float(weight)
        return tuple(sorted(by_room, key=lambda room: -by_room[room]))

    def shares(self, situation: Situation) -> tuple[Share, ...]:
        """The split of the scores of a few poses, one a prior; their sums are the totals."""
        return tuple(
            _share(prior, situation) for prior in (self._position, self._orientation) if prior
        )


def _features(prior: Prior, situation: Situation) -> Floats:
    """The columns of a prior, measured: (poses, columns)."""
    shorts = dict.fromkeys(column.relation for column in prior.columns)
    return measure(tuple(BY_SHORT[short] for short in shorts), situation)


def _share(prior: Prior, situation: Situation) -> Share:
    values = _features(prior, situation)
    return Share(prior.columns, values, prior.density.terms(values), prior.rooms)
