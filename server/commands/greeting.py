"""What the terminal shows when the server is ready."""

from __future__ import annotations

from typing import TYPE_CHECKING
from urllib.parse import urlsplit

from server.joining import Join, bracketed, terminal_code
from server.network import ANY, lan_names
from server.settings import LOCAL_NAMES, Settings
from server.world import World

if TYPE_CHECKING:
    from server.certificate import Certificate

STOP = "Stop with Ctrl+C."


def greeting(
    settings: Settings,
    world: World,
    *,
    port: int,
    join: Join | None = None,
    certificate: Certificate | None = None,
) -> str:
    """What the terminal shows: the addresses, what is loaded, how to stop."""
    host = "localhost" if settings.host in ANY else bracketed(settings.host)
    url = f"{'https' if certificate else 'http'}://{host}:{port}"
    if join is None:
        way = [terminal_code(url), "This address and its code work on this machine only."]
        way.append("To open it on a phone, add --lan (make run LAN=1).")
    else:
        way = [f"On a phone in the same network, scan this or open {join.address}"]
        way += [terminal_code(join.address), "Whoever has this address can join."]
        others = _other_names(join) if settings.host in ANY else []
        if others:
            way.append(f"If it does not open, put another name in it: {', '.join(others)}")
    if certificate is not None:
        way.append(f"Fingerprint of the certificate (SHA-256): {certificate.fingerprint}")
    return "\n".join([f"SceneGen is open at {url}", *way, *_loaded(world), STOP])


def _other_names(join: Join) -> list[str]:
    """What people can type instead of the host that the code has."""
    shown = {urlsplit(join.base).hostname, *LOCAL_NAMES}
    return [name for name in lan_names() if name not in shown and ":" not in name]


def _loaded(world: World) -> list[str]:
    examples = sum(info.examples for info in world.lists.categories)
    known = ", ".join(f"{source.name} ({source.rooms})" for source in world.knowledge.sources)
    rooms = sum(source.rooms for source in world.knowledge.sources)
    lines = [f"Knowledge: {examples} examples from {rooms} rooms: {known}"]
    lines.append(f"Rooms to open: {len(world.rooms)}")
    if world.catalogue.items or world.catalogue.problems:
        lines.append(f"Catalogue: {len(world.catalogue.items)} models")
    return [*lines, *(f"  left out: {problem}" for problem in world.catalogue.problems)]
