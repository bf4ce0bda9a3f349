"""Systems: the poses that yardsticks pick, and what an answer is worth."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest

from scenegen_core.evaluation.bench import Bench, Form, spread
from scenegen_core.evaluation.cases import Case
from scenegen_core.evaluation.measure import Errors, answer, errors
from scenegen_core.evaluation.retrieval import lessons_of
from scenegen_core.evaluation.systems import SYSTEMS, System
from scenegen_core.evaluation.trees import can_grow, grow
from scenegen_core.knowledge import Knowledge, learn
from scenegen_core.placement.choice_learning import gather, with_choices
from scenegen_core.scene.model import PAPER_CATEGORIES, Box
from tests.core.evaluation.made import bedroom

ROOMS = [bedroom(number) for number in range(6)]
BY_NAME = {system.name: system for system in SYSTEMS}
ASKED = [system for system in SYSTEMS if can_grow() or not system.needs_forest]
EVERYWHERE = [(system, task) for system in ASKED for task in system.scores]


@pytest.fixture(scope="module")
def knowledge() -> Knowledge:
    return with_choices(learn(ROOMS, PAPER_CATEGORIES), gather(ROOMS, PAPER_CATEGORIES))


@pytest.fixture(scope="module")
def bed() -> Bench:
    room = bedroom(7)
    forest = grow(gather(ROOMS, PAPER_CATEGORIES)) if can_grow() else {}
    case = Case(room.without("bed"), room["bed"])
    return Bench(case, PAPER_CATEGORIES, lessons_of(ROOMS), forest)


def worth(system: System, task: Form, bench: Bench, knowledge: Knowledge) -> Errors:
    return errors(answer(system, task, bench, knowledge, np.random.default_rng(2)))


def scores(name: str, task: Form, bench: Bench, knowledge: Knowledge) -> list[float]:
    table = bench.table(task)
    found = BY_NAME[name].scores[task](bench, table, knowledge, np.random.default_rng(2))
    return [float(score) for score in found]


@pytest.mark.parametrize(("system", "task"), EVERYWHERE, ids=lambda p: getattr(p, "name", p))
def test_more_answers_are_never_further_from_the_truth(
    system: System, task: Form, bed: Bench, knowledge: Knowledge
) -> None:
    found = worth(system, task, bed, knowledge)
    if task == "orientation":
        assert set(found) == {"angle"}
    else:
        assert 0 <= found["spread5"] <= found["top1"]
    if "angle" in found:
        assert 0 <= found["angle"] <= pi


def test_only_the_random_pose_breaks_rules(bed: Bench, knowledge: Knowledge) -> None:
    broken = {
        system.name
        for system in ASKED
        if "joint" in system.scores
        for seed in range(6)
        if (rng := np.random.default_rng(seed))
        and (found := errors(answer(system, "joint", bed, knowledge, rng)))
        and found["collides"] + found["outside"] > 0
    }
    assert broken == {"random"}


def test_what_goes_along_walls_touches_one(bed: Bench, knowledge: Knowledge) -> None:
    found = scores("along_walls", "joint", bed, knowledge)
    best = int(np.argmax(found))
    assert bed.joint.situation.wall_gaps[best].min() == pytest.approx(0, abs=0.02)


def test_a_bed_with_its_head_to_the_wall_faces_away_from_it(
    bed: Bench, knowledge: Knowledge
) -> None:
    assert worth(BY_NAME["away_from_wall"], "orientation", bed, knowledge)["angle"] < 0.05


def test_five_that_differ_are_three_quarters_of_a_metre_apart(bed: Bench) -> None:
    table = bed.position
    chosen = spread(table, np.random.default_rng(1).random(len(table.candidates)), 5, 0.75)
    points = table.candidates.centers[chosen, :2]
    apart = np.hypot(*(points[:, None] - points[None]).transpose(2, 0, 1))
    assert len(chosen) >= 2
    assert apart[~np.eye(len(points), dtype=bool)].min() >= 0.75


def test_without_a_front_that_is_known_no_angle_is_judged(knowledge: Knowledge) -> None:
    room = bedroom(1)
    guessed = Box("bed", "Bed", (1.0, 1.9, 0.25), (2.0, 1.4, 0.5), front_known=False)
    bench = Bench(Case(room.without("bed"), guessed), PAPER_CATEGORIES)
    assert "angle" not in worth(BY_NAME["random_open"], "joint", bench, knowledge)
