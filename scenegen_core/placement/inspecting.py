"""What is to be said of any pose: why it is forbidden, or what it costs, and what it would take."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from scenegen_core.graph.candidates import Candidates
from scenegen_core.graph.situation import Situation
from scenegen_core.placement.alternatives import BLOCKED_ID
from scenegen_core.placement.answer import Cost, Elsewhere, Inspection, Pose, Reason
from scenegen_core.placement.elsewhere import (
    elsewhere,
    in_the_way,
    nearest_member,
    nearest_possible,
)
from scenegen_core.placement.explain import Explainer, Explanation
from scenegen_core.placement.feasible import ALLOWED, RULES, Space, verdicts
from scenegen_core.placement.heat_map import likelihood
from scenegen_core.placement.refusals import refusal
from scenegen_core.placement.walking import Walking
from scenegen_core.placement.words import sentence
from scenegen_core.scene.geometry import Floats
from scenegen_core.scene.model import Category

COSTS = 3  # told
FELT = 0.1  # nats; what costs less is not felt
NEAR = 1.0  # metres within which a better pose is better than the best one far away
WORTH_MOVING = 0.5  # nats that it must be better by


@dataclass(frozen=True, eq=False)
class Inspector:
    """Looks at single poses of an object in a room for which an answer was found."""

    category: Category
    space: Space
    walking: Walking
    possible: Candidates
    scores: Floats
    """Of the possible poses: (n,)."""
    bounds: tuple[float, float]
    """Of the scores that the heat maps show."""
    explainer: Explainer | None
    best: Pose | None

    def inspect(self, pose: Candidates) -> Inspection:
        """What the model says of a single pose, or which rule forbids it and what it would take."""
        situation = Situation(pose, self.space.around)
        verdict = int(verdicts(situation, self.space)[0])
        closed = self.walking.blocked_by(pose.box(0, BLOCKED_ID)) if verdict == ALLOWED else None
        if verdict != ALLOWED or closed is not None:
            rule = RULES[verdict] if closed is None else "path"
            text = refusal(rule, situation, closed)
            way_out = self._way_out(situation, rule)
            return Inspection(False, rule, None, None, text, (), elsewhere=way_out)
        text = sentence(situation, self.category)
        if self.explainer is None:
            return Inspection(True, "", None, None, text, ())
        why = self.explainer.explain(pose)
        shown = float(likelihood(np.array([why.score]), self.bounds)[0])
        costs = () if self.best is None else dearest(why.reasons, self.best.reasons)
        better = self._better(situation, why, costs)
        return Inspection(True, "", why.score, shown, text, why.reasons, costs, better)

    def _way_out(self, situation: Situation, rule: str) -> Elsewhere | None:
        end = nearest_possible(
            situation.candidates,
            self.possible,
            self.scores,
            self.space,
            self.walking,
            self.category.symmetry,
        )
        by = in_the_way(rule, situation)
        return None if end is None else elsewhere(situation, end, self.category, by)

    def _better(
        self, situation: Situation, why: Explanation, costs: tuple[Cost, ...]
    ) -> Elsewhere | None:
        """The best pose near by if it is worth moving there, else the best of all."""
        if self.best is None or not costs:
            return None
        offset = self.possible.centers - situation.candidates.centers
        near = np.flatnonzero(np.hypot(offset[:, 0], offset[:, 1]) <= NEAR)
        by = nearest_member(situation, costs[0].group)
        for index in near[np.argsort(-self.scores[near], kind="stable")]:
            if self.scores[index] < why.score + WORTH_MOVING:
                break
            single = self.possible[index : index + 1]
            if self.walking.blocked_by(single.box(0, BLOCKED_ID)) is None:
                return elsewhere(situation, single, self.category, by)
        if self.best.score < why.score + FELT:
            return None
        pose = situation.candidates
        best = Candidates(
            pose.category, pose.size, np.array([self.best.center]), np.array([self.best.heading])
        )
        return elsewhere(situation, best, self.category, by)


def dearest(here: tuple[Reason, ...], best: tuple[Reason, ...]) -> tuple[Cost, ...]:
    """What a pose loses most by beside the best one, the dearest first."""
    reasons = {(reason.relation, reason.group): reason for reason in here}
    others = {(reason.relation, reason.group): reason for reason in best}
    costs = []
    for about in {**reasons, **others}:
        mine, other = reasons.get(about), others.get(about)
        difference = (mine.contribution if mine else 0.0) - (other.contribution if other else 0.0)
        if difference <= -FELT:
            texts = [reason.text if reason else "" for reason in (mine, other)]
            costs.append(Cost(*about, difference, *texts))
    return tuple(sorted(costs, key=lambda cost: cost.difference)[:COSTS])
