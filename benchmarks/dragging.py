"""How soon the page can be used, and a map is on the screen while a box is dragged in it.

    python benchmarks/dragging.py [--category Chair]

A real browser with the built page, a server of its own, both on this machine. A drag is timed from
the pointer's event; on the screen is when the second frame after the message begins. Without a
graphics card the browser draws by the processor, on which the server waits meanwhile; so it is
measured once more with all that the page does but the drawing itself, as a graphics card would take
it over.
"""

from __future__ import annotations

import argparse
import json
import shutil
from itertools import product

import numpy as np
import rooms
from playwright.sync_api import Browser, Page, sync_playwright
from serving import answers, started

from scenegen_core.scene.files import write_scene
from tests.e2e.conftest import BROWSERS, FLAGS
from tests.e2e.driving import desk_at

ARRIVALS = 10  # times that the page is opened
STEPS, EVERY = 200, 16  # of the drag, and milliseconds between two
DRAGGED = "box11"  # the loose box on the free floor of the room of the targets
METER = """
const meter = (window.meter = { pointer: 0, sent: {}, edits: {}, maps: [], frames: 0 });
addEventListener("pointermove", (event) => (meter.pointer = event.timeStamp), { capture: true });
const count = () => { meter.frames += 1; requestAnimationFrame(count); };
requestAnimationFrame(count);
const send = WebSocket.prototype.send;
WebSocket.prototype.send = function (data) {
  const message = typeof data === "string" ? JSON.parse(data) : {};
  if (message.type === "put_boxes") {
    meter.sent[message.seq] = { at: meter.pointer, id: message.boxes[0].id, bytes: data.length };
  }
  return send.call(this, data);
};
const Native = WebSocket;
window.WebSocket = class extends Native {
  constructor(...given) {
    super(...given);
    this.addEventListener("message", ({ data }) => {
      const message = typeof data === "string" ? JSON.parse(data) : {};
      if (message.type === "ack") meter.edits[message.revision] = meter.sent[message.seq];
      const edit = message.type === "maps" ? meter.edits[message.revision] : undefined;
      if (edit === undefined || edit.shown) return;
      edit.shown = true;
      const map = { from: edit.at, came: performance.now(), shown: null };
      meter.maps.push(map);
      requestAnimationFrame(() => requestAnimationFrame(() => (map.shown = performance.now())));
    });
  }
};
"""


WATCH_FOR_BUTTONS = """
const watch = new MutationObserver(() => {
  if (document.querySelector("button") === null) return;
  watch.disconnect();
  setTimeout(() => (window.arrived = performance.now()));
});
watch.observe(document, { childList: true, subtree: true });
"""

BLIND = """
for (const call of ["drawElements", "drawArrays", "drawElementsInstanced", "drawArraysInstanced"])
  WebGL2RenderingContext.prototype[call] = () => {};
"""


def main() -> None:
    """Measure; print a table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--category", default="Chair")
    category = parser.parse_args().category
    text = json.dumps(write_scene(rooms.living_room()).decode())
    installed = next(filter(None, map(shutil.which, BROWSERS)), None)
    print("| until (from the pointer) | median ms | quartiles | p99 |\n| --- | ---: | --- | ---: |")
    with started() as (_, port, _), sync_playwright() as playwright:
        answers(port)
        browser = playwright.chromium.launch(executable_path=installed, args=list(FLAGS))
        row("its buttons, from opening the page", arrived(browser, f"http://127.0.0.1:{port}"))
        for how, script in (("drawn by the processor", ""), ("not drawn", BLIND)):
            opening = f"localStorage.setItem('scenegen.scene', {text});{METER}{script}"
            with desk_at(browser, f"http://127.0.0.1:{port}", before=opening) as desk:
                desk.page.keyboard.press("c")
                desk.choose_mode("SceneGen")
                desk.choose(category)
                desk.answer()
                told(how, dragged(desk.page, *grip(desk.page)))
        browser.close()


def arrived(browser: Browser, url: str) -> list[float]:
    """Milliseconds from going to the page until its buttons are there and nothing keeps it busy."""
    found = []
    for _ in range(ARRIVALS):
        page = browser.new_page()
        page.add_init_script(WATCH_FOR_BUTTONS)
        page.goto(url)
        page.get_by_role("button").first.wait_for()
        found.append(page.evaluate("window.arrived"))
        page.close()
    return found


def grip(page: Page) -> tuple[float, float]:
    """A pixel at which the box can be grabbed: beside its name, as the plan is laid out now."""
    for x, y in product(range(180, 240, 8), range(260, 320, 8)):
        if tried(page, x, y):
            return x, y
    raise SystemExit(f"{DRAGGED} cannot be grabbed; where does the plan show it?")


def tried(page: Page, x: float, y: float) -> bool:
    """Drag there a little and back: was it the box?"""
    page.evaluate("meter.sent = {}")
    page.mouse.click(x, y)  # what is chosen can be dragged
    page.mouse.down()
    page.mouse.move(x + 6, y)
    page.mouse.move(x, y)
    page.mouse.up()
    page.wait_for_timeout(30)
    moved = page.evaluate("Object.values(meter.sent).map(({ id }) => id)")
    if moved and DRAGGED not in moved:
        page.keyboard.press("Control+z")
    return DRAGGED in moved


def dragged(page: Page, x: float, y: float) -> dict[str, list[dict[str, float]]]:
    """What the meter says of a drag on a small circle."""
    page.wait_for_timeout(1000)
    page.evaluate("Object.assign(meter, { maps: [], edits: {}, sent: {}, frames: 0 })")
    page.evaluate("meter.begun = performance.now()")
    page.mouse.move(x, y)
    page.mouse.down()
    for step in range(STEPS):
        angle = step / 12
        page.mouse.move(x + 25 * np.sin(angle), y + 25 * (1 - np.cos(angle)))
        page.wait_for_timeout(EVERY)
    page.evaluate("meter.ended = performance.now()")
    page.mouse.up()
    page.wait_for_timeout(1000)
    found: dict[str, list[dict[str, float]]] = page.evaluate("meter")
    return found


def told(how: str, meter: dict) -> None:  # type: ignore[type-arg]
    """Print the rows of a drag."""
    maps = [one for one in meter["maps"] if one["shown"]]
    seconds = (meter["ended"] - meter["begun"]) / 1000
    for name, key in (("the map in the page", "came"), ("the map on the screen", "shown")):
        row(f"{name}, {how}", [one[key] - one["from"] for one in maps])
    size = max(one["bytes"] for one in meter["sent"].values())
    rates = f"{len(maps) / seconds:.0f} maps, {meter['frames'] / seconds:.0f} frames"
    print(f"| a second, {how} | {rates} | a step is {size} bytes | |")


def row(name: str, waits: list[float]) -> None:
    """Print a row."""
    low, mid, high, worst = np.percentile(waits, (25, 50, 75, 99))
    print(f"| {name} | {mid:.0f} | {low:.0f} to {high:.0f} | {worst:.0f} |")


if __name__ == "__main__":
    main()
