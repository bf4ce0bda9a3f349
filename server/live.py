"""The sockets that are open, and which session each one has."""

from __future__ import annotations

import asyncio
from secrets import token_urlsafe

from starlette.websockets import WebSocket

from server.connection import Connection
from server.engine import Engine
from server.limits import Addresses
from server.protocol import (
    CLOSE_TOO_MANY_SESSIONS,
    CLOSE_WRONG_PROTOCOL,
    MAX_SESSIONS_AN_ADDRESS,
    SUBPROTOCOL,
    Hello,
)
from server.session import Session
from server.store import Store
from server.world import World

WRONG_PROTOCOL = "This page and the server are of different versions; reload the page."
TOO_MANY = "Too many pages are open from your address; close one and reload."


class Live:
    """Serves sockets; of a session only the newest one stays open."""

    def __init__(self, world: World, store: Store, engine: Engine) -> None:
        self._world = world
        self._store = store
        self._engine = engine
        self._open: dict[str, Connection] = {}
        self._addresses = Addresses(MAX_SESSIONS_AN_ADDRESS)

    async def serve(self, websocket: WebSocket) -> None:
        """Talk to a page until its socket closes."""
        offered: list[str] = websocket.scope["subprotocols"]
        if SUBPROTOCOL not in offered:
            # A browser shows a close code only if one of its own subprotocols was accepted.
            await websocket.accept(next(iter(offered), None))
            await websocket.close(CLOSE_WRONG_PROTOCOL, WRONG_PROTOCOL)
            return
        await websocket.accept(SUBPROTOCOL)
        address = websocket.client.host if websocket.client else ""
        with self._addresses.enter(address) as allowed:
            if allowed:
                await self._serve(websocket)
            else:
                await websocket.close(CLOSE_TOO_MANY_SESSIONS, TOO_MANY)

    async def _serve(self, websocket: WebSocket) -> None:
        connection = Connection(websocket, self._world, self._store, self._engine)
        async with asyncio.TaskGroup() as tasks:
            writer = tasks.create_task(connection.write())
            hello = await connection.incoming.hello()
            if hello is not None:
                await self._talk(connection, hello)
            writer.cancel()

    async def _talk(self, connection: Connection, hello: Hello) -> None:
        session = await self._session(hello)
        self._replace(session.id)
        self._open[session.id] = connection
        try:
            await connection.talk(session, hello)
        finally:
            if self._open.get(session.id) is connection:
                del self._open[session.id]
                self._engine.forget(session.id)

    async def _session(self, hello: Hello) -> Session:
        """The session that the page had, as it is stored, or a new one."""
        if hello.session is not None:
            self._replace(hello.session)  # before loading: no edit may come after it
            stored = await self._store.load(hello.session)
            if stored is not None:
                return Session(id=hello.session, revision=stored.revision, scene=stored.scene)
        return Session(id=token_urlsafe(12))

    def _replace(self, session: str) -> None:
        """Close the socket that has the session, if there is one."""
        before = self._open.get(session)
        if before is not None:
            before.replaced()
