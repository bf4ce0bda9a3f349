"""The first minute: a sample room, a sofa on its way into it, and whose choice it is."""

from __future__ import annotations

import re
from collections.abc import Callable
from io import BytesIO

import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import Locator, Page, expect

pytestmark = pytest.mark.browser

THINGS = 10  # web/public/rooms/living-room.json: 8 pieces of furniture, a door, a window
WHERE = re.compile(r"\b(wall|corner|floor)\b")


def things(page: Page) -> Locator:
    return page.get_by_role("listbox", name="Things in the room").get_by_role("option")


def first_steps(page: Page) -> Locator:
    return page.get_by_role("region", name="First steps")


def ask_for_a_sofa(page: Page) -> None:
    page.get_by_role("button", name="Put a sofa in this room").click()
    expect(first_steps(page).get_by_role("button", name="Place it")).to_be_visible()


def stage_pixels(page: Page) -> np.ndarray[tuple[int, ...], np.dtype[np.int16]]:
    """What the room looks like, once it looks the same twice."""
    before = b""
    while (now := page.locator("#stage").screenshot()) != before:
        before = now
        page.wait_for_timeout(300)
    return np.asarray(Image.open(BytesIO(now)).convert("RGB"), dtype=np.int16)


def changed_share(page: Page, act: Callable[[], None]) -> float:
    """The share of the room's pixels that an act changes visibly."""
    before = stage_pixels(page)
    act()
    change = np.abs(stage_pixels(page) - before).max(axis=2)
    return float((change > 12).mean())


def test_the_page_opens_on_the_sample_room(page: Page) -> None:
    expect(things(page)).to_have_count(THINGS)
    expect(page.get_by_text("Where would a sofa go in this room")).to_be_visible()


def test_a_sofa_asked_for_brings_a_sentence_and_nothing_solid(page: Page) -> None:
    ask_for_a_sofa(page)
    expect(first_steps(page).locator("p").first).to_have_text(WHERE)
    expect(things(page)).to_have_count(THINGS)


def test_a_sofa_asked_for_brings_a_heat_map_and_a_ghost(desktop: Page) -> None:
    ask_for_a_sofa(desktop)
    shown = desktop.get_by_role("region", name="What is shown")
    expect(shown.get_by_text("unlikely", exact=True)).to_be_visible()
    assert changed_share(desktop, lambda: desktop.keyboard.press("h")) > 0.01  # the map goes
    assert changed_share(desktop, lambda: desktop.keyboard.press("Escape")) > 0.01  # the ghost too
    expect(things(desktop)).to_have_count(THINGS)


def test_another_place_on_offer_can_be_chosen_by_its_number(page: Page) -> None:
    ask_for_a_sofa(page)
    places = page.get_by_role("list", name="Good places").get_by_role("button")
    expect(places).to_have_count(5)
    expect(places.nth(0)).to_have_attribute("aria-pressed", "true")
    page.keyboard.press("2")
    expect(places.nth(1)).to_have_attribute("aria-pressed", "true")
    expect(places.nth(0)).to_have_attribute("aria-pressed", "false")


def test_manual_keeps_the_object_and_its_size(desktop: Page) -> None:
    ask_for_a_sofa(desktop)
    desktop.get_by_text("Size", exact=True).click()
    size = desktop.get_by_role("group", name="Size").get_by_role("textbox")
    before = [field.input_value() for field in size.all()]
    assert len(before) == 3
    desktop.get_by_role("radio", name="Manual").check(force=True)
    expect(desktop.get_by_role("heading", name="Place a sofa")).to_be_visible()
    expect(desktop.get_by_role("list", name="Good places")).to_have_count(0)
    expect(desktop.get_by_role("button", name="Place it")).to_be_visible()
    assert [field.input_value() for field in size.all()] == before


def test_placing_makes_it_solid_and_undo_takes_it_back(page: Page) -> None:
    ask_for_a_sofa(page)
    page.keyboard.press("Enter")
    expect(things(page)).to_have_count(THINGS + 1)
    expect(things(page).filter(has_text=re.compile(r"\bSofa\b"))).to_have_count(1)
    page.keyboard.press("Control+z")
    expect(things(page)).to_have_count(THINGS)
