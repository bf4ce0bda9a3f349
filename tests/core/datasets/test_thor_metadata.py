"""Object metadata of AI2-THOR become the rooms that they were dumped from."""

from __future__ import annotations

import gzip
import importlib.util
import json
from math import cos, pi, radians, sin
from pathlib import Path
from typing import Any

import pytest

from scenegen_core.datasets.formats import format_of, read_scenes
from scenegen_core.datasets.remarks import Remark, Skipped, UnknownLabel
from scenegen_core.errors import DataError
from scenegen_core.scene.files import read_scene, write_scene
from scenegen_core.scene.model import Scene

Numbers = tuple[float, float, float]


def thing(
    label: str, center: Numbers, size: Numbers, turn: float | None = None, **more: Any
) -> dict[str, Any]:
    """An object in Unity's axes; with a turn (degrees) it is a model, else part of the building."""
    found = {
        "objectId": f"{label}|{center[0]}",
        "objectType": label,
        "assetId": "" if turn is None else f"{label}_1",
        "position": dict(zip("xyz", center, strict=True)),
        "rotation": {"x": 0, "y": turn or 0, "z": 0},
        "parentReceptacles": None,
        "objectOrientedBoundingBox": None,
        "axisAlignedBoundingBox": {"cornerPoints": corners(center, size, turn or 0)},
    }
    return found | more


def corners(center: Numbers, size: Numbers, turn: float) -> list[Numbers]:
    """The corners of a box that is turned clockwise as seen from above."""
    s, c = sin(radians(turn)), cos(radians(turn))
    return [
        (
            center[0] + (i * size[0] * c + k * size[2] * s) / 2,
            center[1] + j * size[1] / 2,
            center[2] + (-i * size[0] * s + k * size[2] * c) / 2,
        )
        for i in (-1, 1)
        for j in (-1, 1)
        for k in (-1, 1)
    ]


FLOOR = thing("Floor", (2, 0, 1.5), (4.6, 0.1, 3.6))
# Skirting of a room from (0, 0) to (4, 3): the floor goes on under the walls.
ENDS = [thing("Drawer", (x, 0.2, z), (0.2, 0.2, 0.2)) for x, z in ((0.1, 0.1), (3.9, 2.9))]


def room(*more: dict[str, Any]) -> list[dict[str, Any]]:
    return [FLOOR, *ENDS, *more]


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return tmp_path / "dump.json"


def read(path: Path, value: object, remarks: list[Remark] | None = None) -> list[Scene]:
    """The rooms of a dump; what is said about it goes to ``remarks``, or must be nothing."""
    said: list[Remark] = []
    path.write_text(json.dumps(value))
    assert format_of(path).name == "ai2thor"
    scenes = list(read_scenes(path, said.append))
    if remarks is None:
        assert said == []
    else:
        remarks += said
    return scenes


def test_the_outline_is_the_rectangle_that_the_objects_span_on_the_floor(path: Path) -> None:
    curtain = thing("Curtains", (4.2, 1.5, 1), (0.1, 1, 1))
    (scene,) = read(path, room(curtain))
    assert list(scene.room.corners) == [(0, 0), (4, 0), (4, 3), (0, 3)]
    assert (scene.id, scene.source) == ("dump", "thor")


@pytest.mark.parametrize("turn", [0, 90, 200])
def test_a_model_has_the_box_of_its_own_axes(path: Path, turn: float) -> None:
    sofa = thing("Sofa", (2, 0.4, 1.5), (2.0, 0.8, 0.9), turn)
    (box,) = read(path, room(sofa))[0].boxes
    assert box.category == "Sofa"
    assert box.center == pytest.approx((2, 1.5, 0.4))
    assert box.size == pytest.approx((0.9, 2.0, 0.8), abs=1e-4)
    ahead = radians(90 - turn)
    assert (cos(box.heading), sin(box.heading)) == pytest.approx((cos(ahead), sin(ahead)))
    assert (box.front_known, box.front_from_wall) == (True, False)


def test_an_oriented_box_goes_before_one_along_the_axes(path: Path) -> None:
    oriented = {"cornerPoints": corners((2, 0.4, 1.5), (2.0, 0.8, 0.9), 30)}
    loose = thing("Sofa", (2, 0.4, 1.5), (2.2, 0.8, 1.8), 0, objectOrientedBoundingBox=oriented)
    loose["rotation"]["y"] = 30
    (box,) = read(path, room(loose))[0].boxes
    assert box.size == pytest.approx((0.9, 2.0, 0.8), abs=1e-4)


def test_the_head_of_a_bed_is_where_its_model_looks_to(path: Path) -> None:
    (box,) = read(path, room(thing("Bed", (2, 0.3, 1.5), (1.5, 0.6, 2.0), 0)))[0].boxes
    assert (cos(box.heading), sin(box.heading)) == pytest.approx((0, -1))
    assert box.size == pytest.approx((2.0, 1.5, 0.6))


@pytest.mark.parametrize(
    ("center", "size", "heading"),
    [
        ((0.2, 1, 1.5), (0.4, 2, 1.0), 0),
        ((3.8, 1, 1.5), (0.4, 2, 1.0), pi),
        ((2, 1, 0.2), (1.0, 2, 0.4), pi / 2),
        ((2, 1, 2.8), (1.0, 2, 0.4), -pi / 2),
        ((0.5, 1, 0.2), (1.0, 2, 0.4), pi / 2),
    ],
    ids=["west", "east", "south", "north", "in a corner"],
)
def test_built_in_storage_faces_away_from_the_wall_behind_it(
    path: Path, center: Numbers, size: Numbers, heading: float
) -> None:
    (box,) = read(path, room(thing("Cabinet", center, size)))[0].boxes
    assert cos(box.heading - heading) == pytest.approx(1)
    assert box.size == pytest.approx((0.4, 1.0, 2.0))
    assert box.front_from_wall


def test_of_what_else_is_built_in_only_the_axes_are_known(path: Path) -> None:
    (box,) = read(path, room(thing("CounterTop", (2, 0.9, 1.5), (2, 0.1, 0.6))))[0].boxes
    assert box.category == "Other"
    assert (box.front_known, box.front_from_wall) == (False, False)


def test_what_stands_on_a_thing_has_it_as_its_parent(path: Path) -> None:
    desk = thing("Desk", (2, 0.4, 1.5), (1.2, 0.8, 0.6), 0)
    lamp = thing("DeskLamp", (2.1, 1, 1.5), (0.2, 0.4, 0.2), 0, parentReceptacles=["Desk|2"])
    chair = thing("Chair", (2.2, 0.5, 0.8), (0.5, 1, 0.5), 0, parentReceptacles=["Floor|2"])
    (scene,) = read(path, room(desk, lamp, chair))
    assert [(box.category, box.parent) for box in scene.boxes] == [
        ("Table", None), ("Decor", "Desk|2"), ("Chair", None),
    ]  # fmt: skip


def test_small_things_and_parts_of_the_building_are_left_out(path: Path) -> None:
    mug = thing("Mug", (2, 1, 1.5), (0.1, 0.1, 0.1), 0)
    (scene,) = read(path, room(mug, thing("Faucet", (2, 1, 1), (0.1, 0.1, 0.1))))
    assert scene.boxes == ()


def test_a_window_lies_on_the_outline(path: Path) -> None:
    (scene,) = read(path, room(thing("Window", (4.1, 1.5, 1), (0.2, 1.2, 1.4))))
    (opening,) = scene.room.windows
    assert (opening.start, opening.end) == ((4, 0.3), (4, 1.7))
    assert (opening.bottom, opening.top) == (0.9, 2.1)


def test_the_metadata_of_an_event_name_their_scene(path: Path) -> None:
    (scene,) = read(path, {"sceneName": "FloorPlan312_physics", "agent": {}, "objects": room()})
    assert (scene.id, scene.room.room_type) == ("FloorPlan312_physics", "bedroom")


def test_lists_of_rooms_by_kind_are_read_one_by_one(path: Path) -> None:
    scenes = read(path, {"bedrooms": [room(), room()], "living_rooms": [room()]})
    assert [(scene.id, scene.room.room_type) for scene in scenes] == [
        ("dump/bedrooms/1", "bedroom"),
        ("dump/bedrooms/2", "bedroom"),
        ("dump/living_rooms/1", "living room"),
    ]


@pytest.mark.parametrize(
    ("wrong", "what", "reason"),
    [
        (thing("Sofa", (2, 1, 1), (1, 1, 1), axisAlignedBoundingBox=None), "object 3", "no box"),
        ({"objectType": "Sofa"}, "object 3", "objectId"),
        (thing("Sofa", (2, 1, 1), (1, 0, 1), 0), "object 'Sofa|2'", "size[2]"),
    ],
)
def test_what_is_broken_is_named_and_left_out(
    path: Path, wrong: dict[str, Any], what: str, reason: str
) -> None:
    said: list[Remark] = []
    chair = thing("Chair", (2.2, 0.5, 0.8), (0.5, 1, 0.5), 0)
    (scene,) = read(path, room(wrong, chair), said)
    assert [box.category for box in scene.boxes] == ["Chair"]
    (skipped,) = said
    assert isinstance(skipped, Skipped)
    assert skipped.what == what
    assert reason in skipped.reason


def test_an_unknown_label_is_other_and_said(path: Path) -> None:
    said: list[Remark] = []
    (scene,) = read(path, room(thing("Spaceship", (2, 1, 1), (1, 1, 1), 0)), said)
    assert [box.category for box in scene.boxes] == ["Other"]
    assert said == [UnknownLabel(path, "thor", "Spaceship")]


def test_a_broken_dump_is_refused_with_a_sentence(path: Path) -> None:
    with pytest.raises(DataError, match="not a list of AI2-THOR's objects"):
        read(path, {"objects": {"axisAlignedBoundingBox": 1}})


ROOT = Path(__file__).parents[3]
CORPUS = ROOT.parent / "shared" / "data" / "rooms" / "ithor.jsonl.gz"
NUMBERS = {"kitchens": 0, "living_rooms": 200, "bedrooms": 300, "bathrooms": 400}


@pytest.fixture(scope="module")
def published() -> dict[str, Scene]:
    """The rooms of iTHOR whose metadata the package procthor holds, by their published names."""
    package = importlib.util.find_spec("procthor")
    if package is None or not package.submodule_search_locations:
        pytest.skip("the package procthor is not installed")
    folder = Path(package.submodule_search_locations[0])
    scenes = list(
        read_scenes(folder / "databases" / "ai2thor-object-metadata.json", lambda _: None)
    )
    named: dict[str, Scene] = {}
    for scene in scenes:
        _, kind, number = scene.id.split("/")
        if kind in NUMBERS:
            named[f"ithor:FloorPlan{NUMBERS[kind] + int(number)}"] = scene
    return named


def test_the_published_rooms_are_scene_files(published: dict[str, Scene]) -> None:
    assert len(published) == 120
    for scene in published.values():
        assert read_scene(write_scene(scene)) == scene


@pytest.mark.skipif(not CORPUS.exists(), reason="the corpus of rooms is not at hand")
def test_the_published_rooms_agree_with_the_corpus_that_others_made(
    published: dict[str, Scene],
) -> None:
    with gzip.open(CORPUS, "rt", encoding="utf-8") as lines:
        known = [json.loads(line) for line in lines]
    turned_beds = beds = 0
    for row in known:
        scene = published[row["id"]]
        for theirs in row["objects"]:
            if theirs["category"] is None or theirs["id"] not in scene:
                continue
            box = scene[theirs["id"]]
            assert box.category == theirs["category"]
            assert box.center == pytest.approx(theirs["center"], abs=0.01)
            if theirs["front_from_wall"] or not box.front_known:
                continue
            if box.category == "Bed":  # theirs were turned by pillows, each on its own
                beds += 1
                turned_beds += cos(box.heading - theirs["yaw"]) < 0
            else:
                assert cos(box.heading - theirs["yaw"]) > 0.99 or box.front_from_wall
                assert box.size[2] == pytest.approx(2 * theirs["half"][2], abs=0.05)
    assert beds >= 25
    assert turned_beds <= 3
