"""``scenegen serve``: the page and its server."""

from __future__ import annotations

import argparse
import asyncio
import signal
import socket
import sys
from collections.abc import Callable
from contextlib import AbstractAsyncContextManager, ExitStack, nullcontext, suppress
from dataclasses import fields, replace
from datetime import UTC, datetime
from functools import partial
from importlib import import_module
from pathlib import Path
from types import FrameType
from typing import TYPE_CHECKING

import uvicorn

from scenegen_core.errors import SceneGenError
from server.app import make_app
from server.commands.greeting import greeting
from server.guide import serving_guide
from server.joining import Join, way_in
from server.network import EVERYWHERE, lan_names
from server.protocol import MAX_TEXT_BYTES
from server.settings import Settings
from server.world import World, load_world

if TYPE_CHECKING:
    from server.certificate import Certificate

Beside = AbstractAsyncContextManager[None]
LAST_PORT = 65535
SWITCH_INTERVAL = 0.0005  # seconds; work in other threads then hardly delays acknowledgements
LARGEST_FRAME = 4 * MAX_TEXT_BYTES  # bytes; up to here a sentence answers, beyond the socket closes


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options of the command."""
    defaults = Settings()
    parser.add_argument("--host", default=defaults.host, help="address to listen on")
    parser.add_argument("--port", type=port, default=defaults.port, help="0 for any free port")
    parser.add_argument(
        "--lan", action="store_true", help="let phones in the same network join, over HTTPS"
    )
    parser.add_argument(
        "--cert", type=Path, metavar="FILE", help="your own certificate for HTTPS (PEM)"
    )
    parser.add_argument("--key", type=Path, metavar="FILE", help="its key, if in another file")
    parser.add_argument("--knowledge", type=Path, metavar="FILE", help="what was learned")
    parser.add_argument("--catalogue", type=Path, metavar="DIR", help="your own models (GLB)")
    parser.add_argument(
        "--store", type=Path, metavar="FILE", default=defaults.store, help="where rooms are kept"
    )
    parser.add_argument(
        "--page", type=Path, metavar="DIR", default=defaults.page, help="the built page"
    )


def run(arguments: argparse.Namespace) -> int:
    """Serve until Ctrl+C; SceneGenError if that cannot begin."""
    sys.setswitchinterval(SWITCH_INTERVAL)
    settings = _settings(arguments)
    certificate = certificate_of(settings)
    world = load_world(settings)
    with ExitStack() as sockets:
        listener = sockets.enter_context(listen(settings.host, settings.port))
        port, guide = listener.getsockname()[1], None
        if certificate is not None and settings.cert is None:
            guide = sockets.enter_context(listen(settings.host, following(settings.port)))
        guide_port = guide.getsockname()[1] if guide else None
        join = way_in(settings, certificate, port=port, guide_port=guide_port)
        text = greeting(settings, world, port=port, join=join, certificate=certificate)
        server = make_server(
            settings,
            world,
            ready=partial(print, text, flush=True),
            join=join,
            certificate=certificate,
            beside=serving_guide(guide, port=port) if guide else nullcontext(),
        )
        signal.signal(signal.SIGTERM, _stop)
        with suppress(KeyboardInterrupt):
            server.run(sockets=[listener])
        print("\nStopped; the rooms are kept.")
    return 0


def certificate_of(settings: Settings) -> Certificate | None:
    """The certificate to serve with, the user's own or a kept one; None for plain HTTP."""
    if settings.cert is None and not settings.lan:
        return None
    # Slow to import, and not needed on one's own machine.
    from server.certificate import kept_certificate, read_certificate  # noqa: PLC0415

    now = datetime.now(UTC)
    if settings.cert is None:
        return kept_certificate(settings.own_cert, lan_names(), now=now)
    return read_certificate(settings.cert, settings.key or settings.cert, now=now)


def listen(host: str, port: int) -> socket.socket:
    """A socket on the address; SceneGenError if another program has it."""
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    both = host == EVERYWHERE == "::"
    try:
        return socket.create_server((host, port), family=family, dualstack_ipv6=both)
    except OSError as error:
        raise SceneGenError(
            f"Port {port} of {host} cannot be used ({error.strerror}). Stop the "
            f"other program, or choose another port: --port {following(port)}"
        ) from None


class Server(uvicorn.Server):
    """A server that says when it is ready, and has something beside it while it runs."""

    def __init__(self, config: uvicorn.Config, ready: Callable[[], None], beside: Beside) -> None:
        super().__init__(config)
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


def make_server(
    settings: Settings,
    world: World,
    *,
    ready: Callable[[], None],
    join: Join | None = None,
    certificate: Certificate | None = None,
    beside: Beside | None = None,
) -> Server:
    """The server, to be run on a socket that listens."""
    config = uvicorn.Config(
        make_app(settings, world, join),
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
    return Server(config, ready, beside or nullcontext())


def _settings(arguments: argparse.Namespace) -> Settings:
    """What the arguments ask for; SceneGenError if they do not go together."""
    settings = Settings(**{f.name: getattr(arguments, f.name) for f in fields(Settings)})
    if settings.key is not None and settings.cert is None:
        raise SceneGenError("--key belongs to a certificate; name that too: --cert FILE")
    if settings.lan and settings.loopback:
        return replace(settings, host=EVERYWHERE)
    return settings


def following(port: int) -> int:
    """The next port; 0, any that is free, after the last one and after 0."""
    return port + 1 if 0 < port < LAST_PORT else 0


def port(text: str) -> int:
    """The number of a port; ValueError if it is none."""
    number = int(text)
    if not 0 <= number <= LAST_PORT:
        raise ValueError(text)
    return number


def _stop(_signal: int, _frame: FrameType | None) -> None:
    """Let SIGTERM end the program as Ctrl+C does."""
    raise KeyboardInterrupt
