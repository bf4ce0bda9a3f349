"""The report, from records made by hand."""

from __future__ import annotations

import json
import sys
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest
from msgspec.structs import replace

from scenegen_core.errors import DataError
from scenegen_core.evaluation.bench import Task
from scenegen_core.evaluation.breakdown_tables import (
    by_reach,
    by_source,
    emptier_by_category,
    physical,
)
from scenegen_core.evaluation.calibration_tables import by_category, calibration, reliability
from scenegen_core.evaluation.comparison_tables import differences, skill, steps
from scenegen_core.evaluation.drawing import need_drawing
from scenegen_core.evaluation.emptier_tables import emptier as emptier_table
from scenegen_core.evaluation.records import Chances, Record
from scenegen_core.evaluation.report import write_report
from scenegen_core.evaluation.report_tables import Judged, counts, joint
from scenegen_core.evaluation.summary import summarize
from scenegen_core.evaluation.tables import Table
from tests.core.evaluation.made import FINE, SETTINGS, record
from tests.core.evaluation.made import joint as joint_errors


def emptier(top1: float, *, asked: bool) -> dict[Task, dict[str, float]]:
    """A metre further off with each thing that is gone."""
    if not asked:
        return joint_errors(top1, top1)
    further: list[tuple[Task, float]] = [("joint", 0), ("joint2", 1), ("joint3", 2)]
    return {task: joint_errors(top1 + more, top1)["joint"] for task, more in further}


def bed(number: int, room: str, paper: float, chance: float, angle: float) -> Record:
    return record(
        number,
        {
            "paper": {
                **joint_errors(paper, paper / 2, angle=angle, collides=float(number == 1)),
                "position": {"top1": paper, "top5": 0.6, "spread5": 0.5},
                "orientation": {"angle": 0.85},
            },
            "RP": {"position": {"top1": 2 * paper, "top5": 1.2, "spread5": 0.5}},
            "F": {"orientation": {"angle": 1.7}},
            "random_open": joint_errors(chance, chance / 4, angle=1.5),
            "rules": emptier(paper, asked=number > 1),
        },
        room=room,
        source="flats" if room == "a" else "homes",
        truth={**FINE, "breaks_path": 1.0},
        chances={"paper": Chances((0.3, 0.95), (number == 1, True), -2.0, -3.0)},
    )


RECORDS = (bed(1, "a", 0.4, 2.0, 0.1), bed(2, "b", 0.6, 2.0, 0.3), bed(3, "b", 2.0, 2.0, 0.2))


@pytest.fixture
def judged() -> Judged:
    return Judged(SETTINGS, RECORDS, summarize(RECORDS, rng=np.random.default_rng(1)))


def value(table: Table, row: str, column: str) -> float | None:
    cells = next(found for found in table.rows if found.name == row).cells
    names = [f"{c.group} {c.name}".strip().replace("\N{NO-BREAK SPACE}", " ")
             for c in table.columns]  # fmt: skip
    return cells[names.index(column)].value


PAPER, CHANCE = "SceneGen as published, made sound", "Random possible pose"
BOTH = "place and heading both unknown"


def test_rooms_and_objects_are_counted_by_source(judged: Judged) -> None:
    table = counts(judged)
    assert value(table, "flats", "objects") == 1
    assert (value(table, "homes", "rooms"), value(table, "homes", "Bed")) == (1, 2)
    assert (value(table, "all", "rooms"), value(table, "all", "objects")) == (2, 3)


def test_the_headline_holds_means_and_the_share_that_is_near(judged: Judged) -> None:
    table = joint(judged)
    assert value(table, PAPER, "best pose, m") == pytest.approx(1.0)
    assert value(table, PAPER, "angle, rad") == pytest.approx(0.2)
    near = "within 0.5 m and 15°"  # only the first: 0.4 m and 0.1 rad
    assert value(table, PAPER, near) == pytest.approx(1 / 3)
    assert value(table, CHANCE, near) == 0


def test_skill_is_the_part_of_the_error_of_chance_that_is_gone(judged: Judged) -> None:
    table = skill(judged)
    assert value(table, PAPER, f"{BOTH} best pose") == pytest.approx(0.5)  # 1 m of 2 m
    assert value(table, PAPER, f"{BOTH} angle") == pytest.approx(1 - 0.2 / 1.5)
    assert value(table, PAPER, f"{BOTH} nearest of 5 that differ") == pytest.approx(0)
    assert [row.name for row in table.rows] == [PAPER, "Hand-written rules"]


def test_the_worth_of_relations_is_a_change_of_the_error(judged: Judged) -> None:
    table = steps(judged)
    assert value(table, "RP → AD+S+RP, best pose", "change of the error") == pytest.approx(-0.5)
    assert value(table, "F → F+C+RP, angle", "change of the error") == pytest.approx(-0.5)
    assert len(table.rows) == 3


def test_differences_are_paired(judged: Judged) -> None:
    table = differences(judged)
    assert value(table, CHANCE, f"{BOTH} best pose, m") == pytest.approx(-1.0)
    assert value(table, CHANCE, "place given angle, rad") is None
    assert value(table, "F", "place given angle, rad") == pytest.approx(-0.85)


def test_sources_are_judged_apart(judged: Judged) -> None:
    table = by_source(judged)[0]
    assert value(table, PAPER, "flats best pose, m") == pytest.approx(0.4)
    assert value(table, PAPER, "homes best pose, m") == pytest.approx(1.3)


def test_what_could_have_been_offered_right_is_judged_apart(judged: Judged) -> None:
    records = tuple(
        replace(one, errors={**one.errors, "oracle": joint_errors(near, near)})
        for one, near in zip(RECORDS, (0.2, 0.05, 0.21), strict=True)
    )
    table = by_reach(Judged(SETTINGS, records, summarize(records, rng=np.random.default_rng(1))))
    assert value(table, PAPER, "within 0.2 m (2) best pose, m") == pytest.approx(0.5)
    assert value(table, PAPER, "further away (1) best pose, m") == pytest.approx(2.0)
    assert by_reach(judged).columns == ()  # where nobody knows the bound nothing is said


def test_true_places_are_held_to_the_hard_facts_too(judged: Judged) -> None:
    table = physical(judged)
    assert value(table, PAPER, "runs into something") == pytest.approx(1 / 3)
    assert value(table, "Where it really stood", "bars a way") == 1
    assert value(table, "Where it really stood", "leaves the room") == 0


def test_emptier_rooms_are_held_against_the_same_objects(judged: Judged) -> None:
    table = emptier_table(judged)
    assert "the same 2 objects" in table.title
    assert [row.name for row in table.rows] == ["Hand-written rules"]
    (one, two, three) = [
        value(table, "Hand-written rules", f"{many} taken out best pose, m")
        for many in ("one", "two", "three")
    ]
    assert (one, two, three) == pytest.approx((1.3, 2.3, 3.3))  # without the first, at 0.4 m
    by_category = emptier_by_category(judged)
    assert [value(t, "Hand-written rules", "Bed") for t in by_category] == [two, three]


def test_probabilities_are_shown_by_what_they_call_and_what_holds(judged: Judged) -> None:
    table = reliability(judged)
    assert len(table.rows) == 10
    assert value(table, "30 to 40 %", f"{PAPER} places") == 3
    assert value(table, "30 to 40 %", f"{PAPER} hold the truth") == pytest.approx(1 / 3)
    assert value(table, "90 to 100 %", f"{PAPER} called on average") == pytest.approx(0.95)
    assert value(table, "0 to 10 %", f"{PAPER} hold the truth") is None
    scores = calibration(judged)
    assert value(scores, PAPER, "Brier score") == pytest.approx(
        (0.7**2 + 2 * 0.3**2 + 3 * 0.05**2) / 6
    )
    error = (3 * (1 / 3 - 0.3) + 3 * 0.05) / 6
    assert value(scores, PAPER, "calibration error") == pytest.approx(error)
    assert value(by_category(judged), "Bed", f"{PAPER} log score, nats") == -2


class Links(HTMLParser):
    """Collects what a page loads and links to, its ids, and how its tags nest."""

    def __init__(self) -> None:
        super().__init__()
        self.loads = list[str]()
        self.links = list[str]()
        self.ids = set[str]()
        self.open = list[str]()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = dict(attrs)
        self.ids.add(given.get("id") or "")
        if tag in {"script", "link", "img", "iframe"}:
            self.loads.append(tag)
        if tag == "a":
            self.links.append(given.get("href") or "")
        if tag not in {"meta", "br"}:
            self.open.append(tag)

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.handle_starttag(tag, attrs)
        self.handle_endtag(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


def test_the_page_stands_alone_and_its_links_lead_somewhere(judged: Judged, tmp_path: Path) -> None:
    write_report(tmp_path, SETTINGS, RECORDS, judged.results)
    page = Links()
    text = (tmp_path / "index.html").read_text(encoding="utf-8")
    page.feed(text)
    assert page.loads == []
    assert page.open == []
    assert page.links
    for link in page.links:
        known = link[1:] in page.ids if link.startswith("#") else (tmp_path / link).is_file()
        assert known, link
    assert "TV: 3 objects not asked" in text
    assert text.count("<svg") == 8


def test_our_numbers_and_the_papers_never_share_a_file(judged: Judged, tmp_path: Path) -> None:
    write_report(tmp_path, SETTINGS, RECORDS, judged.results)
    origins = {
        path.stem: json.loads(path.read_text(encoding="utf-8"))["origin"]
        for path in (tmp_path / "tables").glob("*.json")
    }
    for name, origin in origins.items():
        assert ("Matterport3D" in origin) == name.startswith("published"), name
    assert len(origins) > 12
    assert "2.40" not in (tmp_path / "results.md").read_text(encoding="utf-8")


def test_results_carry_what_they_were_made_with(judged: Judged, tmp_path: Path) -> None:
    write_report(tmp_path, SETTINGS, RECORDS, judged.results)
    results = json.loads((tmp_path / "results.json").read_text(encoding="utf-8"))
    assert results["settings"]["digest"] == "0123456789abcdef"
    assert results["models"]["paper"]["joint"]["overall"]["top1"] == pytest.approx(1.0)


def test_one_system_alone_makes_a_report_too(tmp_path: Path) -> None:
    alone = tuple(record(i, {"oracle": joint_errors(0.1, 0.1)}, room=f"r{i}") for i in range(3))
    write_report(tmp_path, SETTINGS, alone, summarize(alone, rng=np.random.default_rng(1)))
    assert not (tmp_path / "tables" / "position.json").exists()
    assert (tmp_path / "tables" / "joint.csv").exists()
    for absent in ("emptier.csv", "calibration.csv", "reliability.csv"):
        assert not (tmp_path / "tables" / absent).exists()
    assert not (tmp_path / "plots" / "reliability.svg").exists()


def test_without_matplotlib_a_sentence_says_how_to_get_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    with pytest.raises(DataError, match=r"pip install 'scenegen\[report\]'"):
        need_drawing()
