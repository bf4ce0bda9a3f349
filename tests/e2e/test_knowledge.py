"""What it knows of each kind of furniture: opened, read, switched, closed, with the server gone."""

from __future__ import annotations

import re

import pytest
from playwright.sync_api import Browser, Locator, Page, expect

from scenegen_core.knowledge import default_knowledge
from scenegen_core.knowledge.marginals import marginals
from tests.e2e.conftest import PATIENCE, ROOT
from tests.e2e.driving import desk_at

pytestmark = pytest.mark.browser

AXE = ROOT / "node_modules" / "axe-core" / "axe.min.js"
BEDS = next(part for part in marginals(default_knowledge()).categories if part.category == "Bed")


@pytest.fixture(autouse=True)
def patience() -> None:
    expect.set_options(timeout=PATIENCE * 1000)


def dialog(page: Page) -> Locator:
    return page.get_by_role("dialog", name=re.compile("^What it knows about"))


def serious(page: Page) -> list[str]:
    """What axe finds wrong with the dialog that keeps people out."""
    page.evaluate(AXE.read_text(encoding="utf-8"))
    found = page.evaluate("axe.run('dialog[open]')")["violations"]
    return [one["id"] for one in found if one["impact"] in {"serious", "critical"}]


def test_what_it_knows_can_be_read_and_switched(page: Page) -> None:
    expect(page.locator(".connection")).to_have_text("Connected")
    page.keyboard.press("k")
    beds = BEDS.examples
    expect(dialog(page)).to_contain_text(f"It has seen {beds} beds.")
    for title in ("Where in the room?", "What is within 1 m of it?"):
        expect(dialog(page).get_by_role("list", name=title)).to_be_visible()
    places = dialog(page).get_by_role("list", name="Where in the room?").get_by_role("listitem")
    counts = [f"{place.count} of {beds}" for place in reversed(BEDS.position)]
    expect(places).to_contain_text(counts)
    assert serious(page) == []
    assert dialog(page).evaluate("box => box.scrollWidth <= box.clientWidth")

    dialog(page).get_by_role("button", name="Table", exact=True).click()
    expect(dialog(page).get_by_role("heading", level=2)).to_have_text("What it knows about tables")
    expect(dialog(page)).to_contain_text("It has no front")

    page.keyboard.press("Escape")
    expect(dialog(page)).to_be_hidden()


def test_while_it_is_open_keys_leave_the_room_alone(desktop: Page) -> None:
    expect(desktop.locator(".connection")).to_have_text("Connected")
    desktop.get_by_role("group", name="What to place").get_by_role("button", name="Sofa").click()
    desktop.keyboard.press("k")
    dialog(desktop).get_by_text("It has seen").click()  # takes the focus off the buttons
    desktop.keyboard.press("b")
    desktop.keyboard.press("Escape")
    expect(dialog(desktop)).to_be_hidden()
    expect(desktop.get_by_role("heading", name="Place a sofa")).to_be_visible()


def test_it_can_be_asked_again_when_the_server_is_back(browser: Browser, server_url: str) -> None:
    with desk_at(browser, server_url, tolerated="Failed to load resource") as desk:
        desk.page.context.set_offline(True)
        desk.page.keyboard.press("k")
        expect(dialog(desk.page)).to_contain_text("can't be reached now")
        desk.page.context.set_offline(False)
        desk.button("Try again").press("Enter")
        expect(dialog(desk.page)).to_contain_text("It has seen")
        expect(dialog(desk.page).get_by_role("button", name="Close")).to_be_focused()


def test_once_read_it_needs_no_server(desktop: Page) -> None:
    expect(desktop.locator(".connection")).to_have_text("Connected")
    desktop.keyboard.press("k")
    expect(dialog(desktop)).to_contain_text("It has seen")
    desktop.keyboard.press("Escape")
    desktop.get_by_role("group", name="What to place").get_by_role("button", name="Sofa").click()
    desktop.route("**/knowledge.json", lambda route: route.abort())
    desktop.get_by_role("button", name="What does it know about sofas?").click()
    expect(dialog(desktop)).to_contain_text("sofas. The usual size:")
    desktop.get_by_role("button", name="Close").click()
    expect(dialog(desktop)).to_be_hidden()
