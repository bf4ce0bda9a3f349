"""One socket with its session: carries out what the session wants."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Callable
from functools import partial
from typing import TypeVar, assert_never

from starlette.websockets import WebSocket, WebSocketDisconnect

from scenegen_core.errors import SceneGenError
from server.effects import (
    Deed,
    DrawGraph,
    Examine,
    FindRemedy,
    Furnish,
    Offer,
    Push,
    Save,
    Send,
    Solve,
    StopSolving,
    StopWeighing,
    Weigh,
    Work,
)
from server.engine import Cancel, Engine
from server.incoming import Incoming
from server.outbox import Frame, Outbox
from server.protocol import CLOSE_REPLACED, AssetHeader, Hello, Problem, ServerMessage
from server.results import Step as ResultStep
from server.results import drawn, examined, furnished, graphed, remedied, solved, weighed
from server.session import Session, Step, greet, handle
from server.store import SessionTakenError, Store, Stored
from server.wire import Binary, Close, encode, frame
from server.work import draw_graph, draw_maps, examine, make_models, make_offer, seek_remedy, weigh
from server.world import World

T = TypeVar("T")
REPLACED = "This room was opened elsewhere; reload to go on here."
log = logging.getLogger(__name__)


class Connection:
    """A socket that is open; its session is a value that only this class replaces."""

    def __init__(self, websocket: WebSocket, world: World, store: Store, engine: Engine) -> None:
        self._outbox = Outbox()
        self.incoming = Incoming(websocket, self._outbox)
        self._websocket = websocket
        self._world = world
        self._store = store
        self._engine = engine
        self._loop = asyncio.get_running_loop()
        self._session = Session(id="")

    async def write(self) -> None:
        """Send what is in the outbox until the socket is closed."""
        try:
            while True:
                for item in await self._outbox.get():
                    await self._send(item)
                    if isinstance(item, Close):
                        return
        except (WebSocketDisconnect, RuntimeError):
            return  # closed by the other side or by the server; the reader hears of it too

    def replaced(self) -> None:
        """Close the socket: the session goes on elsewhere."""
        self.incoming.close(CLOSE_REPLACED, REPLACED)
        self._engine.forget(self._session.id)

    async def talk(self, session: Session, hello: Hello) -> None:
        """Serve the session until the socket closes."""
        self._session = session
        await self._take(greet(session, hello, lists=self._world.lists))
        while (message := await self.incoming.next()) is not None:
            try:
                await self._take(handle(self._session, message, self._world.words))
            except Exception:
                log.exception("A message could not be handled")
                self._outbox.put(_internal(getattr(message, "seq", None)))

    async def _take(self, step: Step) -> None:
        """Go on to the next session and carry out what it wants."""
        self._session, effects = step
        for effect in effects:
            if not isinstance(effect, Save):
                self._begin(effect)
                continue
            try:
                await self._store.save(effect.session, Stored(effect.revision, effect.scene))
            except SessionTakenError:
                self.replaced()
                return

    def _take_result(self, step: ResultStep) -> None:
        self._session, deeds = step
        for deed in deeds:
            self._begin(deed)

    def _begin(self, deed: Deed) -> None:
        match deed:
            case Send():
                self._outbox.put(*deed.frames, deed.message)
            case Push():
                self._push(deed.digest)
            case StopSolving():
                self._abandon("maps", "offer", "remedy")
            case StopWeighing():
                self._abandon("weigh")
            case _:
                self._work(deed)

    def _push(self, digest: str) -> None:
        glb, look = self._world.assets.get(digest), self._world.assets.look(digest)
        if look is not None:
            self._store.keep_look(digest, look)
        if glb is not None:
            self._outbox.put(Binary(AssetHeader(digest=digest), glb))

    def _work(self, wish: Work) -> None:
        world = self._world
        match wish:
            case Furnish():
                self._submit("furnish", partial(make_models, world, wish), furnished)
            case Solve():
                self._abandon("offer", "remedy")
                self._submit("maps", partial(draw_maps, world, wish), drawn)
            case Offer():
                self._submit("offer", partial(make_offer, world, wish), solved)
            case FindRemedy():
                self._submit("remedy", partial(seek_remedy, world, wish), remedied)
            case Examine():
                self._submit("examine", partial(examine, wish), examined)
            case Weigh():
                self._submit("weigh", partial(weigh, world, wish, self._tell), weighed)
            case DrawGraph():
                self._submit("graph", partial(draw_graph, world, wish), graphed)
            case _:
                assert_never(wish)

    def _submit(
        self,
        kind: str,
        work: Callable[[Cancel], T],
        step: Callable[[Session, T], ResultStep],
    ) -> None:
        """Have work done; its result is the session's next step."""
        if self.incoming.over:
            return  # the session may belong to another connection by now
        self._engine.submit(
            self._session.id,
            kind,
            work,
            done=lambda result: self._take_result(step(self._session, result)),
            failed=self._failed,
        )

    def _abandon(self, *kinds: str) -> None:
        for kind in kinds:
            self._engine.abandon(self._session.id, kind)

    def _tell(self, message: ServerMessage) -> None:
        """Send a message from another thread."""
        self._loop.call_soon_threadsafe(self._outbox.put, message)

    def _failed(self, error: Exception) -> None:
        if isinstance(error, SceneGenError):
            self._outbox.put(Problem(code="bad_query", text=str(error)))
        else:
            log.error("Work for a session failed", exc_info=error)
            self._outbox.put(_internal(None))

    async def _send(self, item: Frame) -> None:
        match item:
            case Close():
                await self._websocket.close(item.code, item.reason)
            case Binary():
                await self._websocket.send_bytes(frame(item.header, item.payload))
            case _:
                await self._websocket.send_text(encode(item))


def _internal(seq: int | None) -> Problem:
    text = "Something went wrong here; the log of the server says what. Try again."
    return Problem(code="internal", text=text, seq=seq)
