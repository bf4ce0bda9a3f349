"""How soon a map follows a change over a socket: one box dragged, then many rooms at once.

    python benchmarks/following.py

The server is a process of its own, on this machine; the page is a program without a screen, so
drawing is not in the figures. A drag sends as the page does; its steps wait for no answer.
"""

from __future__ import annotations

from contextlib import ExitStack
from threading import Thread
from time import perf_counter, sleep

import numpy as np
from serving import answers, opened, started

from scenegen_core.scene.files import BoxRecord
from server.protocol import Maps, PutBoxes
from tests.server.driving import Page

STEPS, EVERY = 150, 0.033  # of a drag, and seconds between two
SESSIONS, CHANGES = 50, 15  # rooms at once, and how often each changes


class Drag:
    """Steps that are sent, and when a map of each came or of a newer one."""

    def __init__(self, page: Page, first: int) -> None:
        self.page, self.first = page, first
        self.sent: dict[int, float] = {}
        self.waits: list[float] = []
        self.maps: list[float] = []
        self.revisions: list[int] = []

    def read(self, until: int) -> None:
        """Note every map until that revision has one."""
        while True:
            message = self.page.next()
            if isinstance(message, Maps) and message.revision in self.sent:
                now = perf_counter()
                self.maps.append(now)
                self.waits.append(now - self.sent[message.revision])
                if message.revision >= until:
                    return

    def step(self, number: int) -> None:
        """Send one step."""
        seq = self.first + number
        box = BoxRecord(
            id="dragged",
            category="Other",
            center=(1.2 + 0.3 * float(np.cos(number / 9)), 2.6, 0.2),
            size=(0.5, 0.5, 0.4),
        )
        self.sent[seq] = perf_counter()
        self.page.send(PutBoxes(seq=seq, boxes=(box,)))


def drag(page: Page, steps: int, every: float) -> Drag:
    """Drag a box; return when its last map has come."""
    one = Drag(page, 2)
    reader = Thread(target=one.read, args=(1 + steps,))
    reader.start()
    for number in range(steps):
        one.step(number)
        sleep(every)
    reader.join()
    return one


def told(name: str, waits: list[float]) -> None:
    """Print a row."""
    low, mid, high, worst = np.percentile(1000 * np.array(waits), (25, 50, 75, 99))
    print(f"| {name} | {mid:.0f} | {low:.0f} to {high:.0f} | {worst:.0f} | {len(waits)} |")


def main() -> None:
    """Measure both, print a table."""
    print("| from change to map | median ms | quartiles | p99 | maps |")
    print("| --- | --- | --- | --- | --- |")
    with started() as (_, port, _):
        answers(port)
        one = drag(opened(port), STEPS, EVERY)
        told("one drag", one.waits)
        span = one.maps[-1] - one.maps[0]
        rate = len(one.maps) / span
        print(f"| maps a second, of {1 / EVERY:.0f} steps | {rate:.0f} | | | |")
    told(f"{SESSIONS} rooms, each once a second", many(SESSIONS, 1.0))
    for workers, on in (("1", "one process"), ("2", "two processes")):
        name = f"{SESSIONS} rooms, each three times a second, {on}"
        told(name, many(SESSIONS, 1 / 3, "--workers", workers))


def many(rooms: int, every: float, *more: str) -> list[float]:
    """The waits of as many rooms, each changed that often, of a server with those options."""
    with started(*more) as (_, port, _), ExitStack() as stack:
        answers(port)
        pages = [Page(stack.enter_context(opened(port, n).socket)) for n in range(rooms)]
        found: list[Drag] = []
        threads = []
        for page in pages:
            sleep(every / rooms)
            threads.append(Thread(target=lambda p=page: found.append(drag(p, CHANGES, every))))
            threads[-1].start()
        for thread in threads:
            thread.join()
    return [wait for one in found for wait in one.waits]


if __name__ == "__main__":
    main()
