"""No good place: the nearest thing that gives one."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from math import prod

from scenegen_core.graph.situation import Situation
from scenegen_core.graph.surroundings import Surroundings
from scenegen_core.graph.wording import spoken
from scenegen_core.knowledge.knowledge import Knowledge
from scenegen_core.placement.answer import COMFORTS, Cancelled, Comfort, Query, Remedy
from scenegen_core.placement.feasible import ALLOWED, Space, verdicts
from scenegen_core.placement.proposals import propose
from scenegen_core.placement.solve import solve
from scenegen_core.scene.model import Scene, Vector3
from scenegen_core.scene.resting import taken_out

NOWHERE: Vector3 = (0.0, 0.0, 0.0)  # until the place is known
SHARES = (0.95, 0.9, 0.85, 0.8, 0.75, 0.7)  # of depth and width; smaller is another piece
HUNDRED = 100  # centimetres in a metre, parts in a whole
WITHOUT_RULE: dict[Comfort, str] = {
    "window": "There is a place if it may cover a window.",
    "path": "There is a place if it may stand in the way.",
}


def find_remedy(
    scene: Scene,
    query: Query,
    knowledge: Knowledge,
    *,
    cancelled: Callable[[], bool] = lambda: False,
) -> Remedy | None:
    """The first change that gives the object a place; None if none of them does.

    Tried are smaller sizes, then taking one box away (the one that is least to carry first), then
    living without a rule of comfort.
    """
    size = query.size or knowledge[query.category].usual_size
    asked = replace(query, size=size)
    for change in (*_sizes(size), *_boxes(scene), *_rules(asked)):
        if cancelled():
            raise Cancelled
        without = scene if change.box is None else taken_out(scene, change.box)
        rules = asked.relaxed if change.rule is None else (*asked.relaxed, change.rule)
        changed = replace(asked, size=change.size or size, relaxed=rules)
        if not _may_fit(without, changed, knowledge):
            continue
        answer = solve(without, changed, knowledge, cancelled=cancelled).answer
        if answer.poses:
            best = answer.poses[0]
            return replace(change, center=best.center, heading=best.heading)
    return None


def _sizes(size: Vector3) -> Iterator[Remedy]:
    depth, width, height = size
    for share in SHARES:
        smaller = (round(depth * share, 2), round(width * share, 2), height)
        text = (
            f"One that is {round((1 - share) * HUNDRED)} % smaller would fit: "
            f"{smaller[0]:.2f} × {smaller[1]:.2f} m."
        )
        yield Remedy("size", text, NOWHERE, 0.0, size=smaller)


def _boxes(scene: Scene) -> Iterator[Remedy]:
    for box in sorted(scene.boxes, key=lambda box: prod(box.size)):
        text = f"There is a place without the {spoken(box)}."
        yield Remedy("box", text, NOWHERE, 0.0, box=box.id)


def _rules(query: Query) -> Iterator[Remedy]:
    for rule in COMFORTS:
        if rule not in query.relaxed:
            yield Remedy("rule", WITHOUT_RULE[rule], NOWHERE, 0.0, rule=rule)


def _may_fit(scene: Scene, query: Query, knowledge: Knowledge) -> bool:
    """Is any pose possible, as far as the hard facts but the ways go?"""
    around = Surroundings(scene, knowledge.groups)
    assert query.size is not None
    proposals = propose(around, knowledge[query.category].category, query.size)
    situation = Situation(proposals.candidates, around)
    return bool((verdicts(situation, Space.of(around, query.relaxed)) == ALLOWED).any())
