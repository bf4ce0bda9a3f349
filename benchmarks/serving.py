"""How soon the server answers, what it costs when nobody does anything, and how much a room weighs.

    python benchmarks/serving.py > benchmarks/results/serving.md

Linux only: reads /proc. *Warm* starts find their files in memory, *cold* ones do not (they are
asked out of it with ``posix_fadvise``; those that other programs use stay). *First map* counts from
the start of the program until the heat map of a sofa in a furnished room has come over the socket.
"""

from __future__ import annotations

import argparse
import os
import socket
import subprocess
import sys
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory
from time import perf_counter, sleep

import msgspec
from websockets.sync.client import connect
from websockets.typing import Subprotocol

from scenegen_core.scene.files import SceneRecord
from server.protocol import MAX_SESSIONS_AN_ADDRESS, SUBPROTOCOL, Answer, Ask, Maps, Query
from tests.server.driving import Page

ROOT = Path(__file__).parents[1]
ROOM = ROOT / "web" / "public" / "rooms" / "kitchen-dining.json"  # 14 boxes
RUNS = 5
SETTLING = 3.0  # seconds until what follows the last message is done
QUERY = Query(category="Sofa")
CLOCK = os.sysconf("SC_CLK_TCK")  # ticks a second


@contextmanager
def started(*more: str) -> Iterator[tuple[int, int, float]]:
    """A server of its own, with ``more`` options: its process, its port, when it was started."""
    with socket.create_server(("127.0.0.1", 0)) as free:
        port = free.getsockname()[1]
    with TemporaryDirectory() as directory:
        store = str(Path(directory) / "store")
        command = ("-m", "server.cli", "serve", "--port", str(port), "--store", store, *more)
        begin = perf_counter()
        process = subprocess.Popen(  # noqa: S603 (ourselves)
            [sys.executable, *command], cwd=ROOT, stdout=subprocess.DEVNULL
        )
        try:
            yield process.pid, port, begin
        finally:
            process.terminate()
            process.wait()


def answers(port: int) -> None:
    """Return when the server has answered."""
    while True:
        try:
            with socket.create_connection(("127.0.0.1", port)) as asking:
                asking.sendall(b"GET /health HTTP/1.0\r\nHost: localhost\r\n\r\n")
                if b" 200 " in asking.recv(100):
                    return
        except OSError:
            sleep(0.005)


def opened(port: int, number: int = 0, *, until: type[Answer | Maps] = Answer) -> Page:
    """A page with a furnished room and its first answer, or only its map."""
    here = f"127.0.0.{1 + number // MAX_SESSIONS_AN_ADDRESS}"  # so that no address has too many
    page = Page(
        connect(
            f"ws://127.0.0.1:{port}/socket",
            subprotocols=[Subprotocol(SUBPROTOCOL)],
            source_address=(here, 0),
            max_size=None,
            proxy=None,
        )
    )
    page.open(msgspec.json.decode(ROOM.read_bytes(), type=SceneRecord))
    page.send(Ask(id="sofa", query=QUERY))
    page.until(until)
    return page


def starts(runs: int, *, cold: bool) -> tuple[list[float], list[float]]:
    """Seconds until the first answer, and until the first map."""
    found: tuple[list[float], list[float]] = ([], [])
    for _ in range(runs):
        if cold:
            forget_files()
        with started() as (_, port, begin):
            answers(port)
            found[0].append(perf_counter() - begin)
            opened(port, until=Maps).socket.close()
            found[1].append(perf_counter() - begin)
    return found


def forget_files() -> None:
    """Ask the system to drop Python's and our files from memory."""
    for root in (Path(sys.prefix), Path(sys.base_prefix), ROOT / "server", ROOT / "scenegen_core"):
        for path in root.rglob("*"):
            if path.suffix in {".py", ".pyc", ".so", ".npz"}:
                handle = os.open(path, os.O_RDONLY)
                os.posix_fadvise(handle, 0, 0, os.POSIX_FADV_DONTNEED)
                os.close(handle)


def cpu_seconds(process: int) -> float:
    """What a process has used of the processor."""
    fields = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / CLOCK


def memory(process: int) -> float:
    """What a process has in memory of its own, megabytes."""
    lines = Path(f"/proc/{process}/smaps_rollup").read_text().splitlines()
    own = [int(line.split()[1]) for line in lines if line.startswith(("Private", "Swap:"))]
    return sum(own) / 1000


@dataclass(frozen=True)
class Idle:
    """A server that nobody talks to, with rooms open."""

    share: float
    """Of a core."""
    each: float
    """Megabytes that one more room takes."""
    all: float
    """Megabytes of the program with as many rooms again."""


def idle(sockets: int, seconds: float) -> Idle:
    """Look at a server with that many sockets, then at what as many again weigh."""
    with started() as (process, port, _), ExitStack() as stack:
        answers(port)
        weights = []
        for wave in range(2):  # the first one also fills the working memory of the threads
            for number in range(sockets):
                stack.enter_context(opened(port, wave * sockets + number).socket)
            sleep(SETTLING)
            weights.append(memory(process))
            if wave == 0:
                begin = cpu_seconds(process)
                sleep(seconds)
                share = (cpu_seconds(process) - begin) / seconds
        return Idle(share, (weights[1] - weights[0]) / sockets, weights[1])


def main() -> None:
    """Measure all, print a table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--sockets", type=int, default=50)
    parser.add_argument("--seconds", type=float, default=20.0, help="how long to stay idle")
    arguments = parser.parse_args()
    print("| measured | value | of |\n| --- | --- | --- |")
    for name, cold in (("warm", False), ("cold", True)):
        for what, values in zip(("answer", "map"), starts(RUNS, cold=cold), strict=True):
            spread = f"{min(values):.2f} to {max(values):.2f}"
            print(f"| first {what}, {name} start | {median(values):.2f} s | {RUNS}: {spread} |")
    found = idle(arguments.sockets, arguments.seconds)
    number = arguments.sockets
    print(f"| idle | {100 * found.share:.2f} % of a core | {number} sockets |")
    print(f"| memory of one more room | {found.each:.2f} MB | {number} more |")
    print(f"| memory of all | {found.all:.0f} MB | {2 * number} rooms |")


if __name__ == "__main__":
    main()
