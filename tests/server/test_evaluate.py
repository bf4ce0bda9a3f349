"""``scenegen evaluate``: the object it prints, the report it writes, what it refuses."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest

from server.cli import main

TASKS = {
    "position": {"n", "top1", "top5", "spread5", "ci"},
    "orientation": {"n", "angle", "ci"},
    "joint": {"n", "top1", "top5", "spread5", "angle", "ci"},
}
FEW = ("--model", "paper", "--model", "random_open", "--folds", "2", "--workers", "1")


def row(number: int, source: str = "flats") -> str:
    """A bedroom of 4 m by 3 m: a bed with its head to the wall x = 0, a cupboard at y = 0."""
    common = {"label": "", "front_known": True, "front_from_wall": False, "parent": None}
    bed = {"id": "b", "category": "Bed", "center": [1.0, 1.8 + number / 50, 0.25],
           "half": [1.0, 0.7, 0.25], "yaw": 0.0, **common}  # fmt: skip
    cupboard = {"id": "s", "category": "Storage", "center": [2.5 + number / 20, 0.3, 0.9],
                "half": [0.3, 0.5, 0.9], "yaw": 1.5708, **common}  # fmt: skip
    return json.dumps(
        {
            "id": f"home{number}/1", "source": source, "room_type": "Bedroom",
            "polygon": [[0, 0], [4, 0], [4, 3], [0, 3]], "height": 2.5, "doors": [],
            "windows": [], "objects": [bed, cupboard],
        }
    )  # fmt: skip


@pytest.fixture
def rooms(tmp_path: Path) -> Path:
    path = tmp_path / "rooms.jsonl"
    path.write_text("\n".join(map(row, range(12))), encoding="utf-8")
    return path


def evaluated(capsys: pytest.CaptureFixture[str], *words: str | Path) -> dict[str, Any]:
    """What the command prints as JSON."""
    assert main(["evaluate", *map(str, words), "--json"]) == 0
    found: dict[str, Any] = json.loads(capsys.readouterr().out)
    return found


def refused(capsys: pytest.CaptureFixture[str], *words: str | Path) -> str:
    """The sentence that the command ends with."""
    assert main(["evaluate", *map(str, words)]) == 2
    return capsys.readouterr().err.splitlines()[-1]


def test_the_printed_object_has_the_published_form(
    rooms: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    found = evaluated(capsys, rooms, *FEW)
    assert (found["rooms"], found["queries"]) == (12, 24)
    assert set(found) == {"rooms", "queries", "models"}
    assert set(found["models"]) == {"paper", "random_open"}
    assert set(found["models"]["paper"].pop("calibration")) == {"overall", "Bed", "Storage"}
    for model in found["models"].values():
        assert set(model) == {*TASKS, "physical", "declined"}
        assert set(model["physical"]) == {"collides", "outside", "blocks_door", "breaks_path"}
        for task, measures in TASKS.items():
            assert next(iter(model[task])) == "overall"
            assert set(model[task]["overall"]) == measures
            for measure, (low, high) in model[task]["overall"]["ci"].items():
                assert low <= model[task]["overall"][measure] <= high
        assert model["joint"]["overall"]["n"] == 24
        assert model["orientation"]["overall"]["n"] == 12  # a cupboard faces as its wall does
        assert set(model["joint"]["Storage"]) == TASKS["position"]
        assert set(model["orientation"]) == {"overall", "Bed"}


def test_a_report_is_written_and_gone_on_with(
    rooms: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "report"
    first = evaluated(capsys, rooms, *FEW, "--out", out)
    assert (out / "index.html").read_text(encoding="utf-8").startswith("<!doctype html>")
    journal = (out / "journal.jsonl").read_bytes().splitlines(keepends=True)
    (out / "journal.jsonl").write_bytes(b"".join(journal[:9]) + journal[9][:40])
    assert evaluated(capsys, rooms, *FEW, "--out", out) == first
    assert (out / "journal.jsonl").read_bytes() == b"".join(journal)


def test_other_rooms_are_not_mixed_into_a_journal(
    rooms: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "report"
    evaluated(capsys, rooms, *FEW, "--out", out)
    rooms.write_text("\n".join(map(row, range(1, 13))), encoding="utf-8")
    assert "other settings" in refused(capsys, rooms, *FEW, "--out", out)


def test_what_ships_is_judged_on_other_rooms(
    rooms: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    found = evaluated(capsys, "--test", rooms, *FEW)
    assert found["queries"] == 24


def test_one_source_teaches_and_another_judges(
    rooms: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    other = tmp_path / "other.jsonl"
    other.write_text("\n".join(row(n, "villas") for n in range(12, 17)), encoding="utf-8")
    found = evaluated(capsys, rooms, "--test", other, "--model", "nearest_room", "--workers", "1")
    assert (found["rooms"], found["queries"]) == (5, 10)
    assert found["models"]["nearest_room"]["position"]["overall"]["top1"] < 0.5


def test_without_files_a_table_is_printed(rooms: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["evaluate", str(rooms), *FEW]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0] == "24 objects in 12 rooms"
    assert lines[2].split() == ["joint", "top1", "top5", "spread5", "angle"]
    assert lines[3].startswith("paper ")


def test_bad_input_is_refused_in_words(
    rooms: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    four = tmp_path / "four.jsonl"
    four.write_text("\n".join(map(row, range(4))), encoding="utf-8")
    broken = tmp_path / "knowledge.npz"
    broken.write_bytes(b"PK")
    assert "Name rooms" in refused(capsys)
    assert "There is no file" in refused(capsys, tmp_path / "nowhere.jsonl")
    assert "a fold of one room" in refused(capsys, four, "--folds", "4")
    assert "needs 5 examples" in refused(capsys, four, "--folds", "2")
    assert "leave the other DATA out" in refused(capsys, rooms, "--knowledge", broken)
    assert "learn it again" in refused(capsys, "--test", rooms, "--knowledge", broken)
    assert "choose another folder" in refused(capsys, rooms, *FEW, "--out", four)


@pytest.mark.parametrize("words", [("--folds", "1"), ("--workers", "0"), ("--model", "magic")])
def test_options_out_of_range_are_refused(
    words: tuple[str, str], capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit):
        main(["evaluate", "rooms.jsonl", *words])
    assert words[1] in capsys.readouterr().err


def test_a_run_that_ctrl_c_ends_is_gone_on_with(
    rooms: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out, words = tmp_path / "report", [str(rooms), *FEW[:-1], "2"]
    journal = out / "journal.jsonl"
    command = [sys.executable, "-m", "server.cli", "evaluate", *words, "--out", str(out)]
    with subprocess.Popen(
        command, start_new_session=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
    ) as run:
        while run.poll() is None and not (
            journal.exists() and journal.read_bytes().count(b"\n") > 3
        ):
            time.sleep(0.02)
        os.killpg(run.pid, signal.SIGINT)
    assert run.returncode in {0, 130}  # 0 if it was done that quickly
    assert evaluated(capsys, *words, "--out", out) == evaluated(capsys, *words)
