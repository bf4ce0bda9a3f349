"""Growing: knowledge that learns further categories and examples on top of what it knows."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from scenegen_core.graph.relations import ABSENT, RELATIONS, Column, columns
from scenegen_core.knowledge.choice import MISSING, Choice, choice_columns
from scenegen_core.knowledge.knowledge import CategoryKnowledge, Knowledge
from scenegen_core.scene.geometry import Ints
from scenegen_core.scene.model import Category

NEVER_SEEN = {"AD": ABSENT}
"""What a relation measures of a group that is in no room; 0 where nothing is named."""


def with_groups(knowledge: Knowledge, further: tuple[Category, ...]) -> Knowledge:
    """The same knowledge with further groups, of which its rooms had none."""
    names = {group.name for group in knowledge.groups}
    groups = (*knowledge.groups, *(group for group in further if group.name not in names))
    named, chosen = columns(RELATIONS, groups), choice_columns(groups)
    shared = knowledge.shared
    if shared is not None:
        wide = np.zeros((len(chosen), shared.shape[1]), dtype=shared.dtype)
        wide[_places(choice_columns(knowledge.groups), chosen)] = shared
        shared = wide
    return replace(
        knowledge,
        groups=groups,
        categories={n: _wider(part, named) for n, part in knowledge.categories.items()},
        choices={n: _wider_choice(choice, chosen) for n, choice in knowledge.choices.items()},
        shared=shared,
    )


def together(one: Knowledge, other: Knowledge) -> Knowledge:
    """The examples of both, which have the same groups; the choices of the first."""
    categories = {
        group.name: _both(one.categories.get(group.name), other.categories.get(group.name))
        for group in one.groups
        if group.name in one.categories or group.name in other.categories
    }
    return replace(
        one,
        categories={name: part for name, part in categories.items() if part is not None},
        sources=(*one.sources, *other.sources),
        made_with=f"{one.made_with}; {other.made_with}",
        plans={**one.plans, **other.plans},
    )


def _places(named: tuple[Column, ...], among: tuple[Column, ...]) -> Ints:
    """Where columns are among others."""
    place = {column: index for index, column in enumerate(among)}
    return np.array([place[column] for column in named], dtype=np.int64)


def _wider(part: CategoryKnowledge, named: tuple[Column, ...]) -> CategoryKnowledge:
    rows = np.array([NEVER_SEEN.get(column.relation, 0.0) for column in named])
    rows = np.tile(rows, (part.examples, 1))
    rows[:, _places(part.columns, named)] = part.rows
    return replace(part, columns=named, rows=rows)


def _wider_choice(choice: Choice, named: tuple[Column, ...]) -> Choice:
    place = _places(choice.columns, named)
    curves = np.zeros((len(named), choice.curves.shape[1]), dtype=choice.curves.dtype)
    curves[place] = choice.curves
    examples = np.full((len(choice.examples), len(named)), MISSING, dtype=np.uint8)
    examples[:, place] = choice.examples
    return replace(
        choice, columns=named, curves=curves, pairs=place[choice.pairs], examples=examples
    )


def _both(
    one: CategoryKnowledge | None, other: CategoryKnowledge | None
) -> CategoryKnowledge | None:
    if one is None or other is None:
        return one or other
    return CategoryKnowledge(
        category=one.category,
        columns=one.columns,
        rows=np.concatenate([one.rows, other.rows]),
        rooms=(*one.rooms, *other.rooms),
        front_known=np.concatenate([one.front_known, other.front_known]),
        sizes=np.concatenate([one.sizes, other.sizes]),
        bottoms=np.concatenate([one.bottoms, other.bottoms]),
        weights=np.concatenate([one.weights, other.weights]),
    )
