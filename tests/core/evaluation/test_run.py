"""Runs: what is asked, what is left out, going on after an interruption."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from msgspec import structs

from scenegen_core.errors import DataError
from scenegen_core.evaluation.jobs import Job, cross_validated, held_out, left_out, taught
from scenegen_core.evaluation.records import Journal, Record
from scenegen_core.evaluation.report import write_report
from scenegen_core.evaluation.run import run
from scenegen_core.evaluation.summary import summarize
from scenegen_core.knowledge import learn
from scenegen_core.scene.model import PAPER_CATEGORIES, Scene
from tests.core.evaluation.made import SETTINGS, TELEVISION, bedroom

SYSTEMS = ("paper", "random_open", "oracle", "nearest_room")
ROOMS = [bedroom(number, *[TELEVISION][: number < 3]) for number in range(12)]


@pytest.fixture(scope="module")
def jobs() -> list[Job]:
    return list(cross_validated(ROOMS, PAPER_CATEGORIES, 2, seed=1))


def asked(jobs: list[Job], workers: int = 1) -> tuple[Record, ...]:
    return run(jobs, Journal(None, SETTINGS), systems=SYSTEMS, seed=1, workers=workers)


@pytest.fixture(scope="module")
def records(jobs: list[Job]) -> tuple[Record, ...]:
    return asked(jobs)


def test_no_room_is_asked_with_what_it_taught(jobs: list[Job]) -> None:
    for job in jobs:
        judged = {case.scene.id for case in job.cases}
        assert judged.isdisjoint(lesson.scene.id for lesson in job.lessons)
        assert judged.isdisjoint(job.knowledge["Bed"].rooms)


def test_every_bed_and_cupboard_is_asked_about_once(records: tuple[Record, ...]) -> None:
    names = {f"flats:home{number}/bedroom#{box}" for number in range(12)
             for box in ("bed", "cupboard")}  # fmt: skip
    assert sorted(record.case for record in records) == sorted(names)


def test_a_category_with_three_examples_is_left_out_and_counted(jobs: list[Job]) -> None:
    assert left_out(jobs) == {"TV": 3}


def test_the_best_pose_tried_is_nearest_to_the_truth(records: tuple[Record, ...]) -> None:
    for record in records:
        joint = {name: tasks["joint"]["top1"] for name, tasks in record.errors.items()}
        assert joint["oracle"] <= min(joint.values()) + 0.1  # radians count for 0.1 m too
        assert joint["oracle"] < 0.3


def test_the_most_similar_room_shows_where_the_cupboard_goes(records: tuple[Record, ...]) -> None:
    found = [r.errors["nearest_room"]["position"]["top1"] for r in records if r.category != "Bed"]
    assert max(found) < 0.7  # the rooms are alike but for a shift of 0.55 m at most


def test_processes_do_not_change_a_number(jobs: list[Job], records: tuple[Record, ...]) -> None:
    assert asked(jobs, workers=2) == records


def test_other_systems_do_not_change_the_numbers_of_one(
    jobs: list[Job], records: tuple[Record, ...]
) -> None:
    alone = run(jobs[:1], Journal(None, SETTINGS), systems=("random_open",), seed=1)
    for record, among in zip(alone, records, strict=False):
        assert record.errors["random_open"] == among.errors["random_open"]


def test_where_there_is_nothing_to_choose_from_nothing_is_asked(tmp_path: Path) -> None:
    deep = replace(TELEVISION, size=(0.6, 1.0, 0.6))
    low = replace(
        ROOMS[0].boxes[1], category="Table", size=(0.6, 1.0, 0.5), center=(2.5, 0.3, 0.25)
    )
    rooms = [
        replace(room, boxes=(room.boxes[0], *([low] if i else []), deep))
        for i, room in enumerate(ROOMS)
    ]
    jobs = list(cross_validated(rooms, PAPER_CATEGORIES, 2, seed=1))
    found = asked(jobs)
    (nowhere,) = (r for r in found if r.case == "flats:home0/bedroom#tv")
    assert "joint" not in nowhere.errors["random_open"]
    assert "orientation" in nowhere.errors["random_open"]
    others = [r for r in found if r.category == "TV" and r is not nowhere]
    assert all("joint" in r.errors["random_open"] for r in others)
    settings = structs.replace(SETTINGS, systems=SYSTEMS)
    write_report(tmp_path, settings, found, summarize(found, rng=np.random.default_rng(1)))
    assert "TV" in (tmp_path / "results.md").read_text()


def test_an_interrupted_run_goes_on_where_it_stopped(
    jobs: list[Job], records: tuple[Record, ...], tmp_path: Path
) -> None:
    path = tmp_path / "journal.jsonl"

    def stop(done: int, _: int) -> None:
        if done == 5:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        run(jobs, Journal(path, SETTINGS), systems=SYSTEMS, seed=1, progress=stop)
    journal, told = Journal(path, SETTINGS), list[int]()
    assert len(journal.known) == 5
    again = run(jobs, journal, systems=SYSTEMS, seed=1, progress=lambda done, _: told.append(done))
    assert again == records
    assert told == list(range(6, 25))


def test_half_of_what_has_company_is_asked_in_emptier_rooms(records: tuple[Record, ...]) -> None:
    full = [bedroom(number, TELEVISION) for number in range(20)]
    job = held_out(full, learn(full, PAPER_CATEGORIES))
    found = run([job], Journal(None, SETTINGS), systems=("oracle", "F"), seed=1)
    asked = [record.errors["oracle"] for record in found if "joint2" in record.errors["oracle"]]
    assert 20 <= len(asked) <= 40  # of 60
    for errors in asked:  # what is gone is in the way no more
        assert errors["joint3"]["top1"] <= errors["joint"]["top1"] + 0.1
    assert not any("joint3" in r.errors["F"] for r in found)  # knows no places
    company = {r.room for r in records if "joint3" in r.errors["paper"]}
    assert company <= {f"flats:home{number}/bedroom" for number in range(3)}


def test_what_gives_probabilities_says_some_of_every_case(records: tuple[Record, ...]) -> None:
    for record in records:
        assert list(record.chances) == ["paper"]
        found = record.chances["paper"]
        assert 1 <= len(found.called) == len(found.holds) <= 5
        assert found.log_score <= 0
        nearest = record.errors["paper"]["joint"]["spread5"]
        assert any(found.holds) == (nearest <= 0.5)


def test_rooms_that_taught_are_counted() -> None:
    knowledge = learn(ROOMS[:8], PAPER_CATEGORIES)
    assert taught(ROOMS[6:], knowledge) == 2


def test_without_rooms_at_hand_none_is_remembered() -> None:
    job = held_out(ROOMS[8:], learn(ROOMS[:8], PAPER_CATEGORIES))
    assert job.lessons == ()
    (record, *_) = asked([job])
    assert "nearest_room" not in record.errors


@pytest.mark.parametrize(
    ("rooms", "folds", "words"),
    [
        ([], 4, "no usable room"),
        (ROOMS[:3], 2, "these files hold 3; give more"),
        (ROOMS[:5], 4, "leave a fold of one room"),
        (ROOMS[:4], 6, "too few for 6 folds"),
    ],
)
def test_too_few_rooms_are_refused_in_words(rooms: list[Scene], folds: int, words: str) -> None:
    with pytest.raises(DataError, match=words):
        list(cross_validated(rooms, PAPER_CATEGORIES, folds, seed=1))


def test_rooms_that_teach_nothing_enough_are_refused_in_words() -> None:
    jobs = list(cross_validated(ROOMS[:4], PAPER_CATEGORIES, 2, seed=1))
    with pytest.raises(DataError, match=r"needs 5 examples .* hold Bed \(4\), Storage \(4\), TV"):
        left_out(jobs)
