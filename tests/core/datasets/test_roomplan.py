"""A RoomPlan scan becomes the rooms it was drawn from.

``roomplan_two_stories.json`` was drawn by hand in an upright frame and then turned: u runs along
(0.8, 0.6), v along (-0.6, 0.8), from (1, 2). The ground floor is an L of 5 m by 4 m without its far
right corner, the upper floor a rectangle of 3 m by 4 m; the phone began 1.4 m above the floor.
"""

from __future__ import annotations

import json
import zipfile
from collections.abc import Iterator
from math import atan2, cos, sin
from pathlib import Path
from typing import Any

import pytest
from shapely import Polygon

from scenegen_core.datasets.formats import format_of, read_scenes
from scenegen_core.datasets.labels import categories_of
from scenegen_core.datasets.remarks import Remark, Skipped, UnknownLabel
from scenegen_core.errors import DataError
from scenegen_core.scene.files import read_scene, write_scene
from scenegen_core.scene.model import PAPER_CATEGORIES, Point, Scene

SCAN = Path(__file__).parents[2] / "fixtures/roomplan_two_stories.json"
L_SHAPE = ((0, 0), (5, 0), (5, 2), (3, 2), (3, 4), (0, 4))
RECTANGLE = ((0, 0), (3, 0), (3, 4), (0, 4))


def turned(u: float, v: float) -> Point:
    """A point of the drawing in the room."""
    return 0.8 * u - 0.6 * v + 1, 0.6 * u + 0.8 * v + 2


def heading(u: float, v: float) -> float:
    """The heading of a direction of the drawing in the room."""
    return atan2(0.6 * u + 0.8 * v, 0.8 * u - 0.6 * v)


def scan() -> Any:
    return json.loads(SCAN.read_text())


def read(path: Path, remarks: list[Remark] | None = None) -> list[Scene]:
    return list(read_scenes(path, (remarks if remarks is not None else []).append))


def changed(tmp_path: Path, **changes: Any) -> Path:
    path = tmp_path / "changed.json"
    path.write_text(json.dumps(scan() | changes))
    return path


@pytest.fixture(scope="module")
def remarks() -> list[Remark]:
    return []


@pytest.fixture(scope="module")
def rooms(remarks: list[Remark]) -> list[Scene]:
    return read(SCAN, remarks)


def outline_error(scene: Scene, drawn: tuple[tuple[float, float], ...]) -> float:
    true = Polygon([turned(u, v) for u, v in drawn])
    return Polygon(scene.room.corners).symmetric_difference(true).area


def test_each_story_is_a_room_with_the_outline_of_its_floor(rooms: list[Scene]) -> None:
    assert [scene.id for scene in rooms] == ["roomplan_two_stories/1", "roomplan_two_stories/2"]
    ground, upper = rooms
    assert outline_error(ground, L_SHAPE) == pytest.approx(0, abs=1e-3)
    assert outline_error(upper, RECTANGLE) == pytest.approx(0, abs=1e-3)
    assert all(Polygon(scene.room.corners).exterior.is_ccw for scene in rooms)
    assert [scene.room.height for scene in rooms] == pytest.approx([2.5, 2.3])


def test_sections_say_what_a_room_is_used_for(rooms: list[Scene]) -> None:
    assert [scene.room.room_type for scene in rooms] == ["living room/dining room", "bedroom"]


# Where the things of the drawing stand (u, v, height of the middle), where they look, their size
# (depth, width, height), their category, and whether they look anywhere.
DRAWN = {
    "SOFA": ((1.5, 3.55, 0.4), (0, -1), (0.9, 2.0, 0.8), "Sofa", True),
    "STORAGE": ((2.5, 0.25, 0.25), (0, 1), (0.5, 1.6, 0.5), "Storage", True),
    "TV": ((2.5, 0.2, 0.85), (0, 1), (0.08, 1.2, 0.7), "TV", True),
    "TABLE": ((4.0, 0.9, 0.375), (0, 1), (0.8, 1.4, 0.75), "Table", False),
    "CHAIR": ((4.0, 1.6, 0.45), (0, -1), (0.55, 0.5, 0.9), "Chair", True),
    "STOOL": ((3.0, 1.0, 0.3), (1, 0), (0.4, 0.4, 0.6), "Chair", False),
    "FRIDGE": ((0.35, 0.35, 0.9), (1, 0), (0.7, 0.7, 1.8), "Storage", True),
    "TANK": ((2.7, 2.8, 0.6), (-1, 0), (0.4, 1.0, 1.2), "Other", False),
}


@pytest.mark.parametrize("name", DRAWN)
def test_a_thing_stands_where_it_was_drawn_and_looks_there_too(
    rooms: list[Scene], name: str
) -> None:
    (u, v, z), facing, size, category, front_known = DRAWN[name]
    box = rooms[0][name]
    assert box.center == pytest.approx((*turned(u, v), z), abs=1e-3)
    assert box.size == pytest.approx(size)
    assert cos(box.heading - heading(*facing)) == pytest.approx(1)
    assert (box.category, box.front_known) == (category, front_known)


def test_things_of_the_story_above_stand_above(rooms: list[Scene]) -> None:
    assert set(DRAWN) == {box.id for box in rooms[0].boxes}
    (bed,) = rooms[1].boxes
    assert bed.category == "Bed"
    assert bed.center == pytest.approx((*turned(1.5, 3.0), 0.25), abs=1e-3)
    assert cos(bed.heading - heading(0, -1)) == pytest.approx(1)


def test_labels_name_the_kind_where_it_is_known(rooms: list[Scene]) -> None:
    assert rooms[0]["TABLE"].label == "Dining table"
    assert rooms[0]["FRIDGE"].label == "Refrigerator"


def test_a_parent_counts_only_where_the_thing_stands_on_it(rooms: list[Scene]) -> None:
    assert rooms[0]["TV"].parent == "STORAGE"
    assert rooms[0]["CHAIR"].parent is None  # RoomPlan calls the table the parent of its chairs


def test_doors_openings_and_windows_are_where_they_were_drawn(rooms: list[Scene]) -> None:
    door, passage = rooms[0].room.doors
    (window,) = rooms[0].room.windows
    for opening, ends, heights in (
        (door, ((0.55, 0), (1.45, 0)), (0, 2.1)),
        (passage, ((5, 0.2), (5, 1.8)), (0, 2.2)),
        (window, ((0, 1.4), (0, 2.6)), (0.9, 2.1)),
    ):
        found = sorted([opening.start, opening.end])
        true = sorted(turned(u, v) for u, v in ends)
        assert found == [pytest.approx(point, abs=1e-3) for point in true]
        assert (opening.bottom, opening.top) == pytest.approx(heights, abs=1e-3)
    assert rooms[1].room.doors == rooms[1].room.windows == ()


def test_an_opening_high_in_the_wall_is_a_window(tmp_path: Path) -> None:
    hatch = scan()["openings"][0]
    hatch["transform"][13] += 0.7
    hatch["dimensions"][1] = 0.8
    ground = read(changed(tmp_path, openings=[hatch]))[0]
    assert len(ground.room.doors) == 1
    assert [(w.bottom, w.top) for w in ground.room.windows if w.id == "OPENING"] == [(1.4, 2.2)]


def test_what_is_left_out_or_unknown_is_said(rooms: list[Scene], remarks: list[Remark]) -> None:
    assert rooms
    assert [r.what for r in remarks if isinstance(r, Skipped)] == ["object 'NEXT-DOOR'"]
    assert [r.label for r in remarks if isinstance(r, UnknownLabel)] == ["aquarium"]


def test_without_floors_the_walls_of_each_story_are_its_outline(tmp_path: Path) -> None:
    old = scan()  # as iOS 16 wrote it, the walls in any order and direction
    walls = old["walls"][::-1]
    for wall in walls[::2]:
        for column in (0, 8):  # seen from the other side, width and normal point the other way
            wall["transform"][column : column + 3] = [
                -number for number in wall["transform"][column : column + 3]
            ]
    ground, upper = read(changed(tmp_path, walls=walls, floors=[], sections=[]))
    assert outline_error(ground, L_SHAPE) == pytest.approx(0, abs=1e-3)
    assert outline_error(upper, RECTANGLE) == pytest.approx(0, abs=1e-3)
    assert ground["SOFA"].center == pytest.approx((*turned(1.5, 3.55), 0.4), abs=1e-3)
    assert upper.room.height == pytest.approx(2.3)
    assert ground.room.room_type == ""


def test_a_wall_that_counts_as_straight_is_named(tmp_path: Path) -> None:
    walls = scan()["walls"]
    walls[0]["curve"] = {"radius": 4.0, "startAngle": 0.0, "endAngle": 1.0}
    said: list[Remark] = []
    ground = read(changed(tmp_path, walls=walls, floors=[]), said)[0]
    assert outline_error(ground, L_SHAPE) == pytest.approx(0, abs=1e-3)
    assert isinstance(said[0], Skipped)
    assert said[0].what == "the curve of wall 'WALL-0'"


def test_the_rooms_of_a_structure_are_read_one_by_one(tmp_path: Path) -> None:
    ground, upper = scan(), scan()
    for room, story in ((ground, 0), (upper, 1)):
        for kind in ("walls", "floors", "objects", "doors", "windows", "openings"):
            room[kind] = [thing for thing in room[kind] if thing["story"] == story]
    structure = tmp_path / "home.json"
    structure.write_text(json.dumps({**scan(), "rooms": [ground, upper, {"walls": 5}]}))
    said: list[Remark] = []
    scenes = read(structure, said)
    assert [(scene.id, len(scene.boxes)) for scene in scenes] == [("home/1", 8), ("home/2", 1)]
    assert any("$.walls" in str(remark) for remark in said)


def test_a_category_may_be_a_bare_word_and_a_transform_four_columns(tmp_path: Path) -> None:
    sofa = scan()["objects"][0]
    numbers = sofa["transform"]
    sofa |= {"category": "sofa", "transform": [numbers[i : i + 4] for i in (0, 4, 8, 12)]}
    (box,) = read(changed(tmp_path, objects=[sofa]))[0].boxes
    assert (box.category, box.label) == ("Sofa", "Rectangular sofa")
    assert cos(box.heading - heading(0, -1)) == pytest.approx(1)


def spoiled(**changes: Any) -> Any:
    return scan()["objects"][0] | changes


@pytest.mark.parametrize(
    ("thing", "reason"),
    [
        (spoiled(transform=[1, 2, 3]), "3 numbers instead of 16"),
        (spoiled(transform=[0] * 16), "not a turn and a shift"),
        (spoiled(dimensions=[1, 2]), "dimensions"),
        (spoiled(dimensions=[1, 2, 0]), "size"),
        (spoiled(dimensions=[1, 2, 4000]), "size"),
        ("a sofa", "Expected `object`"),
    ],
)
def test_a_broken_thing_is_named_and_the_room_is_kept(
    tmp_path: Path, thing: Any, reason: str
) -> None:
    said: list[Remark] = []
    ground = read(changed(tmp_path, objects=[thing, *scan()["objects"][1:3]]), said)[0]
    assert {box.id for box in ground.boxes} == {"STORAGE", "TV"}
    (skipped,) = (remark for remark in said if isinstance(remark, Skipped))
    assert skipped.what.startswith("object")
    assert reason in skipped.reason


def test_a_scan_of_two_walls_is_no_room(tmp_path: Path) -> None:
    said: list[Remark] = []
    with pytest.raises(DataError, match="holds no usable room"):
        read(changed(tmp_path, floors=[], walls=scan()["walls"][:2]), said)
    assert "fewer than three walls" in str(said[0])


def zipped(path: Path, files: dict[str, bytes]) -> Path:
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            archive.writestr(name, content)
    return path


def test_a_scan_in_a_zip_beside_a_model_is_read(tmp_path: Path) -> None:
    path = zipped(
        tmp_path / "flat.zip",
        {
            "Export/Room.usdz": b"PK\x03\x04 not looked at",
            "Export/Room.json": SCAN.read_bytes(),
            "Export/about.json": b'{"app": "a scanner"}',
            "__MACOSX/Export/._Room.json": b"\x00\x05\x16\x07",
        },
    )
    assert format_of(path).name == "roomplan"
    rooms = read(path)
    assert [scene.id for scene in rooms] == ["flat/1", "flat/2"]
    assert [scene.boxes for scene in rooms] == [scene.boxes for scene in read(SCAN)]


def test_a_zip_bomb_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("scenegen_core.datasets.contents.LARGEST", 1_000_000)
    bomb = zipped(tmp_path / "bomb.zip", {f"{i}.json": b" " * 400_000 for i in range(3)})
    assert bomb.stat().st_size < 10_000
    with pytest.raises(DataError, match="larger than 1 MB"):
        format_of(bomb)


def test_a_zip_of_other_things_is_no_scan(tmp_path: Path) -> None:
    other = zipped(tmp_path / "other.zip", {"notes.txt": b"hello", "x.json": b"{}"})
    with pytest.raises(DataError, match="neither a scene file"):
        format_of(other)


def test_a_scanned_room_is_a_scene_file(rooms: list[Scene]) -> None:
    for scene in rooms:
        assert read_scene(write_scene(scene)) == scene


def test_every_category_of_roomplan_is_reviewed() -> None:
    # The sixteen cases of CapturedRoom.Object.Category.
    ours = categories_of("roomplan")
    assert " ".join(sorted(ours)) == (
        "bathtub bed chair dishwasher fireplace oven refrigerator sink sofa stairs storage stove "
        "table television toilet washerDryer"
    )
    assert {category.name for category in PAPER_CATEGORIES} >= set(ours.values())


def rotated(numbers: list[float], angle: float) -> Iterator[float]:
    """A matrix of RoomPlan turned about its y axis."""
    c, s = cos(angle), sin(angle)
    for start in (0, 4, 8, 12):
        x, y, z, w = numbers[start : start + 4]
        yield from (c * x + s * z, y, c * z - s * x, w)


def test_turning_the_whole_scan_turns_the_whole_room(tmp_path: Path) -> None:
    other = scan()
    for kind in ("walls", "floors", "objects", "doors", "windows", "openings"):
        for thing in other[kind]:
            thing["transform"] = list(rotated(thing["transform"], 2.0))
    ground = read(changed(tmp_path, **other | {"sections": []}))[0]
    straight = read(SCAN)[0]
    assert [box.id for box in ground.boxes] == [box.id for box in straight.boxes]
    for box, true in zip(ground.boxes, straight.boxes, strict=True):
        assert cos(box.heading - true.heading - 2.0) == pytest.approx(1)
        x, y, z = true.center
        where = (cos(2.0) * x - sin(2.0) * y, sin(2.0) * x + cos(2.0) * y, z)
        assert box.center == pytest.approx(where, abs=1e-3)
