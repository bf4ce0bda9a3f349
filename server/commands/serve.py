"""``scenegen serve``: the page and its server."""

from __future__ import annotations

import argparse
import signal
import socket
from contextlib import ExitStack, nullcontext, suppress
from dataclasses import fields, replace
from datetime import UTC, datetime
from functools import partial
from pathlib import Path
from types import FrameType
from typing import TYPE_CHECKING

from scenegen_core.errors import SceneGenError
from server.app import make_app
from server.commands.greeting import greeting
from server.guide import serving_guide
from server.joining import way_in
from server.network import EVERYWHERE, lan_names
from server.processes import Server, Workers, loaded_app
from server.settings import Settings
from server.world import load_world

if TYPE_CHECKING:
    from server.certificate import Certificate

LAST_PORT = 65535


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options of the command."""
    defaults = Settings()
    parser.add_argument("--host", default=defaults.host, help="address to listen on")
    parser.add_argument("--port", type=port, default=defaults.port, help="0 for any free port")
    parser.add_argument(
        "--workers", type=count, default=defaults.workers, metavar="N", help="processes that serve"
    )
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
        ready = partial(print, text, flush=True)
        beside = serving_guide(guide, port=port) if guide else nullcontext()
        signal.signal(signal.SIGTERM, _stop)
        with suppress(KeyboardInterrupt):
            if settings.workers == 1:
                app = make_app(settings, world, join)
                Server(app, certificate, ready, beside).run(sockets=[listener])
            else:
                loaded = partial(loaded_app, settings, join)
                Workers(loaded, settings.workers, certificate, ready, beside).run_on(listener)
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
    """A socket on the address; SceneGenError if another program has it.

    Its connections send each message at once: else a map that follows an acknowledgment waits up to
    40 ms for the other side to have acknowledged that.
    """
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    both = host == EVERYWHERE == "::"
    try:
        listener = socket.create_server((host, port), family=family, dualstack_ipv6=both)
    except OSError as error:
        raise SceneGenError(
            f"Port {port} of {host} cannot be used ({error.strerror}). Stop the "
            f"other program, or choose another port: --port {following(port)}"
        ) from None
    listener.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, True)
    return listener


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


def count(text: str) -> int:
    """A number of processes; ValueError if it is none."""
    number = int(text)
    if number < 1:
        raise ValueError(text)
    return number


def port(text: str) -> int:
    """The number of a port; ValueError if it is none."""
    number = int(text)
    if not 0 <= number <= LAST_PORT:
        raise ValueError(text)
    return number


def _stop(_signal: int, _frame: FrameType | None) -> None:
    """Let SIGTERM end the program as Ctrl+C does."""
    raise KeyboardInterrupt
