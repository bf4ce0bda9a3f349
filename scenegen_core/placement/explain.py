"""Why here: the score of a pose, taken apart into relations and groups, and the rooms behind it."""

from __future__ import annotations

from collections.abc import Mapping, Sized
from dataclasses import dataclass

import numpy as np

from scenegen_core.graph.candidates import Candidates
from scenegen_core.graph.own_relations import OWN_RELATIONS
from scenegen_core.graph.relations import RELATIONS
from scenegen_core.graph.situation import Situation
from scenegen_core.graph.surroundings import Surroundings
from scenegen_core.placement.answer import Reason
from scenegen_core.placement.models import PlacementModel
from scenegen_core.placement.reasons import reason_text

REFERENCES = 500  # poses that stand for all possible ones of a room
ROOMS_NAMED = 3
NEGLIGIBLE = 1e-9  # nats; below that a relation says nothing

NAMES = {relation.short: relation.name for relation in (*RELATIONS, *OWN_RELATIONS)}


@dataclass(frozen=True, slots=True)
class Explanation:
    """The score of one pose and its parts, which add up to it."""

    score: float
    reasons: tuple[Reason, ...]
    rooms: tuple[str, ...]


def reference(possible: Sized) -> slice:
    """Those of a room's possible poses whose average all scores are told relative to."""
    return slice(None, None, max(1, len(possible) // REFERENCES))


class Explainer:
    """Compares poses with the average possible pose of the same room."""

    def __init__(self, model: PlacementModel, around: Surroundings, possible: Candidates) -> None:
        self._model = model
        self._around = around
        self._members = {
            group.name: [around.scene.boxes[i] for i in np.flatnonzero(around.group_of == index)]
            for index, group in enumerate(around.groups)
        }
        self._fronted = possible.category not in around.frontless
        average = model.parts(Situation(possible[reference(possible)], around))
        self._average = dict(zip(average.subjects, average.values.mean(axis=0), strict=True))

    def explain(self, pose: Candidates) -> Explanation:
        """Why a single pose (n = 1) has its score."""
        situation = Situation(pose, self._around)
        parts = self._model.parts(situation)
        reasons = [
            Reason(NAMES.get(relation, relation), group, above, self._text(relation, group, seen))
            for (relation, group), value, seen in zip(
                parts.subjects, parts.values[0].tolist(), parts.measured, strict=True
            )
            if abs(above := value - float(self._average[relation, group])) > NEGLIGIBLE
        ]
        reasons.sort(key=lambda reason: -abs(reason.contribution))
        score = sum(reason.contribution for reason in reasons)
        return Explanation(score, tuple(reasons), self._model.rooms(situation)[:ROOMS_NAMED])

    def _text(self, relation: str, group: str, measured: Mapping[str, float]) -> str:
        members = self._members.get(group, [])
        return reason_text(relation, group, measured, members, fronted=self._fronted)
