"""What a person does with the page, and what can be seen of it: on screen, kept, and sent."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, TypeVar

from playwright.sync_api import (
    Browser,
    ConsoleMessage,
    Locator,
    Page,
    ViewportSize,
    WebSocket,
    expect,
)

from tests.e2e.conftest import PATIENCE

SMALL_DESK: ViewportSize = {"width": 960, "height": 600}  # few pixels to draw, so fast
STEP = 0.05  # metres that an arrow moves a thing
FINE = 0.01  # metres, with Shift
T = TypeVar("T")
QUIET = 150  # milliseconds; the page asks of a new place sooner
SAVED = "() => JSON.parse(localStorage.getItem('scenegen.scene'))"

Record = dict[str, Any]
"""A message or a part of a scene, as JSON has it."""


class Desk:
    """A page that is open, and the messages that went through its sockets."""

    def __init__(self, page: Page) -> None:
        self.page = page
        self.sent: list[Record] = []
        self.heard: list[Record] = []
        page.on("websocket", self._listen)

    def _listen(self, socket: WebSocket) -> None:
        socket.on("framesent", lambda data: _keep(data, self.sent))
        socket.on("framereceived", lambda data: _keep(data, self.heard))

    # --- what can be seen -------------------------------------------------------------------------

    @property
    def things(self) -> Locator:
        """Boxes, doors and windows of the room, as a screen reader has them."""
        return self.page.get_by_role("listbox", name="Things in the room").get_by_role("option")

    @property
    def places(self) -> Locator:
        """The places on offer."""
        return self.page.get_by_role("list", name="Good places").get_by_role("button")

    @property
    def connection(self) -> Locator:
        """The state of the connection in words."""
        return self.page.locator(".connection")

    @property
    def toast(self) -> Locator:
        """What happened, as a sentence."""
        return self.page.locator(".toast")

    def button(self, name: str | re.Pattern[str]) -> Locator:
        """A button by its name."""
        return self.page.get_by_role("button", name=name)

    def middle_of_the_view(self) -> tuple[float, float]:
        """The middle of what the panels leave free of the window, CSS pixels."""
        left, right, top, bottom = (
            self._inset(side) for side in ("left", "right", "top", "bottom")
        )
        width, height = SMALL_DESK["width"], SMALL_DESK["height"]
        return (left + width - right) / 2, (top + height - bottom) / 2

    def _inset(self, side: str) -> float:
        style = "getComputedStyle(document.documentElement)"
        inset: float = self.page.evaluate(f"parseFloat({style}.getPropertyValue('--inset-{side}'))")
        return inset

    # --- what is kept and sent --------------------------------------------------------------------

    def saved(self) -> Record:
        """The scene that this device remembers."""
        scene: Record = self.page.evaluate(SAVED)
        return scene

    def wait_for_saved(self, right: Callable[[Record], bool]) -> Record:
        """The scene that this device remembers, once it is as it should be."""
        return self.wait_for(self.saved, right)

    def wait_for(self, look: Callable[[], T], right: Callable[[T], bool]) -> T:
        """What is seen once it is right."""
        tries = 600
        while not right(seen := look()):
            tries -= 1
            assert tries, f"This stays: {seen}"
            self.page.wait_for_timeout(50)
        return seen

    def last_sent(self, kind: str) -> Record | None:
        """The newest message of a kind that the page sent."""
        return next((one for one in reversed(self.sent) if one["type"] == kind), None)

    def last_heard(self, kind: str) -> Record | None:
        """The newest message of a kind that the server sent."""
        return next((one for one in reversed(self.heard) if one["type"] == kind), None)

    def answer(self) -> Record:
        """The answer to the ask in force, once it is there."""
        ask = self.wait_for(lambda: self.last_sent("ask"), lambda one: one is not None)
        found = self.wait_for(
            lambda: self.last_heard("answer"),
            lambda one: bool(one and ask and one["ask"] == ask["id"]),
        )
        assert found is not None
        return found

    def verdict(self) -> Record:
        """What the server says of where the ghost stands now: nothing else is asked after it."""
        while True:
            told = self.wait_for(self._verdict, lambda one: one is not None) or {}
            self.page.wait_for_timeout(QUIET)
            if told == self._verdict():
                return told

    def _verdict(self) -> Record | None:
        asked, told = self.last_sent("inspect"), self.last_heard("inspected")
        return told if asked and told and asked["id"] == told["id"] else None

    # --- what is done -----------------------------------------------------------------------------

    def close_greeting(self) -> None:
        """Waits for the server and sends the first steps away."""
        expect(self.connection).to_have_text("Connected")
        close = self.page.get_by_role("region", name="First steps").get_by_role(
            "button", name="Close"
        )
        if close.count():
            close.click()

    def open_room(self, name: str) -> None:
        """Opens a room from the menu of rooms."""
        self.wait_for(self._edits_sent, lambda count: count > 0)  # the room that it begins with
        self.wait_until_stored()
        before = self._edits_sent()
        self.page.locator("button.room-name").click()
        menu = self.page.locator("#rooms-menu")
        menu.get_by_role("button", name=re.compile(rf"^{re.escape(name)} \d")).click()
        expect(menu).to_be_hidden()
        self.wait_for_saved(lambda scene: bool(scene["name"] == name))
        expect(self.page.locator("button.room-name")).to_have_text(name)
        self.wait_for(self._edits_sent, lambda count: count > before)
        self.wait_until_stored()

    def wait_until_stored(self) -> None:
        """Until the server has acknowledged all that it was sent."""
        self.wait_for(self._waiting, lambda waiting: not waiting)
        expect(self.connection).to_have_text("Connected")

    def _edits_sent(self) -> int:
        return sum("seq" in one for one in self.sent)

    def _waiting(self) -> set[int]:
        told = {one["seq"] for one in self.heard if one["type"] == "ack"}
        return {one["seq"] for one in self.sent if "seq" in one} - told

    def choose_mode(self, mode: str) -> None:
        """SceneGen or Manual."""
        self.page.get_by_role("radio", name=mode).check(force=True)

    def choose(self, category: str) -> None:
        """Picks what to place."""
        chips = self.page.get_by_role("group", name="What to place")
        chips.get_by_role("button", name=category, exact=True).click()
        expect(self.button("Cancel")).to_be_visible()

    def walk(self, start: Record, to: Record) -> None:
        """Moves and turns the ghost by keys, to within half a step and half a degree."""
        turn = math.degrees(to["heading"] - start["heading"])
        degrees = round((turn + 180) % 360 - 180)
        coarse, fine = divmod(abs(degrees), 15)
        self._press("[" if degrees > 0 else "]", coarse)
        self._press("{" if degrees > 0 else "}", fine)
        for axis, (less, more) in enumerate((("Left", "Right"), ("Down", "Up"))):
            way = to["center"][axis] - start["center"][axis]
            key = f"Arrow{more if way > 0 else less}"
            steps, rest = divmod(round(abs(way) / FINE), round(STEP / FINE))
            self._press(key, steps)
            self._press(f"Shift+{key}", rest)

    def _press(self, key: str, times: int) -> None:
        for _ in range(times):
            self.page.keyboard.press(key)


@contextmanager
def desk_at(
    browser: Browser, url: str, *, tolerated: str | None = None, before: str = ""
) -> Iterator[Desk]:
    """A page on a desktop, greeted and connected; it must complain of nothing but what is told.

    ``before`` is a script that runs ahead of the page's own.
    """
    expect.set_options(timeout=PATIENCE * 1000)
    context = browser.new_context(viewport=SMALL_DESK, reduced_motion="reduce")
    page = context.new_page()
    page.set_default_timeout(PATIENCE * 1000)
    complaints: list[str] = []

    def listen(message: ConsoleMessage) -> None:
        known = tolerated is not None and tolerated in message.text
        if message.type == "error" and not known:
            complaints.append(message.text)

    page.on("console", listen)
    page.on("pageerror", lambda error: complaints.append(str(error)))
    page.add_init_script(before)
    desk = Desk(page)
    page.goto(url)
    desk.close_greeting()
    yield desk
    context.close()
    assert complaints == []


def _keep(data: str | bytes, messages: list[Record]) -> None:
    if isinstance(data, str):
        messages.append(json.loads(data))
