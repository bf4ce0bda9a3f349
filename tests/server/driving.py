"""A running server, and a page without a browser that talks to it over its socket."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager, nullcontext
from struct import unpack_from
from threading import Event, Thread
from typing import TypeVar

import msgspec
import pytest
from msgspec import Struct
from starlette.applications import Starlette
from starlette.testclient import TestClient
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import ClientConnection, connect
from websockets.typing import Origin, Subprotocol

from scenegen_core.scene.files import BoxRecord, RoomRecord, SceneRecord
from server.app import make_app
from server.commands.serve import listen
from server.processes import Server
from server.protocol import (
    SUBPROTOCOL,
    AssetHeader,
    ClientMessage,
    FrameHeader,
    HeatMapHeader,
    Hello,
    Problem,
    PutScene,
    ServerMessage,
    Welcome,
)
from server.settings import Settings
from server.world import World

M = TypeVar("M", bound=Struct)
SERVE = (sys.executable, "-m", "server.cli", "serve")
PATIENCE = 60.0  # seconds; only a server that hangs takes longer

ROOM = RoomRecord(corners=((0.0, 0.0), (5.0, 0.0), (5.0, 4.0), (0.0, 4.0)))
TABLE = BoxRecord(id="table", category="Table", center=(2.5, 2.0, 0.35), size=(0.8, 1.2, 0.7))
SCENE = SceneRecord(room=ROOM, boxes=(TABLE,))


class Page:
    """One socket; remembers what came that nobody asked for yet."""

    def __init__(self, socket: ClientConnection) -> None:
        self.socket = socket
        self.frames: list[tuple[FrameHeader, bytes]] = []

    def send(self, *messages: ClientMessage) -> None:
        """Send messages as the page does."""
        for message in messages:
            self.socket.send(msgspec.json.encode(message).decode())

    def next(self) -> ServerMessage | AssetHeader | HeatMapHeader:
        """The next message, or the header of the next binary frame."""
        frame = self.socket.recv(timeout=PATIENCE)
        if isinstance(frame, str):
            message: ServerMessage = msgspec.json.decode(frame, type=ServerMessage)
            return message
        (length,) = unpack_from("<I", frame)
        header: FrameHeader = msgspec.json.decode(frame[4 : 4 + length], type=FrameHeader)
        self.frames.append((header, frame[4 + length :]))
        return header

    def until(self, kind: type[M]) -> M:
        """The next message of a kind; others are skipped, but a problem is none to skip."""
        while True:
            message = self.next()
            if isinstance(message, kind):
                return message
            assert not isinstance(message, Problem), message.text

    def open(self, scene: SceneRecord = SCENE) -> Welcome:
        """Say hello as a new page and upload a scene as edit 1."""
        self.send(Hello(), PutScene(seq=1, scene=scene))
        return self.until(Welcome)


def closed(socket: Page) -> tuple[int, str]:
    """Code and reason of the close that comes; what comes before it is skipped."""
    with pytest.raises(ConnectionClosed) as error:
        _read_on(socket)
    assert error.value.rcvd is not None
    return error.value.rcvd.code, error.value.rcvd.reason


def _read_on(socket: Page) -> None:
    while True:
        socket.next()


@contextmanager
def started(*arguments: str) -> Iterator[tuple[subprocess.Popen[str], str]]:
    """The running program and what it printed before it was ready."""
    with subprocess.Popen(
        [*SERVE, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    ) as process:
        assert process.stdout is not None
        printed = ""
        try:
            while "Stop with" not in printed and (line := process.stdout.readline()):
                printed += line
            yield process, printed
        finally:
            process.kill()


@contextmanager
def serving(settings: Settings, world: World) -> Iterator[str]:
    """A running server: its address, ``ws://...``; afterwards it is stopped."""
    with listen(settings.host, settings.port) as listener:
        ready = Event()
        server = Server(make_app(settings, world), None, ready.set, nullcontext())
        thread = Thread(target=server.run, kwargs={"sockets": [listener]})
        thread.start()
        ready.wait()
        try:
            yield f"ws://127.0.0.1:{listener.getsockname()[1]}"
        finally:
            server.should_exit = True
            thread.join()


def browser(app: Starlette, host: str = "127.0.0.1", url: str = "http://localhost") -> TestClient:
    """A browser that asks for the url, from a machine with that address."""
    return TestClient(
        app,
        base_url=url,
        client=(host, 50000),
        raise_server_exceptions=False,
        follow_redirects=False,
    )


@contextmanager
def page(
    url: str, *, subprotocol: str = SUBPROTOCOL, origin: Origin | None = None
) -> Iterator[Page]:
    """A page's socket to the server at ``ws://...``."""
    with connect(
        f"{url}/socket",
        subprotocols=[Subprotocol(subprotocol)],
        origin=origin,
        max_size=None,
        proxy=None,
    ) as socket:
        yield Page(socket)
