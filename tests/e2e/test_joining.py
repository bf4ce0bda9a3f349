"""A phone joins over HTTPS as a person does it: scan, read, press through the warning."""

from __future__ import annotations

import re
from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, Page, expect

from tests.e2e.conftest import DESKTOP, PATIENCE, PHONE, take_picture
from tests.e2e.driving import Desk
from tests.server.driving import started

pytestmark = pytest.mark.browser


@pytest.fixture(scope="module")
def address(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """What the code of a server for the network says."""
    store = tmp_path_factory.mktemp("lan") / "sessions.sqlite3"
    with started("--lan", "--port", "0", "--store", str(store)) as (_, printed):
        found = re.search(r"http://\S+/#\S+", printed)
        assert found is not None
        yield found[0]


@pytest.fixture
def phone(browser: Browser, request: pytest.FixtureRequest) -> Iterator[Page]:
    """A phone that was never here."""
    context = browser.new_context(viewport=PHONE, has_touch=True, is_mobile=True)
    page = context.new_page()
    page.set_default_timeout(PATIENCE * 1000)
    yield page
    take_picture(page, request.node.name)
    context.close()


def press_through_the_warning(phone: Page) -> None:
    phone.locator("#details-button").tap()
    phone.locator("#proceed-link").tap()


def test_the_code_leads_over_an_explanation_and_the_warning_into_the_room(
    phone: Page, address: str
) -> None:
    sockets: list[str] = []
    phone.on("websocket", lambda socket: sockets.append(socket.url))
    phone.goto(address)
    expect(phone.get_by_role("heading")).to_contain_text("Your browser will warn you")
    expect(phone.get_by_text("The code to join is missing")).to_be_hidden()
    phone.get_by_role("link", name="Open SceneGen").tap()
    expect(phone.locator("body")).to_contain_text("Your connection is not private")
    press_through_the_warning(phone)
    phone.get_by_role("button", name="Put a sofa in this room").wait_for()
    assert phone.url.startswith("https://")
    assert address.partition("#")[2] not in phone.url
    assert [url.partition("://")[0] for url in sockets] == ["wss"]
    secure, has_xr, cookies = phone.evaluate(
        "[isSecureContext, 'xr' in navigator, document.cookie]"
    )
    assert secure
    assert has_xr
    assert cookies == ""  # scripts cannot read the token
    phone.goto(phone.url)  # typed by hand, another day
    phone.get_by_role("button", name="Put a sofa in this room").wait_for()


def test_without_the_code_a_phone_stays_outside(phone: Page, address: str) -> None:
    phone.goto(address.partition("#")[0])
    expect(phone.get_by_text("The code to join is missing")).to_be_visible()
    phone.get_by_role("link", name="Open SceneGen").tap()
    press_through_the_warning(phone)
    expect(phone.locator("body")).to_contain_text("scan the code that its terminal shows")


def test_a_phone_goes_on_with_the_room_that_the_page_shows(
    phone: Page, browser: Browser, address: str
) -> None:
    expect.set_options(timeout=PATIENCE * 1000)
    context = browser.new_context(viewport=DESKTOP, ignore_https_errors=True)
    page = context.new_page()
    page.set_default_timeout(PATIENCE * 1000)
    desk = Desk(page)
    page.goto(address)
    page.get_by_role("link", name="Open SceneGen").click()
    desk.close_greeting()
    desk.open_room("Bedroom")
    page.get_by_role("button", name="Open on your phone").click()
    code = page.get_by_role("img", name="Code to scan")
    page.wait_for_function("(code) => code.naturalWidth > 0", arg=code.element_handle())
    take_picture(page, "join-dialog")
    phone.goto(page.locator(".join .address").inner_text())
    phone.get_by_role("link", name="Open SceneGen").tap()
    press_through_the_warning(phone)
    expect(phone.locator("button.room-name")).to_have_text("Bedroom")
    expect(phone.get_by_text("Connected")).to_be_attached()
    assert "session" not in phone.url
    expect(page.locator(".pill")).to_contain_text("open elsewhere")
    phone.locator("button.room-name").tap()
    phone.locator("#rooms-menu").get_by_role("button", name="New room").tap()
    expect(phone.get_by_text("Connected")).to_be_attached()
    page.reload()  # what the phone did is not lost
    expect(page.locator("button.room-name")).to_have_text("My room")
    context.close()
