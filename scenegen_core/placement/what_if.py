"""What if this were not here? The box that matters most to where an object would go."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import dist, inf, pi

import numpy as np

from scenegen_core.graph.wording import spoken
from scenegen_core.knowledge.knowledge import Knowledge
from scenegen_core.placement.answer import Answer, Cancelled, Counterfactual, Pose, Query
from scenegen_core.placement.elsewhere import length
from scenegen_core.placement.solve import solve
from scenegen_core.scene.geometry import wrapped
from scenegen_core.scene.model import Box, Scene, Symmetry

TURNING = 1 / pi  # metres that a radian is worth: a half turn changes as much as a metre
SAME = 0.1  # metres of change below which people see the same place


def what_matters(
    scene: Scene,
    query: Query,
    answer: Answer,
    knowledge: Knowledge,
    *,
    progress: Callable[[int], None] = lambda _: None,
    cancelled: Callable[[], bool] = lambda: False,
) -> Counterfactual | None:
    """The box whose removal changes the best place most; None if none changes it.

    By how far the place moves and turns; of those that tie, by how much its score changes. The
    ``answer`` is the one with everything there. ``progress`` is told how many boxes were tried.
    Raises Cancelled as ``solve`` does.
    """
    if not answer.poses:
        return None
    symmetry = knowledge[query.category].category.symmetry
    found: list[Counterfactual] = []
    for done, box in enumerate(scene.boxes):
        if cancelled():
            raise Cancelled
        progress(done)
        asked = replace(query, size=answer.size, count=1)
        without = solve(scene.without(box.id), asked, knowledge, cancelled=cancelled).answer
        best = next(iter(without.poses), None)
        found.append(_compared(box, answer.poses[0], best, symmetry))
    if not found:
        return None
    most = max(found, key=lambda one: (_change(one), abs(one.score_change)))
    return most if _change(most) >= SAME else None


def _compared(box: Box, before: Pose, after: Pose | None, symmetry: Symmetry) -> Counterfactual:
    if after is None:
        text = f"Without the {spoken(box)} there would be no place for it."
        return Counterfactual(box.id, None, None, text)
    moved = dist(before.center, after.center)
    turned = abs(float(wrapped(np.array(after.heading - before.heading))))
    if symmetry is Symmetry.SYMMETRIC:
        turned = min(turned, pi - turned)
    where = after.sentence[0].lower() + after.sentence[1:]
    away = f", {length(moved)} from here" if moved >= SAME else ""
    text = f"Without the {spoken(box)} it would go {where}{away}."
    change = after.score - before.score
    return Counterfactual(box.id, after.center, after.heading, text, moved, turned, change)


def _change(one: Counterfactual) -> float:
    return inf if one.center is None else one.moved + one.turned * TURNING
