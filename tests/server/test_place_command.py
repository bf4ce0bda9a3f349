"""``scenegen place``: what it prints and saves, and what it says of bad input."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from scenegen_core.scene.files import read_scene
from server.cli import main
from tests.server.glb_files import primitives

LIVING_ROOM = Path(__file__).parents[1] / "fixtures/living_room.json"
SCENE: dict[str, Any] = json.loads(LIVING_ROOM.read_text())


def place(*words: str | Path) -> int:
    """The exit code of the command, also where the words themselves are wrong."""
    try:
        return main(["place", *map(str, words)])
    except SystemExit as stop:
        return int(stop.code or 0)


def answered(capsys: pytest.CaptureFixture[str], *words: str | Path) -> dict[str, Any]:
    """What the command prints as JSON."""
    assert place(*words, "--json") == 0
    printed: dict[str, Any] = json.loads(capsys.readouterr().out)
    return printed


def scene_file(folder: Path, room: dict[str, Any] | None = None, **changes: Any) -> Path:
    """The living room with some things changed, as a file."""
    path = folder / "room.json"
    content = SCENE | changes | {"room": SCENE["room"] | (room or {})}
    path.write_text(json.dumps(content))
    return path


def box(box_id: str, center: list[float], **changes: Any) -> dict[str, Any]:
    return {"id": box_id, "category": "Chair", "center": center, "size": [0.1, 0.1, 0.1]} | changes


# --- what it prints -------------------------------------------------------------------------------


def test_it_prints_the_agreed_json(capsys: pytest.CaptureFixture[str]) -> None:
    found = answered(capsys, LIVING_ROOM, "--add", "table:0.5,0.9,0.7", "--count", "3")
    assert found.keys() >= {"room_id", "model", "answers", "elapsed_ms"}
    assert (found["room_id"], found["model"]) == ("drawn", "scenegen")
    assert found["elapsed_ms"] > 0
    (answer,) = found["answers"]
    assert answer.keys() >= {"category", "size", "placements", "heat_map", "no_good_place"}
    assert (answer["category"], answer["size"]) == ("Table", [0.5, 0.9, 0.7])
    assert answer["no_good_place"] is None
    assert answer["heat_map"].keys() >= {"origin", "cell", "shape", "min", "max"}
    assert answer["heat_map"]["origin"] == [0, 0]
    assert answer["heat_map"]["shape"] == [40, 50]  # rows of a room of 5 m by 4 m
    assert answer["heat_map"]["cell"] == 0.1
    assert answer["heat_map"]["min"] < answer["heat_map"]["max"]
    assert [placement["rank"] for placement in answer["placements"]] == [1, 2, 3]
    for placement in answer["placements"]:
        assert placement.keys() >= {"rank", "center", "yaw", "score", "reasons"}
        x, y, z = placement["center"]
        assert 0 < x < 5
        assert 0 < y < 4
        assert z == 0.35  # half of its height
        assert -np.pi <= placement["yaw"] <= np.pi
        for reason in placement["reasons"]:
            assert reason.keys() == {"relation", "group", "contribution", "text"}
            assert reason["text"]
        total = sum(reason["contribution"] for reason in placement["reasons"])
        assert total == pytest.approx(placement["score"], abs=1e-9)


def test_it_prints_nothing_else_than_one_line_of_json(capsys: pytest.CaptureFixture[str]) -> None:
    assert place(LIVING_ROOM, "--add", "chair", "--json") == 0
    printed = capsys.readouterr()
    assert printed.out.count("\n") == 1
    assert printed.err == ""


def test_without_json_it_tells_a_line_a_placement(capsys: pytest.CaptureFixture[str]) -> None:
    assert place(LIVING_ROOM, "--add", "Picture:0.04,0.6,0.5", "--count", "2") == 0
    first, *lines = capsys.readouterr().out.splitlines()
    assert first == "Picture, 0.04 × 0.60 × 0.50 m"
    assert len(lines) == 3
    assert lines[0].startswith("  1  ")
    assert ": at (" in lines[0]
    assert " wall" in lines[0]
    assert lines[2].startswith("  Rooms that speak for the first: ")


def test_objects_added_together_see_each_other(capsys: pytest.CaptureFixture[str]) -> None:
    words = (LIVING_ROOM, "--add", "table:0.5,0.9,0.7")
    alone = answered(capsys, *words)["answers"]
    both = answered(capsys, *words, "--add", "table:0.5,0.9,0.7")["answers"]
    assert len(both) == 2
    assert both[0] == alone[0]
    first, second = (answer["placements"][0]["center"] for answer in both)
    assert max(abs(a - b) for a, b in zip(first, second, strict=True)) >= 0.5


def test_a_category_may_be_written_in_any_case(capsys: pytest.CaptureFixture[str]) -> None:
    answers = answered(capsys, LIVING_ROOM, "--add", "tv", "--add", "SOFA:0.8,1.2,0.8")["answers"]
    assert [answer["category"] for answer in answers] == ["TV", "Sofa"]


def test_the_seed_and_the_count_are_heeded(capsys: pytest.CaptureFixture[str]) -> None:
    words = (LIVING_ROOM, "--add", "decor", "--seed", "3", "--count", "1")
    one, two = answered(capsys, *words), answered(capsys, *words)
    assert one["answers"] == two["answers"]
    assert len(one["answers"][0]["placements"]) == 1


def test_a_room_without_a_place_is_an_answer_too(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    full = scene_file(tmp_path, boxes=[box("b", [2.5, 2, 0.5], size=[4.9, 3.9, 1], category="Bed")])
    (answer,) = answered(capsys, full, "--add", "sofa")["answers"]
    assert answer["placements"] == []
    assert answer["no_good_place"].keys() == {"rule", "text"}
    assert answer["no_good_place"]["rule"] == "collision"
    assert answer["no_good_place"]["text"].endswith("Try a smaller one, or move something.")
    assert place(full, "--add", "sofa") == 0
    assert "No good place for a sofa" in capsys.readouterr().out


def test_an_empty_room_is_a_room(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    answers = answered(capsys, scene_file(tmp_path, boxes=[]), "--add", "sofa")["answers"]
    assert len(answers[0]["placements"]) == 5


def test_boxes_outside_the_room_are_taken_as_they_are(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    outside = [box("far", [90, -40, 0.5]), box("in the wall", [5, 2, 0.5], size=[0.6, 0.6, 1])]
    answers = answered(capsys, scene_file(tmp_path, boxes=outside), "--add", "sofa")["answers"]
    assert answers[0]["placements"]


# --- what it saves --------------------------------------------------------------------------------


def test_it_saves_a_picture_of_the_heat_map(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    picture = tmp_path / "map.png"
    assert place(LIVING_ROOM, "--add", "sofa:0.8,1.2,0.8", "--heat-map", picture) == 0
    with Image.open(picture) as image:
        assert image.format == "PNG"
        assert min(image.size) > 200
        assert len(image.convert("RGB").getcolors(1 << 20) or ()) > 20  # a scale, not just lines
    assert f"Saved {picture}." in capsys.readouterr().err


def test_it_saves_the_furnished_room_as_a_model(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    before, after = tmp_path / "one.glb", tmp_path / "two.glb"
    assert place(LIVING_ROOM, "--add", "decor:0.3,0.3,1.2", "--glb", before) == 0
    assert (
        place(LIVING_ROOM, "--add", "decor:0.3,0.3,1.2", "--add", "chair", "--glb", after, "--json")
        == 0
    )
    capsys.readouterr()
    for path in (before, after):
        content = path.read_bytes()
        assert content[:4] == b"glTF"
        assert int.from_bytes(content[8:12], "little") == len(content)
    assert after.stat().st_size > before.stat().st_size
    assert len(primitives(after.read_bytes())) > len(primitives(before.read_bytes()))


def test_it_runs_as_a_program() -> None:
    words = [str(LIVING_ROOM), "--add", "chair", "--count", "1", "--json"]
    done = subprocess.run(
        [sys.executable, "-m", "server.cli", "place", *words],
        capture_output=True, text=True, check=False, cwd=Path(__file__).parents[2],
    )  # fmt: skip
    assert (done.returncode, done.stderr) == (0, "")
    assert len(json.loads(done.stdout)["answers"][0]["placements"]) == 1


# --- what it says of bad input --------------------------------------------------------------------

SQUARE = [[0, 0], [4, 0], [4, 4], [0, 4]]
BAD_FILES: dict[str, tuple[str, str]] = {
    "half a JSON": (json.dumps(SCENE)[:400], "room.json"),
    "nothing": ("", "room.json"),
    "another JSON": ("[1, 2, 3]", "room.json"),
    "an outline of two corners": (
        json.dumps(SCENE | {"room": {"corners": [[0, 0], [4, 0]]}}),
        "$.room.corners",
    ),
    "an outline without any floor": (
        json.dumps(SCENE | {"room": {"corners": [[0, 0], [4, 0], [2, 0]]}}),
        "outline",
    ),
    "an outline that crosses itself": (
        json.dumps(SCENE | {"room": {"corners": [[0, 0], [4, 4], [4, 0], [0, 4]]}}),
        "crosses or touches itself",
    ),
    "NaN": (json.dumps(SCENE | {"room": {"corners": [[0, 0], [float("nan"), 0], [4, 4]]}}), ""),
    "a room of kilometers": (
        json.dumps(SCENE | {"room": {"corners": [[0, 0], [4e5, 0], [4e5, 4e5]]}}),
        "$.room.corners",
    ),
    "a box without a size": (
        json.dumps(SCENE | {"boxes": [box("b", [1, 1, 1], size=[0, 1, 1])]}),
        "$.boxes[0].size",
    ),
    "a box of a kilometer": (
        json.dumps(SCENE | {"boxes": [box("b", [1, 1, 1], size=[1000, 1, 1])]}),
        "$.boxes[0].size",
    ),
    "ten thousand boxes": (
        json.dumps(SCENE | {"boxes": [box(f"b{i}", [1, 1, 1]) for i in range(10_000)]}),
        "$.boxes",
    ),
    "two boxes of one id": (
        json.dumps(SCENE | {"boxes": [box("twin", [1, 1, 1]), box("twin", [2, 1, 1])]}),
        "'twin'",
    ),
}


@pytest.mark.parametrize("name", BAD_FILES)
def test_a_bad_file_is_refused_in_one_sentence(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, name: str
) -> None:
    content, told = BAD_FILES[name]
    path = tmp_path / "room.json"
    path.write_text(content)
    assert place(path, "--add", "sofa", "--json") == 2
    printed = capsys.readouterr()
    assert printed.out == ""
    assert printed.err.startswith("scenegen: ")
    assert told in printed.err
    assert printed.err.count("\n") == 1


@pytest.mark.parametrize(
    ("words", "told"),
    [
        ((LIVING_ROOM, "--add", "piano"), "use one of Bed, Chair"),
        ((LIVING_ROOM, "--add", "other"), "use one of Bed, Chair"),
        ((LIVING_ROOM, "--add", ""), "use one of Bed, Chair"),
        ((LIVING_ROOM, "--add", "sofa:0,1,1"), "between 0.01 and 20 metres"),
        ((LIVING_ROOM, "--add", "sofa:1,-1,1"), "between 0.01 and 20 metres"),
        ((LIVING_ROOM, "--add", "sofa:1,1,5000"), "between 0.01 and 20 metres"),
        ((LIVING_ROOM, "--add", "tv:nan,1,1"), "A TV cannot be nan"),
        ((LIVING_ROOM, "--add", "sofa:inf,1,1"), "between 0.01 and 20 metres"),
        ((LIVING_ROOM, "--add", "sofa:1,1"), "depth,width,height in metres"),
        ((LIVING_ROOM, "--add", "sofa:large"), "depth,width,height in metres"),
        ((LIVING_ROOM, "--add", "sofa", "--count", "0"), "from 1 to 10"),
        ((LIVING_ROOM, "--add", "sofa", "--count", "11"), "from 1 to 10"),
        ((LIVING_ROOM, "--add", "sofa", "--model", "none"), "invalid choice"),
        ((LIVING_ROOM, "--add", "sofa", "--seed", "x"), "whole number"),
        ((LIVING_ROOM, "--add", "sofa", "--seed", "-1"), "whole number"),
        ((LIVING_ROOM,), "--add"),
        ((LIVING_ROOM.parent, "--add", "sofa"), "is a folder"),
        ((LIVING_ROOM.parent / "none.json", "--add", "sofa"), "There is no file"),
        ((Path(__file__), "--add", "sofa"), "test_place_command.py"),
        ((LIVING_ROOM, "--add", "sofa", "--knowledge", LIVING_ROOM), "knowledge"),
        ((LIVING_ROOM, "--add", "sofa", "--room-id", "attic"), "attic"),
        ((LIVING_ROOM, "--add", "chair", "--glb", "/no/such/folder/x.glb"), "cannot be written"),
        ((LIVING_ROOM, "--add", "chair", "--heat-map", LIVING_ROOM.parent), "cannot be written"),
    ],
)
def test_bad_words_are_refused_with_what_to_do(
    capsys: pytest.CaptureFixture[str], words: tuple[str | Path, ...], told: str
) -> None:
    assert place(*words) == 2
    assert told in capsys.readouterr().err


def test_the_room_itself_is_never_changed(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    path = scene_file(tmp_path)
    content = path.read_bytes()
    assert place(path, "--add", "chair", "--add", "table") == 0
    capsys.readouterr()
    assert path.read_bytes() == content
    assert read_scene(content).id == "drawn"


# --- what it says beyond the places ---------------------------------------------------------------


def test_every_place_has_a_name_of_its_own(capsys: pytest.CaptureFixture[str]) -> None:
    (answer,) = answered(capsys, LIVING_ROOM, "--add", "chair")["answers"]
    names = [placement["name"] for placement in answer["placements"]]
    assert all(names)
    assert len(set(names)) == len(names)
    assert place(LIVING_ROOM, "--add", "chair") == 0
    words = capsys.readouterr().out
    assert all(f"{rank}  {name}:" in words for rank, name in enumerate(names, start=1))
    assert f"Rooms that speak for the first: {answer['placements'][0]['rooms'][0]}" in words


def test_why_not_names_the_rule_and_the_nearest_place(
    capsys: pytest.CaptureFixture[str],
) -> None:
    """A table of 0.6 m, its middle on the west wall: 0.3 m further in it is free of it."""
    words = (LIVING_ROOM, "--add", "table:0.6,0.6,0.7", "--why-not", "0,3.5")
    seen = answered(capsys, *words)["why_not"]
    assert (seen["allowed"], seen["rule"]) == (False, "room")
    assert seen["elsewhere"]["distance"] == pytest.approx(0.3, abs=0.01)
    assert place(*words) == 0
    printed = capsys.readouterr().out
    assert "At (0, 3.5): It would stick through a wall" in printed
    assert "It may stand 30 cm further from the west wall: " in printed


def test_why_not_says_what_a_possible_place_costs(capsys: pytest.CaptureFixture[str]) -> None:
    words = (LIVING_ROOM, "--add", "sofa:0.9,1.5,0.8", "--why-not", "3.8,1.2,10")
    seen = answered(capsys, *words)["why_not"]
    assert seen["allowed"]
    assert 1 <= len(seen["costs"]) <= 3
    assert all(cost["difference"] < 0 for cost in seen["costs"])


def test_what_if_names_the_thing_that_matters_most(capsys: pytest.CaptureFixture[str]) -> None:
    found = answered(capsys, LIVING_ROOM, "--add", "sofa", "--what-if")["what_if"]
    assert found["box"] in {one["id"] for one in SCENE["boxes"]}
    assert found["text"].startswith("Without the ")
    assert place(LIVING_ROOM, "--add", "sofa", "--what-if") == 0
    assert found["text"] in capsys.readouterr().out


def test_where_there_is_no_place_it_says_what_would_give_one(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A room of 2 m by 2 m without a thing in it: 85 % of 2.3 m is the first that fits."""
    corners = [[0, 0], [2, 0], [2, 2], [0, 2]]
    room = scene_file(tmp_path, {"corners": corners, "doors": [], "windows": []}, boxes=[])
    remedy = answered(capsys, room, "--add", "bed:2.3,0.9,0.5")["remedy"]
    assert remedy["kind"] == "size"
    assert remedy["size"][0] == pytest.approx(0.85 * 2.3, abs=0.006)
    assert place(room, "--add", "bed:2.3,0.9,0.5") == 0
    assert "One that is 15 % smaller would fit" in capsys.readouterr().out


@pytest.mark.parametrize("spot", ["1", "1,b", "1,2,3,4"])
def test_a_spot_that_is_none_says_how_to_write_one(
    spot: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert place(LIVING_ROOM, "--add", "sofa", "--why-not", spot) == 2
    assert "like 1.2,0.5,90" in capsys.readouterr().err
