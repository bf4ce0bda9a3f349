"""The production page in a real browser, talking to the real server."""

from __future__ import annotations

import re
import shutil
import socket
import subprocess
import sys
import urllib.error
import urllib.request
from collections.abc import Callable, Iterator
from pathlib import Path
from time import monotonic, sleep

import pytest
from playwright.sync_api import Browser, ConsoleMessage, Page, ViewportSize, sync_playwright

ROOT = Path(__file__).parents[2]
PICTURES = ROOT / "test-results"
DESKTOP: ViewportSize = {"width": 1440, "height": 900}
PHONE: ViewportSize = {"width": 412, "height": 915}
PATIENCE = 60.0  # seconds; a slow machine may take long, only a hang takes longer
BROWSERS = ("chromium", "chromium-browser", "google-chrome")
# WebGL drawn by the processor, for machines without a graphics card.
FLAGS = (
    "--no-sandbox",
    "--disable-gpu",
    "--use-gl=angle",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--no-first-run",
)

OpenPage = Callable[..., Page]


@pytest.fixture(scope="session")
def server_url(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """The address of a running `scenegen serve` with an empty store."""
    if not (ROOT / "web" / "dist" / "index.html").exists():
        pytest.fail("The page is not built; run: make page")
    directory = tmp_path_factory.mktemp("server")
    port = _free_port()
    with (directory / "log.txt").open("wb") as log:
        process = subprocess.Popen(
            [
                sys.executable,
                *("-m", "server.cli", "serve"),
                *("--port", str(port), "--store", str(directory / "sessions.sqlite3")),
            ],
            cwd=ROOT,
            stdout=log,
            stderr=subprocess.STDOUT,
        )
    try:
        url = f"http://127.0.0.1:{port}"
        _wait_until_served(url, process, directory / "log.txt")
        yield url
    finally:
        process.terminate()
        process.wait(timeout=PATIENCE)
    said = (directory / "log.txt").read_text(errors="replace")
    assert "Traceback" not in said, said


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    """The browser that is installed here, else Playwright's own.

    One a module: while it is open Playwright runs an event loop, beside which no other can run.
    """
    installed = next(filter(None, map(shutil.which, BROWSERS)), None)
    with sync_playwright() as playwright:
        chromium = playwright.chromium.launch(executable_path=installed, args=list(FLAGS))
        yield chromium
        chromium.close()


@pytest.fixture
def open_page(
    request: pytest.FixtureRequest, browser: Browser, server_url: str
) -> Iterator[OpenPage]:
    """Opens the page at a path; afterwards takes its picture and fails on console errors."""
    pages: list[Page] = []
    complaints: list[str] = []

    def listen(message: ConsoleMessage) -> None:
        if message.type == "error":
            complaints.append(f"{message.text} ({message.location['url']})")

    def open_at(path: str = "/", *, viewport: ViewportSize = DESKTOP, touch: bool = False) -> Page:
        context = browser.new_context(
            viewport=viewport, has_touch=touch, is_mobile=touch, reduced_motion="reduce"
        )
        page = context.new_page()
        page.set_default_timeout(PATIENCE * 1000)
        page.on("console", listen)
        page.on("pageerror", lambda error: complaints.append(str(error)))
        page.goto(server_url + path)
        pages.append(page)
        return page

    yield open_at
    for page in pages:
        take_picture(page, request.node.name)
        page.context.close()
    assert complaints == []


@pytest.fixture
def desktop(open_page: OpenPage) -> Page:
    """The page as it opens on a desktop, 1440 by 900."""
    return open_page()


@pytest.fixture
def phone(open_page: OpenPage) -> Page:
    """The page as it opens on a phone, 412 by 915, touched."""
    return open_page(viewport=PHONE, touch=True)


@pytest.fixture(params=["desktop", "phone"])
def page(request: pytest.FixtureRequest) -> Page:
    """The page on a desktop and then on a phone."""
    opened: Page = request.getfixturevalue(request.param)
    return opened


def take_picture(page: Page, name: str) -> None:
    """Save what the page shows in test-results/."""
    PICTURES.mkdir(exist_ok=True)
    stem = re.sub(r"\W+", "-", name).strip("-")
    page.screenshot(path=PICTURES / f"{stem}.png")


def _free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port: int = probe.getsockname()[1]
        return port


def _wait_until_served(url: str, process: subprocess.Popen[bytes], log: Path) -> None:
    end = monotonic() + PATIENCE
    while monotonic() < end:
        if process.poll() is not None:
            break
        try:
            with urllib.request.urlopen(url):
                return
        except urllib.error.URLError:
            sleep(0.1)
    pytest.fail(f"The server does not answer:\n{log.read_text(errors='replace')}")
