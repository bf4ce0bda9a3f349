"""An emulated phone in an emulated room, and what a person does with it.

The room is one of ours whose truth is known; it lies somewhere in the device's frame, which knows
nothing of it. Places are given in the room's frame (core: metres, z up).
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

from playwright.sync_api import Browser, Locator, Page, WebSocket, expect

from tests.e2e.conftest import PATIENCE, PHONE, ROOT
from tests.e2e.driving import Desk, Record

Place = tuple[float, float, float]

SCRIPTS = (
    ROOT / "node_modules/iwer/build/iwer.min.js",
    ROOT / "node_modules/@iwer/sem/build/iwer-sem.min.js",
    ROOT / "web/emulator/phone.js",
)
THICKNESS = 0.02  # metres; floors and walls of emulated rooms
MIDDLE = (PHONE["width"] / 2, PHONE["height"] / 2)
LABELS = {
    "Bed": "BED",
    "Chair": "CHAIR",
    "Decor": "PLANT",
    "Picture": "WALL_ART",
    "Sofa": "COUCH",
    "Storage": "STORAGE",
    "TV": "SCREEN",
    "Table": "TABLE",
}


@dataclass(frozen=True)
class Frame:
    """Where a room lies in the frame of the device (y up): its origin, and its turn, radians."""

    at: Place
    turn: float

    def place(self, core: Place) -> Place:
        """A place of the room in the frame of the device."""
        x, y, z = core
        cos, sin = math.cos(self.turn), math.sin(self.turn)
        return (
            self.at[0] + x * cos - y * sin,
            self.at[1] + z,
            self.at[2] - x * sin - y * cos,
        )


# The device woke up anywhere, its floor is off by some centimetres, the room is turned.
SOMEWHERE = Frame((-1.3, 0.07, 2.1), math.radians(33))


def emulated_room(scene: Record, frame: Frame = SOMEWHERE, *, labels: bool = False) -> Record:
    """A scene as a capture of @iwer/sem: volumes for the furniture, slabs for floor and walls.

    Without labels the device does not know the room, it only meets it: all is "other", and the test
    leaves plane and mesh detection out.
    """
    entities = [_floor(scene["room"]["corners"], frame)]
    for box in scene["boxes"]:
        label = LABELS.get(box["category"], "OTHER") if labels else "OTHER"
        entities.append(_volume(box, label, frame))
    entities.extend(_wall(a, b, scene["room"]["height"], frame) for a, b in _sides(scene))
    for number, entity in enumerate(entities):
        entity["uuid"] = f"{number:08x}-0000-4000-8000-000000000000"
    return {"type": "scene", "version": 1, "spatialEntities": entities}


def _sides(scene: Record) -> Iterator[tuple[list[float], list[float]]]:
    corners = scene["room"]["corners"]
    yield from zip(corners, corners[1:] + corners[:1], strict=True)


def _floor(corners: list[list[float]], frame: Frame) -> Record:
    (low_x, high_x), (low_y, high_y) = (
        (min(axis), max(axis)) for axis in zip(*corners, strict=True)
    )
    middle = ((low_x + high_x) / 2, (low_y + high_y) / 2, 0.0)
    width, depth = high_x - low_x, high_y - low_y
    # A plane's rectangle is turned into XZ with its normal along -y: turned once more it looks up.
    return {
        "semanticLabel_META": "FLOOR",
        "locatable_META": {
            "position": _xyz(frame.place(middle)),
            "orientation": _turned_over(frame.turn),
        },
        "bounded2D_META": {
            "offset": {"x": -width / 2, "y": -depth / 2},
            "extent": {"width": width, "height": depth},
        },
    }


def _turned_over(turn: float) -> Record:
    """About x by half a turn, then about the upright axis."""
    return {"x": math.cos(turn / 2), "y": 0.0, "z": -math.sin(turn / 2), "w": 0.0}


def _volume(box: Record, label: str, frame: Frame) -> Record:
    """A box; volumes are z-up and have their front at -y."""
    depth, width, height = box["size"]
    turn = frame.turn + box.get("heading", 0.0) + math.pi / 2
    return {
        "semanticLabel_META": label,
        "locatable_META": {
            "position": _xyz(frame.place(tuple(box["center"]))),
            "orientation": _upright(turn),
        },
        "bounded3D_META": {
            "offset": {"x": -width / 2, "y": -depth / 2, "z": -height / 2},
            "extent": {"width": width, "height": depth, "depth": height},
        },
    }


def _upright(turn: float) -> Record:
    """About x by a quarter back, so that z is up, then about the upright axis."""
    half = math.sqrt(0.5)
    cos, sin = math.cos(turn / 2), math.sin(turn / 2)
    return {"x": -half * cos, "y": half * sin, "z": half * sin, "w": half * cos}


def _wall(a: list[float], b: list[float], height: float, frame: Frame) -> Record:
    length = math.dist(a, b)
    along = math.atan2(b[1] - a[1], b[0] - a[0])
    out = (math.sin(along) * THICKNESS / 2, -math.cos(along) * THICKNESS / 2)
    center = [(a[0] + b[0]) / 2 + out[0], (a[1] + b[1]) / 2 + out[1], height / 2]
    box = {"center": center, "size": [THICKNESS, length, height], "heading": along + math.pi / 2}
    return _volume(box, "WALL_FACE", frame)


def _xyz(place: Place) -> Record:
    return dict(zip("xyz", place, strict=True))


class Phone(Desk):
    """A phone in a person's hand; counts what the person does."""

    frame = SOMEWHERE
    steps = 0
    eye: Place = (0.0, 0.0, 1.5)

    def __init__(self, page: Page) -> None:
        super().__init__(page)
        self.binary_sent = 0
        page.on("websocket", self._count)

    def _count(self, socket: WebSocket) -> None:
        def note(data: str | bytes) -> None:
            self.binary_sent += not isinstance(data, str)

        socket.on("framesent", note)

    # --- what can be seen -------------------------------------------------------------------------

    @property
    def hint(self) -> Locator:
        """The sentence that says what to do next."""
        return self.page.locator(".pill.hint")

    def on_phone(self, script: str, *arguments: Any) -> Any:
        """Has the emulator do something: `phone` and the arguments `a` are at hand."""
        return self.page.evaluate(f"(a) => {{ const {{ phone }} = window; {script} }}", arguments)

    @property
    def presenting(self) -> bool:
        """Whether the camera is on."""
        return bool(self.on_phone("return phone.presenting"))

    # --- what is done -----------------------------------------------------------------------------

    def enter(self, scene: Record, *, labels: bool = False) -> None:
        """Stands in the middle of a room, holding the phone up."""
        corners = scene["room"]["corners"]
        x, y = (sum(axis) / len(corners) for axis in zip(*corners, strict=True))
        self.eye = (x, y, 1.5)
        self.on_phone("phone.enter(a[0])", emulated_room(scene, self.frame, labels=labels))
        self.look((x, y - 1.1, 0.0))

    def look(self, target: Place, eye: Place | None = None) -> None:
        """Points the middle of the view at a place, and holds still until it is drawn."""
        self.eye = eye or self.eye
        places = self.frame.place(self.eye), self.frame.place(target)
        self.on_phone("phone.look(a[0], a[1])", *places)
        self.rest()

    def rest(self, frames: int = 3) -> None:
        """Until some frames were drawn, and the aim was looked at."""
        self.page.evaluate(
            """(count) => new Promise((done) => {
                const begin = performance.now();
                const next = (left) =>
                    left > 0 || performance.now() - begin < 130
                        ? requestAnimationFrame(() => next(left - 1))
                        : done();
                next(count);
            })""",
            frames,
        )

    def press(self, name: str) -> None:
        """Presses a button."""
        self.steps += 1
        self.page.get_by_role("button", name=name, exact=True).click()

    def tap(self) -> None:
        """Touches the middle of the screen."""
        self.steps += 1
        self.page.touchscreen.tap(*MIDDLE)
        self.page.wait_for_function("() => !window.phone.touched")

    def tap_at(self, target: Place, eye: Place | None = None) -> None:
        """Points at a place, and touches it."""
        self.look(target, eye)
        self.tap()

    def pull(self, target: Place) -> None:
        """Points a headset's controller, held at the right of the eye, and pulls its trigger."""
        self.steps += 1
        x, y, z = self.eye
        hand = (x + 0.15, y, z - 0.25)
        self.on_phone(
            "phone.reach(a[0]); phone.point(a[1])", *map(self.frame.place, (hand, target))
        )
        self.rest(2)
        for act in ("pull", "release"):
            self.on_phone(f"phone.{act}()")
            self.rest(3)

    def thing_at(self, target: Place, eye: Place) -> str:
        """The kind of thing that a tap on a place selects; empty for nothing."""
        self.page.keyboard.press("Escape")  # no handles are in the way
        self.tap_at(target, eye)
        chosen = self.things.and_(self.page.locator('[aria-selected="true"]'))
        if chosen.count() == 0:
            return ""
        words = chosen.inner_text().strip()
        return next((name for name in LABELS if words.lower().startswith(name.lower())), words)

    def inspected(self) -> Record:
        """The pose of the ghost that the server was asked about last, once it has answered."""
        self.rest(6)
        self.verdict()
        return self.last_sent("inspect") or {}

    def drag(self, start: tuple[float, float], end: tuple[float, float]) -> None:
        """Moves one finger over the screen."""
        self._touch([start], [end])

    def two_fingers(
        self, middle: tuple[float, float], *, radius: float, start: float, end: float
    ) -> None:
        """Turns two fingers about a place, clockwise, from one angle to another in degrees."""

        def fingers(degrees: float) -> list[tuple[float, float]]:
            u, v = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
            return [
                (middle[0] + sign * radius * u, middle[1] + sign * radius * v) for sign in (1, -1)
            ]

        self._touch(*(fingers(start + (end - start) * i / 4) for i in range(5)))

    def _touch(self, *stages: list[tuple[float, float]]) -> None:
        self.steps += 1
        client = self.page.context.new_cdp_session(self.page)

        def send(kind: str, points: list[tuple[float, float]]) -> None:
            touches = [{"x": x, "y": y, "id": i} for i, (x, y) in enumerate(points)]
            client.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": touches})
            self.rest(3)

        send("touchStart", stages[0])
        for before, after in pairwise(stages):
            for step in (0.5, 1.0):
                send(
                    "touchMove",
                    [
                        (a[0] + (b[0] - a[0]) * step, a[1] + (b[1] - a[1]) * step)
                        for a, b in zip(before, after, strict=True)
                    ],
                )
        send("touchEnd", [])
        self.page.wait_for_function("() => !window.phone.touched")
        client.detach()

    def start_camera(self, way: str = "Start in a new room") -> None:
        """Goes into the camera view."""
        self.press("Camera")
        self.press(way)
        expect(self.button("End")).to_be_visible()

    def find_floor(self) -> None:
        """Taps the floor, once it was found."""
        expect(self.hint).to_have_text("Put the ring on the floor, and tap.")
        self.tap()

    def outline(self, corners: list[list[float]]) -> None:
        """Taps the corners of the room, and the first one again."""
        for x, y in [*corners, corners[0]]:
            self.tap_at((x, y, 0.0))

    def mark_box(self, box: Record) -> None:
        """Three corners of its foot and its top edge, from the side that can be seen."""
        a, b, c, top, eye = seen_corners(box)
        for corner in (a, b, c):
            self.tap_at(corner, eye)
        self.tap_at(top, eye)


def seen_corners(box: Record) -> tuple[Place, Place, Place, Place, Place]:
    """Two corners of the foot at the front, one at the back, the top edge, and where to stand."""
    depth, width, height = box["size"]
    heading = box.get("heading", 0.0)
    ahead = (math.cos(heading), math.sin(heading))
    left = (-ahead[1], ahead[0])

    def at(u: float, v: float, z: float) -> Place:
        x, y, middle = box["center"]
        return (
            x + ahead[0] * u + left[0] * v,
            y + ahead[1] * u + left[1] * v,
            middle - height / 2 + z,
        )

    stand = at(depth / 2 + 0.9, 0.3, 1.5 - (box["center"][2] - height / 2))
    front = depth / 2
    return (
        at(front, -width / 2, 0),
        at(front, width / 2, 0),
        at(-front, width / 2, 0),
        at(front, 0, height),
        stand,
    )


@contextmanager
def phone_at(
    browser: Browser,
    url: str,
    *,
    features: list[str] | None = None,
    device: str = "installPhone",
    prepare: Callable[[Page], object] = id,
) -> Iterator[Phone]:
    """The page on an emulated phone, greeted and connected; it must complain of nothing.

    ``prepare`` does what has to be done to the page before it opens.
    """
    expect.set_options(timeout=PATIENCE * 1000)
    context = browser.new_context(
        viewport=PHONE, has_touch=True, is_mobile=True, reduced_motion="reduce"
    )
    page = context.new_page()
    page.set_default_timeout(PATIENCE * 1000)
    complaints: list[str] = []
    page.on("console", lambda one: complaints.append(one.text) if one.type == "error" else None)
    page.on("pageerror", lambda error: complaints.append(str(error)))
    source = "\n;".join(script.read_text() for script in SCRIPTS)
    granted = "undefined" if features is None else json.dumps(features)
    page.add_init_script(f"{source}\n;window.phone = {device}({granted});")
    prepare(page)
    phone = Phone(page)
    page.goto(url)
    phone.close_greeting()
    yield phone
    context.close()
    assert complaints == []
