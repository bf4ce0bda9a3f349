"""No server, bad files, a second tab, a bad spot: a clear sentence, and nothing is lost."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

import pytest
from playwright.sync_api import Browser, FilePayload, Page, expect

from tests.e2e.conftest import PATIENCE, ROOT, _free_port, _wait_until_served, take_picture
from tests.e2e.driving import Desk, Record, desk_at

pytestmark = pytest.mark.browser

SQUARE = [[0, 0], [4, 0], [4, 3], [0, 3]]
BOX = {"id": "box-1", "category": "Table", "center": [2, 1.5, 0.4], "size": [0.8, 1.2, 0.8]}


def scene_file(**change: object) -> bytes:
    scene = {"format": "scenegen.scene", "version": 1, "room": {"corners": SQUARE}, "boxes": [BOX]}
    return json.dumps(scene | change).encode()


BEFORE_THE_DOOR = (-2.4, -1.2)  # of the sample living room, metres

BAD_FILES = {
    "half a file": (scene_file()[:60], "part of it is missing"),
    "no JSON at all": (b"\x89PNG\r\n\x1a\n" + bytes(64), "can't be read"),
    "another program's JSON": (b'{"name": "scenegen", "version": "1.0.0"}', "no room in this file"),
    "an outline that crosses itself": (
        scene_file(room={"corners": [[0, 0], [4, 3], [4, 0], [0, 3]]}, boxes=[]),
        "walls do not cross",
    ),
    "ten thousand boxes": (
        scene_file(boxes=[BOX | {"id": f"box-{i}"} for i in range(10_000)]),
        "10000 things in this file; a room holds 500 at most",
    ),
}


@pytest.fixture(scope="module")
def desk(browser: Browser, server_url: str) -> Iterator[Desk]:
    """One page for the tests that need no server of their own."""
    with desk_at(browser, server_url, tolerated="status of 4") as desk:
        desk.open_room("Living room")
        yield desk


@contextmanager
def serving(port: int, directory: Path) -> Iterator[None]:
    """A server on that port with the store of that directory."""
    with (directory / "log.txt").open("ab") as log:
        process = subprocess.Popen(
            [
                sys.executable,
                *("-m", "server.cli", "serve"),
                *("--port", str(port), "--store", str(directory / "sessions.sqlite3")),
            ],
            cwd=ROOT,
            stdout=log,
            stderr=subprocess.STDOUT,
        )
    try:
        _wait_until_served(f"http://127.0.0.1:{port}", process, directory / "log.txt")
        yield
    finally:
        process.kill()  # as when the machine is switched off
        process.wait(timeout=PATIENCE)


@pytest.mark.parametrize("kind", BAD_FILES)
def test_a_bad_file_is_refused_with_a_sentence_and_nothing_is_lost(desk: Desk, kind: str) -> None:
    content, words = BAD_FILES[kind]
    before = desk.saved()
    open_file(desk.page, content)
    expect(desk.toast).to_contain_text(words)
    take_picture(desk.page, f"bad-file-{kind}")
    desk.toast.get_by_role("button", name="Dismiss").click()
    expect(desk.things).to_have_count(10)
    assert desk.saved() == before


def test_a_good_file_opens(desk: Desk) -> None:
    open_file(desk.page, scene_file(name="From a file"))
    scene = desk.wait_for_saved(lambda scene: bool(scene["name"] == "From a file"))
    assert [box["id"] for box in scene["boxes"]] == ["box-1"]
    desk.page.keyboard.press("Control+z")
    desk.wait_for_saved(lambda scene: bool(scene["id"] == "living-room"))


def test_nothing_is_placed_in_the_way_of_a_door_online_or_offline(
    browser: Browser, tmp_path: Path
) -> None:
    port = _free_port()
    with desk_of_its_own(browser, port, tmp_path) as (desk, server):
        desk.open_room("Living room")
        before = desk.saved()["boxes"]
        desk.choose_mode("Manual")
        desk.choose("Chair")
        desk.verdict()
        ghost = desk.last_sent("inspect") or {}
        desk.walk(ghost, {**ghost, "center": BEFORE_THE_DOOR})
        for _ in ("online", "offline"):
            expect(desk.page.locator(".decision .blocked")).to_have_text(
                "It would stand in the way of a door."
            )
            expect(desk.button("Place it")).to_be_disabled()
            desk.page.keyboard.press("Enter")
            expect(desk.toast).to_contain_text("It would stand in the way of a door.")
            desk.toast.get_by_role("button", name="Dismiss").click()
            assert desk.saved()["boxes"] == before
            server.close()
            expect(desk.connection).to_contain_text("Offline")
        take_picture(desk.page, "offline-before-the-door")


def test_what_was_done_while_the_server_was_gone_arrives_when_it_is_back(
    browser: Browser, tmp_path: Path
) -> None:
    port = _free_port()
    with desk_of_its_own(browser, port, tmp_path) as (desk, server):
        desk.open_room("Living room")
        server.close()
        expect(desk.connection).to_contain_text("Offline")
        desk.page.keyboard.press("Escape")
        desk.things.first.focus()
        for _ in range(4):
            desk.page.keyboard.press("ArrowLeft")
        # The TV unit, and the TV on it.
        expect(desk.connection).to_have_text("Offline, 2 changes waiting")
        take_picture(desk.page, "offline")
        desk.heard.clear()
        with serving(port, tmp_path):
            desk.wait_for(lambda: desk.last_heard("ack"), lambda one: one is not None)
            expect(desk.connection).to_have_text("Connected")
            welcome = desk.last_heard("welcome") or {}
            assert welcome["resumed"]
            moved = desk.saved()["boxes"][:2]
            acknowledged = {one["seq"] for one in desk.heard if one["type"] == "ack"}
            arrived = [one for one in desk.sent if one.get("seq") in acknowledged]
            assert [box["label"] for box in moved] == ["TV unit", "TV"]
            assert any(all(box in boxes_of(one) for box in moved) for one in arrived)


def test_of_two_tabs_the_older_one_says_that_it_stopped_and_takes_the_room_back(
    desk: Desk, server_url: str
) -> None:
    other = desk.page.context.new_page()
    other.goto(server_url)
    expect(other.locator(".connection")).to_have_text("Connected")
    sentence = "This room is open elsewhere. Reload to take it back."
    expect(desk.page.locator(".pill").get_by_text(sentence)).to_be_visible()
    take_picture(desk.page, "another-tab")
    desk.page.reload()
    expect(desk.connection).to_have_text("Connected")
    expect(other.locator(".pill").get_by_text(sentence)).to_be_visible()
    other.close()


@contextmanager
def desk_of_its_own(
    browser: Browser, port: int, directory: Path
) -> Iterator[tuple[Desk, ExitStack]]:
    """A page, and its server to be closed."""
    with ExitStack() as server:
        server.enter_context(serving(port, directory))
        url = f"http://127.0.0.1:{port}"
        with desk_at(browser, url, tolerated="ERR_CONNECTION_REFUSED") as desk:
            yield desk, server


def open_file(page: Page, content: bytes) -> None:
    page.locator("button.room-name").click()
    with page.expect_file_chooser() as chooser:
        page.locator("#rooms-menu").get_by_role("button", name="Open file…").click()
    chooser.value.set_files(FilePayload(name="a.json", mimeType="application/json", buffer=content))


def boxes_of(message: Record) -> list[Record]:
    holder = message["scene"] if message["type"] == "put_scene" else message
    boxes: list[Record] = holder.get("boxes", [])
    return boxes
