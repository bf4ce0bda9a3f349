"""Rows of rooms, as text, become scenes; what is broken is named and left out."""

from __future__ import annotations

import gzip
import json
import logging
from pathlib import Path
from typing import Any

import pytest

from scenegen_core.datasets.remarks import Remark, Skipped
from scenegen_core.datasets.rows import read_scenes, write_rows
from scenegen_core.errors import DataError

SOFA: dict[str, Any] = {
    "id": "s", "label": "COUCH", "category": "Sofa", "center": [1.0, 2.0, 0.4],
    "half": [0.5, 1.0, 0.4], "yaw": 1.5, "front_known": True, "front_from_wall": False,
    "parent": None,
}  # fmt: skip
VASE: dict[str, Any] = {
    "id": "v", "label": "Vase", "category": "Decor", "center": [1.0, 2.0, 0.9],
    "half": [0.1, 0.1, 0.1], "yaw": 0.0, "front_known": False, "front_from_wall": True,
    "parent": "s",
}  # fmt: skip
CRUMB = {**VASE, "id": "c", "label": "Crumb", "category": None, "parent": None}
ROOM: dict[str, Any] = {
    "id": "home/1", "source": "drawn", "room_type": "LivingRoom",
    "polygon": [[0, 0], [4, 0], [4, 3], [0, 3]], "height": 2.7,
    "doors": [{"segment": [[0, 1], [0, 2]]}],
    "windows": [{"segment": [[1, 3], [2, 3]], "z": [0.8, 2.2]}, {"segment": [[3, 3], [4, 3]]}],
    "objects": [SOFA, VASE, CRUMB],
}  # fmt: skip


def write(path: Path, *rows: object) -> Path:
    lines = [row if isinstance(row, str) else json.dumps(row) for row in rows]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path


@pytest.fixture
def broken() -> list[Remark]:
    return []


def test_a_row_becomes_a_scene(tmp_path: Path) -> None:
    (scene,) = read_scenes(write(tmp_path / "rooms.jsonl", ROOM))
    assert (scene.id, scene.source, scene.room.room_type) == ("home/1", "drawn", "LivingRoom")
    assert list(scene.room.corners) == [(0, 0), (4, 0), (4, 3), (0, 3)]
    assert scene.room.height == 2.7
    door, window = scene.room.doors[0], scene.room.windows[0]
    assert (door.start, door.end, door.bottom) == ((0, 1), (0, 2), 0)
    assert (window.bottom, window.top) == (0.8, 2.2)
    sofa = scene["s"]
    assert (sofa.category, sofa.label, sofa.center) == ("Sofa", "COUCH", (1, 2, 0.4))
    assert (sofa.size, sofa.heading) == ((1.0, 2.0, 0.8), 1.5)
    assert (sofa.front_known, sofa.front_from_wall) == (True, False)
    assert (scene["v"].front_known, scene["v"].front_from_wall) == (False, True)
    assert scene["v"].parent == "s"


def test_a_window_of_unknown_height_does_not_reach_the_floor(tmp_path: Path) -> None:
    (scene,) = read_scenes(write(tmp_path / "rooms.jsonl", ROOM))
    assert 0.5 < scene.room.windows[1].bottom < scene.room.windows[1].top < 2.5


def test_clutter_is_dropped_and_nothing_stands_on_it(tmp_path: Path) -> None:
    on_crumb = {**VASE, "id": "w", "parent": "c"}
    row = {**ROOM, "objects": [SOFA, CRUMB, on_crumb]}
    (scene,) = read_scenes(write(tmp_path / "rooms.jsonl", row))
    assert [box.id for box in scene.boxes] == ["s", "w"]
    assert scene["w"].parent is None


def test_an_outline_that_runs_clockwise_is_turned(tmp_path: Path) -> None:
    row = {**ROOM, "polygon": [[0, 3], [4, 3], [4, 0], [0, 0]]}
    (scene,) = read_scenes(write(tmp_path / "rooms.jsonl", row))
    assert list(scene.room.corners) == [(0, 0), (4, 0), (4, 3), (0, 3)]


def test_an_unknown_height_is_the_default_one(tmp_path: Path) -> None:
    (scene,) = read_scenes(write(tmp_path / "rooms.jsonl", {**ROOM, "height": None}))
    assert scene.room.height == 2.6


def test_gzipped_rows_are_read_too(tmp_path: Path) -> None:
    path = tmp_path / "rooms.jsonl.gz"
    path.write_bytes(gzip.compress(json.dumps(ROOM).encode()))
    assert [scene.id for scene in read_scenes(path)] == ["home/1"]


@pytest.mark.parametrize(
    ("row", "reason"),
    [
        ("{", "truncated"),
        ({**ROOM, "polygon": [[0, 0], [4, 3], [4, 0], [0, 3]]}, "crosses or touches itself"),
        ({**ROOM, "polygon": [[0, 0], [1, 1]]}, "fewer than three corners"),
        ({**ROOM, "polygon": []}, "fewer than three corners"),
        ({key: value for key, value in ROOM.items() if key != "source"}, "`source`"),
        ({**ROOM, "objects": [{**SOFA, "half": [1, 2]}]}, r"$.objects[0].half"),
        ({**ROOM, "objects": [SOFA, SOFA]}, "Two boxes have the id 's'"),
        ({**ROOM, "doors": [{"segment": [[0, 1], [0, 2]], "z": [2, 1]}]}, "ends below"),
    ],
)
def test_a_broken_row_is_named_and_left_out(
    tmp_path: Path, broken: list[Remark], row: object, reason: str
) -> None:
    path = write(tmp_path / "rooms.jsonl", ROOM, "", row, {**ROOM, "id": "home/2"})
    scenes = list(read_scenes(path, broken.append))
    assert [scene.id for scene in scenes] == ["home/1", "home/2"]
    (what,) = broken
    assert isinstance(what, Skipped)
    assert (what.path, what.what) == (path, "line 3")
    assert reason in what.reason
    assert str(what).startswith(f"{path}, line 3: ")


def test_a_broken_row_is_logged_when_nobody_listens(
    tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    path = write(tmp_path / "rooms.jsonl", "[]")
    with caplog.at_level(logging.WARNING):
        assert list(read_scenes(path)) == []
    assert f"{path}, line 1" in caplog.text


def test_rooms_are_read_one_by_one(tmp_path: Path, broken: list[Remark]) -> None:
    scenes = read_scenes(write(tmp_path / "rooms.jsonl", ROOM, "{"), broken.append)
    next(scenes)
    assert broken == []


def test_a_missing_file_is_named(tmp_path: Path) -> None:
    with pytest.raises(DataError, match=r"none\.jsonl"):
        list(read_scenes(tmp_path / "none.jsonl"))


@pytest.mark.parametrize("cut", [slice(None, 40), slice(None, -4)])
def test_a_damaged_gzip_file_is_named(tmp_path: Path, cut: slice) -> None:
    path = tmp_path / "rooms.jsonl.gz"
    path.write_bytes(gzip.compress(json.dumps(ROOM).encode())[cut])
    with pytest.raises(DataError, match=r"rooms\.jsonl\.gz.*complete"):
        list(read_scenes(path))


def test_a_row_that_was_read_is_written_as_it_was(tmp_path: Path) -> None:
    known = {**ROOM, "objects": [SOFA, VASE], "doors": [{"segment": [[0, 1], [0, 2]], "z": [0, 2]}],
             "windows": ROOM["windows"][:1]}  # fmt: skip
    written = write_rows(read_scenes(write(tmp_path / "rooms.jsonl", known)))
    assert written.endswith(b"}\n")
    assert json.loads(written) == known
    assert list(json.loads(written)) == list(ROOM)
