"""The pictures of rooms that were learned from."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest
from starlette.testclient import TestClient

from scenegen_core.knowledge.plans import Plan, PlanBox
from scenegen_core.knowledge.sources import Source
from server.app import make_app
from server.room_plan import room_plan
from server.settings import Settings
from server.world import World
from tests.server.driving import browser

SVG = "{http://www.w3.org/2000/svg}"
HOMES = Source("homes", "Homes & gardens", "CC-BY-4.0", "© 2020 Somebody", 1, 3)
PLAN = Plan(
    source="homes",
    corners=((0, 0), (500, 0), (500, 400), (0, 400)),
    doors=((100, 0, 180, 0),),
    windows=((500, 100, 500, 200),),
    boxes=(
        PlanBox("Sofa", 250, 45, 90, 210, 90, 80),
        PlanBox("Table", 250, 150, 60, 100, 0, 45),
        PlanBox("Picture", 250, 398, 2, 60, 270, 190),
    ),
)


@pytest.fixture
def client(world: World, page_files: Path, tmp_path: Path) -> Iterator[TestClient]:
    settings = Settings(store=tmp_path / "sessions.sqlite3", page=page_files)
    with browser(make_app(settings, world)) as client:
        yield client


@pytest.fixture
def picture() -> ET.Element:
    return ET.fromstring(room_plan(PLAN, "Sofa", "Home 1/Living room", HOMES))


def filled(picture: ET.Element, color: str) -> list[ET.Element]:
    return [one for one in picture.iter(f"{SVG}rect") if one.get("fill") == color]


def test_the_picture_is_the_room_with_a_margin_and_north_is_up(
    picture: ET.Element,
) -> None:
    left, top, width, height = map(float, picture.attrib["viewBox"].split())
    assert (left, top, width) == (-20, -420, 540)
    assert height > 440  # the room, and the source beneath
    outline = next(picture.iter(f"{SVG}polygon")).attrib["points"]
    assert outline == "0,0 500,0 500,-400 0,-400"


def test_what_is_asked_for_alone_stands_out(picture: ET.Element) -> None:
    (sofa,) = filled(picture, "#2f6fed")
    assert (sofa.get("width"), sofa.get("height")) == ("90", "210")
    places = [group.attrib["transform"] for group in picture.iter(f"{SVG}g")]
    assert places[-1] == "translate(250 -45) rotate(-90)"


def test_what_has_no_front_has_no_mark_of_it(picture: ET.Element) -> None:
    marks = [len(group) for group in picture.iter(f"{SVG}g")]
    assert sorted(marks) == [1, 2, 2]


def test_its_source_is_named_beneath(picture: ET.Element) -> None:
    words = " ".join("".join(text.itertext()) for text in picture.iter(f"{SVG}text"))
    assert words == "Home 1/Living room · Homes & gardens · © 2020 Somebody · CC-BY-4.0"


def test_every_room_that_is_named_can_be_fetched(client: TestClient, world: World) -> None:
    name = world.knowledge.choice("Sofa").rooms[0]
    response = client.get(f"/knowledge/rooms/{name}.svg?category=Sofa")
    assert response.status_code == 200
    assert response.headers["content-type"].startswith("image/svg+xml")
    assert "#2f6fed" in response.text
    assert re.search(r"©", response.text)


def test_a_room_that_is_not_known_is_said_so(client: TestClient) -> None:
    response = client.get("/knowledge/rooms/nowhere/at all.svg")
    assert response.status_code == 404
    assert response.json()["text"] == "There is no plan of that room in what was learned."
