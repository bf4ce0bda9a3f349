"""``scenegen graph``, and how commands open the room that they are about."""

from __future__ import annotations

import gzip
import json
from argparse import ArgumentParser
from pathlib import Path
from typing import Any

import pytest

from scenegen_core.errors import SceneGenError
from scenegen_core.scene.files import read_scene
from server.commands import graph
from server.commands.rooms import open_room

LIVING_ROOM = Path(__file__).parents[1] / "fixtures/living_room.json"


def row(room_id: str, **changes: Any) -> str:
    bed = {
        "id": "bed",
        "label": "Bed",
        "category": "Bed",
        "center": [1, 2, 0.3],
        "half": [1, 0.7, 0.3],
        "yaw": 0,
    }
    polygon = [[0, 0], [4, 0], [4, 4], [0, 4]]
    room = {"id": room_id, "source": "drawn", "room_type": "bedroom", "polygon": polygon}
    return json.dumps(room | {"objects": [bed]} | changes)


def rows_file(path: Path, *rows: str) -> Path:
    content = "".join(f"{line}\n" for line in rows).encode()
    path.write_bytes(gzip.compress(content) if path.suffix == ".gz" else content)
    return path


def scenegen_graph(*words: str) -> int:
    parser = ArgumentParser()
    graph.add_arguments(parser)
    return graph.run(parser.parse_args(words))


def test_a_scene_file_is_opened_whatever_its_name(tmp_path: Path) -> None:
    odd = tmp_path / "room.jsonl"
    odd.write_bytes(LIVING_ROOM.read_bytes())
    assert open_room(odd) == open_room(LIVING_ROOM) == read_scene(LIVING_ROOM.read_bytes())


def test_a_scene_file_on_one_line_is_still_a_scene_file(tmp_path: Path) -> None:
    flat = tmp_path / "room.json"
    flat.write_text(json.dumps(json.loads(LIVING_ROOM.read_text())))
    assert open_room(flat, "drawn") == open_room(LIVING_ROOM)


@pytest.mark.parametrize("name", ["rooms.jsonl", "rooms.jsonl.gz", "rooms.txt"])
def test_a_room_of_many_is_opened_by_its_id(tmp_path: Path, name: str) -> None:
    path = rows_file(tmp_path / name, row("one"), row("two", room_type="attic"))
    assert open_room(path, "two").room.room_type == "attic"


def test_the_only_room_needs_no_id(tmp_path: Path) -> None:
    assert open_room(rows_file(tmp_path / "rooms.jsonl", row("one"))).id == "one"


def test_one_of_several_rooms_has_to_be_chosen(tmp_path: Path) -> None:
    path = rows_file(tmp_path / "rooms.jsonl", *(row(f"r{i}") for i in range(7)))
    with pytest.raises(SceneGenError, match=r"7 rooms; .* --room-id: r0, r1, r2, r3, r4, …\."):
        open_room(path)


def test_a_room_that_is_not_there_is_named(tmp_path: Path) -> None:
    path = rows_file(tmp_path / "rooms.jsonl", row("one"))
    with pytest.raises(SceneGenError, match="no room 'nine'"):
        open_room(path, "nine")
    with pytest.raises(SceneGenError, match=r"no room 'nine' in .*; it holds drawn"):
        open_room(LIVING_ROOM, "nine")


def test_what_cannot_be_opened_is_said(tmp_path: Path) -> None:
    with pytest.raises(SceneGenError, match=r"There is no file .*check its name"):
        open_room(tmp_path / "nowhere.json")
    with pytest.raises(SceneGenError, match="is a folder; name a file in it"):
        open_room(tmp_path)
    picture = tmp_path / "picture.json"
    picture.write_bytes(b"\x89PNG\r\n\x1a\n\xff\xfe")
    with pytest.raises(SceneGenError, match="is neither a scene file"):
        open_room(picture)
    broken = rows_file(tmp_path / "rooms.jsonl", row("one", polygon=[[0, 0], [1, 1]]))
    with pytest.raises(SceneGenError, match="no usable room; choose another"):
        open_room(broken)


def test_a_room_of_another_program_is_opened_and_what_it_lacks_is_said(
    capsys: pytest.CaptureFixture[str],
) -> None:
    scan = LIVING_ROOM.with_name("roomplan_two_stories.json")
    assert [box.category for box in open_room(scan, "roomplan_two_stories/2").boxes] == ["Bed"]
    said = capsys.readouterr().err
    assert "object 'NEXT-DOOR': lies outside of the room" in said
    assert "unknown label, counts as Other: 'aquarium'" in said


def test_the_graph_is_printed_as_json(capsys: pytest.CaptureFixture[str]) -> None:
    assert scenegen_graph(str(LIVING_ROOM)) == 0
    printed = capsys.readouterr()
    assert len(json.loads(printed.out)["nodes"]) == 8 + 7 + 1  # objects, groups, the room
    assert printed.err == ""


@pytest.mark.parametrize(
    ("kind", "start"),
    [("json", "{"), ("graphml", '<?xml version="1.0" encoding="UTF-8"?>'), ("dot", "digraph")],
)
def test_the_graph_is_saved_in_the_format_asked_for(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], kind: str, start: str
) -> None:
    out = tmp_path / "graph"
    assert scenegen_graph(str(LIVING_ROOM), "--format", kind, "--out", str(out)) == 0
    assert out.read_text(encoding="utf-8").startswith(start)
    assert capsys.readouterr().out == ""


def test_a_place_that_cannot_be_written_is_said(tmp_path: Path) -> None:
    with pytest.raises(SceneGenError, match=r"cannot be written .*choose another place"):
        scenegen_graph(str(LIVING_ROOM), "--out", str(tmp_path / "no" / "such" / "folder"))
