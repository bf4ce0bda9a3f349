"""Runs an evaluation: cases, systems; on several processes; resumable."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from functools import partial
from hashlib import blake2b
from signal import SIG_IGN, SIGINT, signal

import numpy as np

from scenegen_core.errors import DataError
from scenegen_core.evaluation.bench import Bench, Task
from scenegen_core.evaluation.cases import Case
from scenegen_core.evaluation.jobs import Job
from scenegen_core.evaluation.measure import errors
from scenegen_core.evaluation.physical import physical
from scenegen_core.evaluation.records import Journal, Record
from scenegen_core.evaluation.retrieval import Lesson
from scenegen_core.evaluation.systems import SYSTEMS, System
from scenegen_core.knowledge.knowledge import Knowledge
from scenegen_core.scene.model import Symmetry

CASES_A_TASK = 8  # sent to a process at a time, with the knowledge

Progress = Callable[[int, int], None]
"""Told how many cases are done, of how many."""


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
    deaf = partial(signal, SIGINT, SIG_IGN)  # Ctrl+C is for this process, which ends the others
    pool = ProcessPoolExecutor(workers, initializer=deaf)
    try:
        yield from pool.map(put, missing, chunksize=CASES_A_TASK)
    except BrokenProcessPool:
        raise DataError(
            "A process that was judging has ended, perhaps for want of memory; run the same "
            "command again with --workers 1; with --out it goes on where it stopped."
        ) from None
    finally:
        pool.shutdown(cancel_futures=True)


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
