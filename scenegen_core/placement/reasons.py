"""What one number of a feature vector says, in plain words: "2 chairs within 1 m"."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from scenegen_core.graph.relations import ABSENT, NEAR_WALL, NEARBY
from scenegen_core.graph.wording import about_group, about_room, noun, nouns, spoken
from scenegen_core.placement.own_reasons import TEXTS, neighbor
from scenegen_core.placement.paper_model import AGREEMENT
from scenegen_core.scene.model import Box

TOLD = {"AD": "AverageDistance", "SP": "Support", "F": "Facing", "NT": "NextTo"}
"""Relations that the scene graph tells in the same words."""
NONE = {
    "S": f"no {{}} within {NEARBY:g} m",
    "SP": "neither on nor under a {}",
    "F": "faces no {} close by",
    "NT": "no {} at its side",
}
"""What they say of a group where they count nothing."""


def reason_text(
    relation: str,
    group: str,
    measured: Mapping[str, float],
    members: Sequence[Box],
    *,
    fronted: bool = True,
) -> str:
    """What a relation says of a group with ``members``, or of a part; ``measured`` by its parts.

    A group's only member goes by its own label, if it has one. What is not ``fronted`` has neither
    front nor back to speak of.
    """
    if relation == AGREEMENT:
        return "how many known rooms agree"
    if relation in TEXTS:
        return TEXTS[relation](measured, fronted=fronted)
    if relation == "N":
        return neighbor(group, measured, members, fronted=fronted)
    return _paper_text(relation, group, measured[""], members)


def _paper_text(relation: str, group: str, value: float, members: Sequence[Box]) -> str:
    """What one column of the paper's relations says."""
    count = round(value)
    if relation == "AD" and value >= ABSENT:
        return f"no {noun(group)} in the room"
    if relation in NONE and not count:
        return NONE[relation].format(noun(group))
    if relation in TOLD:
        name = spoken(members[0]) if len(members) == 1 else group
        return about_group(TOLD[relation], value, name, len(members))
    return {
        "RP": f"middle within {NEAR_WALL:g} m of {count} wall{'s'[: count != 1]}"
        if count
        else f"middle more than {NEAR_WALL:g} m from any wall",
        "S": f"{count} {noun(group) if count == 1 else nouns(group)} within {NEARBY:g} m",
        "TC": about_room("TowardsCenter", value) if count else "faces a near wall",
        "AW": about_room("AwayFromWall", value) if count else "no wall right behind it",
        "DS": f"{count or 'no'} neighbor{'s face' if count > 1 else ' faces'} the {group} way",
    }[relation]
