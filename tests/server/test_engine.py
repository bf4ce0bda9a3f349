"""Work off the event loop: the newest wins, sessions take turns, failures are told."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable
from threading import Event, current_thread

from scenegen_core.placement.answer import Cancelled
from server.engine import Cancel, Engine

Result = int | str | Exception


class Desk:
    """An engine with one thread, and what it was done with, in order."""

    def __init__(self, engine: Engine) -> None:
        self.engine = engine
        self.results: list[Result] = []
        self.changed = asyncio.Event()

    def submit(self, session: str, kind: str, work: Callable[[Cancel], Result]) -> None:
        self.engine.submit(session, kind, work, done=self.note, failed=self.note)

    def note(self, result: Result) -> None:
        self.results.append(result)
        self.changed.set()

    async def until(self, count: int) -> list[Result]:
        while len(self.results) < count:
            self.changed.clear()
            await self.changed.wait()
        return self.results


def at_a_desk(
    story: Callable[[Desk], Awaitable[None]], *, workers: int = 1, patience: float = 0
) -> None:
    async def run() -> None:
        engine = Engine(workers, patience=patience)
        await story(Desk(engine))
        await engine.close()

    asyncio.run(run())


class Gate:
    """Work that waits to be let through, unless it is cancelled before."""

    def __init__(self, result: Result) -> None:
        self.result = result
        self.begun = Event()
        self.open = Event()
        self.stopped = Event()

    def work(self, cancelled: Cancel) -> Result:
        self.begun.set()
        while not self.open.wait(0.005):
            if cancelled():
                self.stopped.set()
                raise Cancelled
        return self.result

    async def has_begun(self) -> None:
        await asyncio.to_thread(self.begun.wait)


def returning(result: Result) -> Callable[[Cancel], Result]:
    return lambda _: result


def fail(_: Cancel) -> Result:
    raise ValueError("no floor")


NEVER = Cancel(Event(), Event(), patience=3600, begun=0)


def test_work_is_done_off_the_event_loop_and_its_result_comes_back() -> None:
    async def story(desk: Desk) -> None:
        desk.submit("a", "solve", lambda _: current_thread().name)
        (name,) = await desk.until(1)
        assert name != current_thread().name

    at_a_desk(story)


def test_newer_work_stops_the_older_that_takes_too_long() -> None:
    async def story(desk: Desk) -> None:
        older = Gate("older")
        desk.submit("a", "solve", older.work)
        await older.has_begun()
        desk.submit("a", "solve", returning("newer"))
        assert await desk.until(1) == ["newer"]
        assert older.stopped.is_set()

    at_a_desk(story)


def test_in_a_stream_of_edits_a_result_on_the_way_counts_and_then_the_newest() -> None:
    async def story(desk: Desk) -> None:
        first = Gate("first")
        desk.submit("a", "solve", first.work)
        await first.has_begun()
        for number in range(10):
            desk.submit("a", "solve", returning(number))
        first.open.set()
        assert await desk.until(2) == ["first", 9]

    at_a_desk(story, patience=3600)


def test_the_result_of_work_that_was_dropped_while_it_ran_is_never_heard_of() -> None:
    async def story(desk: Desk) -> None:
        deaf = Gate("older")
        desk.submit("a", "solve", lambda _: deaf.work(NEVER))
        await deaf.has_begun()
        desk.engine.abandon("a", "solve")
        desk.submit("a", "solve", returning("newer"))
        deaf.open.set()
        assert await desk.until(1) == ["newer"]

    at_a_desk(story)


def test_of_the_work_that_waits_only_the_newest_is_done() -> None:
    async def story(desk: Desk) -> None:
        busy = Gate("busy")
        desk.submit("b", "solve", busy.work)
        for number in range(10):
            desk.submit("a", "solve", returning(number))
        busy.open.set()
        assert await desk.until(2) == ["busy", 9]

    at_a_desk(story)


def test_different_kinds_of_work_do_not_replace_each_other() -> None:
    async def story(desk: Desk) -> None:
        desk.submit("a", "solve", returning("answer"))
        desk.submit("a", "graph", returning("graph"))
        assert sorted(map(str, await desk.until(2))) == ["answer", "graph"]

    at_a_desk(story)


def test_sessions_take_turns() -> None:
    async def story(desk: Desk) -> None:
        busy = Gate("busy")
        desk.submit("a", "first", busy.work)
        for kind in ("second", "third"):
            desk.submit("a", kind, returning(f"a {kind}"))
        desk.submit("b", "first", returning("b first"))
        busy.open.set()
        assert await desk.until(4) == ["busy", "a second", "b first", "a third"]

    at_a_desk(story)


def test_a_session_in_a_hurry_leaves_a_thread_to_the_others() -> None:
    """Its old work does not hear that it is to stop, its newer work waits for that."""

    async def story(desk: Desk) -> None:
        deaf = Gate("older")
        desk.submit("a", "maps", lambda _: deaf.work(NEVER))
        await deaf.has_begun()
        desk.submit("a", "maps", returning("newer"))
        desk.submit("b", "maps", returning("other session"))
        assert await desk.until(1) == ["other session"]
        deaf.open.set()
        assert await desk.until(3) == ["other session", "older", "newer"]

    at_a_desk(story, workers=2)


def test_maps_go_before_the_offers_of_all_sessions() -> None:
    async def story(desk: Desk) -> None:
        busy = Gate("busy")
        desk.submit("a", "offer", busy.work)
        for session in ("a", "b"):
            for kind in ("graph", "maps"):
                desk.submit(session, kind, returning(f"{session} {kind}"))
        busy.open.set()
        assert await desk.until(5) == ["busy", "a maps", "b maps", "a graph", "b graph"]

    at_a_desk(story)


def test_however_much_slow_work_there_is_a_thread_is_left_for_maps() -> None:
    async def story(desk: Desk) -> None:
        slow = [Gate("first"), Gate("second")]
        for session, gate in zip("ab", slow, strict=True):
            desk.submit(session, "offer", gate.work)
        await slow[0].has_begun()
        desk.submit("c", "maps", returning("maps"))
        assert await desk.until(1) == ["maps"]
        assert not slow[1].begun.is_set()
        for gate in slow:
            gate.open.set()
        assert await desk.until(3) == ["maps", "first", "second"]

    at_a_desk(story, workers=2)


def test_a_failure_is_told_and_the_next_work_is_done() -> None:
    async def story(desk: Desk) -> None:
        desk.submit("a", "solve", fail)
        desk.submit("b", "solve", returning("fine"))
        error, fine = await desk.until(2)
        assert isinstance(error, ValueError)
        assert fine == "fine"

    at_a_desk(story)


def test_the_work_of_a_session_that_is_gone_stops() -> None:
    async def story(desk: Desk) -> None:
        running = Gate("running")
        desk.submit("a", "solve", running.work)
        await running.has_begun()
        desk.submit("a", "graph", returning("waiting"))
        desk.engine.forget("a")
        desk.submit("b", "solve", returning("other session"))
        assert await desk.until(1) == ["other session"]
        assert running.stopped.is_set()

    at_a_desk(story)


def test_closing_stops_what_runs() -> None:
    async def close_while_running() -> None:
        engine, running = Engine(workers=1), Gate("never")
        desk = Desk(engine)
        desk.submit("a", "solve", running.work)
        await running.has_begun()
        await engine.close()
        assert running.stopped.is_set()
        assert desk.results == []

    asyncio.run(close_while_running())
