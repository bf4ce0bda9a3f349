"""What comes in on a socket: well-formed messages; the rest is answered, counted, then closed."""

from __future__ import annotations

from time import monotonic

from starlette.websockets import WebSocket

from server.limits import Allowance
from server.outbox import Outbox
from server.protocol import (
    CLOSE_TOO_MANY_ERRORS,
    MAX_ERRORS,
    MAX_MESSAGES_A_SECOND,
    ClientMessage,
    Hello,
    Problem,
)
from server.wire import Close, decode


class Incoming:
    """The messages of a socket; problems go to its outbox."""

    def __init__(self, websocket: WebSocket, outbox: Outbox) -> None:
        self._websocket = websocket
        self._outbox = outbox
        self._allowance = Allowance.full(MAX_MESSAGES_A_SECOND, now=monotonic())
        self._errors = 0
        self.over = False
        """True once a close is on its way: what is still read is ignored."""

    async def hello(self) -> Hello | None:
        """The first message; None if the socket closes before there is one."""
        while (message := await self.next()) is not None:
            if isinstance(message, Hello):
                return message
            self._refuse(Problem(code="bad_message", text="Say hello first.", path="$.type"))
        return None

    async def next(self) -> ClientMessage | None:
        """The next well-formed message; None once the socket is closed."""
        while True:
            await self._outbox.has_room()
            event = await self._websocket.receive()
            if event["type"] == "websocket.disconnect":
                return None
            if self.over:
                continue
            message = _message(event.get("text"))
            if not self._allowance.take(now=monotonic()):
                message = _too_fast(message)
            if not isinstance(message, Problem):
                return message
            self._refuse(message)

    def close(self, code: int, reason: str) -> None:
        """Close the socket behind what waits in the outbox."""
        self.over = True
        self._outbox.put(Close(code, reason))

    def _refuse(self, problem: Problem) -> None:
        """Answer a bad frame; too many of them end the connection."""
        self._outbox.put(problem)
        self._errors += 1
        if self._errors >= MAX_ERRORS:
            self.close(CLOSE_TOO_MANY_ERRORS, "Too many broken messages; reload the page.")


def _message(text: str | None) -> ClientMessage | Problem:
    if text is None:
        return Problem(code="bad_message", text="Pages send text; send messages as JSON.")
    return decode(text)


def _too_fast(message: ClientMessage | Problem) -> Problem:
    return Problem(
        code="too_fast",
        text=f"More than {MAX_MESSAGES_A_SECOND} messages a second; wait a little, send it again.",
        seq=getattr(message, "seq", None),
    )
