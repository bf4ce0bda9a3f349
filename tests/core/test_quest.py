"""Captures of a Quest headset become the rooms that they show."""

from __future__ import annotations

import gzip
import json
from math import cos, pi, sin
from pathlib import Path
from typing import Any

import pytest
from shapely import Polygon

from scenegen_core.datasets.labels import categories_of
from scenegen_core.datasets.quest import ROOMS, read_scenes
from scenegen_core.datasets.remarks import Remark, Skipped, UnknownLabel
from scenegen_core.errors import DataError
from scenegen_core.scene.files import read_scene, write_scene
from scenegen_core.scene.model import PAPER_CATEGORIES, Box, Scene

ROOT = Path(__file__).parents[2]
CAPTURES = ROOT / "node_modules" / "@iwer" / "sem" / "captures"
CORPUS = ROOT.parent / "shared" / "data" / "rooms" / "iwer_sem.jsonl.gz"

FLOOR = 0.05  # metres; the headset's floor in the drawn capture below
UPRIGHT = 0.7071067811865476


def entity(label: str, position: tuple[float, float, float], turn: tuple[float, ...]) -> Any:
    return {
        "uuid": label,
        "semanticLabel_META": label,
        "locatable_META": {
            "position": dict(zip("xyz", position, strict=True)),
            "orientation": dict(zip("xyzw", turn, strict=True)),
        },
    }


def plane(label: str, position: tuple[float, float, float], out: float, size: Any) -> Any:
    """A vertical plane whose own y points along the plan direction ``out`` (core radians)."""
    width, height = size
    # Turn the own y down to the page's z, then about the page's y to where it should point.
    turn = about_y(out + pi / 2, (UPRIGHT, 0.0, 0.0, UPRIGHT))
    return entity(label, position, turn) | {
        "bounded2D_META": {
            "offset": {"x": -width / 2, "y": -height / 2},
            "extent": {"width": width, "height": height},
        }
    }


def volume(label: str, top: tuple[float, float, float], facing: float, size: Any) -> Any:
    """A box whose pose is at the middle of its top, front along ``facing`` (core radians)."""
    depth, width, height = size
    turn = about_y(facing + pi / 2, (-UPRIGHT, 0.0, 0.0, UPRIGHT))
    return entity(label, top, turn) | {
        "bounded3D_META": {
            "offset": {"x": -width / 2, "y": -depth / 2, "z": -height},
            "extent": {"width": width, "height": depth, "depth": height},
        }
    }


def about_y(angle: float, turn: tuple[float, float, float, float]) -> tuple[float, ...]:
    """The Hamilton product of a turn about y and another turn (x, y, z, w)."""
    s, c = sin(angle / 2), cos(angle / 2)
    x, y, z, w = turn
    return (c * x + s * z, c * y + s * w, c * z - s * x, c * w - s * y)


def drawn(*extra: Any) -> bytes:
    """A room 4 m (x) by 3 m (y) and 2.5 m high, with more in it."""
    middle = FLOOR + 1.25
    walls = [
        plane("WALL_FACE", (2.0, middle, 0.0), 0.0, (3.0, 2.5)),
        plane("WALL_FACE", (-2.0, middle, 0.0), pi, (3.0, 2.5)),
        plane("WALL_FACE", (0.0, middle, -1.5), pi / 2, (4.0, 2.5)),
        plane("WALL_FACE", (0.0, middle, 1.5), -pi / 2, (4.0, 2.5)),
    ]
    floor = entity("FLOOR", (0.0, FLOOR, 0.0), (0.0, 0.0, 0.0, 1.0))
    return json.dumps({"spatialEntities": [floor, *walls, *extra]}).encode()


@pytest.fixture
def file(tmp_path: Path) -> Path:
    return tmp_path / "capture.json"


def read(file: Path, text: bytes, remarks: list[Remark] | None = None) -> Scene:
    """The one room of a capture; what is said about it goes to ``remarks``, or must be nothing."""
    said: list[Remark] = []
    file.write_bytes(text)
    (scene,) = read_scenes(file, said.append)
    if remarks is None:
        assert said == []
    else:
        remarks += said
    return scene


def test_the_outline_is_where_the_walls_meet(file: Path) -> None:
    room = read(file, drawn()).room
    expected = Polygon([(-2, -1.5), (2, -1.5), (2, 1.5), (-2, 1.5)])
    assert Polygon(room.corners).symmetric_difference(expected).area < 1e-3
    assert Polygon(room.corners).exterior.is_ccw
    assert room.height == pytest.approx(2.5)


def test_a_couch_faces_along_its_own_minus_y_and_stands_on_the_floor(file: Path) -> None:
    couch = volume("COUCH", (0.5, FLOOR + 0.8, -1.0), -pi / 2, (0.9, 2.0, 0.83))
    (box,) = read(file, drawn(couch)).boxes
    assert (box.category, box.label) == ("Sofa", "Couch")
    assert box.heading == pytest.approx(-pi / 2, abs=1e-3)
    # It reached 3 cm below the floor: its foot is put on the floor, its top stays.
    assert box.center == pytest.approx((0.5, 1.0, 0.4), abs=1e-3)
    assert box.size == pytest.approx((0.9, 2.0, 0.8), abs=1e-3)
    assert box.front_known


def test_a_screen_on_a_table_keeps_its_height(file: Path) -> None:
    screen = volume("SCREEN", (0.0, FLOOR + 1.3, 0.0), 0.3, (0.1, 1.0, 0.6))
    (box,) = read(file, drawn(screen)).boxes
    assert (box.bottom, box.top) == pytest.approx((0.7, 1.3), abs=1e-3)
    assert box.heading == pytest.approx(0.3, abs=1e-3)


def test_a_picture_is_a_thin_box_that_looks_into_the_room(file: Path) -> None:
    picture = plane("WALL_ART", (1.0, FLOOR + 1.6, -1.5), pi / 2, (0.8, 0.6))
    (box,) = read(file, drawn(picture)).boxes
    assert box.category == "Picture"
    assert box.heading == pytest.approx(-pi / 2, abs=1e-3)
    assert box.center == pytest.approx((1.0, 1.49, 1.6), abs=1e-3)
    assert box.size == pytest.approx((0.02, 0.8, 0.6), abs=1e-3)


def test_doors_and_windows_lie_on_the_outline_above_the_floor(file: Path) -> None:
    door = plane("DOOR_FRAME", (1.96, FLOOR + 0.98, 0.5), 0.0, (0.9, 2.06))
    window = plane("WINDOW_FRAME", (0.0, FLOOR + 1.5, -1.46), pi / 2, (1.2, 1.2))
    room = read(file, drawn(door, window)).room
    (opening,) = room.doors
    assert sorted([opening.start, opening.end]) == [
        pytest.approx((2.0, -0.95), abs=1e-3),
        pytest.approx((2.0, -0.05), abs=1e-3),
    ]
    assert (opening.bottom, opening.top) == pytest.approx((0.0, 2.01), abs=1e-3)
    (opening,) = room.windows
    assert {opening.start[1], opening.end[1]} == {1.5}
    assert (opening.bottom, opening.top) == pytest.approx((0.9, 2.1), abs=1e-3)


def test_what_was_seen_through_a_door_is_left_out_and_named(file: Path) -> None:
    near = volume("PLANT", (2.3, FLOOR + 1.0, 0.0), 0.0, (0.3, 0.3, 1.0))
    far = volume("PLANT", (2.9, FLOOR + 1.0, 0.0), 0.0, (0.3, 0.3, 1.0))
    far_door = plane("DOOR_FRAME", (3.5, FLOOR + 1.0, 0.0), 0.0, (0.9, 2.0))
    remarks: list[Remark] = []
    scene = read(file, drawn(near, far, far_door), remarks)
    assert len(scene.boxes) == 1
    assert scene.room.doors == ()
    left_out = [remark.what for remark in remarks if isinstance(remark, Skipped)]
    assert left_out == ["door 'door-1'", "object 'decor-2'"]


def test_an_unknown_label_is_other_and_said(file: Path) -> None:
    remarks: list[Remark] = []
    scene = read(file, drawn(volume("SPACESHIP", (0, 1, 0), 0.0, (1, 1, 1))), remarks)
    assert [(box.category, box.label) for box in scene.boxes] == [("Other", "Spaceship")]
    assert remarks == [UnknownLabel(file, "quest", "SPACESHIP")]


@pytest.mark.parametrize(
    ("broken", "reason"),
    [
        ({"uuid": "no label"}, "semanticLabel_META"),
        (entity("WALL_ART", (1, 1, 1), (0, 0, 0, 1)), "is no plane"),
        (plane("WALL_ART", (1, 1, 1), 0.0, (1e9, 1)), "bounded2D_META"),
        ({**plane("WALL_ART", (1, 1, 1), 0.0, (1, 1)), **entity("WALL_ART", (1, 1, 1), (0,) * 4)},
         "no direction"),
    ],
)  # fmt: skip
def test_a_broken_entity_is_named_and_the_room_is_kept(
    file: Path, broken: Any, reason: str
) -> None:
    couch = volume("COUCH", (0.5, FLOOR + 0.8, -1.0), 0.0, (0.9, 2.0, 0.8))
    remarks: list[Remark] = []
    scene = read(file, drawn(broken, couch), remarks)
    assert [box.category for box in scene.boxes] == ["Sofa"]
    (skipped,) = remarks
    assert str(skipped).startswith(f"{file}, entity 6: ")
    assert reason in str(skipped)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (b"not json", "not a capture"),
        (b'{"spatialEntities": []}', "no floor"),
    ],
)
def test_a_broken_capture_is_refused_with_a_sentence(file: Path, text: bytes, message: str) -> None:
    with pytest.raises(DataError, match=message):
        read(file, text)


def test_the_reviewed_labels_lead_to_the_papers_categories() -> None:
    named = {category for category in categories_of("quest").values() if category}
    assert named <= {category.name for category in PAPER_CATEGORIES}
    assert categories_of("quest")["COUCH"] == "Sofa"
    assert categories_of("quest")["WALL_FACE"] is None


@pytest.fixture(scope="module", params=sorted(ROOMS))
def real(request: pytest.FixtureRequest) -> tuple[str, Scene]:
    if not CAPTURES.is_dir():
        pytest.fail("The captures are missing; run: npm ci")
    stem = str(request.param)
    (scene,) = read_scenes(CAPTURES / f"{stem}.json", lambda _: None)
    return stem, scene


# Counted by hand in the captures: volumes and pictures, less what hangs in the next room.
COUNTS = {
    "living_room": (10, 6, 0, 2),
    "meeting_room": (3, 8, 1, 5),
    "music_room": (4, 6, 1, 2),
    "office_large": (17, 8, 2, 1),
    "office_small": (4, 4, 1, 1),
}


def test_a_real_scan_has_its_boxes_walls_doors_and_windows(real: tuple[str, Scene]) -> None:
    stem, scene = real
    room = scene.room
    found = (len(scene.boxes), len(room.corners), len(room.doors), len(room.windows))
    assert found == COUNTS[stem]


def test_a_real_scan_stands_on_the_floor_under_the_ceiling(real: tuple[str, Scene]) -> None:
    scene = real[1]
    for box in scene.boxes:
        assert box.bottom >= -1e-4
        assert box.top <= scene.room.height + 0.1


def test_a_real_scan_is_a_scene_file(real: tuple[str, Scene]) -> None:
    scene = real[1]
    assert read_scene(write_scene(scene)) == scene


@pytest.mark.skipif(not CORPUS.exists(), reason="the corpus of rooms is not at hand")
def test_a_real_scan_agrees_with_the_corpus_that_others_made(real: tuple[str, Scene]) -> None:
    stem, scene = real
    known = corpus_room(stem)
    outline = Polygon(scene.room.corners)
    assert outline.symmetric_difference(Polygon(known["polygon"])).area < 0.01
    theirs = [o for o in known["objects"] if o["category"]]
    for box in scene.boxes:
        match = min(theirs, key=lambda o: apart(box, o))
        assert apart(box, match) < 0.03, box.id
        assert box.category == match["category"]
        assert box.size[:2] == pytest.approx([2 * h for h in match["half"][:2]], abs=0.01)
        assert cos(box.heading - match["yaw"]) == pytest.approx(1, abs=1e-4)
        assert box.front_known == match["front_known"]
        assert box.top == pytest.approx(match["center"][2] + match["half"][2], abs=0.01)


def corpus_room(stem: str) -> Any:
    with gzip.open(CORPUS, "rt", encoding="utf-8") as lines:
        return next(room for room in map(json.loads, lines) if room["id"] == stem)


def apart(box: Box, known: Any) -> float:
    """Distance of the centers in plan, metres."""
    x, y = box.center[:2]
    return float(((x - known["center"][0]) ** 2 + (y - known["center"][1]) ** 2) ** 0.5)
