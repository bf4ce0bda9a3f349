"""Why here: the score of a pose, taken apart into relations and groups, and the rooms behind it."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass

import numpy as np

from scenegen_core.graph.candidates import Candidates
from scenegen_core.graph.relations import BY_SHORT
from scenegen_core.graph.situation import Situation
from scenegen_core.graph.surroundings import Surroundings
from scenegen_core.placement.answer import Reason
from scenegen_core.placement.paper_model import PaperModel, Share
from scenegen_core.placement.reasons import reason_text
from scenegen_core.scene.geometry import Floats

REFERENCES = 500  # poses that stand for all possible ones of a room
ROOMS_NAMED = 3
NEGLIGIBLE = 1e-9  # nats; below that a relation says nothing

AGREEMENT = "Agreement"
"""What is left of a density after its columns: how many known rooms share the word."""


@dataclass(frozen=True, slots=True)
class Explanation:
    """The score of one pose and its parts, which add up to it."""

    score: float
    reasons: tuple[Reason, ...]
    rooms: tuple[str, ...]


class Explainer:
    """Compares poses with the average possible pose of the same room."""

    def __init__(self, model: PaperModel, around: Surroundings, possible: Candidates) -> None:
        self._model = model
        self._around = around
        self._members = {
            group.name: [around.scene.boxes[i] for i in np.flatnonzero(around.group_of == index)]
            for index, group in enumerate(around.groups)
        }
        step = max(1, len(possible) // REFERENCES)
        reference = model.shares(Situation(possible[::step], around))
        self._average = [_parts(share).mean(axis=0) for share in reference]
        self.baseline = float(sum(average.sum() for average in self._average))
        """The log score of the average possible pose: scores are told relative to it."""

    def explain(self, pose: Candidates) -> Explanation:
        """Why a single pose (n = 1) has its score."""
        shares = self._model.shares(Situation(pose, self._around))
        total: defaultdict[tuple[str, str], float] = defaultdict(float)
        values: dict[tuple[str, str], float] = {}
        for share, average in zip(shares, self._average, strict=True):
            above = _parts(share)[0] - average
            for column, part, value in zip(share.columns, above[:-1], share.values[0], strict=True):
                total[column.relation, column.group] += float(part)
                values[column.relation, column.group] = float(value)
            total[AGREEMENT, ""] += float(above[-1])
        reasons = [
            Reason(_name(relation), group, part, self._text(relation, group, values))
            for (relation, group), part in total.items()
            if abs(part) > NEGLIGIBLE
        ]
        reasons.sort(key=lambda reason: -abs(reason.contribution))
        score = sum(reason.contribution for reason in reasons)
        return Explanation(score, tuple(reasons), _loudest(shares))

    def _text(self, relation: str, group: str, values: dict[tuple[str, str], float]) -> str:
        if relation == AGREEMENT:
            return "how many known rooms agree"
        members = self._members.get(group, [])
        return reason_text(relation, group, values[relation, group], members)


def _name(relation: str) -> str:
    """The whole name of what a reason is about."""
    return AGREEMENT if relation == AGREEMENT else BY_SHORT[relation].name


def _parts(share: Share) -> Floats:
    """The columns and the agreement side by side: (poses, columns + 1)."""
    return np.column_stack([share.terms.columns, share.terms.agreement])


def _loudest(shares: tuple[Share, ...]) -> tuple[str, ...]:
    """The rooms whose examples carry most of the density of the position, the loudest first."""
    share = shares[0]
    by_room: defaultdict[str, float] = defaultdict(float)
    for room, weight in zip(share.rooms, share.terms.responsibilities[0], strict=True):
        by_room[room] += float(weight)
    ranked = sorted(by_room, key=lambda room: -by_room[room])
    return tuple(ranked[:ROOMS_NAMED])
