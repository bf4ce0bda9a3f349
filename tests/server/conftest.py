"""A real server on a free port, and what it has loaded."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from server.settings import Settings
from server.world import World, load_world
from tests.server.driving import serving

ROOM = Path(__file__).parents[1] / "fixtures" / "living_room.json"


@pytest.fixture(scope="session")
def page_files(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A page as it is built: an index, a hashed script, a sample room and a scan."""
    directory = tmp_path_factory.mktemp("page")
    (directory / "index.html").write_text("<title>SceneGen</title>")
    for folder in ("assets", "rooms", "rooms/scans"):
        (directory / folder).mkdir()
    (directory / "assets" / "index-abc123.js").write_text("export {};")
    (directory / "rooms" / "living-room.json").write_bytes(ROOM.read_bytes())
    (directory / "rooms" / "scans" / "scan.json").write_bytes(ROOM.read_bytes())
    return directory


@pytest.fixture(scope="session")
def world(page_files: Path) -> World:
    """What a server with the shipped knowledge has loaded."""
    return load_world(Settings(page=page_files))


@pytest.fixture(scope="session")
def url(world: World, page_files: Path, tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """The address of a server that many tests share."""
    store = tmp_path_factory.mktemp("store") / "sessions.sqlite3"
    with serving(Settings(port=0, store=store, page=page_files), world) as address:
        yield address
