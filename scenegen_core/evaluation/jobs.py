"""Jobs: which cases are asked with which knowledge; folds, or rooms held out."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from scenegen_core.errors import DataError
from scenegen_core.evaluation.cases import Case, cases, folds
from scenegen_core.evaluation.retrieval import Lesson, lessons_of
from scenegen_core.evaluation.trees import Forest, grow
from scenegen_core.knowledge.knowledge import MIN_EXAMPLES, CategoryKnowledge, Knowledge
from scenegen_core.knowledge.learning import learn
from scenegen_core.placement.choice_learning import gather, with_choices
from scenegen_core.scene.model import Category, Scene, Symmetry

MIN_ROOMS = 4  # fewer make no evaluation
MIN_FOLD = 2  # rooms; an interval by rooms needs two


@dataclass(frozen=True, slots=True)
class Job:
    """Cases to ask with one piece of knowledge."""

    fold: int
    knowledge: Knowledge
    cases: tuple[Case, ...]
    lessons: tuple[Lesson, ...]
    """The rooms that taught the knowledge, where they are at hand."""
    forest: Forest
    """The trees that the same choices grew; empty where none were."""
    left_out: dict[str, int]
    """Category -> cases not asked, since the knowledge has too few examples of it."""


def cross_validated(
    scenes: Sequence[Scene],
    groups: tuple[Category, ...],
    count: int,
    *,
    seed: int,
    choices: bool = True,
    forest: bool = False,
) -> Iterator[Job]:
    """A job a fold: its cases, and the knowledge of the other folds. DataError if too few homes.

    Without ``choices`` only the model paper can be asked; learning is much faster. ``forest`` grows
    trees too.
    """
    _enough(scenes)
    parts = folds(scenes, count, rng=np.random.default_rng(seed))
    if min(map(len, parts)) < MIN_FOLD:
        raise DataError(
            f"{len(scenes)} rooms in {count} folds leave a fold of one room, which says nothing; "
            "give more rooms, or ask for fewer folds."
        )
    chosen = [gather(part, groups) if choices else () for part in parts]
    for index, part in enumerate(parts):
        others = tuple(scene for other in parts if other is not part for scene in other)
        teach = [one for i, some in enumerate(chosen) if i != index for one in some]
        known = learn(others, groups)
        known = with_choices(known, teach) if choices else known
        yield _job(index, known, part, others, grow(teach) if forest else {})


def held_out(scenes: Sequence[Scene], knowledge: Knowledge) -> Job:
    """One job: all cases, asked with knowledge that was learned elsewhere."""
    _enough(scenes)
    return _job(0, knowledge, scenes, (), {})


def taught_by(
    lessons: tuple[Scene, ...],
    scenes: Sequence[Scene],
    groups: tuple[Category, ...],
    *,
    choices: bool = True,
    forest: bool = False,
) -> Job:
    """One job: all cases of the scenes, asked with what the lessons teach."""
    _enough(scenes)
    teach = gather(lessons, groups) if choices or forest else ()
    known = learn(lessons, groups)
    known = with_choices(known, teach) if choices else known
    return _job(0, known, scenes, lessons, grow(teach) if forest else {})


def _job(
    fold: int,
    knowledge: Knowledge,
    scenes: Sequence[Scene],
    lessons: tuple[Scene, ...],
    forest: Forest,
) -> Job:
    everything = cases(scenes, [group.name for group in knowledge.groups])
    known = {name for name, part in knowledge.categories.items() if _enough_examples(part)}
    return Job(
        fold,
        knowledge,
        tuple(case for case in everything if case.box.category in known),
        lessons_of(lessons),
        forest,
        dict(Counter(c.box.category for c in everything if c.box.category not in known)),
    )


def _enough_examples(part: CategoryKnowledge) -> bool:
    fronted = part.category.symmetry is Symmetry.ASYMMETRIC
    return (int(part.front_known.sum()) if fronted else part.examples) >= MIN_EXAMPLES


def taught(scenes: Sequence[Scene], knowledge: Knowledge) -> int:
    """How many of the rooms have taught the knowledge, by their ids."""
    known = {room for part in knowledge.categories.values() for room in part.rooms}
    return sum(scene.id in known for scene in scenes)


def left_out(jobs: Sequence[Job]) -> dict[str, int]:
    """Category -> cases that are not asked. DataError if none is asked."""
    counts: Counter[str] = Counter()
    for job in jobs:
        counts.update(job.left_out)
    if not any(job.cases for job in jobs):
        seen = ", ".join(f"{name} ({count})" for name, count in sorted(counts.items()))
        raise DataError(
            f"Nothing can be asked of these rooms: a category needs {MIN_EXAMPLES} examples to "
            f"learn from, and none has them. They hold {seen or 'nothing to place'}; give more "
            "rooms."
        )
    return dict(sorted(counts.items()))


def _enough(scenes: Sequence[Scene]) -> None:
    if not scenes:
        raise DataError("There is no usable room in these files; give others.")
    if len(scenes) < MIN_ROOMS:
        raise DataError(
            f"An evaluation needs {MIN_ROOMS} usable rooms, and these files hold {len(scenes)}; "
            "give more."
        )
