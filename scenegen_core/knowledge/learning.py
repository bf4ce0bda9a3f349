"""Learning: measure every box of every room as if it were being placed."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from scenegen_core.errors import DataError
from scenegen_core.graph.candidates import Candidates
from scenegen_core.graph.relations import RELATIONS, columns, measure
from scenegen_core.graph.situation import Situation
from scenegen_core.graph.surroundings import Surroundings
from scenegen_core.knowledge.density import Floats
from scenegen_core.knowledge.knowledge import SETTINGS, CategoryKnowledge, Knowledge
from scenegen_core.knowledge.sources import sources_of
from scenegen_core.scene.model import OTHER, Box, Category, Scene


class _Example(NamedTuple):
    row: Floats
    box: Box
    room: str


def learn(
    scenes: Sequence[Scene],
    groups: tuple[Category, ...],
    *,
    made_with: str = "",
    progress: Callable[[int], None] = lambda _: None,
) -> Knowledge:
    """The knowledge that scenes teach; DataError if there is nothing to learn from.

    Boxes of Other, or of no group, are seen but not learned. ``progress`` is told after each room
    how many are done.
    """
    examples: dict[str, list[_Example]] = {
        group.name: [] for group in groups if group.name != OTHER
    }
    for done, scene in enumerate(scenes, start=1):
        for box in scene.boxes:
            if box.category in examples:
                row = _measure_in_place(scene, box, groups)
                examples[box.category].append(_Example(row, box, scene.id))
        progress(done)
    if not any(examples.values()):
        raise DataError(
            f"There is nothing to learn from in {len(scenes)} rooms; give rooms that hold "
            f"{', '.join(examples)}."
        )
    return Knowledge(
        groups=groups,
        categories={
            group.name: _category(group, groups, examples[group.name])
            for group in groups
            if examples.get(group.name)
        },
        sources=sources_of(scenes),
        settings=SETTINGS,
        made_with=made_with,
    )


def _measure_in_place(scene: Scene, box: Box, groups: tuple[Category, ...]) -> Floats:
    """The feature vector of a box where it stands, in its scene without it: (columns,)."""
    around = Surroundings(scene.without(box.id), groups)
    row: Floats = measure(RELATIONS, Situation(Candidates.of(box), around))[0]
    return row


def _category(
    group: Category, groups: tuple[Category, ...], examples: list[_Example]
) -> CategoryKnowledge:
    boxes = [example.box for example in examples]
    return CategoryKnowledge(
        category=group,
        columns=columns(RELATIONS, groups),
        rows=np.array([example.row for example in examples]),
        rooms=tuple(example.room for example in examples),
        front_known=np.array([box.front_known and not box.front_from_wall for box in boxes]),
        sizes=np.array([box.size for box in boxes]),
        bottoms=np.array([box.bottom for box in boxes]),
    )
