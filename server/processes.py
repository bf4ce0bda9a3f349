"""The processes that serve: this one, or several that share a socket."""

from __future__ import annotations

import asyncio
import socket
import sys
from collections.abc import Callable
from contextlib import AbstractAsyncContextManager
from importlib import import_module
from threading import Thread
from typing import TYPE_CHECKING

import uvicorn
from starlette.applications import Starlette
from uvicorn.supervisors import Multiprocess

from server.app import make_app
from server.joining import Join
from server.protocol import MAX_TEXT_BYTES
from server.settings import Settings
from server.world import load_world

if TYPE_CHECKING:
    from server.certificate import Certificate

Beside = AbstractAsyncContextManager[None]
"""What runs while the server does."""
SWITCH_INTERVAL = 0.0005  # seconds; work in other threads then hardly delays acknowledgements
LARGEST_FRAME = 4 * MAX_TEXT_BYTES  # bytes; up to here a sentence answers, beyond the socket closes
PATIENCE = 60.0  # seconds that a process may take to begin


class Server(uvicorn.Server):
    """Serves from this process; says when it is ready."""

    def __init__(
        self,
        app: Starlette,
        certificate: Certificate | None,
        ready: Callable[[], None],
        beside: Beside,
    ) -> None:
        sys.setswitchinterval(SWITCH_INTERVAL)
        super().__init__(_config(lambda: app, certificate, workers=1))
        self._ready = ready
        self._beside = beside

    async def serve(self, sockets: list[socket.socket] | None = None) -> None:
        """Run until it is told to stop."""
        async with self._beside:
            await super().serve(sockets)

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        """Begin to answer."""
        await super().startup(sockets)
        self._ready()
        # Slow to import; the first room needs it, and the page still has to load before that.
        asyncio.get_running_loop().run_in_executor(None, import_module, "server.furniture")


class Workers(Multiprocess):
    """Serves from processes of their own, each with all that it needs; one that dies is replaced.

    A socket stays with its process. What they share is the store.
    """

    def __init__(
        self,
        app: Callable[[], Starlette],
        count: int,
        certificate: Certificate | None,
        ready: Callable[[], None],
        beside: Beside,
    ) -> None:
        super().__init__(_config(app, certificate, workers=count), [])
        self._ready = ready
        self._beside = beside

    def run_on(self, listener: socket.socket) -> None:
        """Run until a signal says stop."""
        self.sockets = [listener]
        Thread(target=asyncio.run, args=(_forever(self._beside),), daemon=True).start()
        self.run()

    def init_processes(self) -> None:
        """Begin to answer."""
        super().init_processes()
        if all(process.wait_until_ready(PATIENCE, self.should_exit) for process in self.processes):
            self._ready()


def loaded_app(settings: Settings, join: Join | None) -> Starlette:
    """The application, as a process that has nothing yet makes it."""
    sys.setswitchinterval(SWITCH_INTERVAL)
    return make_app(settings, load_world(settings), join)


async def _forever(beside: Beside) -> None:
    async with beside:
        await asyncio.Event().wait()


def _config(
    app: Callable[[], Starlette], certificate: Certificate | None, *, workers: int
) -> uvicorn.Config:
    return uvicorn.Config(
        app,
        factory=True,
        workers=workers,
        ws="websockets-sansio",
        ws_max_size=LARGEST_FRAME,
        ws_per_message_deflate=False,  # frames are small or do not shrink; a bomb cannot grow
        ssl_certfile=certificate.cert if certificate else None,
        ssl_keyfile=certificate.key if certificate else None,
        log_level="warning",
        access_log=False,
        server_header=False,
        timeout_graceful_shutdown=3,
    )
