"""The room seen through the camera of an emulated phone: the production page, the real server.

Emulated, not verified on devices: docs/phone.md says how to try it on one.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from io import BytesIO
from typing import Any

import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import Browser, Page, WebSocketRoute, expect

from tests.e2e.ar_driving import MIDDLE, Phone, phone_at
from tests.e2e.conftest import PHONE, ROOT, take_picture
from tests.e2e.driving import Record, desk_at

pytestmark = pytest.mark.browser

# A room whose truth is known, metres: a bed, a bookcase, a table and a chair that stands askew.
ROOM: Record = {
    "format": "scenegen.scene",
    "version": 1,
    "id": "true-room",
    "name": "True room",
    "room": {"corners": [[0, 0], [4.2, 0], [4.2, 3.4], [0, 3.4]], "height": 2.5},
    "boxes": [
        {
            "id": "bed",
            "category": "Bed",
            "center": [1.0, 2.6, 0.25],
            "size": [2.0, 1.6, 0.5],
            "heading": 0.0,
        },
        {
            "id": "bookcase",
            "category": "Storage",
            "center": [3.2, 3.2, 0.9],
            "size": [0.4, 1.2, 1.8],
            "heading": -math.pi / 2,
        },
        {
            "id": "table",
            "category": "Table",
            "center": [3.4, 0.5, 0.37],
            "size": [0.7, 1.4, 0.74],
            "heading": math.pi / 2,
        },
        {
            "id": "chair",
            "category": "Chair",
            "center": [3.3, 1.2, 0.44],
            "size": [0.45, 0.5, 0.88],
            "heading": -1.2,
        },
    ],
}
CORNERS = ROOM["room"]["corners"]
CENTIMETER = 0.01
STEPS = 30  # taps; at two seconds each, a minute

# What a page could read a picture by.
READERS = """
for (const [type, names] of [
    [CanvasRenderingContext2D, ["getImageData"]],
    [HTMLCanvasElement, ["toDataURL", "toBlob", "captureStream"]],
    [WebGL2RenderingContext, ["readPixels"]],
    [MediaDevices, ["getUserMedia"]],
]) {
    for (const name of names) {
        const own = type.prototype[name];
        type.prototype[name] = function (...all) {
            (globalThis.read ??= []).push(name);
            return own.apply(this, all);
        };
    }
}
"""

# What the page has the graphics card do, frame by frame; the emulator's own picture is left out.
METER = """
(() => {
    const meter = (globalThis.meter = {
        frames: 0, calls: 0, triangles: 0, most: [0, 0], alive: 0,
    });
    const gl = WebGL2RenderingContext.prototype;
    const isOurs = (one) => one.canvas !== globalThis.phone?.device.sem?.environmentCanvas;
    const wrap = (name, note) => {
        const own = gl[name];
        gl[name] = function (...all) {
            if (isOurs(this)) note(...all);
            return own.apply(this, all);
        };
    };
    const draw = (mode, count, times = 1) => {
        meter.calls += 1;
        if (mode === 4) meter.triangles += (count / 3) * times;
    };
    wrap("drawArrays", (mode, _, count) => draw(mode, count));
    wrap("drawElements", (mode, count) => draw(mode, count));
    wrap("drawArraysInstanced", (mode, _, count, times) => draw(mode, count, times));
    wrap("drawElementsInstanced", (mode, count, _, __, times) => draw(mode, count, times));
    for (const kind of ["Buffer", "Texture", "Framebuffer", "Renderbuffer", "VertexArray"]) {
        wrap(`create${kind}`, () => { meter.alive += 1; });
        wrap(`delete${kind}`, (one) => { if (one) meter.alive -= 1; });
    }
    const count = () => {
        meter.frames += 1;
        const { calls, triangles, most } = meter;
        meter.most = [Math.max(most[0], calls), Math.max(most[1], triangles)];
        meter.calls = meter.triangles = 0;
        requestAnimationFrame(count);
    };
    requestAnimationFrame(count);
})();
"""


def remember(page: Page, scene: Record) -> None:
    """Has the page begin with a room that was drawn before."""
    room = {"doors": [], "windows": [], "room_type": "", **scene["room"]}
    text = json.dumps({"source": "", **scene, "room": room})
    page.add_init_script(
        f"if (!localStorage.getItem('scenegen.scene')) "
        f"localStorage.setItem('scenegen.scene', {json.dumps(text)});"
    )


@pytest.fixture
def phone(browser: Browser, server_url: str) -> Iterator[Phone]:
    """A phone in the true room, its camera off."""
    with phone_at(browser, server_url) as phone:
        phone.enter(ROOM)
        yield phone


@pytest.fixture
def at_home(browser: Browser, server_url: str) -> Iterator[Phone]:
    """A phone in the true room, which was drawn before: the camera is on, the room lined up."""
    with phone_at(browser, server_url, prepare=lambda page: remember(page, ROOM)) as phone:
        line_up(phone)
        yield phone


def line_up(phone: Phone) -> None:
    phone.enter(ROOM)
    phone.start_camera("I am in “True room”")
    phone.find_floor()
    for x, y in CORNERS[1:3]:  # a short wall: the long ones have another length
        phone.tap_at((x, y, 0.0))
    if opposite(phone):
        phone.press("Turn")
    phone.rest()


def opposite(phone: Phone) -> bool:
    """Whether the room lies turned by half: at the bookcase's place stands something else."""
    return phone.thing_at((3.2, 3.0, 1.5), (2.6, 1.2, 1.5)) != "Storage"


def off(one: list[float], other: list[float]) -> float:
    return max(abs(a - b) for a, b in zip(one, other, strict=True))


def sides_and_heading(box: Record) -> tuple[list[float], float]:
    """Its sides with the first along the heading, which is taken between 0 and 90 degrees."""
    depth, width, height = box["size"]
    quarters, heading = divmod(box.get("heading", 0.0), math.pi / 2)
    if math.pi / 2 - heading < 1e-3:
        quarters, heading = quarters + 1, heading - math.pi / 2
    return ([width, depth, height] if quarters % 2 else [depth, width, height]), heading


def test_the_first_sofa_stands_in_a_room_of_four_boxes_within_a_minute_of_taps(
    phone: Phone,
) -> None:
    phone.start_camera()
    phone.find_floor()
    phone.outline(CORNERS)
    expect(phone.hint).to_contain_text("What stands here?")
    for box in ROOM["boxes"]:
        phone.mark_box(box)
        label = phone.page.get_by_role("group", name="What is it?").get_by_role(
            "button", name=box["category"], exact=True
        )
        if label.get_attribute("aria-pressed") != "true":
            phone.steps += 1
            label.click()
    drawn = phone.wait_for_saved(lambda scene: len(scene["boxes"]) == 4)
    take_picture(phone.page, "ar-marked")

    assert drawn["room"]["corners"] == CORNERS
    for made, true in zip(drawn["boxes"], ROOM["boxes"], strict=True):
        assert made["category"] == true["category"]
        assert off(made["center"], true["center"]) < CENTIMETER
        (sides, heading), (true_sides, true_heading) = map(sides_and_heading, (made, true))
        assert off(sides, true_sides) < CENTIMETER
        assert heading == pytest.approx(true_heading, abs=math.radians(1))

    phone.press("Done")
    phone.steps += 1
    phone.choose("Sofa")
    offered = phone.answer()["placements"][0]
    phone.press("Place it")
    placed = phone.wait_for_saved(lambda scene: len(scene["boxes"]) == 5)["boxes"][4]
    assert placed["center"] == pytest.approx(offered["center"], abs=1e-6)
    assert phone.steps <= STEPS, phone.steps
    take_picture(phone.page, "ar-first-sofa")


def test_what_is_placed_stands_at_its_true_scale_to_the_centimeter(at_home: Phone) -> None:
    phone = at_home
    phone.choose("Chair")
    phone.answer()
    phone.press("Place it")
    chair = phone.wait_for_saved(lambda scene: len(scene["boxes"]) == 5)["boxes"][4]
    depth, width, height = chair["size"]
    x, y, z = chair["center"]
    cos, sin = math.cos(chair["heading"]), math.sin(chair["heading"])

    def beside(along: float, across: float) -> tuple[float, float, float]:
        return (x + cos * along - sin * across, y + sin * along + cos * across, z + height / 2)

    for along, across in ((depth / 2, 0.0), (-depth / 2, 0.0), (0.0, width / 2), (0.0, -width / 2)):
        inner, outer = (
            beside(
                along * (1 + grown / abs(along or across)),
                across * (1 + grown / abs(across or along)),
            )
            for grown in (-CENTIMETER, CENTIMETER)
        )
        # Seen from straight above, so that only the top is met.
        assert phone.thing_at(inner, (inner[0] + 0.001, inner[1], 2.2)) == "Chair"
        assert phone.thing_at(outer, (outer[0] + 0.001, outer[1], 2.2)) != "Chair"


def test_by_hand_it_goes_where_the_phone_points_and_is_put_down_by_a_tap(at_home: Phone) -> None:
    phone = at_home
    phone.choose_mode("Manual")
    phone.choose("Chair")
    expect(phone.hint).to_have_text("Point to where it should go, and tap.")
    phone.tap_at((1.6, 1.0, 0.0), (2.6, 1.8, 1.5))
    expect(phone.hint).to_contain_text("turn it with two fingers")
    put = phone.wait_for(lambda: phone.last_sent("inspect") or {}, lambda one: "center" in one)
    assert put["center"][:2] == pytest.approx([1.6, 1.0], abs=0.09)  # it may have snapped
    phone.look((2.2, 1.4, 0.0))
    take_picture(phone.page, "ar-by-hand")
    phone.press("Place it")
    phone.wait_for_saved(lambda scene: len(scene["boxes"]) == 5)
    phone.page.get_by_role("navigation", name="Tools").get_by_role("button", name="Undo").click()
    phone.wait_for_saved(lambda scene: len(scene["boxes"]) == 4)


def test_two_fingers_turn_it_and_one_drags_it(at_home: Phone) -> None:
    phone = at_home
    phone.choose_mode("Manual")
    phone.choose("Chair")
    phone.tap_at((1.6, 1.1, 0.0), (2.6, 1.9, 1.5))
    before = phone.inspected()
    phone.two_fingers(MIDDLE, radius=60, start=0, end=40)
    turned = phone.inspected()
    # Fingers that go round clockwise on the screen turn it clockwise on the floor below.
    assert math.sin(turned["heading"] - before["heading"]) < -0.3
    assert turned["center"] == pytest.approx(before["center"], abs=0.001)
    phone.drag(MIDDLE, (MIDDLE[0] + 130, MIDDLE[1] - 60))
    moved = phone.inspected()
    assert math.dist(moved["center"], turned["center"]) > 0.2
    assert moved["heading"] == pytest.approx(turned["heading"], abs=math.radians(16))


def test_a_side_that_was_marked_wrong_is_dragged_to_where_it_is(at_home: Phone) -> None:
    phone = at_home
    bed = ROOM["boxes"][0]
    assert phone.thing_at((1.0, 2.6, 0.5), (3.0, 1.4, 1.6)) == "Bed"
    phone.look((2.0, 2.6, 0.02), (3.4, 1.4, 1.6))  # the handle of its front
    phone.drag(MIDDLE, (MIDDLE[0] + 90, MIDDLE[1]))
    moved = phone.wait_for_saved(lambda scene: bool(scene["boxes"][0]["size"] != bed["size"]))
    depth, width, height = moved["boxes"][0]["size"]
    assert depth > 2.1
    assert [width, height] == bed["size"][1:]
    assert moved["boxes"][0]["center"][0] - depth / 2 == pytest.approx(0.0, abs=CENTIMETER / 2)


def test_a_door_is_marked_on_its_wall(at_home: Phone) -> None:
    phone = at_home
    phone.page.get_by_role("navigation", name="Tools").get_by_role("button", name="Door").click()
    for x in (0.8, 1.7):
        phone.tap_at((x, 0.0, 1.0), (1.6, 2.0, 1.5))
    (door,) = phone.wait_for_saved(lambda scene: bool(scene["room"]["doors"]))["room"]["doors"]
    assert sorted([door["start"], door["end"]]) == [
        pytest.approx([0.8, 0.0], abs=CENTIMETER),
        pytest.approx([1.7, 0.0], abs=CENTIMETER),
    ]


def test_the_map_lies_on_the_real_floor_and_the_places_stand_on_it(at_home: Phone) -> None:
    phone = at_home
    phone.choose("Chair")
    phone.answer()
    phone.look((2.6, 1.8, 0.0), (1.2, 0.6, 1.9))
    phone.rest(6)
    take_picture(phone.page, "ar-map")
    with_map = phone.page.screenshot()
    phone.page.keyboard.press("h")
    phone.rest(6)
    assert phone.page.screenshot() != with_map


def test_a_tap_on_the_floor_asks_why_not_here_and_the_sheet_says_it(at_home: Phone) -> None:
    phone = at_home
    phone.choose("Chair")
    phone.answer()
    phone.tap_at((2.3, 0.45, 0.0), (2.0, 1.9, 1.6))
    told = phone.verdict()
    assert told["allowed"], told["sentence"]
    steps = phone.page.get_by_role("group", name="Place after place")
    expect(steps).to_contain_text("Your own place")
    steps.get_by_role("button", name="Why not here?").click()
    sheet = phone.page.get_by_label("Panel", exact=True)
    cost = next(one for one in told["costs"] if one["best"])
    expect(sheet.get_by_text(f"Best place: {cost['best']}").first).to_be_in_viewport()
    phone.rest(6)
    take_picture(phone.page, "ar-why-not-here")
    phone.press("Move it there")
    there = phone.inspected()
    assert math.dist(there["center"][:2], (2.3, 0.45)) > 0.05


def test_real_things_hide_what_is_behind_them_until_told_not_to(at_home: Phone) -> None:
    phone = at_home
    hide = phone.button("Hide")
    expect(hide).to_have_attribute("aria-pressed", "true")
    phone.press("Hide")
    expect(hide).to_have_attribute("aria-pressed", "false")
    phone.page.keyboard.press("o")
    expect(hide).to_have_attribute("aria-pressed", "true")


def test_every_gesture_has_a_button_and_a_key(phone: Phone) -> None:
    phone.start_camera()
    phone.press("The floor is here")
    for x, y in CORNERS[:3]:
        phone.look((x, y, 0.0))
        phone.press("Corner here")
    phone.look((*CORNERS[3], 0.0))
    phone.page.keyboard.press("Enter")
    phone.press("Close it")
    phone.wait_for_saved(lambda scene: bool(scene["room"]["corners"] == CORNERS))
    phone.page.keyboard.press("v")
    expect(phone.button("Around")).to_be_visible()
    assert not phone.presenting


def test_pauses_and_losses_are_said_and_nothing_is_lost(at_home: Phone) -> None:
    phone = at_home
    phone.page.keyboard.press("Escape")
    phone.on_phone("phone.show('hidden')")
    expect(phone.hint).to_have_text("Paused. Come back to go on.")
    phone.on_phone("phone.show('visible')")
    expect(phone.hint).to_contain_text("Pick what to place")
    phone.on_phone("phone.lose(true)")
    expect(phone.hint).to_contain_text("I've lost the room")
    expect(phone.page.locator("#announcer")).to_contain_text("I've lost the room")
    phone.on_phone("phone.lose(false)")
    expect(phone.hint).to_contain_text("Pick what to place")
    assert phone.thing_at((3.2, 3.0, 1.5), (2.6, 1.2, 1.5)) == "Storage"
    phone.on_phone("phone.device.recenter()")
    expect(phone.toast).to_contain_text("The device has lost its place")
    expect(phone.hint).to_contain_text("the floor")
    assert len(phone.saved()["boxes"]) == 4


def test_the_device_s_own_pieces_are_kept_put_right_or_dropped(
    browser: Browser, server_url: str
) -> None:
    features = ["dom-overlay", "anchors", "plane-detection", "mesh-detection", "light-estimation"]
    with phone_at(browser, server_url, features=features) as phone:
        phone.enter(ROOM, labels=True)
        phone.start_camera()
        phone.find_floor()
        expect(phone.page.get_by_role("heading", name="4 pieces found")).to_be_visible()
        take_picture(phone.page, "ar-found")
        phone.press("Use them")
        expect(phone.page.get_by_role("heading", name="Is this a bed?")).to_be_visible()
        phone.press("Keep")
        phone.press("Keep")
        phone.press("Drop")
        # No label of the devices says chair: it is put right by its chip.
        chips = phone.page.get_by_role("group", name="What is it?")
        chips.get_by_role("button", name="Chair", exact=True).click()
        phone.press("Keep")
        kinds = ["Bed", "Storage", "Chair"]
        scene = phone.wait_for_saved(
            lambda scene: bool([box["category"] for box in scene["boxes"]] == kinds)
        )
        for made, true in zip(scene["boxes"], (ROOM["boxes"][i] for i in (0, 1, 3)), strict=True):
            assert off(sides_and_heading(made)[0][2:], true["size"][2:]) < CENTIMETER
            assert sorted(made["size"][:2]) == pytest.approx(
                sorted(true["size"][:2]), abs=CENTIMETER
            )


class Cuttable:
    """The page's sockets, which the network may swallow (they look open) until the next one."""

    def __init__(self, page: Page) -> None:
        self.dead: set[int] = set()
        self.count = 0
        page.route_web_socket("**/socket*", self._route)

    def cut(self) -> None:
        """From now on nothing goes through the sockets there are."""
        self.dead.update(range(self.count))

    def _route(self, socket: WebSocketRoute) -> None:
        number = self.count
        self.count += 1
        server = socket.connect_to_server()
        socket.on_message(lambda data: None if number in self.dead else server.send(data))
        server.on_message(lambda data: None if number in self.dead else socket.send(data))


def test_the_socket_may_die_at_every_moment_and_nothing_is_lost(
    browser: Browser, server_url: str
) -> None:
    sockets: list[Cuttable] = []
    with phone_at(
        browser, server_url, prepare=lambda page: sockets.append(Cuttable(page))
    ) as phone:
        (network,) = sockets
        phone.enter(ROOM)
        network.cut()
        phone.start_camera()
        phone.wait_for(lambda: network.count, lambda count: count == 2)
        phone.find_floor()
        phone.outline(CORNERS)
        phone.mark_box(ROOM["boxes"][0])
        network.cut()
        phone.on_phone("phone.show('hidden')")
        phone.on_phone("phone.show('visible')")
        phone.wait_for(lambda: network.count, lambda count: count == 3)
        expect(phone.hint).to_contain_text("Next thing")
        phone.mark_box(ROOM["boxes"][2])
        network.cut()
        phone.page.evaluate("document.dispatchEvent(new Event('visibilitychange'))")
        phone.wait_for(lambda: network.count, lambda count: count == 4)
        network.cut()
        phone.press("End")
        phone.wait_for(lambda: network.count, lambda count: count == 5)
        expect(phone.connection).to_have_text("Connected")
        session = phone.page.evaluate("localStorage.getItem('scenegen.session')")
        mine = phone.saved()
    with desk_at(browser, f"{server_url}/?session={session}") as other:
        joined = other.wait_for_saved(lambda scene: bool(scene and scene["id"] == mine["id"]))
    assert len(mine["boxes"]) == 2
    assert joined == mine


def test_no_picture_is_read_and_only_outlines_boxes_and_questions_leave_the_page(
    browser: Browser, server_url: str
) -> None:
    left: list[tuple[str, str, int]] = []

    def watch(page: Page) -> None:
        page.add_init_script(READERS)
        page.on(
            "request",
            lambda one: left.append((one.method, one.url, len(one.post_data_buffer or b""))),
        )

    with phone_at(browser, server_url, prepare=watch) as phone:
        phone.enter(ROOM)
        phone.page.evaluate("globalThis.read = []")
        left.clear()
        phone.sent.clear()
        phone.start_camera()
        phone.find_floor()
        phone.outline(CORNERS)
        phone.mark_box(ROOM["boxes"][2])
        phone.press("Done")
        phone.choose("Chair")
        phone.answer()
        phone.press("Place it")
        phone.wait_for_saved(lambda scene: len(scene["boxes"]) == 2)
        phone.wait_until_stored()
        phone.press("End")
        assert phone.page.evaluate("globalThis.read") == []
        kinds = {one["type"] for one in phone.sent}
        assert kinds <= {
            "put_scene",
            "put_room",
            "put_boxes",
            "remove_box",
            "ask",
            "inspect",
            "ping",
        }
        assert phone.binary_sent == 0
        # A camera's image has a hundred thousand bytes; what is sent here are a few numbers.
        assert max(len(json.dumps(one)) for one in phone.sent) < 4_000
        assert {method for method, _, _ in left} <= {"GET"}
        assert all(url.startswith((server_url, "blob:")) for _, url, _ in left)


def picture_difference(one: bytes, other: bytes) -> float:
    """The share of pixels that differ visibly."""
    a, b = (
        np.asarray(Image.open(BytesIO(picture)).convert("RGB"), dtype=np.int16)
        for picture in (one, other)
    )
    return float((np.abs(a - b).max(axis=2) > 12).mean())


def furnished(count: int) -> Record:
    """The true room with that many chairs in it, that were placed."""
    chairs = [
        {
            "id": f"placed-{i}",
            "category": "Chair",
            "center": [0.4 + 0.55 * (i % 6), 0.4 + 0.6 * (i // 6), 0.44],
            "size": [0.45, 0.45, 0.88],
            "heading": 0.3 * i,
            "placed": True,
        }
        for i in range(count)
    ]
    return {**ROOM, "boxes": [*ROOM["boxes"], *chairs]}


KINDS = ("Object", "Array", "Map", "Function", "EventTarget", "Float32Array", "XRSession")


def things_kept(page: Page) -> int:
    """How many objects of the common kinds are still there once the garbage is gone.

    Bytes would say less: the browser keeps compiled code and caches of its own.
    """
    client = page.context.new_cdp_session(page)
    for _ in range(3):
        client.send("HeapProfiler.collectGarbage")
    count = 0
    for kind in KINDS:
        prototype = client.send("Runtime.evaluate", {"expression": f"{kind}.prototype"})
        found = client.send(
            "Runtime.queryObjects",
            {"prototypeObjectId": prototype["result"]["objectId"], "objectGroup": "kept"},
        )
        told = client.send(
            "Runtime.callFunctionOn",
            {
                "objectId": found["objects"]["objectId"],
                "functionDeclaration": "function () { return this.length; }",
                "returnByValue": True,
            },
        )
        count += told["result"]["value"]
        client.send("Runtime.releaseObjectGroup", {"objectGroup": "kept"})
    client.detach()
    return count


def meter(page: Page) -> dict[str, Any]:
    read: dict[str, Any] = page.evaluate("structuredClone(globalThis.meter)")
    return read


EVERYTHING = {
    "samplingInterval": 1024,
    "includeObjectsCollectedByMajorGC": True,
    "includeObjectsCollectedByMinorGC": True,
}
"""Also what is gone again by the end counts."""


def allocated(node: dict[str, Any], files: tuple[str, ...]) -> float:
    """Bytes that functions of these files have made since the sampling began."""
    name = node["callFrame"]["url"].rsplit("/", 1)[-1]
    own = float(node["selfSize"]) if name.startswith(files) else 0.0
    return own + sum(allocated(child, files) for child in node["children"])


def prepared(page: Page) -> None:
    page.add_init_script(METER)
    remember(page, furnished(8))


def test_twelve_boxes_stay_within_the_means_of_a_phone_over_600_frames(
    browser: Browser, server_url: str
) -> None:
    with phone_at(browser, server_url, prepare=prepared) as phone:
        line_up(phone)
        phone.choose("Decor")
        phone.answer()
        phone.look((2.1, 1.7, 0.3), (-3.0, -3.0, 3.2))  # all of it is in view
        phone.rest(6)
        take_picture(phone.page, "ar-twelve")
        phone.rest(30)
        phone.page.evaluate("globalThis.meter.most = [0, 0]")
        profiler = phone.page.context.new_cdp_session(phone.page)
        profiler.send("HeapProfiler.startSampling", EVERYTHING)
        before, alive, begin = (
            things_kept(phone.page),
            meter(phone.page)["alive"],
            meter(phone.page)["frames"],
        )
        phone.page.wait_for_function(
            "(end) => globalThis.meter.frames >= end", arg=begin + 600, timeout=300_000
        )
        calls, triangles = meter(phone.page)["most"]
        assert 12 < calls <= 150
        assert 1_000 < triangles <= 150_000
        assert meter(phone.page)["alive"] == alive
        assert things_kept(phone.page) - before < 100  # of 600 frames
        profile = profiler.send("HeapProfiler.stopSampling")["profile"]
        frames = meter(phone.page)["frames"] - begin
        assert allocated(profile["head"], ("index-", "ar_view-")) < 8_000 * frames


def test_the_emulator_is_no_part_of_the_page() -> None:
    for part in (ROOT / "web/dist").rglob("*.*s"):
        assert "installPhone" not in part.read_text()
        assert "IWER" not in part.read_text()


def test_ten_sessions_leave_nothing_behind(browser: Browser, server_url: str) -> None:
    with phone_at(browser, server_url, prepare=prepared) as phone:
        phone.enter(ROOM)
        phone.rest(20)
        before = phone.page.screenshot()
        alive = []
        kept = []
        for _ in range(10):
            phone.start_camera("I am in “True room”")
            phone.find_floor()
            phone.rest(3)
            phone.press("End")
            expect(phone.button("Around")).to_be_visible()
            phone.rest(6)
            alive.append(meter(phone.page)["alive"])
            kept.append(things_kept(phone.page))
        assert alive[-1] <= alive[1]
        phone.page.mouse.move(0, 0)
        phone.rest(20)
        # Not the last pixel: a button may still have the focus.
        assert picture_difference(before, phone.page.screenshot()) < 0.02
        assert kept[-1] - kept[2] < 100


def test_a_headset_that_shows_no_page_has_a_panel_in_the_room(
    browser: Browser, server_url: str
) -> None:
    with phone_at(browser, server_url, device="installHeadset") as headset:
        headset.enter(ROOM)
        headset.start_camera()
        headset.rest(10)
        x, y, _ = headset.eye
        headset.pull((x, y - 1.1, 0.0))
        # The device knows this room: what is offered is the first button of the panel.
        headset.rest(30)
        take_picture(headset.page, "ar-headset")
        headset.pull(panel_place(headset, 0.25, 0.4))
        found = headset.wait_for_saved(lambda scene: len(scene["boxes"]) == 4)
        assert found["room"]["corners"] != [[0, 0], [5, 0], [5, 4], [0, 4]]
        for _ in range(4):
            headset.pull(panel_place(headset, 0.25, 0.82))
        headset.pull(panel_place(headset, 0.4, 0.4))
        headset.answer()
        rows = (0.376, 0.6, 0.824)
        width, two, one, zero = (0.5, rows[1]), (0.307, rows[0]), (0.114, rows[0]), (0.886, rows[1])
        for key in (width, two, one, zero):
            headset.pull(panel_place(headset, *key))
            headset.rest(2)
        take_picture(headset.page, "ar-headset-keypad")
        okay, place_it = (0.822, rows[2]), (0.178, rows[2])
        headset.pull(panel_place(headset, *okay))
        headset.answer()
        headset.rest(10)
        take_picture(headset.page, "ar-headset-places")
        headset.pull(panel_place(headset, *place_it))
        placed = headset.wait_for_saved(lambda scene: len(scene["boxes"]) == 5)
        assert placed["boxes"][-1]["size"][1] == 2.1


def panel_place(headset: Phone, across: float, down: float) -> tuple[float, float, float]:
    """A place of the panel: it floats 0.9 m before the eye and 0.32 m below it, leaning back.

    ``across`` and ``down`` are shares of its 0.64 by 0.33 m; the eye looks along -y.
    """
    x, y, z = headset.eye
    up = (0.5 - down) * 0.33
    lean = math.atan2(0.32, 0.9)
    return (
        x - (across - 0.5) * 0.64,
        y - 0.9 - up * math.sin(lean),
        z - 0.32 + up * math.cos(lean),
    )


def test_axe_finds_nothing_serious(at_home: Phone) -> None:
    phone = at_home
    axe = (ROOT / "node_modules/axe-core/axe.min.js").read_text()
    phone.page.evaluate(axe)

    def serious() -> list[str]:
        found: list[str] = phone.page.evaluate(
            """async () => (await axe.run(document)).violations
                .filter(({ impact }) => impact === "serious" || impact === "critical")
                .map(({ id, nodes }) => `${id}: ${nodes[0].html}`)"""
        )
        return found

    assert serious() == []
    phone.choose("Chair")
    phone.answer()
    assert serious() == []
    phone.press("Cancel")
    phone.page.get_by_role("navigation", name="Tools").get_by_role("button", name="Box").click()
    expect(phone.button("Corner here")).to_be_visible()
    assert serious() == []


def test_targets_are_large_and_within_reach_of_the_thumb(at_home: Phone) -> None:
    phone = at_home
    phone.page.get_by_role("navigation", name="Tools").get_by_role("button", name="Box").click()
    for name in ("Corner here", "Hide", "Line up", "End", "Done"):
        box = phone.button(name).bounding_box()
        assert box is not None
        assert min(box["width"], box["height"]) >= 44, name
        assert box["y"] > 0.4 * PHONE["height"], name


def test_without_a_camera_view_the_reason_is_told_and_the_page_goes_on(
    browser: Browser, server_url: str
) -> None:
    with desk_at(browser, server_url) as desk:
        desk.button("Camera").click()
        dialog = desk.page.get_by_role("dialog", name="See it in your own room")
        expect(dialog).to_contain_text("This browser can't show your room")
        expect(dialog.get_by_role("button", name="Start")).to_have_count(0)
        dialog.get_by_role("button", name="Close").click()
        desk.choose("Chair")
        expect(desk.places.first).to_be_visible()
