"""Sessions on disk: one SQLite file, one row a session, written before an edit is acknowledged.

Several processes may share the file: who has a session loaded writes only what is newer than what
is there, so that of two sockets with one session in two processes the older cannot undo anything.
"""

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
from server.looks import Look

P = ParamSpec("P")
T = TypeVar("T")

KEPT = 30  # days; sessions that nobody touched for longer are removed at the start
SCHEMA = """
CREATE TABLE IF NOT EXISTS sessions (
    id TEXT PRIMARY KEY, revision INTEGER NOT NULL, scene BLOB NOT NULL, updated TEXT NOT NULL
);
CREATE TABLE IF NOT EXISTS models (
    digest TEXT PRIMARY KEY, look BLOB NOT NULL, updated TEXT NOT NULL
)"""
WRITE = """
INSERT INTO sessions VALUES (?, ?, ?, datetime('now')) ON CONFLICT (id) DO UPDATE
SET revision = excluded.revision, scene = excluded.scene, updated = excluded.updated
WHERE excluded.revision > sessions.revision"""
READ = "SELECT revision, scene FROM sessions WHERE id = ?"
KEEP_LOOK = "INSERT OR REPLACE INTO models VALUES (?, ?, datetime('now'))"
READ_LOOK = "SELECT look FROM models WHERE digest = ?"
PRUNE = (
    "DELETE FROM sessions WHERE updated < datetime('now', ?)",
    "DELETE FROM models WHERE updated < datetime('now', ?)",
)


class SessionTakenError(Exception):
    """Another process has written a newer state of the session."""


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
        self._next: asyncio.Task[frozenset[str]] | None = None
        self._looks: set[str] = set()
        self._writing = asyncio.Lock()
        try:
            self._database = self._thread.submit(_open, path).result()
        except (OSError, sqlite3.Error) as error:
            self._thread.shutdown()
            raise SceneGenError(
                f"Rooms cannot be kept in {path}: {error}. Choose another file with --store."
            ) from None

    async def save(self, session: str, stored: Stored) -> None:
        """Return once this state of the session, or a newer one, is on disk.

        SessionTakenError if another process goes on with the session.
        """
        self._waiting[session] = stored
        if self._next is None:
            self._next = asyncio.create_task(self._commit())
        if session in await asyncio.shield(self._next):
            raise SessionTakenError

    async def load(self, session: str) -> Stored | None:
        """The session as it was saved last; None if it is unknown."""
        async with self._writing:
            waiting = self._waiting.get(session)
            return waiting or await self._run(_read, self._database, session)

    def keep_look(self, digest: str, look: Look) -> None:
        """Remember what a model shows, soon: other processes, and later ones, can make it again."""
        if digest not in self._looks:
            self._looks.add(digest)
            self._thread.submit(_keep_look, self._database, digest, look)

    async def look(self, digest: str) -> Look | None:
        """What a model shows; None if no such model was ever sent."""
        return await self._run(_read_look, self._database, digest)

    async def close(self) -> None:
        """Write what waits and close the file."""
        if self._next is not None:
            await self._next
        await self._run(self._database.close)
        self._thread.shutdown()

    async def _commit(self) -> frozenset[str]:
        async with self._writing:
            batch, self._waiting, self._next = self._waiting, {}, None
            return await self._run(_write, self._database, batch)

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
        database.executescript(SCHEMA)
        for statement in PRUNE:
            database.execute(statement, (f"-{KEPT} days",))
    return database


def _write(database: sqlite3.Connection, batch: dict[str, Stored]) -> frozenset[str]:
    """Write what is newer than what is there; the sessions of which it is not."""
    taken = set()
    with database:
        for session, stored in batch.items():
            scene = msgspec.json.encode(record_of(stored.scene))
            if database.execute(WRITE, (session, stored.revision, scene)).rowcount == 0:
                taken.add(session)
    return frozenset(taken)


def _keep_look(database: sqlite3.Connection, digest: str, look: Look) -> None:
    with database:
        database.execute(KEEP_LOOK, (digest, msgspec.json.encode(look)))


def _read_look(database: sqlite3.Connection, digest: str) -> Look | None:
    row = database.execute(READ_LOOK, (digest,)).fetchone()
    return None if row is None else msgspec.json.decode(row[0], type=Look)


def _read(database: sqlite3.Connection, session: str) -> Stored | None:
    row = database.execute(READ, (session,)).fetchone()
    return None if row is None else Stored(row[0], scene_of(decode_scene(row[1])))
