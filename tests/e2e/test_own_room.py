"""A room of one's own: its outline, what stands in it, and what leaves it as a file."""

from __future__ import annotations

import io
import json
import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from PIL import Image
from playwright.sync_api import Browser, Download, expect

from tests.e2e.conftest import take_picture
from tests.e2e.driving import Desk, desk_at

pytestmark = pytest.mark.browser

# Where the outline is clicked from above, CSS pixels: 4 wide for 3 high.
OUTLINE = ((260, 160), (500, 160), (500, 340), (260, 340))

BLANK = [[0, 0], [5, 0], [5, 4], [0, 4]]  # the room before it is drawn, metres


@pytest.fixture(scope="module")
def desk(browser: Browser, server_url: str) -> Iterator[Desk]:
    """One page for all of these tests."""
    with desk_at(browser, server_url) as desk:
        yield desk


def new_room(desk: Desk) -> None:
    desk.page.keyboard.press("Escape")
    desk.wait_for_saved(bool)
    before = desk.saved()["id"]
    desk.page.locator("button.room-name").click()
    desk.page.locator("#rooms-menu").get_by_role("button", name="New room").click()
    desk.wait_for_saved(lambda scene: bool(scene["id"] != before and not scene["boxes"]))
    expect(desk.page.get_by_role("heading", name="Draw the room")).to_be_visible()


def draw_with_pointer(desk: Desk) -> None:
    """A new room of four corners, seen from above."""
    new_room(desk)
    desk.button("Above").click()
    mouse = desk.page.mouse
    for x, y in (*OUTLINE, OUTLINE[0]):
        mouse.move(x, y, steps=3)
        mouse.click(x, y)
    expect(desk.page.get_by_role("heading", name="Draw the room")).to_be_hidden()
    desk.wait_for_saved(lambda scene: bool(scene["room"]["corners"] != BLANK))


def sides_of(corners: list[list[float]]) -> list[float]:
    """How far each corner is from the next along x and y, metres."""
    turned = corners[1:] + corners[:1]
    return [abs(a[0] - b[0]) + abs(a[1] - b[1]) for a, b in zip(corners, turned, strict=True)]


def test_an_outline_that_is_clicked_becomes_the_room(desk: Desk) -> None:
    draw_with_pointer(desk)
    corners = desk.saved()["room"]["corners"]
    across, up, back, down = sides_of(corners)
    assert (back, down) == pytest.approx((across, up), abs=0.002)
    assert max(across, up) / min(across, up) == pytest.approx(4 / 3, rel=0.05)
    take_picture(desk.page, "own-room")


def test_an_outline_can_be_drawn_with_keys_alone(desk: Desk) -> None:
    new_room(desk)
    keys = desk.page.keyboard
    keys.press("Enter")
    for key, times in (("ArrowRight", 8), ("ArrowUp", 6), ("ArrowLeft", 8), ("ArrowDown", 6)):
        for _ in range(times):
            keys.press(key)
        keys.press("Enter")
    expect(desk.page.get_by_role("heading", name="Draw the room")).to_be_hidden()
    room = desk.wait_for_saved(lambda scene: bool(scene["room"]["corners"] != BLANK))["room"]
    assert sorted(sides_of(room["corners"])) == pytest.approx([3, 3, 4, 4], abs=0.002)


def test_boxes_drawn_by_pointer_stand_and_furniture_goes_round_them(desk: Desk) -> None:
    draw_with_pointer(desk)
    mouse = desk.page.mouse
    desk.page.get_by_role("navigation", name="Tools").get_by_role("button", name="Box").click()
    mouse.move(330, 220)
    mouse.down()
    mouse.move(380, 270, steps=4)
    mouse.up()
    desk.page.keyboard.press("Enter")  # the height on offer
    drawn = desk.wait_for_saved(lambda scene: len(scene["boxes"]) == 1)["boxes"][0]
    assert drawn["size"][2] == 0.75
    assert not drawn.get("placed", False)
    desk.choose_mode("SceneGen")
    desk.choose("Chair")
    expect(desk.places.first).to_have_attribute("aria-pressed", "true")
    offered = desk.answer()["placements"][0]
    desk.page.keyboard.press("Enter")
    chair = desk.wait_for_saved(lambda scene: len(scene["boxes"]) == 2)["boxes"][1]
    assert chair["center"] == pytest.approx(offered["center"], abs=1e-6)
    take_picture(desk.page, "own-room-furnished")


def test_by_hand_a_thing_is_dragged_to_its_place(desk: Desk) -> None:
    draw_with_pointer(desk)
    desk.choose_mode("Manual")
    desk.choose("Chair")
    desk.verdict()
    before = (desk.last_sent("inspect") or {})["center"]
    x, y = desk.middle_of_the_view()
    mouse = desk.page.mouse
    mouse.move(x, y)
    mouse.down()
    mouse.move(x + 60, y + 10, steps=6)
    mouse.up()
    after = desk.wait_for(
        lambda: (desk.last_sent("inspect") or {})["center"],
        lambda at: bool(at[0] > before[0] + 0.2),
    )
    assert desk.verdict()["allowed"]
    desk.page.keyboard.press("Enter")
    chair = desk.wait_for_saved(lambda scene: len(scene["boxes"]) == 1)["boxes"][0]
    assert chair["center"] == pytest.approx(after, abs=1e-6)
    desk.page.keyboard.press("Control+z")
    desk.wait_for_saved(lambda scene: not scene["boxes"])


def test_the_map_leaves_as_a_picture_and_the_room_as_a_model(desk: Desk, tmp_path: Path) -> None:
    desk.open_room("Bedroom")
    desk.choose_mode("SceneGen")
    desk.choose("Sofa")
    desk.answer()
    picture = content_of(exported(desk, "Map of likely places (PNG)"), tmp_path)
    image = Image.open(io.BytesIO(picture))
    assert image.format == "PNG"
    assert len(image.convert("RGB").getcolors(1 << 24) or []) > 10
    assert content_of(exported(desk, "Room as a 3D model (GLB)"), tmp_path)[:4] == b"glTF"
    scene = json.loads(content_of(exported(desk, "Scene file (JSON)"), tmp_path))
    assert scene == desk.saved()


def exported(desk: Desk, what: str) -> Download:
    desk.button(re.compile("^Export")).click()
    with desk.page.expect_download() as download:
        desk.page.locator("#export-menu").get_by_role("button", name=what).click()
    return download.value


def content_of(download: Download, directory: Path) -> bytes:
    path = directory / download.suggested_filename
    download.save_as(path)
    return path.read_bytes()
