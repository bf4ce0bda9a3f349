"""Sessions on disk."""

from __future__ import annotations

import asyncio
import sqlite3
from collections.abc import Awaitable, Callable
from pathlib import Path

import pytest

from scenegen_core.errors import SceneGenError
from scenegen_core.scene.files import scene_of
from server.looks import Look
from server.store import SessionTakenError, Store, Stored
from tests.server.driving import SCENE

DRAWN = scene_of(SCENE)


def with_store(path: Path, story: Callable[[Store], Awaitable[None]]) -> None:
    async def run() -> None:
        store = Store(path)
        try:
            await story(store)
        finally:
            await store.close()

    asyncio.run(run())


def rows(path: Path) -> list[tuple[str, int]]:
    """What another program reads in the file."""
    with sqlite3.connect(path) as database:
        found = database.execute("SELECT id, revision FROM sessions ORDER BY id").fetchall()
    database.close()
    return found


def test_what_was_saved_comes_back_after_a_restart(tmp_path: Path) -> None:
    path = tmp_path / "new folder" / "sessions.sqlite3"

    async def save(store: Store) -> None:
        await store.save("a", Stored(3, DRAWN))

    async def load(store: Store) -> None:
        assert await store.load("a") == Stored(3, DRAWN)
        assert await store.load("b") is None

    with_store(path, save)
    with_store(path, load)


def test_once_saved_it_is_in_the_file_without_closing_the_store(tmp_path: Path) -> None:
    path = tmp_path / "sessions.sqlite3"

    async def save_and_look(store: Store) -> None:
        await store.save("a", Stored(1, DRAWN))
        assert rows(path) == [("a", 1)]

    with_store(path, save_and_look)


def test_many_saves_at_once_keep_the_newest_of_each_session(tmp_path: Path) -> None:
    path = tmp_path / "sessions.sqlite3"

    async def save_many(store: Store) -> None:
        saves = [
            store.save(session, Stored(revision, DRAWN))
            for revision in range(1, 51)
            for session in ("a", "b")
        ]
        await asyncio.gather(*saves)
        assert rows(path) == [("a", 50), ("b", 50)]

    with_store(path, save_many)


def test_a_load_sees_what_is_still_being_saved(tmp_path: Path) -> None:
    async def save_and_load(store: Store) -> None:
        saving = asyncio.create_task(store.save("a", Stored(1, DRAWN)))
        await asyncio.sleep(0)
        assert await store.load("a") == Stored(1, DRAWN)
        await saving

    with_store(tmp_path / "sessions.sqlite3", save_and_load)


def test_who_has_an_older_state_of_a_session_cannot_write_over_a_newer_one(tmp_path: Path) -> None:
    path = tmp_path / "sessions.sqlite3"

    async def two_processes(one: Store) -> None:
        other = Store(path)
        await one.save("a", Stored(1, DRAWN))
        await other.save("a", Stored(2, DRAWN))
        for revision in (1, 2):
            with pytest.raises(SessionTakenError):
                await one.save("a", Stored(revision, DRAWN))
        await one.save("b", Stored(1, DRAWN))
        assert rows(path) == [("a", 2), ("b", 1)]
        await other.close()

    with_store(path, two_processes)


def test_what_a_model_shows_is_known_after_a_restart(tmp_path: Path) -> None:
    path, sofa = tmp_path / "sessions.sqlite3", Look("Sofa", (90, 200, 80), "couch")

    async def keep(store: Store) -> None:
        for _ in range(2):
            store.keep_look("abc", sofa)

    async def recall(store: Store) -> None:
        assert await store.look("abc") == sofa
        assert await store.look("abd") is None

    with_store(path, keep)
    with_store(path, recall)


def test_sessions_untouched_for_a_month_are_removed_at_the_start(tmp_path: Path) -> None:
    path = tmp_path / "sessions.sqlite3"

    async def save(store: Store) -> None:
        await store.save("old", Stored(1, DRAWN))
        await store.save("new", Stored(1, DRAWN))

    async def nothing(_: Store) -> None:
        pass

    with_store(path, save)
    with sqlite3.connect(path) as database:
        database.execute(
            "UPDATE sessions SET updated = datetime('now', '-31 days') WHERE id = 'old'"
        )
    database.close()
    with_store(path, nothing)
    assert rows(path) == [("new", 1)]


def test_a_file_that_cannot_be_one_is_refused_with_what_to_do(tmp_path: Path) -> None:
    path = tmp_path / "notes.txt"
    path.write_text("This is not a database. " * 100)
    with pytest.raises(SceneGenError, match="--store"):
        Store(path)
