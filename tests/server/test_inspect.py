"""``scenegen inspect`` and /knowledge.json: what is known, as pictures and as numbers."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from scenegen_core.knowledge import default_knowledge
from server.app import make_app
from server.cli import main
from server.settings import Settings
from server.world import World
from tests.server.driving import browser

CATEGORIES = ["Bed", "Chair", "Decor", "Picture", "Sofa", "Storage", "Table", "TV"]


def test_every_category_has_a_picture_and_its_counts(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "deep" / "known"
    assert main(["inspect", "--out", str(out)]) == 0
    page = (out / "index.html").read_text(encoding="utf-8")
    assert page.count("<svg") == 8
    assert "<script" not in page
    for name in CATEGORIES:
        assert (out / f"{name.lower()}.svg").read_text(encoding="utf-8").startswith("<svg")
        assert f'<section id="{name}">' in page
    printed = capsys.readouterr().out
    assert printed.startswith("Bed: in a corner ")
    assert printed.count("faces the middle of the room") == 4  # bed, chair, sofa, TV


def test_shares_and_counts_agree_with_each_other(tmp_path: Path) -> None:
    main(["inspect", "--out", str(tmp_path)])
    known = json.loads((tmp_path / "knowledge.json").read_text(encoding="utf-8"))
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
