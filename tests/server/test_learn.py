"""``scenegen learn``, from rows in files to a file of knowledge and a summary."""

from __future__ import annotations

import json
from argparse import ArgumentParser
from dataclasses import replace
from pathlib import Path

import pytest
from shapely import Polygon

from scenegen_core.errors import DataError
from scenegen_core.knowledge import Knowledge, default_knowledge, load_knowledge, save_knowledge
from scenegen_core.knowledge.writing_tables import write_tables
from scenegen_core.placement.answer import Query
from scenegen_core.placement.solve import solve
from scenegen_core.scene.files import read_scene
from scenegen_core.scene.model import Box
from server.commands import learn
from tests.core.placement.by_shapely import ERROR, rectangle

LIVING_ROOM = Path(__file__).parents[1] / "fixtures/living_room.json"


def row(number: int) -> str:
    """A bedroom of 4 m by 5 m with its bed against the wall x = 0."""
    bed = {
        "id": "b", "label": "Bed", "category": "Bed", "center": [1.1, 1 + number / 10, 0.3],
        "half": [1.0, 0.8, 0.3], "yaw": 0.0, "front_known": True, "front_from_wall": False,
        "parent": None,
    }  # fmt: skip
    return json.dumps(
        {
            "id": f"home/{number}", "source": "robot-at-virtualhome", "room_type": "Bedroom",
            "polygon": [[0, 0], [4, 0], [4, 5], [0, 5]], "height": None, "doors": [],
            "windows": [], "objects": [bed],
        }
    )  # fmt: skip


def run(*words: str | Path) -> int:
    parser = ArgumentParser()
    learn.add_arguments(parser)
    return learn.run(parser.parse_args([str(word) for word in words]))


def test_rooms_become_a_knowledge_file_and_a_summary(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    one, two, out = tmp_path / "one.jsonl", tmp_path / "two.jsonl", tmp_path / "known.npz"
    one.write_text("\n".join([row(0), row(1), "{"]), encoding="utf-8")
    two.write_text("\n".join([row(2), row(3), row(4)]), encoding="utf-8")
    assert run(one, two, "--out", out) == 0
    knowledge = load_knowledge(out)
    assert knowledge["Bed"].examples == 5
    assert knowledge.made_with == "scenegen learn one.jsonl two.jsonl"
    printed = capsys.readouterr()
    summary = " ".join(printed.out.split())
    assert "Bed 5 5 2.00 × 1.60 × 0.60" in summary
    assert "Robot@VirtualHome: 5 rooms, 5 objects (MIT, © 2021 David Fernández Chaves)" in summary
    assert "skipped 1" in summary
    assert f"left out: {one}, line 3:" in printed.out + printed.err


def test_nothing_is_written_when_there_is_nothing_to_learn(tmp_path: Path) -> None:
    empty, out = tmp_path / "empty.jsonl", tmp_path / "known.npz"
    empty.touch()
    with pytest.raises(DataError, match=r"empty\.jsonl is neither"):
        run(empty, "--out", out)
    assert not out.exists()


def edited(folder: Path, name: str, rows: list[str]) -> Path:
    """What ships as tables, one of them written anew below its head."""
    write_tables(default_knowledge(), folder)
    path = folder / name
    head = path.read_text(encoding="utf-8").splitlines()[0]
    path.write_text("\n".join([head, *rows]) + "\n", encoding="utf-8")
    return folder


def test_a_curve_raised_by_hand_changes_where_things_go(tmp_path: Path) -> None:
    out = tmp_path / "edited.npz"
    away = [
        "Walls,,nearest,-inf,0.8,0",
        "Walls,,nearest,0.8,inf,50",
        "Walls,,nearest,none,none,0",
    ]
    tables = edited(tmp_path / "tables", "sofa-curves.csv", away)
    assert run("--tables", tables, "--on", "shipped", "--out", out) == 0
    gaps = [gap_to_walls(knowledge) for knowledge in (default_knowledge(), load_knowledge(out))]
    assert gaps[0] < 0.3
    assert gaps[1] > 0.8 - ERROR


def gap_to_walls(knowledge: Knowledge) -> float:
    """How far from the walls a sofa would go in the empty living room."""
    room = replace(read_scene(LIVING_ROOM.read_bytes()), boxes=())
    answer = solve(room, Query("Sofa"), knowledge).answer
    pose = answer.poses[0]
    walls = Polygon(room.room.corners).exterior
    sofa = Box("sofa", "Sofa", pose.center, answer.size, pose.heading)
    return float(walls.distance(rectangle(sofa)))


def test_tables_alone_leave_the_examples_as_they_are(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    known, out, tables = tmp_path / "known.npz", tmp_path / "edited.npz", tmp_path / "tables"
    save_knowledge(default_knowledge(), known)
    write_tables(default_knowledge(), tables)
    assert run("--tables", tables, "--on", known, "--out", out) == 0
    before, after = default_knowledge(), load_knowledge(out)
    assert after.sources == before.sources
    assert after.made_with == f"{before.made_with}; tables edited"
    assert {name: part.examples for name, part in after.categories.items()} == {
        name: part.examples for name, part in before.categories.items()
    }
    assert (
        capsys.readouterr().out == f"Wrote {out}, which is {known} with the tables of {tables}.\n"
    )


def test_rooms_can_teach_on_top_of_edited_tables(tmp_path: Path) -> None:
    rooms, out = tmp_path / "rooms.jsonl", tmp_path / "known.npz"
    rooms.write_text("\n".join(row(number) for number in range(5)), encoding="utf-8")
    tables = edited(tmp_path / "tables", "sofa-curves.csv", [])
    assert run(rooms, "--tables", tables, "--on", "shipped", "--out", out) == 0
    knowledge = load_knowledge(out)
    assert not knowledge.choices["Sofa"].curves.any()
    assert knowledge["Bed"].examples == default_knowledge()["Bed"].examples + 5


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ((), r"nothing to learn from; name files of rooms, or --tables"),
        (("--on", "shipped"), r"nothing to learn from"),
        (("--tables", "tables"), r"--tables needs the knowledge that they are of: --on FILE"),
    ],
)
def test_what_is_missing_is_asked_for(tmp_path: Path, words: tuple[str, ...], said: str) -> None:
    with pytest.raises(DataError, match=said):
        run(*words, "--out", tmp_path / "known.npz")
