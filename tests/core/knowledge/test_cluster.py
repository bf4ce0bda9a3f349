"""Learning on dask: the same knowledge, whoever measures, and whoever dies."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from scenegen_core.errors import DataError
from scenegen_core.knowledge.cluster import dask_mapper

LEARN = """
import os, sys
from pathlib import Path
from scenegen_core.knowledge import learn, save_knowledge
from scenegen_core.knowledge.cluster import dask_mapper
from scenegen_core.knowledge.learning import examples_of
from scenegen_core.placement.choice_learning import gather, with_choices
from scenegen_core.scene.files import read_scene
from scenegen_core.scene.model import PAPER_CATEGORIES

def deadly(batch, groups, mark):
    if not mark.exists():
        mark.touch()
        os._exit(1)
    return examples_of(batch, groups)

def main(rooms, out, kill):
    scene = read_scene(Path(rooms).read_bytes())
    scenes = [scene] * 200
    few = scenes[:0 if kill else 33]  # two batches
    alone = learn(scenes, PAPER_CATEGORIES)
    alone = with_choices(alone, gather(few, PAPER_CATEGORIES))
    save_knowledge(alone, Path(out + ".alone"))
    with dask_mapper("local", 2) as mapper:
        def risky(work, batches):
            mark = Path(out + ".killed")
            return mapper(lambda batch: deadly(batch, PAPER_CATEGORIES, mark), batches)
        knowledge = learn(scenes, PAPER_CATEGORIES, mapper=risky if kill else mapper)
        knowledge = with_choices(knowledge, gather(few, PAPER_CATEGORIES, mapper=mapper))
    save_knowledge(knowledge, Path(out + ".dask"))

if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], sys.argv[3] == "kill")
"""
ROOM = Path(__file__).parents[3] / "web/public/rooms/living-room.json"


@pytest.mark.parametrize("fate", ["live", "kill"])
def test_workers_measure_what_one_process_does_to_the_bit_even_if_one_dies(
    fate: str, tmp_path: Path
) -> None:
    script, out = tmp_path / "learn.py", tmp_path / "knowledge"
    script.write_text(LEARN, encoding="utf-8")
    command = [sys.executable, str(script), str(ROOM), str(out), fate]
    done = subprocess.run(command, capture_output=True, text=True, timeout=240, check=False)
    assert done.returncode == 0, done.stderr
    assert out.with_suffix(".killed").exists() == (fate == "kill")
    assert out.with_suffix(".dask").read_bytes() == out.with_suffix(".alone").read_bytes()


def test_without_a_scheduler_the_error_says_how_to_start_one() -> None:
    with (
        pytest.raises(DataError, match="start one with"),
        dask_mapper("tcp://127.0.0.1:9", 1, patience="1s"),
    ):
        pass
