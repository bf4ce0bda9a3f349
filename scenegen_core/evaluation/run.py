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
from scenegen_core.evaluation.bench import FORMS, Bench, Task
from scenegen_core.evaluation.cases import Case, emptier
from scenegen_core.evaluation.chances import chances
from scenegen_core.evaluation.jobs import Job
from scenegen_core.evaluation.measure import Errors, answer, errors, has_front
from scenegen_core.evaluation.physical import physical
from scenegen_core.evaluation.records import Chances, Journal, Record
from scenegen_core.evaluation.retrieval import Lesson
from scenegen_core.evaluation.systems import SYSTEMS, System
from scenegen_core.evaluation.trees import Forest
from scenegen_core.knowledge.knowledge import Knowledge

CASES_A_TASK = 8  # sent to a process at a time, with the knowledge
EMPTIER: tuple[Task, ...] = ("joint2", "joint3")  # one more is gone, two more are
EMPTIER_SHARE = 0.5  # of the cases that are asked in emptier rooms too; half the time it takes

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
    put = partial(_ask_named, job.knowledge, job.lessons, job.forest, systems, seed, job.fold)
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
    forest: Forest,
    systems: tuple[str, ...],
    seed: int,
    fold: int,
    case: Case,
) -> Record:
    """Ask by the names of the systems: names go to other processes, functions do not."""
    chosen = tuple(system for system in SYSTEMS if system.name in systems)
    return ask(case, knowledge, chosen, lessons=lessons, forest=forest, seed=seed, fold=fold)


def ask(
    case: Case,
    knowledge: Knowledge,
    systems: Sequence[System],
    *,
    lessons: tuple[Lesson, ...] = (),
    forest: Forest | None = None,
    seed: int,
    fold: int = 0,
) -> Record:
    """The errors of systems in one case; the same whichever process and whatever else is asked.

    Where there is no pose to choose from, as for a deep TV in a room without a table, nothing is
    asked.
    """
    bench = Bench(case, knowledge.groups, lessons, forest or {})
    questions = _questions(bench, knowledge, seed)
    found: dict[str, dict[Task, Errors]] = {}
    said: dict[str, Chances] = {}
    for system in systems:
        if system.needs_lessons and not lessons:
            continue
        if system.needs_forest and case.box.category not in (forest or {}):
            continue
        if system.needs_choices and case.box.category not in knowledge.choices:
            continue
        found[system.name] = {}
        for task, bench in questions.items():
            if FORMS[task] not in system.scores:
                continue
            rng = _rng(seed, case.key, system.name, task)
            one = answer(system, task, bench, knowledge, rng)
            found[system.name][task] = errors(one)
            if system.probabilities and task == "joint":
                said[system.name] = chances(one, expects=system.expects)
    return Record(
        case=case.key,
        room=f"{case.source}:{case.scene.id}",
        source=case.source,
        category=case.box.category,
        fold=fold,
        errors=found,
        chances=said,
        truth=physical(bench, case.box),
    )


def _questions(bench: Bench, knowledge: Knowledge, seed: int) -> dict[Task, Bench]:
    """The tasks of a case. Emptier rooms are asked of a share of the cases, both or none."""
    case = bench.case
    questions: dict[Task, Bench] = {"position": bench, "joint": bench}
    if has_front(bench):
        questions["orientation"] = bench
    if _rng(seed, case.key, "emptier").random() < EMPTIER_SHARE:
        names = [group.name for group in knowledge.groups]
        for task, one in zip(EMPTIER, emptier(case, len(EMPTIER), names), strict=False):
            questions[task] = Bench(one, knowledge.groups, bench.lessons, bench.forest)
    return {task: one for task, one in questions.items() if len(one.table(FORMS[task]).candidates)}


def _rng(seed: int, *words: str) -> np.random.Generator:
    text = ":".join((str(seed), *words))
    digest = blake2b(text.encode(), digest_size=8).digest()
    return np.random.default_rng(int.from_bytes(digest, "big"))
