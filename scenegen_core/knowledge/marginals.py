"""What knowledge says of each category, one relation at a time: the paper's knowledge figure.

The figure ("Visualization of the Knowledge Model") shows (a) RoomPosition, (b) SurroundedBy,
(c) Facing, (d) TowardsCenter. Here they are shares of the examples, with the counts behind them.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from scenegen_core.graph.relations import ABSENT
from scenegen_core.knowledge.knowledge import CategoryKnowledge, Knowledge
from scenegen_core.knowledge.sources import Source
from scenegen_core.scene.geometry import Bools, Floats
from scenegen_core.scene.model import Symmetry

SEVERAL = 2  # members; "surrounded by multiple objects"
PLACES = ("middle", "edge", "corner")
"""RoomPosition of 0, 1, and 2 or more walls near."""


@dataclass(frozen=True, slots=True)
class Bar:
    """How many of the examples counted hold a thing true."""

    label: str
    count: int
    share: float
    several: int = 0
    """Of them, with two or more members of the group."""
    possible: int = 0
    """Of groups: examples whose room has a member of it at all."""


@dataclass(frozen=True, slots=True)
class CategoryMarginals:
    """What the examples of one category say."""

    category: str
    examples: int
    fronts: int
    """Examples whose front is known: those that Facing and TowardsCenter count."""
    position: tuple[Bar, ...]
    surrounded_by: tuple[Bar, ...]
    facing: tuple[Bar, ...]
    """Empty for what has no front of its own."""
    towards_center: tuple[Bar, ...]
    """Empty likewise."""


@dataclass(frozen=True, slots=True)
class KnowledgeMarginals:
    """What knowledge says, and where from."""

    sources: tuple[Source, ...]
    categories: tuple[CategoryMarginals, ...]


def marginals(knowledge: Knowledge) -> KnowledgeMarginals:
    """What knowledge says of each of its categories."""
    parts = tuple(_of_category(part) for part in knowledge.categories.values())
    return KnowledgeMarginals(knowledge.sources, parts)


def _of_category(part: CategoryKnowledge) -> CategoryMarginals:
    near_walls = _column(part, "RP").clip(max=len(PLACES) - 1)
    fronts = part.front_known & (part.category.symmetry is Symmetry.ASYMMETRIC)
    ahead = _column(part, "TC")[fronts] > 0
    return CategoryMarginals(
        category=part.category.name,
        examples=part.examples,
        fronts=int(fronts.sum()),
        position=tuple(_bar(place, near_walls == i) for i, place in enumerate(PLACES)),
        surrounded_by=_by_group(part, "S", np.ones(part.examples, dtype=np.bool_)),
        facing=_by_group(part, "F", fronts) if fronts.any() else (),
        towards_center=(_bar("yes", ahead), _bar("no", ~ahead)) if fronts.any() else (),
    )


def _column(part: CategoryKnowledge, relation: str, group: str = "") -> Floats:
    """The values of a column: (n,)."""
    names = [(column.relation, column.about) for column in part.columns]
    values: Floats = part.rows[:, names.index((relation, group))]
    return values


def _by_group(part: CategoryKnowledge, relation: str, which: Bools) -> tuple[Bar, ...]:
    """A bar a group: the examples that the relation counts a member of it for."""
    bars = []
    for column in part.columns:
        if column.relation == relation:
            members = _column(part, relation, column.about)[which]
            there = _column(part, "AD", column.about)[which] != ABSENT
            bars.append(_bar(column.about, members > 0, members >= SEVERAL, there))
    return tuple(bars)


def _bar(
    label: str, holds: Bools, several: Bools | None = None, possible: Bools | None = None
) -> Bar:
    return Bar(
        label=label,
        count=int(holds.sum()),
        share=float(holds.mean()),
        several=0 if several is None else int(several.sum()),
        possible=0 if possible is None else int(possible.sum()),
    )
