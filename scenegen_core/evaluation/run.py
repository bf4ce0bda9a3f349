"""Runs an evaluation: folds, cases, systems; on several processes; resumable."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import partial
from hashlib import blake2b

import numpy as np

from scenegen_core.errors import DataError
from scenegen_core.evaluation.bench import Bench, Task
from scenegen_core.evaluation.cases import Case, cases, folds
from scenegen_core.evaluation.measure import errors
from scenegen_core.evaluation.physical import physical
from scenegen_core.evaluation.records import Journal, Record
from scenegen_core.evaluation.retrieval import Lesson, lessons_of
from scenegen_core.evaluation.systems import SYSTEMS, System
from scenegen_core.knowledge.knowledge import MIN_EXAMPLES, CategoryKnowledge, Knowledge
from scenegen_core.knowledge.learning import learn
from scenegen_core.scene.model import Category, Scene, Symmetry

MIN_ROOMS = 4  # fewer make no evaluation
MIN_FOLD = 2  # rooms; an interval by rooms needs two
CASES_A_TASK = 16  # sent to a process at a time, with the knowledge

Progress = Callable[[int, int], None]
"""Told how many cases are done, of how many."""


@dataclass(frozen=True, slots=True)
class Job:
    """Cases to ask with one piece of knowledge."""

    fold: int
    knowledge: Knowledge
    cases: tuple[Case, ...]
    lessons: tuple[Lesson, ...]
    """The rooms that taught the knowledge, where they are at hand."""
    left_out: dict[str, int]
    """Category -> cases not asked, since the knowledge has too few examples of it."""


def cross_validated(
    scenes: Sequence[Scene], groups: tuple[Category, ...], count: int, *, seed: int
) -> Iterator[Job]:
    """A job a fold: its cases, and the knowledge of the other folds. DataError if too few homes."""
    _enough(scenes)
    parts = folds(scenes, count, rng=np.random.default_rng(seed))
    if min(map(len, parts)) < MIN_FOLD:
        raise DataError(
            f"{len(scenes)} rooms in {count} folds leave a fold of one room, which says nothing; "
            "give more rooms, or ask for fewer folds."
        )
    for index, part in enumerate(parts):
        others = tuple(scene for other in parts if other is not part for scene in other)
        yield _job(index, learn(others, groups), part, others)


def held_out(scenes: Sequence[Scene], knowledge: Knowledge, lessons: tuple[Scene, ...] = ()) -> Job:
    """One job: all cases, asked with knowledge that was learned elsewhere."""
    _enough(scenes)
    return _job(0, knowledge, scenes, lessons)


def _job(
    fold: int, knowledge: Knowledge, scenes: Sequence[Scene], lessons: tuple[Scene, ...]
) -> Job:
    everything = cases(scenes, [group.name for group in knowledge.groups])
    known = {name for name, part in knowledge.categories.items() if _enough_examples(part)}
    return Job(
        fold,
        knowledge,
        tuple(case for case in everything if case.box.category in known),
        lessons_of(lessons),
        dict(Counter(c.box.category for c in everything if c.box.category not in known)),
    )


def _enough_examples(part: CategoryKnowledge) -> bool:
    fronted = part.category.symmetry is Symmetry.ASYMMETRIC
    return (int(part.front_known.sum()) if fronted else part.examples) >= MIN_EXAMPLES


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
            f"There are only {len(scenes)} usable rooms in these files, and an evaluation needs "
            f"{MIN_ROOMS}; give more rooms."
        )


def run(
    jobs: Sequence[Job],
    journal: Journal,
    *,
    systems: Sequence[str],
    seed: int,
    workers: int = 1,
    progress: Progress = lambda *_: None,
) -> tuple[Record, ...]:
    """The records of all cases of all jobs, in their order; what the journal knows is kept."""
    total = sum(len(job.cases) for job in jobs)
    found: dict[str, Record] = {}
    for job in jobs:
        names = {case.key for case in job.cases}
        found |= {key: record for key, record in journal.known.items() if key in names}
        missing = [case for case in job.cases if case.key not in found]
        for record in _asked(job, missing, tuple(systems), seed, workers):
            journal.add(record)
            found[record.case] = record
            progress(len(found), total)
    return tuple(found[case.key] for job in jobs for case in job.cases)


def _asked(
    job: Job, missing: list[Case], systems: tuple[str, ...], seed: int, workers: int
) -> Iterator[Record]:
    put = partial(_ask_named, job.knowledge, job.lessons, systems, seed, job.fold)
    if workers == 1:
        yield from map(put, missing)
        return
    with ProcessPoolExecutor(workers) as pool:
        yield from pool.map(put, missing, chunksize=CASES_A_TASK)


def _ask_named(
    knowledge: Knowledge,
    lessons: tuple[Lesson, ...],
    systems: tuple[str, ...],
    seed: int,
    fold: int,
    case: Case,
) -> Record:
    """Ask by the names of the systems: names go to other processes, functions do not."""
    chosen = tuple(system for system in SYSTEMS if system.name in systems)
    return ask(case, knowledge, chosen, lessons=lessons, seed=seed, fold=fold)


def ask(
    case: Case,
    knowledge: Knowledge,
    systems: Sequence[System],
    *,
    lessons: tuple[Lesson, ...] = (),
    seed: int,
    fold: int = 0,
) -> Record:
    """The errors of systems in one case; the same whichever process and whatever else is asked."""
    bench = Bench(case, knowledge.groups, lessons)
    return Record(
        case=case.key,
        room=f"{case.source}:{case.scene.id}",
        source=case.source,
        category=case.box.category,
        fold=fold,
        errors={
            system.name: {
                task: errors(system, task, bench, knowledge, _rng(seed, case, system, task))
                for task in system.scores
                if _asks(task, bench)
            }
            for system in systems
            if lessons or not system.needs_lessons
        },
        truth=physical(bench, case.box),
    )


def _rng(seed: int, case: Case, system: System, task: Task) -> np.random.Generator:
    text = f"{seed}:{case.key}:{system.name}:{task}"
    digest = blake2b(text.encode(), digest_size=8).digest()
    return np.random.default_rng(int.from_bytes(digest, "big"))


def _asks(task: Task, bench: Bench) -> bool:
    """Orientation is asked only of what has a front that is known."""
    box = bench.case.box
    fronted = bench.category.symmetry is Symmetry.ASYMMETRIC and box.front_known
    return task != "orientation" or (fronted and not box.front_from_wall)
