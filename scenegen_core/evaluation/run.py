"""Runs an evaluation: folds, cases, systems; on several processes; resumable."""

from __future__ import annotations

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
from scenegen_core.evaluation.records import Journal, Record
from scenegen_core.evaluation.systems import SYSTEMS, System
from scenegen_core.knowledge.knowledge import Knowledge
from scenegen_core.knowledge.learning import learn
from scenegen_core.scene.model import Category, Scene, Symmetry

MIN_ROOMS = 4  # fewer make no evaluation
CASES_A_TASK = 16  # sent to a process at a time, with the knowledge

Progress = Callable[[int, int], None]
"""Told how many cases are done, of how many."""


@dataclass(frozen=True, slots=True)
class Job:
    """Cases to ask with one piece of knowledge."""

    fold: int
    knowledge: Knowledge
    cases: tuple[Case, ...]


def cross_validated(
    scenes: Sequence[Scene], groups: tuple[Category, ...], count: int, *, seed: int
) -> Iterator[Job]:
    """A job a fold: its cases, and the knowledge of the other folds. DataError if too few homes."""
    _enough(scenes)
    parts = folds(scenes, count, rng=np.random.default_rng(seed))
    for index, part in enumerate(parts):
        others = [scene for other in parts if other is not part for scene in other]
        knowledge = learn(others, groups)
        yield Job(index, knowledge, cases(part, knowledge.categories))


def held_out(scenes: Sequence[Scene], knowledge: Knowledge) -> Job:
    """One job: all cases, asked with knowledge that was learnt elsewhere."""
    _enough(scenes)
    return Job(0, knowledge, cases(scenes, knowledge.categories))


def _enough(scenes: Sequence[Scene]) -> None:
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


@dataclass(frozen=True, slots=True)
class Examiner:
    """What cases are asked with."""

    knowledge: Knowledge
    systems: tuple[System, ...]
    seed: int
    fold: int


def _asked(
    job: Job, missing: list[Case], systems: tuple[str, ...], seed: int, workers: int
) -> Iterator[Record]:
    chosen = tuple(system.name for system in SYSTEMS if system.name in systems)
    put = partial(_ask_named, job.knowledge, chosen, seed, job.fold)
    if workers == 1:
        yield from map(put, missing)
        return
    with ProcessPoolExecutor(workers) as pool:
        yield from pool.map(put, missing, chunksize=CASES_A_TASK)


def _ask_named(
    knowledge: Knowledge, systems: tuple[str, ...], seed: int, fold: int, case: Case
) -> Record:
    """Ask by the names of the systems: names go to other processes, functions do not."""
    chosen = tuple(system for system in SYSTEMS if system.name in systems)
    return ask(case, Examiner(knowledge, chosen, seed, fold))


def ask(case: Case, examiner: Examiner) -> Record:
    """The errors of all systems in one case; the same whichever process asks."""
    bench = Bench(case, examiner.knowledge.groups)
    digest = blake2b(f"{examiner.seed}:{case.key}".encode(), digest_size=8).digest()
    rng = np.random.default_rng(int.from_bytes(digest, "big"))
    return Record(
        case=case.key,
        room=case.scene.id,
        source=case.source,
        category=case.box.category,
        fold=examiner.fold,
        errors={
            system.name: {
                task: errors(system, task, bench, examiner.knowledge, rng)
                for task in system.scores
                if _asks(task, bench)
            }
            for system in examiner.systems
        },
    )


def _asks(task: Task, bench: Bench) -> bool:
    """Orientation is asked only of what has a front that is known."""
    box = bench.case.box
    fronted = bench.category.symmetry is Symmetry.ASYMMETRIC and box.front_known
    return task != "orientation" or (fronted and not box.front_from_wall)
