"""What people read when something cannot stand somewhere, or nowhere."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from scenegen_core.graph.situation import Situation
from scenegen_core.graph.wording import noun, spoken
from scenegen_core.placement.answer import NoGoodPlace
from scenegen_core.placement.feasible import collisions
from scenegen_core.placement.mounts import Mount, mounts
from scenegen_core.scene.model import Vector3


def refusal(rule: str, situation: Situation, closed: str | None) -> str:
    """Why the single pose of a situation is not possible."""
    if rule == "collision":
        hit = np.flatnonzero(collisions(situation)[0])
        names = [spoken(situation.surroundings.scene.boxes[i]) for i in hit]
        return f"It would stand in the {' and the '.join(dict.fromkeys(names))}."
    if rule == "path":
        return f"It would close the way to {closed}."
    if rule == "mount":
        return _rests_on_nothing(situation)
    return {
        "room": "It would stick through a wall or out of the room.",
        "door": "It would stand in the way of a door.",
        "window": "It would cover a window.",
    }[rule]


def _rests_on_nothing(situation: Situation) -> str:
    candidates = situation.candidates
    kinds = mounts(candidates.category, candidates.size)
    if kinds == (Mount.WALL,):
        return "It has to hang on a wall."
    if Mount.FLOOR in kinds:
        return "It would hang in the air."
    return "It has to stand on a cabinet or a table, or hang on a wall."


def no_good_place(
    category: str, size: Vector3, counts: Mapping[str, int], closed: str | None
) -> NoGoodPlace:
    """Why nothing is possible; ``counts`` says how many poses each rule is the first to forbid.

    Poses that only the way forbids are those where it would fit.
    """
    name = noun(category)
    article = "an" if name[0] in "aeiou" else "a"
    thing = f"{article} {name} of {size[0]:.2g} × {size[1]:.2g} × {size[2]:.2g} m"
    if not any(counts.values()):
        return NoGoodPlace("mount", f"There is nothing here that {thing} could stand or hang on.")
    rule = "path" if counts["path"] else _telling_rule(counts)
    why = {
        "room": "no stretch of floor or wall is large enough for it",
        "mount": "there is nothing that it could stand or hang on",
        "collision": "other furniture is in the way nearly everywhere",
        "door": "the free floor is needed before the doors",
        "window": "it would cover the windows",
        "path": f"wherever it fits it would close the way to {closed}",
    }[rule]
    remedy = "Try a smaller one." if rule == "room" else "Try a smaller one, or move something."
    return NoGoodPlace(rule, f"No good place for {thing}: {why}. {remedy}")


def _telling_rule(counts: Mapping[str, int]) -> str:
    """The rule that forbids most poses, of those that the empty room would take, if any.

    Most poses of a grid stick through a wall, whatever the room.
    """
    furnished = {rule: count for rule, count in counts.items() if rule not in ("room", "mount")}
    among = furnished if any(furnished.values()) else counts
    return max(among, key=lambda rule: among[rule])
