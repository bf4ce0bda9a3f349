"""The routes: the page, rooms, models, exports, and who may post."""

from __future__ import annotations

import io
import json
import struct
from collections.abc import Iterator
from pathlib import Path

import msgspec
import pytest
from PIL import Image
from shapely import Polygon
from starlette.testclient import TestClient

from scenegen_core.scene.files import SceneRecord, read_scene
from server.app import make_app
from server.protocol import RoomInfo
from server.settings import Settings
from server.world import World
from tests.core import test_quest
from tests.core.datasets import test_mruk
from tests.server.driving import ROOM, SCENE, TABLE, browser

ROOMPLAN = Path(__file__).parents[1] / "fixtures" / "roomplan_two_stories.json"
LIVING_ROOM = Path(__file__).parents[1] / "fixtures" / "living_room.json"


@pytest.fixture
def client(world: World, page_files: Path, tmp_path: Path) -> Iterator[TestClient]:
    settings = Settings(store=tmp_path / "sessions.sqlite3", page=page_files)
    with browser(make_app(settings, world)) as client:
        yield client


def scene(**changes: object) -> bytes:
    return msgspec.json.encode(msgspec.structs.replace(SCENE, **changes))


def test_the_page_is_served_and_asked_for_again_each_time(client: TestClient) -> None:
    response = client.get("/")
    assert "SceneGen" in response.text
    assert response.headers["cache-control"] == "no-cache"
    again = client.get("/", headers={"if-none-match": response.headers["etag"]})
    assert again.status_code == 304


def test_files_with_a_hash_in_their_name_are_kept_forever(client: TestClient) -> None:
    assert "immutable" in client.get("/assets/index-abc123.js").headers["cache-control"]


def test_a_page_that_is_not_built_says_how_to_build_it(world: World, tmp_path: Path) -> None:
    settings = Settings(store=tmp_path / "store", page=tmp_path / "nowhere")
    with browser(make_app(settings, world)) as client:
        response = client.get("/")
        assert response.status_code == 503
        assert "make page" in response.text
        assert client.get("/index.html").status_code == 404


@pytest.mark.parametrize("path", ["/", "/health", "/rooms", "/nowhere", "/rooms/no.json"])
def test_every_response_limits_what_a_page_may_load(client: TestClient, path: str) -> None:
    headers = client.get(path).headers
    assert "default-src 'self'" in headers["content-security-policy"]
    assert "frame-ancestors 'none'" in headers["content-security-policy"]
    assert headers["x-content-type-options"] == "nosniff"


def test_the_camera_of_a_phone_is_out_of_reach_of_the_page(client: TestClient) -> None:
    assert "camera=()" in client.get("/").headers["permissions-policy"]


@pytest.mark.parametrize("path", ["/../pyproject.toml", "/%2e%2e/store", "/rooms/..%2findex.json"])
def test_files_beside_the_page_are_out_of_reach(client: TestClient, path: str) -> None:
    assert client.get(path).status_code == 404


def test_rooms_are_listed_and_handed_out_by_their_id(client: TestClient) -> None:
    rooms = msgspec.json.decode(client.get("/rooms").content, type=list[RoomInfo])
    assert [(room.id, room.kind, room.area) for room in rooms] == [
        ("living-room", "sample", 20.0),
        ("scan", "scan", 20.0),
    ]
    assert client.get("/rooms/scan.json").content == LIVING_ROOM.read_bytes()
    assert client.get("/rooms/palace.json").status_code == 404


def test_a_model_is_fetched_by_its_hash_and_kept_forever(client: TestClient) -> None:
    socket = client.websocket_connect("ws://localhost/socket", subprotocols=["scenegen.1"])
    with socket as page:
        page.send_text('{"type":"hello"}')
        page.send_bytes(b"")
        page.send_text(
            msgspec.json.encode({"type": "put_scene", "seq": 1, "scene": SCENE}).decode()
        )
        while (frame := page.receive()).get("bytes") is None:
            pass
    (length,) = struct.unpack_from("<I", frame["bytes"])
    digest = json.loads(frame["bytes"][4 : 4 + length])["digest"]
    response = client.get(f"/assets/{digest}.glb")
    assert response.content == frame["bytes"][4 + length :]
    assert response.headers["content-type"] == "model/gltf-binary"
    assert "immutable" in response.headers["cache-control"]
    assert client.get(f"/assets/{'0' * 32}.glb").status_code == 404


def test_a_scene_file_is_checked_and_comes_back_as_this_program_writes_it(
    client: TestClient,
) -> None:
    clockwise = scene(room=msgspec.structs.replace(ROOM, corners=ROOM.corners[::-1]))
    response = client.post("/scenes/check", content=clockwise)
    assert response.headers["content-type"] == "application/json"
    checked = read_scene(response.content)
    assert checked.room.corners == ROOM.corners
    assert [box.id for box in checked.boxes] == ["table"]


def test_a_scan_of_roomplan_comes_back_as_a_scene(client: TestClient) -> None:
    response = client.post("/scenes/check", content=ROOMPLAN.read_bytes())
    scanned = read_scene(response.content)
    assert scanned.name == "Scanned room"
    assert {box.id: box.category for box in scanned.boxes} == {
        "SOFA": "Sofa",
        "STORAGE": "Storage",
        "TV": "TV",
        "TABLE": "Table",
        "CHAIR": "Chair",
        "STOOL": "Chair",
        "FRIDGE": "Storage",
        "TANK": "Other",
    }


def test_captures_of_headsets_come_back_as_scenes(client: TestClient) -> None:
    """Rooms drawn by hand: 4 m by 3 m, and an L of 5 m by 4 m without 2 m by 2 m."""
    saved = {"UUID": "room", "RoomLayout": {}, "Anchors": test_mruk.SHELL}
    unity = json.dumps({"CoordinateSystem": "Unity", "Rooms": [saved]}).encode()
    for capture, area in ((test_quest.drawn(), 12.0), (unity, 16.0)):
        scanned = read_scene(client.post("/scenes/check", content=capture).content)
        assert Polygon(scanned.room.corners).area == pytest.approx(area, abs=0.01)


def test_a_scan_without_a_room_is_refused_in_words(client: TestClient) -> None:
    scan = json.loads(ROOMPLAN.read_text())
    response = client.post("/scenes/check", json=scan | {"walls": [], "floors": []})
    assert response.status_code == 422
    text = response.json()["text"]
    assert "scan" in text
    assert "/" not in text  # no path of the server


@pytest.mark.parametrize(
    ("content", "says"),
    [
        (b"Dear diary", "not a scene file"),
        (b'{"format":"gltf"}', "not a scene file"),
        (b'{"name":"a package","version":"1.0.0"}', "Choose one of those"),
        (scene().replace(b'"version":1', b'"version":9'), "version 9"),
        (scene().replace(b'"size":[0.8', b'"size":[-0.8'), "$.boxes[0].size[0]"),
        (scene().replace(b'"Table"', b'"Spaceship"'), "choose one of Bed"),
        (b'{"format":"scenegen.scene","version":1,"x":' + b"[" * 100_000, "nested"),
    ],
)
def test_a_file_that_is_no_scene_is_refused_in_words(
    client: TestClient, content: bytes, says: str
) -> None:
    response = client.post("/scenes/check", content=content)
    assert response.status_code == 422
    assert says in response.json()["text"]


@pytest.mark.parametrize("path", ["/scenes/check", "/export/room.glb", "/export/heat-map.png"])
def test_a_body_that_is_too_large_is_refused(client: TestClient, path: str) -> None:
    response = client.post(path, content=b" " * 1_000_001)
    assert response.status_code == 413
    assert "1 MB" in response.json()["text"]


def test_the_furnished_room_is_exported_as_one_glb(client: TestClient) -> None:
    response = client.post("/export/room.glb", content=scene())
    assert response.headers["content-type"] == "model/gltf-binary"
    magic, version, length = struct.unpack_from("<4sII", response.content)
    assert (magic, version, length) == (b"glTF", 2, len(response.content))
    bare = client.post("/export/room.glb", content=scene(boxes=()))
    assert len(bare.content) < len(response.content)


def test_the_heat_map_is_exported_as_a_picture_with_the_best_spots_brightest(
    client: TestClient,
) -> None:
    """A wardrobe fills the south east: there the paper shows; where one can stand it is colored."""
    wardrobe = msgspec.structs.replace(
        TABLE, category="Storage", center=(4.0, 1.0, 1.0), size=(1.9, 1.9, 2.0)
    )
    room = SceneRecord(room=ROOM, boxes=(wardrobe,))
    body = msgspec.json.encode({"scene": room, "query": {"category": "Chair", "count": 1}})
    response = client.post("/export/heat-map.png", content=body)
    picture = Image.open(io.BytesIO(response.content)).convert("RGB")
    assert picture.format is None
    assert picture.width == 1200
    south_east, north_west = at(picture, 3.3, 1.7), at(picture, 1.0, 3.0)
    assert south_east == (255, 255, 255)
    assert north_west != (255, 255, 255)


def at(picture: Image.Image, x: float, y: float) -> object:
    """The color at a point of the room, metres: 60 pixels of margin round 5 by 4 m, y up."""
    scale = (1200 - 2 * 60) / 5
    return picture.getpixel((round(60 + x * scale), round(60 + (4 - y) * scale)))


@pytest.mark.parametrize(
    ("query", "says"),
    [({"category": "Spaceship"}, "cannot be placed"), ({}, "$.query"), (None, "$.query")],
)
def test_a_heat_map_of_no_query_is_refused_in_words(
    client: TestClient, query: object, says: str
) -> None:
    body = msgspec.json.encode({"scene": SCENE, "query": query})
    response = client.post("/export/heat-map.png", content=body)
    assert response.status_code == 422
    assert says in response.json()["text"]


@pytest.mark.parametrize(
    "origin", ["https://elsewhere.example", "null", "http://localhost.evil", "http://["]
)
def test_another_site_cannot_post(client: TestClient, origin: str) -> None:
    response = client.post("/scenes/check", content=scene(), headers={"origin": origin})
    assert response.status_code == 403
    assert "another site" in response.json()["text"]


@pytest.mark.parametrize("origin", ["http://localhost", "http://localhost:5173"])
def test_the_own_page_and_pages_of_this_machine_can_post(client: TestClient, origin: str) -> None:
    response = client.post("/scenes/check", content=scene(), headers={"origin": origin})
    assert response.status_code == 200


def test_the_server_says_that_it_is_up(client: TestClient) -> None:
    assert client.get("/health").json() == {"status": "ok"}
