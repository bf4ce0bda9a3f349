"""``scenegen convert``, from rooms of any format to scene files, rows and counts."""

from __future__ import annotations

import gzip
import json
from pathlib import Path
from typing import Any

import pytest

from scenegen_core.datasets.formats import read_scenes
from scenegen_core.scene.files import read_scene
from scenegen_core.scene.model import Scene
from server.cli import main

FIXTURES = Path(__file__).parents[1] / "fixtures"
LIVING_ROOM = FIXTURES / "living_room.json"
SCAN = FIXTURES / "roomplan_two_stories.json"
CORPORA = Path(__file__).parents[3] / "shared" / "data" / "rooms"

BED: dict[str, Any] = {
    "id": "b", "label": "Bed", "category": "Bed", "center": [1.1, 2.0, 0.3],
    "half": [1.0, 0.8, 0.3], "yaw": 0.5, "front_known": True, "front_from_wall": False,
    "parent": None,
}  # fmt: skip
ROW: dict[str, Any] = {
    "id": "home/1", "source": "drawn", "room_type": "Bedroom",
    "polygon": [[0.0, 0.0], [4.0, 0.0], [4.0, 5.0], [0.0, 5.0]], "height": 2.5,
    "doors": [{"segment": [[0.0, 1.0], [0.0, 2.0]], "z": [0.0, 2.0]}], "windows": [],
    "objects": [BED],
}  # fmt: skip


def convert(*words: str | Path) -> int:
    return main(["convert", *map(str, words)])


def write(path: Path, *rows: Any) -> Path:
    path.write_text("".join(json.dumps(row) + "\n" for row in rows), encoding="utf-8")
    return path


def rooms(path: Path) -> list[Scene]:
    return list(read_scenes(path))


def test_one_room_becomes_a_scene_file(tmp_path: Path) -> None:
    out = tmp_path / "scene.json"
    assert convert(SCAN, "--room-id", "roomplan_two_stories/2", "--to", out) == 0
    scene = read_scene(out.read_bytes())
    assert (scene.id, scene.source) == ("roomplan_two_stories/2", "roomplan")
    assert [box.category for box in scene.boxes] == ["Bed"]


@pytest.mark.parametrize("name", ["rooms.jsonl", "rooms.jsonl.gz"])
def test_rooms_become_rows_that_read_the_same(tmp_path: Path, name: str) -> None:
    out = tmp_path / name
    assert convert(SCAN, LIVING_ROOM, "--to", out) == 0
    assert (out.read_bytes()[:2] == b"\x1f\x8b") == name.endswith(".gz")
    read = rooms(out)
    assert [scene.id for scene in read] == [
        "roomplan_two_stories/1", "roomplan_two_stories/2", "drawn",
    ]  # fmt: skip
    for scene, true in zip(read, [*rooms(SCAN), *rooms(LIVING_ROOM)], strict=True):
        assert scene.boxes == true.boxes
        assert scene.room.corners == true.room.corners
        assert (scene.room.height, scene.room.room_type) == (true.room.height, true.room.room_type)
        assert [(d.start, d.end, d.bottom, d.top) for d in scene.room.doors] == [
            (d.start, d.end, d.bottom, d.top) for d in true.room.doors
        ]


def test_rows_come_out_as_they_went_in(tmp_path: Path) -> None:
    given = write(tmp_path / "in.jsonl", ROW, {**ROW, "id": "home/2", "doors": []})
    out = tmp_path / "out.jsonl"
    assert convert(given, "--to", out) == 0
    assert [json.loads(line) for line in out.read_text().splitlines()] == [
        json.loads(line) for line in given.read_text().splitlines()
    ]
    first = json.loads(out.read_text().splitlines()[0])
    assert list(first) == list(ROW)
    assert list(first["objects"][0]) == list(BED)


@pytest.mark.skipif(not CORPORA.is_dir(), reason="the corpora of rooms are not at hand")
def test_a_whole_corpus_survives_being_written_and_read(tmp_path: Path) -> None:
    corpus, out = CORPORA / "robot_virtualhome.jsonl.gz", tmp_path / "out.jsonl.gz"
    assert convert(corpus, "--to", out) == 0
    lines = gzip.decompress(corpus.read_bytes()).splitlines()
    copied = gzip.decompress(out.read_bytes()).splitlines()
    for line, copy in zip(map(json.loads, lines), map(json.loads, copied), strict=True):
        assert copy["id"] == line["id"]
        assert copy["polygon"] == line["polygon"]
        objects = {thing["id"]: thing for thing in line["objects"]}
        assert len(copy["objects"]) == sum(t["category"] is not None for t in line["objects"])
        for thing in copy["objects"]:
            true = objects[thing["id"]]
            assert thing["center"] == true["center"]
            assert thing["half"] == pytest.approx(true["half"])
            assert (thing["yaw"], thing["category"]) == (true["yaw"], true["category"])


def test_the_same_rooms_give_the_same_bytes(tmp_path: Path) -> None:
    one, two = tmp_path / "one.jsonl.gz", tmp_path / "two.jsonl.gz"
    assert convert(SCAN, "--to", one) == convert(SCAN, "--to", two) == 0
    assert one.read_bytes() == two.read_bytes()


def test_without_a_target_the_rooms_are_listed(capsys: pytest.CaptureFixture[str]) -> None:
    assert convert(SCAN) == 0
    lines = [line.split() for line in capsys.readouterr().out.splitlines()]
    # The L of 16 m² holds eight things and has a door, a passage and a window.
    assert lines[1] == ["roomplan_two_stories/1", "living", "room/dining", "room", "16.0",
                        "8", "2", "1"]  # fmt: skip
    assert lines[2] == ["roomplan_two_stories/2", "bedroom", "12.0", "1", "0", "0"]


def test_what_is_left_out_is_always_said(capsys: pytest.CaptureFixture[str]) -> None:
    assert convert(SCAN) == 0
    said = capsys.readouterr().err
    assert "left out: " in said
    assert "object 'NEXT-DOOR'" in said
    assert "unknown label, counts as Other: 'aquarium' (roomplan), 1" in said


def test_the_report_counts_every_reduction(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    thin = {**BED, "id": "thin", "half": [1.0, 0.8, 0.0]}
    outside = {**BED, "id": "out", "center": [9.0, 9.0, 0.3]}
    high = {**BED, "id": "high", "center": [1.1, 2.0, 0.4]}
    given = write(
        tmp_path / "rooms.jsonl",
        {**ROW, "objects": [BED, thin, outside]},
        {**ROW, "id": "bath", "room_type": "Bathroom"},
        {**ROW, "id": "hall", "polygon": [[0, 0], [20, 0], [20, 20], [0, 20]]},
        {**ROW, "id": "bare", "objects": []},
        {**ROW, "id": "uneven", "objects": [high]},
        {**ROW, "id": "broken", "polygon": []},
    )
    assert convert(given, "--report") == 0
    counts = {
        " ".join(words): int(number)
        for *words, number in map(str.split, capsys.readouterr().out.splitlines())
    }
    assert counts == {
        "rooms read": 5,
        "boxes read": 6,
        "left out while reading": 1,
        "unknown labels": 0,
        "cleaning: other room types": 1,
        "cleaning: outlier areas": 1,
        "cleaning: thin boxes": 1,
        "cleaning: outside boxes": 1,
        "cleaning: empty rooms": 1,
        "cleaning: uneven floors": 1,
        "rooms left to learn from": 2,
        "boxes left to learn from": 2,
    }


def test_rooms_of_one_id_are_told_apart(tmp_path: Path) -> None:
    given = [write(tmp_path / f"{name}.jsonl", ROW) for name in ("a", "b", "c")]
    out = tmp_path / "out.jsonl"
    assert convert(*given, "--to", out) == 0
    assert [scene.id for scene in rooms(out)] == ["home/1", "home/1-2", "home/1-3"]


def test_a_folder_stands_for_the_files_in_it(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = tmp_path / "rooms"
    (folder / "more").mkdir(parents=True)
    write(folder / "one.jsonl", ROW)
    write(folder / "more" / "two.jsonl", {**ROW, "id": "home/2"})
    (folder / "notes.txt").write_text("about these rooms")
    out = tmp_path / "out.jsonl"
    assert convert(folder, folder / "one.jsonl", "--to", out) == 0
    assert {scene.id for scene in rooms(out)} == {"home/1", "home/2"}
    assert "notes.txt is neither" in capsys.readouterr().err


def test_progress_is_told_over_many_files(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for number in range(12):
        write(tmp_path / f"{number}.jsonl", {**ROW, "id": str(number)})
    assert convert(tmp_path, "--report") == 0
    assert "12 of 12 files" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["nowhere.json"], "There is no file nowhere.json; check its name and folder."),
        ([SCAN, "nowhere.json"], "There is no file nowhere.json"),
        ([SCAN, "--to", "{tmp}/x.json"], "holds 2 rooms; choose one with --room-id: roomplan_"),
        ([SCAN, LIVING_ROOM, "--to", "{tmp}/x.json"], "the input holds 3 rooms"),
        ([SCAN, "--room-id", "attic"], "There is no room 'attic' in"),
        ([LIVING_ROOM, "--to", "{tmp}/no/such/x.json"], "cannot be written"),
        (["{tmp}"], "is a folder; name a file in it"),
        (["{tmp}/text", "{tmp}/cut.json"], "None of the 2 files is usable"),
        (["{tmp}/text"], "is neither a scene file, rows of rooms"),
        (["{tmp}/cut.json"], "begins as JSON but is none; check that it is complete"),
    ],
)
def test_what_cannot_be_done_is_said_in_a_sentence(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], words: list[Any], message: str
) -> None:
    if any("/" in str(word) for word in words if "{tmp}" in str(word)):
        (tmp_path / "text").write_text("hello")
        (tmp_path / "cut.json").write_bytes(LIVING_ROOM.read_bytes()[:300])
    assert convert(*(str(word).replace("{tmp}", str(tmp_path)) for word in words)) == 2
    assert message in capsys.readouterr().err


def test_a_target_of_no_known_kind_is_refused_before_anything_is_read(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit):
        convert("nowhere.json", "--to", tmp_path / "rooms.csv")
    assert "name it .json for one room, or .jsonl or .jsonl.gz for rows" in capsys.readouterr().err


def test_a_room_too_full_for_a_scene_file_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    crowd = [{**BED, "id": str(number)} for number in range(501)]
    given = write(tmp_path / "rooms.jsonl", {**ROW, "objects": crowd})
    assert convert(given, "--to", tmp_path / "scene.json") == 2
    assert "$.boxes" in capsys.readouterr().err
    assert not (tmp_path / "scene.json").exists()
