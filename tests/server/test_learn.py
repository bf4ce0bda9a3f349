"""``scenegen learn``, from rows in files to a file of knowledge and a summary."""

from __future__ import annotations

import json
from argparse import ArgumentParser
from pathlib import Path

import pytest

from scenegen_core.errors import DataError
from scenegen_core.knowledge import load_knowledge
from server.commands import learn


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
