"""Who may come in: this machine, and from elsewhere whoever has the token."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path

import pytest
from starlette.testclient import TestClient
from starlette.websockets import WebSocketDisconnect

from server.app import make_app
from server.joining import Join
from server.settings import Settings
from server.world import World
from tests.server.driving import browser

LAN = "https://192.168.1.5:8000"
JOIN = Join(token="S3cret", base=LAN, guide="http://192.168.1.5:8001")
PATHS = ("/", "/rooms", "/rooms/scan.json", "/knowledge.json", "/join.json", "/join.svg", "/health")

Visit = Callable[..., TestClient]


@pytest.fixture
def visit(world: World, page_files: Path, tmp_path: Path) -> Iterator[Visit]:
    """A browser somewhere, and what it asks for."""
    with ExitStack() as open_clients:

        def opened(
            host: str = "192.168.1.77", url: str = LAN, join: Join | None = JOIN
        ) -> TestClient:
            settings = Settings(store=tmp_path / f"{host}.sqlite3", page=page_files)
            client = browser(make_app(settings, world, join), host, url)
            return open_clients.enter_context(client)

        yield opened


def can_talk(client: TestClient, **headers: str) -> bool:
    """Whether the server opens a socket."""
    address = str(client.base_url).replace("http", "ws", 1) + "/socket"
    try:
        with client.websocket_connect(address, ["scenegen.1"], headers=headers) as socket:
            socket.send_text('{"type":"hello"}')
            return "welcome" in socket.receive_text()
    except WebSocketDisconnect:
        return False


@pytest.mark.parametrize("path", PATHS)
def test_a_stranger_sees_nothing(visit: Visit, path: str) -> None:
    response = visit().get(path)
    assert response.status_code == 403
    assert "scan the code" in response.text
    assert "frame-ancestors 'none'" in response.headers["content-security-policy"]


def test_a_stranger_can_neither_talk_nor_post(visit: Visit) -> None:
    client = visit()
    assert not can_talk(client)
    assert client.post("/scenes/check", content=b"{}").status_code == 403


def test_a_person_who_is_refused_reads_text(visit: Visit) -> None:
    response = visit().get("/", headers={"accept": "text/html,*/*"})
    assert response.status_code == 403
    assert response.headers["content-type"].startswith("text/plain")


def test_the_token_opens_the_door_and_leaves_the_address(visit: Visit) -> None:
    response = visit().get("/?join=S3cret&room=scan")
    assert response.status_code == 303
    assert response.headers["location"] == f"{LAN}/?room=scan"
    cookie = response.headers["set-cookie"]
    for part in ("S3cret", "HttpOnly", "Secure", "SameSite=lax", "Path=/"):
        assert part in cookie


def test_after_the_first_visit_the_phone_is_known(visit: Visit) -> None:
    client = visit()
    client.get("/?join=S3cret")
    assert [path for path in PATHS if client.get(path).status_code != 200] == []
    assert can_talk(client, origin=LAN)
    posted = client.post("/scenes/check", content=b"{}", headers={"origin": LAN})
    assert posted.status_code == 422


def test_a_known_phone_is_still_no_door_for_other_sites(visit: Visit) -> None:
    client = visit()
    client.get("/?join=S3cret")
    for site in ("https://elsewhere.example", "http://192.168.1.5:8001", "https://192.168.1.5"):
        assert not can_talk(client, origin=site)
        assert (
            client.post("/scenes/check", content=b"{}", headers={"origin": site}).status_code == 403
        )


@pytest.mark.parametrize("wrong", ["", "s3cret", "S3cret ", "Sécret", "S3cretS3cret"])
def test_a_wrong_token_opens_nothing(visit: Visit, wrong: str) -> None:
    client = visit()
    assert client.get("/", params={"join": wrong}).status_code == 403
    assert client.get("/", headers={"cookie": f"scenegen-join={wrong!a}"}).status_code == 403


@pytest.mark.parametrize(
    ("host", "url"),
    [
        ("127.0.0.1", "https://localhost:8000"),
        ("127.0.0.1", "https://127.0.0.1:8000"),
        ("::1", "https://[::1]:8000"),
        ("::ffff:127.0.0.1", "https://localhost:8000"),
    ],
)
def test_this_machine_needs_no_token(visit: Visit, host: str, url: str) -> None:
    client = visit(host, url)
    assert client.get("/").status_code == 200
    assert can_talk(client)


@pytest.mark.parametrize("join", [JOIN, None])
@pytest.mark.parametrize("name", ["tunnel.example", "localhost.example", "192.168.1.5:8000"])
def test_what_comes_in_under_another_name_is_from_elsewhere(
    visit: Visit, name: str, join: Join | None
) -> None:
    """A tunnel ends on this machine; so does a name that a site made point to it."""
    client = visit("127.0.0.1", f"http://{name}", join)
    assert client.get("/").status_code == 403
    assert not can_talk(client, origin=f"http://{name}")


def test_without_a_way_in_no_token_helps(visit: Visit) -> None:
    client = visit(join=None)
    for token in ("", "None", "S3cret"):
        assert client.get("/", params={"join": token}).status_code == 403


def test_the_page_can_show_how_to_join(visit: Visit) -> None:
    client = visit("127.0.0.1", "https://localhost:8000")
    assert client.get("/join.json").json()["address"] == "http://192.168.1.5:8001/#S3cret"
    picture = client.get("/join.svg")
    assert picture.headers["content-type"] == "image/svg+xml"
    assert picture.headers["cache-control"] == "no-store"
    assert "<svg" in picture.text
    assert "viewBox" in picture.text


def test_the_code_leads_on_to_the_room_of_a_session(visit: Visit) -> None:
    client = visit("127.0.0.1", "https://localhost:8000")
    info = client.get("/join.json", params={"session": "r4nd&m"}).json()
    assert info["address"] == "http://192.168.1.5:8001/#S3cret&session=r4nd%26m"
    plain, leading = (
        client.get("/join.svg", params={"session": session}) for session in ("", "room")
    )
    assert leading.content != plain.content
    assert client.get("/join.svg", params={"session": "x" * 5000}).status_code == 200


def test_the_page_can_say_why_nobody_can_join(visit: Visit) -> None:
    client = visit("127.0.0.1", "http://localhost:8000", join=None)
    info = client.get("/join.json").json()
    assert info["address"] is None
    assert "make run LAN=1" in info["text"]
    assert client.get("/join.svg").status_code == 404


def test_a_certificate_that_browsers_know_needs_no_guide() -> None:
    trusted = Join(token="S3cret", base="https://me.example.net:8000")
    assert trusted.address == "https://me.example.net:8000/?join=S3cret"
