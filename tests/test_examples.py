"""Every example runs as its first lines say, and prints what it promises."""

from __future__ import annotations

import runpy
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
PROMISED = {
    "01_place_a_sofa": ["five places for a sofa", "5. ", "Why the first?", "heat map"],
    "02_scene_graph": ["Living room", "TV unit", "SurroundedBy"],
    "03_learn_your_rooms": ["Learned from 4 rooms", "Where a storage would go"],
}


def test_every_example_is_run_here() -> None:
    assert {path.stem for path in (ROOT / "examples").glob("*.py")} == PROMISED.keys()


@pytest.mark.parametrize("name", sorted(PROMISED))
def test_an_example_runs_and_prints_what_it_promises(
    name: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(ROOT)
    runpy.run_path(str(ROOT / "examples" / f"{name}.py"), run_name="__main__")
    printed = capsys.readouterr().out
    assert [words for words in PROMISED[name] if words not in printed] == []
