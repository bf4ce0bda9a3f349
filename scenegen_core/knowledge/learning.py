"""Learning: measure every box of every room as if it were being placed."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import partial
from itertools import islice
from typing import NamedTuple, Protocol, TypeVar

import numpy as np

from scenegen_core.errors import DataError
from scenegen_core.graph.candidates import Candidates
from scenegen_core.graph.relations import RELATIONS, columns, measure
from scenegen_core.graph.situation import Situation
from scenegen_core.graph.surroundings import Surroundings
from scenegen_core.knowledge.knowledge import SETTINGS, CategoryKnowledge, Knowledge
from scenegen_core.knowledge.plans import Plan, plan_of
from scenegen_core.knowledge.sources import sources_of
from scenegen_core.scene.geometry import Floats
from scenegen_core.scene.model import OTHER, Box, Category, Scene

BATCH = 32  # rooms measured at a time; the unit of work that goes to other processes


class Example(NamedTuple):
    """A box where it stands, measured."""

    row: Floats
    box: Box
    room: str
    source: str


Batch = Sequence[Scene]
Found = TypeVar("Found")


class Mapper(Protocol):
    """Like the built-in map: in order, wherever the work is done."""

    def __call__(
        self, work: Callable[[Batch], Found], batches: Iterator[Batch], /
    ) -> Iterator[Found]:
        """What the work finds in each batch."""
        ...


def learn(
    scenes: Sequence[Scene],
    groups: tuple[Category, ...],
    *,
    made_with: str = "",
    weights: Mapping[str, float] | None = None,
    mapper: Mapper = map,
    progress: Callable[[int], None] = lambda _: None,
) -> Knowledge:
    """The knowledge that scenes teach; DataError if there is nothing to learn from.

    Boxes of Other, or of no group, are seen but not learned. ``weights`` says how much an example
    of a source counts (1 where it says nothing). ``mapper`` measures batches of rooms, here or
    elsewhere; the knowledge is the same to the bit. ``progress`` is told how many rooms are done.
    """
    examples: defaultdict[str, list[Example]] = defaultdict(list)
    done = 0
    for measured in mapper(partial(examples_of, groups=groups), batches(scenes)):
        for example in measured:
            examples[example.box.category].append(example)
        done = min(done + BATCH, len(scenes))
        progress(done)
    if not examples:
        learnable = (group.name for group in groups if group.name != OTHER)
        raise DataError(
            f"There is nothing to learn from in {len(scenes)} rooms; give rooms that hold "
            f"{', '.join(learnable)}."
        )
    return Knowledge(
        groups=groups,
        categories={
            group.name: _category(group, groups, examples[group.name], weights or {})
            for group in groups
            if group.name in examples
        },
        sources=sources_of(scenes),
        settings=SETTINGS,
        made_with=made_with,
        plans=_plans(scenes, examples.values()),
    )


def _plans(scenes: Sequence[Scene], examples: Iterable[list[Example]]) -> dict[str, Plan]:
    """The plans of the rooms that there are examples from."""
    rooms = {example.room for some in examples for example in some}
    return {scene.id: plan_of(scene) for scene in scenes if scene.id in rooms}


def examples_of(scenes: Batch, groups: tuple[Category, ...]) -> tuple[Example, ...]:
    """Every box of the scenes that teaches, each measured in its scene without it."""
    learnable = {group.name for group in groups} - {OTHER}
    return tuple(
        Example(_measure_in_place(scene, box, groups), box, scene.id, scene.source)
        for scene in scenes
        for box in scene.boxes
        if box.category in learnable
    )


def batches(scenes: Sequence[Scene]) -> Iterator[Batch]:
    """The scenes in portions that are worth sending elsewhere."""
    rest = iter(scenes)
    while batch := tuple(islice(rest, BATCH)):
        yield batch


def _measure_in_place(scene: Scene, box: Box, groups: tuple[Category, ...]) -> Floats:
    """The feature vector of a box where it stands, in its scene without it: (columns,)."""
    around = Surroundings(scene.without(box.id), groups)
    row: Floats = measure(RELATIONS, Situation(Candidates.of(box), around))[0]
    return row


def _category(
    group: Category,
    groups: tuple[Category, ...],
    examples: list[Example],
    weights: Mapping[str, float],
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
        weights=np.array([weights.get(example.source, 1.0) for example in examples]),
    )
