"""``scenegen serve``: the page and its server."""

from __future__ import annotations

import argparse
import io
import signal
import socket
import sys
from collections.abc import Callable
from dataclasses import fields
from functools import partial
from pathlib import Path
from types import FrameType

import segno
import uvicorn

from scenegen_core.errors import SceneGenError
from server.app import make_app
from server.protocol import MAX_TEXT_BYTES
from server.settings import Settings
from server.world import World, load_world

ANY = ("0.0.0.0", "::")  # noqa: S104 (only compared with)
STOP = "Stop with Ctrl+C."
LAST_PORT = 65535
SWITCH_INTERVAL = 0.0005  # seconds; work in other threads then hardly delays acknowledgements
LARGEST_FRAME = 4 * MAX_TEXT_BYTES  # bytes; up to here a sentence answers, beyond the socket closes


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options of the command."""
    defaults = Settings()
    parser.add_argument("--host", default=defaults.host, help="address to listen on")
    parser.add_argument("--port", type=port, default=defaults.port, help="0 for any free port")
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
    settings = Settings(**{f.name: getattr(arguments, f.name) for f in fields(Settings)})
    world = load_world(settings)
    with listen(settings) as listener:
        text = greeting(settings, world, port=listener.getsockname()[1])
        server = make_server(settings, world, ready=partial(print, text, flush=True))
        signal.signal(signal.SIGTERM, _stop)
        try:
            server.run(sockets=[listener])
        except KeyboardInterrupt:
            print("\nStopped; the rooms are kept.")
    return 0


def listen(settings: Settings) -> socket.socket:
    """A socket on the address; SceneGenError if another program has it."""
    family = socket.AF_INET6 if ":" in settings.host else socket.AF_INET
    try:
        return socket.create_server((settings.host, settings.port), family=family)
    except OSError as error:
        raise SceneGenError(
            f"Port {settings.port} of {settings.host} cannot be used ({error.strerror}). Stop the "
            f"other program, or choose another port: --port {settings.port + 1}"
        ) from None


class Server(uvicorn.Server):
    """A server that says when it is ready."""

    def __init__(self, config: uvicorn.Config, ready: Callable[[], None]) -> None:
        super().__init__(config)
        self._ready = ready

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        """Begin to answer."""
        await super().startup(sockets)
        self._ready()


def make_server(settings: Settings, world: World, *, ready: Callable[[], None]) -> Server:
    """The server, to be run on a socket that listens."""
    config = uvicorn.Config(
        make_app(settings, world),
        ws="websockets-sansio",
        ws_max_size=LARGEST_FRAME,
        ws_per_message_deflate=False,  # frames are small or do not shrink; a bomb cannot grow
        log_level="warning",
        access_log=False,
        server_header=False,
        timeout_graceful_shutdown=3,
    )
    return Server(config, ready)


def greeting(settings: Settings, world: World, *, port: int) -> str:
    """What the terminal shows: the address, what is loaded, how to stop."""
    host = "localhost" if settings.host in ANY else settings.host
    host = f"[{host}]" if ":" in host else host
    url = f"http://{host}:{port}"
    note = "This address and its code work on this machine only." if settings.loopback else ""
    return "\n".join(
        filter(None, [f"SceneGen is open at {url}", _qr_code(url), note, *_loaded(world), STOP])
    )


def _loaded(world: World) -> list[str]:
    examples = sum(info.examples for info in world.lists.categories)
    known = ", ".join(f"{source.name} ({source.rooms})" for source in world.knowledge.sources)
    rooms = sum(source.rooms for source in world.knowledge.sources)
    lines = [f"Knowledge: {examples} examples from {rooms} rooms: {known}"]
    lines.append(f"Rooms to open: {len(world.rooms)}")
    if world.catalogue.items or world.catalogue.problems:
        lines.append(f"Catalogue: {len(world.catalogue.items)} models")
    return [*lines, *(f"  left out: {problem}" for problem in world.catalogue.problems)]


def _qr_code(url: str) -> str:
    text = io.StringIO()
    segno.make(url, micro=False).terminal(text, border=2, compact=True)
    return text.getvalue()


def port(text: str) -> int:
    """The number of a port; ValueError if it is none."""
    number = int(text)
    if not 0 <= number <= LAST_PORT:
        raise ValueError(text)
    return number


def _stop(_signal: int, _frame: FrameType | None) -> None:
    """Let SIGTERM end the program as Ctrl+C does."""
    raise KeyboardInterrupt
