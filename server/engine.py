"""Work off the event loop: newest wins, fair among sessions."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import partial
from threading import Event
from time import monotonic
from typing import TypeVar

from scenegen_core.placement.answer import Cancelled

T = TypeVar("T")
Then = Callable[[], None]
"""What is to be done on the event loop when the work is over."""

WORKERS = 3  # threads: one for urgent work; one long answer must not keep all others waiting
URGENT = ("maps", "examine")
"""Kinds of work that go first whoever waits for the rest: what follows a finger."""
PATIENCE = 0.5  # seconds that work may run on when newer work waits: a drag must see maps


@dataclass(frozen=True, slots=True)
class Job:
    """Work for a session."""

    session: str
    kind: str
    run: Callable[[], Then]
    dropped: Event
    """Nobody waits for it any more."""
    superseded: Event
    """Newer work of its kind waits."""


@dataclass(frozen=True, slots=True)
class Cancel:
    """Says whether work should stop: long work asks it now and then."""

    dropped: Event
    superseded: Event
    patience: float
    begun: float

    def __call__(self) -> bool:
        """Does nobody wait for it, or has it taken too long while newer work waits?"""
        too_long = monotonic() - self.begun > self.patience
        return self.dropped.is_set() or (self.superseded.is_set() and too_long)


class Engine:
    """Runs jobs on a few threads; of one session and kind only the newest counts.

    Urgent kinds go first, and one thread does nothing else, if there are several.

    A newer job replaces the one that waits. The one that runs is abandoned if it takes longer than
    ``patience``; otherwise its result still counts, so that a stream of edits sees results on its
    way and not only at its end. Sessions take turns. All methods belong to the event loop.
    """

    def __init__(self, workers: int = WORKERS, *, patience: float = PATIENCE) -> None:
        self._patience = patience
        self._pool = ThreadPoolExecutor(workers, thread_name_prefix="engine")
        self._workers = self._free = workers
        self._waiting: dict[str, dict[str, Job]] = {}  # by session in turn, then by kind
        self._running: dict[tuple[str, str], Job] = {}
        self._busy: set[tuple[str, str]] = set()  # running, or told to stop and still at it
        self._tasks: set[asyncio.Task[None]] = set()

    def submit(
        self,
        session: str,
        kind: str,
        work: Callable[[Cancel], T],
        *,
        done: Callable[[T], None],
        failed: Callable[[Exception], None],
    ) -> None:
        """Do this work instead of older work of the session and kind.

        ``done`` or ``failed`` is called on the event loop, unless the work was abandoned.
        """
        running = self._running.get((session, kind))
        if running is not None:
            running.superseded.set()
        dropped, superseded = Event(), Event()
        cancel = partial(Cancel, dropped, superseded, self._patience)
        run = partial(_run, work, cancel, done, failed)
        self._waiting.setdefault(session, {})[kind] = Job(session, kind, run, dropped, superseded)
        self._start()

    def abandon(self, session: str, kind: str) -> None:
        """Nobody waits for that kind of work any more."""
        self._waiting.get(session, {}).pop(kind, None)
        running = self._running.pop((session, kind), None)
        if running is not None:
            running.dropped.set()

    def forget(self, session: str) -> None:
        """The session is gone."""
        self._waiting.pop(session, None)
        for kind in [kind for owner, kind in self._running if owner == session]:
            self.abandon(session, kind)

    async def close(self) -> None:
        """Stop all work and wait until the threads are idle."""
        for session in {*self._waiting, *(owner for owner, _ in self._running)}:
            self.forget(session)
        await asyncio.gather(*self._tasks)
        self._pool.shutdown()

    def _start(self) -> None:
        """Give the free threads the next jobs."""
        while self._free and (job := self._next()) is not None:
            self._free -= 1
            self._running[job.session, job.kind] = job
            self._busy.add((job.session, job.kind))
            task = asyncio.create_task(self._finish(job))
            self._tasks.add(task)
            task.add_done_callback(self._tasks.discard)

    def _next(self) -> Job | None:
        """The next job of the session whose turn it is, urgent ones first; then others' turn.

        Work that was told to stop and has not yet keeps newer work of its kind waiting: one
        session in a hurry cannot take all threads.
        """
        waiting = ((session, kind) for session, jobs in self._waiting.items() for kind in jobs)
        ready = [one for one in waiting if one not in self._busy]
        urgent = [(session, kind) for session, kind in ready if kind in URGENT]
        slow = sum(kind not in URGENT for _, kind in self._busy)
        may_be_slow = slow < max(self._workers - 1, 1)
        found = next(iter(urgent or (ready if may_be_slow else ())), None)
        if found is None:
            return None
        session, kind = found
        jobs = self._waiting.pop(session)
        self._waiting[session] = jobs  # behind the others
        return jobs.pop(kind)

    async def _finish(self, job: Job) -> None:
        then = await asyncio.get_running_loop().run_in_executor(self._pool, job.run)
        self._free += 1
        self._busy.remove((job.session, job.kind))
        if self._running.get((job.session, job.kind)) is job:
            del self._running[job.session, job.kind]
            then()
        self._start()


def _run(
    work: Callable[[Cancel], T],
    cancel: Callable[[float], Cancel],
    done: Callable[[T], None],
    failed: Callable[[Exception], None],
) -> Then:
    """Do the work on this thread."""
    try:
        return partial(done, work(cancel(monotonic())))
    except Cancelled:
        return _nothing
    except Exception as error:  # noqa: BLE001 (whatever it is, the page must hear of it)
        return partial(failed, error)


def _nothing() -> None:
    pass
