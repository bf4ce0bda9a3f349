"""Houses of ProcTHOR become their rooms, in a right-handed frame."""

from __future__ import annotations

import gzip
import importlib.util
import json
import sys
from collections.abc import Iterator
from math import cos, pi, sin
from pathlib import Path
from typing import Any

import pytest
from shapely import Polygon

from scenegen_core.datasets.formats import format_of, read_scenes
from scenegen_core.datasets.labels import categories_of
from scenegen_core.datasets.remarks import Remark, Skipped
from scenegen_core.datasets.thor_house_file import assets_by_id
from scenegen_core.errors import DataError
from scenegen_core.scene.files import read_scene, write_scene
from scenegen_core.scene.model import PAPER_CATEGORIES, Scene

SIZES = {"Sofa": (2.0, 0.8, 0.9), "Vase": (0.2, 0.4, 0.2), "Painting": (0.6, 0.5, 0.04)}


@pytest.fixture(autouse=True)
def database(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """A small database of assets in the place of the one that the package procthor holds."""
    assets = {
        kind: [{"assetId": f"{kind}_1", "objectType": kind, "boundingBox": xyz(*size)}]
        for kind, size in SIZES.items()
    }
    folder = tmp_path / "packages" / "procthor" / "databases"
    folder.mkdir(parents=True)
    (folder.parent / "__init__.py").touch()
    (folder / "asset-database.json").write_text(json.dumps(assets))
    monkeypatch.syspath_prepend(tmp_path / "packages")
    assets_by_id.cache_clear()
    yield
    assets_by_id.cache_clear()


def xyz(x: float, y: float, z: float) -> dict[str, float]:
    return {"x": x, "y": y, "z": z}


def floor(room: int, kind: str, west: float, east: float) -> dict[str, Any]:
    """A room 3 m deep (z) between two walls, listed clockwise as seen from above."""
    corners = [(west, 0), (west, 3), (east, 3), (east, 0)]
    return {
        "id": f"room|{room}",
        "roomType": kind,
        "floorPolygon": [xyz(x, 0, z) for x, z in corners],
    }


def thing(asset: str, x: float, y: float, z: float, turn: float = 0, **more: Any) -> dict[str, Any]:
    place = {"position": xyz(x, y, z), "rotation": xyz(0, turn, 0)}
    return {"id": f"{asset}|at|{x}", "assetId": asset, "children": [], **place, **more}


# The wall between the two rooms, seen from the first: from (4, 0) to (4, 3), 2.5 m high.
WALL: dict[str, Any] = {
    "id": "wall|1|east",
    "roomId": "room|1",
    "polygon": [xyz(4, 0, 0), xyz(4, 0, 3), xyz(4, 2.5, 3), xyz(4, 2.5, 0)],
}


def house(*objects: dict[str, Any], **more: Any) -> dict[str, Any]:
    rooms = [floor(1, "LivingRoom", 0, 4), floor(2, "Bedroom", 4, 7)]
    return {"rooms": rooms, "walls": [WALL], "objects": list(objects), **more}


def read(path: Path, value: object, remarks: list[Remark] | None = None) -> list[Scene]:
    """The rooms of a house; what is said about it goes to ``remarks``, or must be nothing."""
    said: list[Remark] = []
    path.write_text(json.dumps(value))
    scenes = list(read_scenes(path, said.append))
    if remarks is None:
        assert said == []
    else:
        remarks += said
    return scenes


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return tmp_path / "house.json"


def test_rooms_lie_as_seen_from_above(path: Path) -> None:
    living, bedroom = read(path, house())
    expected = Polygon([(0, 0), (4, 0), (4, 3), (0, 3)])
    assert Polygon(living.room.corners).symmetric_difference(expected).area < 1e-9
    assert Polygon(living.room.corners).exterior.is_ccw
    assert (living.id, living.room.room_type, living.room.height) == (
        "house/1/1", "LivingRoom", 2.5,
    )  # fmt: skip
    assert (bedroom.id, bedroom.room.room_type) == ("house/1/2", "Bedroom")


@pytest.mark.parametrize(
    ("turn", "heading"), [(0, pi / 2), (90, 0), (180, -pi / 2), (270, pi), (30, pi / 3)]
)
def test_a_model_looks_north_and_turns_clockwise(path: Path, turn: float, heading: float) -> None:
    (box,) = read(path, house(thing("Sofa_1", 1.5, 0.4, 2, turn)))[0].boxes
    assert (box.category, box.label, box.front_known) == ("Sofa", "Sofa", True)
    assert box.center == pytest.approx((1.5, 2, 0.4))
    assert box.size == pytest.approx((0.9, 2.0, 0.8))
    assert (cos(box.heading), sin(box.heading)) == pytest.approx((cos(heading), sin(heading)))


def test_a_model_that_lies_on_its_back_has_an_upright_box(path: Path) -> None:
    lying = thing("Sofa_1", 1.5, 0.5, 2) | {"rotation": xyz(90, 0, 0)}
    (box,) = read(path, house(lying))[0].boxes
    assert box.size == pytest.approx((0.8, 2.0, 0.9))


def test_what_stands_on_an_object_has_it_as_its_parent_and_goes_to_its_own_room(path: Path) -> None:
    vase = thing("Vase_1", 1.5, 1.0, 2)
    sofa = thing("Sofa_1", 1.5, 0.4, 2, children=[vase])
    living, bedroom = read(path, house(sofa, thing("Painting_1", 5, 1.6, 2.98, 180)))
    assert [(box.category, box.parent) for box in living.boxes] == [
        ("Sofa", None), ("Decor", "Sofa_1|at|1.5"),
    ]  # fmt: skip
    assert [box.category for box in bedroom.boxes] == ["Picture"]


@pytest.mark.parametrize(
    "hole",
    [
        {"holePolygon": [xyz(0.5, 0, 0), xyz(1.5, 2.1, 0)]},
        {"boundingBox": {"min": xyz(0.5, 0, 0), "max": xyz(1.5, 2.1, 0)}},
    ],
    ids=["new", "old"],
)
def test_a_door_is_measured_along_its_wall_and_leads_to_both_rooms(
    path: Path, hole: dict[str, Any]
) -> None:
    door = {"id": "door|1|2", "wall0": "wall|1|east", "wall1": "wall|2|west", **hole}
    for scene in read(path, house(doors=[door])):
        (opening,) = scene.room.doors
        assert (opening.start, opening.end) == ((4, 0.5), (4, 1.5))
        assert (opening.bottom, opening.top) == (0, 2.1)


def test_a_window_is_in_the_room_of_its_wall(path: Path) -> None:
    west = [xyz(0, 0, 3), xyz(0, 0, 0), xyz(0, 2.5, 3), xyz(0, 2.5, 0)]
    wall = {"id": "wall|1|west", "roomId": "room|1", "polygon": west}
    window = {
        "id": "w",
        "wall0": "wall|1|west",
        "holePolygon": [xyz(1, 0.9, 0), xyz(1.8, 2, 0)],
    }
    living, bedroom = read(path, house(walls=[WALL, wall], windows=[window]))
    (opening,) = living.room.windows
    assert (*opening.start, *opening.end) == pytest.approx((0, 2, 0, 1.2))
    assert (opening.bottom, opening.top) == (0.9, 2)
    assert bedroom.room.windows == ()


def test_one_house_a_line_is_read_too(path: Path) -> None:
    path = path.with_suffix(".jsonl.gz")
    text = "\n".join([json.dumps(house()), "", json.dumps(house(thing("Sofa_1", 1.5, 0.4, 2)))])
    path.write_bytes(gzip.compress(text.encode()))
    assert format_of(path).name == "procthor"
    scenes = list(read_scenes(path))
    assert [scene.id for scene in scenes] == [
        "house/1/1", "house/1/2", "house/3/1", "house/3/2",
    ]  # fmt: skip
    assert [len(scene.boxes) for scene in scenes] == [0, 0, 1, 0]


def test_a_house_over_many_lines_is_read_too(path: Path) -> None:
    path.write_text(json.dumps(house(), indent=2))
    assert len(list(read_scenes(path))) == 2


def test_a_house_is_a_scene_file(path: Path) -> None:
    (scene, _) = read(path, house(thing("Sofa_1", 1.5, 0.4, 2)))
    assert read_scene(write_scene(scene)) == scene


@pytest.mark.parametrize(
    ("wrong", "what", "reason"),
    [
        ({"objects": [thing("Spaceship_1", 1, 1, 1)]}, "Spaceship_1|at|1", "not in the database"),
        ({"objects": [{"id": "s"}]}, "object 0", "assetId"),
        ({"objects": [thing("Sofa_1", 99, 0, 1)]}, "Sofa_1|at|99", "stands in no room"),
        ({"objects": [thing("Sofa_1", 1, 0, 1)] * 2}, "Sofa_1|at|1", "the same id"),
        ({"doors": [{"id": "d", "wall0": "?"}]}, "opening 'd'", "wall or its hole is missing"),
        (
            {
                "windows": [
                    {
                        "id": "w",
                        "wall0": "wall|1|east",
                        "holePolygon": [xyz(0, 2, 0), xyz(1, 1, 0)],
                    }
                ]
            },
            "opening 'w'",
            "ends below",
        ),
        ({"walls": [{"id": "w"}]}, "wall 0", "polygon"),
        (
            {"rooms": [floor(1, "Bedroom", 0, 4), floor(2, "Bedroom", 4, 4)]},
            "room 'room|2'",
            "corners",
        ),
    ],
)
def test_what_is_broken_is_named_and_left_out(
    path: Path, wrong: dict[str, Any], what: str, reason: str
) -> None:
    said: list[Remark] = []
    scenes = read(path, house() | wrong, said)
    assert scenes[0].id == "house/1/1"
    (skipped,) = said
    assert isinstance(skipped, Skipped)
    assert what in skipped.what
    assert reason in skipped.reason


def test_a_broken_house_is_named_and_left_out(path: Path) -> None:
    said: list[Remark] = []
    path.write_text(json.dumps(house()) + '\n{"rooms": 1}\n')
    assert len(list(read_scenes(path, said.append))) == 2
    assert [str(remark) for remark in said] == [
        f"{path}, house 2: Expected `array`, got `int` - at `$.rooms`"
    ]


def test_without_the_database_the_message_says_what_to_install(
    path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "procthor", None)
    with pytest.raises(DataError, match=r'pip install "scenegen\[thor\]"'):
        read(path, house())


def test_the_reviewed_labels_lead_to_the_papers_categories() -> None:
    named = {category for category in categories_of("thor").values() if category}
    assert named <= {category.name for category in PAPER_CATEGORIES}


def test_every_kind_of_the_published_database_is_reviewed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.undo()
    if importlib.util.find_spec("procthor") is None:
        pytest.skip("the package procthor is not installed")
    assert {asset.object_type for asset in assets_by_id().values()} <= categories_of("thor").keys()
    assert len(assets_by_id()) > 1000
