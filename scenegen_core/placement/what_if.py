"""What if this were not here? The box that matters most to where an object would go."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import dist, inf, pi

import numpy as np

from scenegen_core.graph.candidates import Candidates
from scenegen_core.graph.wording import spoken
from scenegen_core.knowledge.knowledge import Knowledge
from scenegen_core.placement.alternatives import APART
from scenegen_core.placement.answer import Answer, Cancelled, Counterfactual, Pose, Query
from scenegen_core.placement.elsewhere import length, way
from scenegen_core.placement.solve import solve
from scenegen_core.scene.geometry import wrapped
from scenegen_core.scene.model import Box, Category, Scene, Symmetry, Vector3
from scenegen_core.scene.resting import taken_out

TURNING = 1 / pi  # metres that a radian is worth: a half turn changes as much as a metre
DIGITS = 6  # of metres; what differs by less ties
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
    category = knowledge[query.category].category
    found: list[Counterfactual] = []
    for done, box in enumerate(scene.boxes):
        if cancelled():
            raise Cancelled
        progress(done)
        asked = replace(query, size=answer.size)
        without = solve(taken_out(scene, box.id), asked, knowledge, cancelled=cancelled).answer
        best = next(iter(without.poses), None)
        found.append(_compared(box, answer.poses[0], best, category, answer.size))
    if not found:
        return None
    most = max(found, key=lambda one: (_change(one), abs(one.score_change)))
    return most if _change(most) >= SAME else None


def _compared(
    box: Box, before: Pose, after: Pose | None, category: Category, size: Vector3
) -> Counterfactual:
    if after is None:
        text = f"Without the {spoken(box)} there would be no place for it."
        return Counterfactual(box.id, None, None, text)
    moved = dist(before.center, after.center)
    turned = abs(float(wrapped(np.array(after.heading - before.heading))))
    if category.symmetry is Symmetry.SYMMETRIC:
        turned = min(turned, pi - turned)
    where = after.sentence[0].lower() + after.sentence[1:]
    if moved < APART:
        where = way(_pose(before, size), _pose(after, size), category, None)
    else:
        where = f"{where}, {length(moved)} from here"
    text = f"Without the {spoken(box)} it would go {where}."
    change = after.score - before.score
    return Counterfactual(box.id, after.center, after.heading, text, moved, turned, change)


def _pose(pose: Pose, size: Vector3) -> Candidates:
    return Candidates("", size, np.array([pose.center]), np.array([pose.heading]))


def _change(one: Counterfactual) -> float:
    return inf if one.center is None else round(one.moved + one.turned * TURNING, DIGITS)
