"""Every kind of furniture, placed in both modes, in the sample rooms and the scans."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, expect

from tests.e2e.conftest import take_picture
from tests.e2e.driving import Desk, Record, desk_at

pytestmark = pytest.mark.browser

CATEGORIES = ("Sofa", "Table", "Chair", "Bed", "TV", "Picture", "Storage", "Decor")
# name: boxes, doors and windows, as in the scene files
ROOMS = {
    "Living room": 10,
    "Bedroom": 9,
    "Kitchen and dining": 16,
    "Office": 10,
    "Studio": 17,
    "Living room (scan)": 12,
    "Meeting room (scan)": 9,
    "Music room (scan)": 7,
    "Large office (scan)": 20,
    "Small office (scan)": 6,
}
NEAR = (0.0, 0.01, -0.01)  # metres; walls are nearer to a place than keys step


@pytest.fixture(scope="module")
def desk(browser: Browser, server_url: str) -> Iterator[Desk]:
    """One page for all of these tests."""
    with desk_at(browser, server_url) as desk:
        yield desk


@pytest.mark.parametrize(("turn", "room"), list(enumerate(ROOMS)))
def test_every_room_opens_and_takes_what_fits(desk: Desk, turn: int, room: str) -> None:
    desk.open_room(room)
    expect(desk.things).to_have_count(ROOMS[room])
    take_picture(desk.page, f"room-{room}")
    desk.choose_mode("SceneGen")
    for category in CATEGORIES[turn % 2 :: 2]:
        desk.choose(category)
        place_where_offered(desk, category)


@pytest.mark.parametrize("category", CATEGORIES)
def test_scenegen_places_it_where_the_ghost_stands(desk: Desk, category: str) -> None:
    desk.open_room("Living room")
    desk.choose_mode("SceneGen")
    desk.choose(category)
    assert place_where_offered(desk, category), "the sample room has room for everything"


@pytest.mark.parametrize("category", CATEGORIES)
def test_by_hand_it_is_placed_where_it_was_moved_to(desk: Desk, category: str) -> None:
    desk.open_room("Living room")
    before = desk.saved()["boxes"]
    desk.choose_mode("Manual")
    desk.choose(category)
    ghost = move_to_an_allowed_spot(desk)
    assert desk.page.get_by_text("unlikely", exact=True).count() == 0  # no map by hand
    take_picture(desk.page, f"manual-{category}")
    desk.page.keyboard.press("Enter")
    check_placed(desk, before, category, ghost)


def place_where_offered(desk: Desk, category: str) -> bool:
    """Place it on the first place, or read why there is none; undo. Whether it was placed."""
    answer = desk.answer()
    if not answer["placements"]:
        panel = desk.page.get_by_role("complementary", name="Panel")
        expect(
            panel.get_by_text(answer["no_good_place"]["text"]).filter(visible=True)
        ).to_be_visible()
        expect(desk.button("Place it")).to_be_disabled()
        desk.button("Cancel").click()
        return False
    expect(desk.places).to_have_count(len(answer["placements"]))
    expect(desk.places.first).to_have_attribute("aria-pressed", "true")
    before = desk.saved()["boxes"]
    desk.page.keyboard.press("Enter")
    check_placed(desk, before, category, answer["placements"][0])
    return True


def check_placed(desk: Desk, before: list[Record], category: str, ghost: Record) -> None:
    """The newest thing stands where the ghost stood; undo takes it back."""
    count = len(before) + 1
    placed = desk.wait_for_saved(lambda scene: len(scene["boxes"]) == count)["boxes"][-1]
    assert placed["category"] == category
    assert placed["center"] == pytest.approx(ghost["center"], abs=1e-6)
    assert placed["heading"] == pytest.approx(ghost["heading"], abs=1e-6)
    expect(desk.things.filter(has_text=re.compile(rf"\b{category}\b")).last).to_be_attached()
    desk.page.keyboard.press("Control+z")
    after = desk.wait_for_saved(lambda scene: len(scene["boxes"]) < count)
    assert after["boxes"] == before


def move_to_an_allowed_spot(desk: Desk) -> Record:
    """By keys to a place that the server holds possible; what it was last asked about."""
    desk.verdict()
    start = (desk.last_sent("inspect") or {})["center"]
    targets = desk.answer()["placements"]
    for target in sorted(targets, key=lambda target: math.dist(target["center"], start)):
        for dx, dy in ((dx, dy) for dx in NEAR for dy in NEAR):
            desk.verdict()
            ghost = desk.last_sent("inspect") or {}
            x, y, _ = target["center"]
            desk.walk(ghost, {**target, "center": (x + dx, y + dy)})
            if desk.verdict()["allowed"]:
                return desk.last_sent("inspect") or {}
            expect(desk.button("Place it")).to_be_disabled()
    pytest.fail(f"None of {len(targets)} places can be reached by keys")
