"""Sessions on disk: one SQLite file, one row a session, written before an edit is acknowledged."""

from __future__ import annotations

import asyncio
import sqlite3
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import ParamSpec, TypeVar

import msgspec

from scenegen_core.errors import SceneGenError
from scenegen_core.scene.files import decode_scene, record_of, scene_of
from scenegen_core.scene.model import Scene

P = ParamSpec("P")
T = TypeVar("T")

KEPT = 30  # days; sessions that nobody touched for longer are removed at the start
SCHEMA = """
CREATE TABLE IF NOT EXISTS sessions (
    id TEXT PRIMARY KEY, revision INTEGER NOT NULL, scene BLOB NOT NULL, updated TEXT NOT NULL
)"""
WRITE = """
INSERT INTO sessions VALUES (?, ?, ?, datetime('now')) ON CONFLICT (id) DO UPDATE
SET revision = excluded.revision, scene = excluded.scene, updated = excluded.updated"""
READ = "SELECT revision, scene FROM sessions WHERE id = ?"
PRUNE = "DELETE FROM sessions WHERE updated < datetime('now', ?)"


@dataclass(frozen=True, slots=True)
class Stored:
    """A session as it was saved last."""

    revision: int
    scene: Scene


class Store:
    """Sessions in a file.

    One thread writes, one commit at a time. What is saved meanwhile is committed together next,
    of each session only the newest state: a drag stays cheap however fast it is.
    """

    def __init__(self, path: Path) -> None:
        """Open or make the file; SceneGenError if that cannot be."""
        self._thread = ThreadPoolExecutor(1, thread_name_prefix="store")
        self._waiting: dict[str, Stored] = {}
        self._next: asyncio.Task[None] | None = None
        self._writing = asyncio.Lock()
        try:
            self._database = self._thread.submit(_open, path).result()
        except (OSError, sqlite3.Error) as error:
            self._thread.shutdown()
            raise SceneGenError(
                f"Rooms cannot be kept in {path}: {error}. Choose another file with --store."
            ) from None

    async def save(self, session: str, stored: Stored) -> None:
        """Return once this state of the session, or a newer one, is on disk."""
        self._waiting[session] = stored
        if self._next is None:
            self._next = asyncio.create_task(self._commit())
        await asyncio.shield(self._next)

    async def load(self, session: str) -> Stored | None:
        """The session as it was saved last; None if it is unknown."""
        async with self._writing:
            waiting = self._waiting.get(session)
            return waiting or await self._run(_read, self._database, session)

    async def close(self) -> None:
        """Write what waits and close the file."""
        if self._next is not None:
            await self._next
        await self._run(self._database.close)
        self._thread.shutdown()

    async def _commit(self) -> None:
        async with self._writing:
            batch, self._waiting, self._next = self._waiting, {}, None
            await self._run(_write, self._database, batch)

    async def _run(self, work: Callable[P, T], *args: P.args, **named: P.kwargs) -> T:
        loop = asyncio.get_running_loop()
        return await loop.run_in_executor(self._thread, partial(work, *args, **named))


def _open(path: Path) -> sqlite3.Connection:
    path.parent.mkdir(parents=True, exist_ok=True)
    database = sqlite3.connect(path)
    # A write-ahead log with synchronous=NORMAL loses nothing when the process dies; only a power
    # cut can lose the last moments (never corrupt the file), and then the page still has them.
    database.execute("PRAGMA journal_mode = WAL")
    database.execute("PRAGMA synchronous = NORMAL")
    with database:
        database.execute(SCHEMA)
        database.execute(PRUNE, (f"-{KEPT} days",))
    return database


def _write(database: sqlite3.Connection, batch: dict[str, Stored]) -> None:
    rows = [
        (session, stored.revision, msgspec.json.encode(record_of(stored.scene)))
        for session, stored in batch.items()
    ]
    with database:
        database.executemany(WRITE, rows)


def _read(database: sqlite3.Connection, session: str) -> Stored | None:
    row = database.execute(READ, (session,)).fetchone()
    return None if row is None else Stored(row[0], scene_of(decode_scene(row[1])))
