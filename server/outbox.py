"""What waits for a slow reader: commands in order, of everything else the newest."""

from __future__ import annotations

import asyncio
from collections import deque

from msgspec.structs import replace

from server.protocol import (
    Answer,
    AssetHeader,
    Graph,
    HeatMapHeader,
    Inspected,
    Maps,
    Matters,
    Models,
    ServerMessage,
    Weighing,
)
from server.wire import Binary, Close

Frame = ServerMessage | Binary | Close
Unit = tuple[Frame, ...]
"""Frames that travel together or not at all."""

MAX_WAITING = 256  # messages; with more the page's edits are left unread until it has caught up


class Outbox:
    """A queue that stays small.

    Acknowledgements, problems and the like are never lost and go first, so that a result never
    overtakes the acknowledgement of its revision. Results are kept by kind (a model by its
    digest): a newer one replaces the one that waits, and goes last.
    """

    def __init__(self) -> None:
        self._commands: deque[Unit] = deque()
        self._newest: dict[str, Unit] = {}
        self._filled = asyncio.Event()
        self._drained = asyncio.Event()
        self._drained.set()

    def put(self, *unit: Frame) -> None:
        """Queue frames that travel together; the last one says what they are."""
        key = _key(unit[-1])
        if key is None:
            self._commands.append(unit)
        else:
            self._newest[key] = _merged(self._newest.pop(key, None), unit)
        self._update()

    async def get(self) -> Unit:
        """The next frames to send; waits for them."""
        await self._filled.wait()
        if self._commands:
            unit = self._commands.popleft()
        else:
            unit = self._newest.pop(next(iter(self._newest)))
        self._update()
        return unit

    async def has_room(self) -> None:
        """Wait until the reader has caught up."""
        await self._drained.wait()

    def _update(self) -> None:
        _set(self._filled, on=bool(self._commands or self._newest))
        _set(self._drained, on=len(self._commands) < MAX_WAITING)


def _set(event: asyncio.Event, *, on: bool) -> None:
    if on:
        event.set()
    else:
        event.clear()


def _key(frame: Frame) -> str | None:
    """What a frame is the newest of; None for commands."""
    match frame:
        case Answer() | Maps() | Inspected() | Weighing() | Matters() | Graph() | Models():
            return type(frame).__name__
        case Binary(header=AssetHeader(digest=digest)):
            return digest
        case Binary(header=HeatMapHeader()):
            raise TypeError("a heat map travels with the message that ends it; put them together")
        case _:
            return None


def _merged(old: Unit | None, new: Unit) -> Unit:
    """Models of different boxes add up; everything else is replaced."""
    match old, new:
        case (Models(boxes=before),), (Models(boxes=after) as models,):
            return (replace(models, boxes=before | after),)
        case _:
            return new
