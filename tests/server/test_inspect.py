"""``scenegen inspect`` and /knowledge.json: what is known, as pictures and as numbers."""

from __future__ import annotations

import json
import re
from contextlib import redirect_stdout
from dataclasses import replace
from io import StringIO
from pathlib import Path

import numpy as np
import pytest

from scenegen_core.evaluation.knowledge_page import write_knowledge
from scenegen_core.knowledge import Knowledge, default_knowledge, load_knowledge, save_knowledge
from scenegen_core.knowledge.choice import BINS, Choice, choice_columns
from server.app import make_app
from server.cli import main
from server.settings import Settings
from server.world import World
from tests.server.driving import browser

CATEGORIES = ["Bed", "Chair", "Decor", "Picture", "Sofa", "Storage", "Table", "TV"]


@pytest.fixture(scope="module")
def shipped(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, str]:
    """The page of what ships, in a folder that was not there, and what the command said."""
    out = tmp_path_factory.mktemp("inspected") / "deep" / "known"
    with redirect_stdout(StringIO()) as said:
        assert main(["inspect", "--out", str(out)]) == 0
    return out, said.getvalue()


def test_every_category_has_a_picture_and_its_counts(shipped: tuple[Path, str]) -> None:
    out, said = shipped
    page = (out / "index.html").read_text(encoding="utf-8")
    assert "<script" not in page
    for name in CATEGORIES:
        assert f'<section id="{name}">' in page
        for end in ("", "-curves", "-surfaces"):
            picture = (out / f"{name.lower()}{end}.svg").read_text(encoding="utf-8")
            assert picture.startswith("<svg")
    assert not (out / "tables").exists()
    assert said.startswith("Bed: in a corner ")
    assert said.count("faces the middle of the room") == 4  # bed, chair, sofa, TV


def test_curves_are_named_in_plain_words_the_strongest_first(tmp_path: Path) -> None:
    page = written(tmp_path, hand_made(shared=False))
    sofa = page.split('<section id="Sofa">')[1].split("</section>")[0]
    told = "Curves, the strongest first: gap to the nearest wall, m; gap to the nearest TV, m"
    assert f'aria-label="{told}"' in sofa
    named = "is it in front of the nearest TV? with gap to the nearest wall, m"
    assert f'aria-label="Surfaces, the strongest first: {named}"' in sofa
    assert "dashed" not in page
    assert 'id="all"' not in page


def test_what_all_furniture_shares_is_drawn_once_and_beside_each_curve(tmp_path: Path) -> None:
    page = written(tmp_path, hand_made(shared=True))
    everything = page.split('<section id="all">')[1].split("</section>")[0]
    assert 'aria-label="Curves, the strongest first: gap to the nearest wall, m"' in everything
    assert (tmp_path / "all-furniture.svg").exists()
    assert page.count("dashed: what all furniture shares") == 1  # the curves of the sofa


def test_a_category_without_curves_says_why(tmp_path: Path) -> None:
    page = written(tmp_path, hand_made(shared=False))
    bed = page.split('<section id="Bed">')[1].split("</section>")[0]
    assert "too few examples to learn curves from" in bed
    assert bed.count("<svg") == 1
    assert not (tmp_path / "bed-curves.svg").exists()


def test_knowledge_for_the_model_paper_alone_speaks_of_no_curves(tmp_path: Path) -> None:
    page = written(tmp_path, replace(hand_made(shared=False), choices={}, shared=None))
    assert page.count("<svg") == 2
    assert "curves" not in page


def test_tables_are_written_and_linked_and_can_be_read_back(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    known = tmp_path / "known.npz"
    save_knowledge(hand_made(shared=True), known)
    assert main(["inspect", str(known), "--out", str(tmp_path), "--tables"]) == 0
    page = (tmp_path / "index.html").read_text(encoding="utf-8")
    links = re.findall(r'href="(tables/[^"]+)"', page)
    assert links == ["tables/sofa-curves.csv", "tables/sofa-surfaces.csv"]
    assert all((tmp_path / link).exists() for link in links)
    command = capsys.readouterr().out.split("read them with: scenegen ")[1].split()
    command[command.index("edited.npz")] = str(tmp_path / "edited.npz")
    assert main(command) == 0
    assert list(load_knowledge(tmp_path / "edited.npz").choices) == ["Sofa"]


def hand_made(*, shared: bool) -> Knowledge:
    """A sofa that likes walls, and TVs less; all furniture likes walls a little, or nothing."""
    known = default_knowledge()
    named = choice_columns(known.groups)
    wall, gap, faced = (
        next(i for i, c in enumerate(named) if (c.relation, c.group, c.part) == key)
        for key in (("W", "", "nearest"), ("N", "TV", "gap"), ("N", "TV", "faced"))
    )
    curves = np.zeros((len(named), BINS), dtype=np.float32)
    curves[wall, :12], curves[gap, :12] = 2.0, 1.0
    surfaces = np.zeros((1, BINS, BINS), dtype=np.float32)
    surfaces[0, 1, :12] = 1.0
    examples = np.zeros((4, len(named)), dtype=np.uint8)
    examples[:2, [wall, gap]] = 20
    examples[::2, faced] = 1
    sofa = Choice(named, curves, np.array([[faced, wall]]), surfaces, examples, ("r",) * 4)
    in_common = np.zeros_like(curves)
    in_common[wall, :12] = 0.5 if shared else 0.0
    both = {name: known.categories[name] for name in ("Bed", "Sofa")}
    return replace(known, categories=both, choices={"Sofa": sofa}, shared=in_common)


def written(out: Path, knowledge: Knowledge) -> str:
    write_knowledge(out, knowledge)
    return (out / "index.html").read_text(encoding="utf-8")


def test_shares_and_counts_agree_with_each_other(shipped: tuple[Path, str]) -> None:
    known = json.loads((shipped[0] / "knowledge.json").read_text(encoding="utf-8"))
    examples = {name: part.examples for name, part in default_knowledge().categories.items()}
    for part in known["categories"]:
        assert part["examples"] == examples[part["category"]]
        assert sum(bar["count"] for bar in part["position"]) == part["examples"]
        assert sum(bar["count"] for bar in part["towards_center"]) == part["fronts"]
        for bar in part["surrounded_by"]:
            assert bar["several"] <= bar["count"] <= bar["possible"] <= part["examples"]
            assert bar["share"] == pytest.approx(bar["count"] / part["examples"])


def test_a_file_that_is_no_knowledge_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "known.npz").write_bytes(b"PK")
    words = ["inspect", str(tmp_path / "known.npz"), "--out", str(tmp_path / "out")]
    assert main(words) == 2
    assert "learn it again" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


def test_a_place_that_cannot_be_written_is_named(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "file").touch()
    assert main(["inspect", "--out", str(tmp_path / "file")]) == 2
    assert "choose another folder" in capsys.readouterr().err


def test_the_page_can_ask_what_is_known(world: World, page_files: Path, tmp_path: Path) -> None:
    settings = Settings(store=tmp_path / "sessions.sqlite3", page=page_files)
    with browser(make_app(settings, world)) as client:
        response = client.get("/knowledge.json")
    assert response.headers["content-type"] == "application/json"
    known = response.json()
    assert [part["category"] for part in known["categories"]] == CATEGORIES
    assert known["sources"][0]["license"] == "MIT"
    assert [bar["label"] for bar in known["categories"][0]["position"]] == [
        "middle",
        "edge",
        "corner",
    ]
