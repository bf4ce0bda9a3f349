"""What a pose costs beside the best one, with contributions written by hand."""

from __future__ import annotations

from pathlib import Path

import pytest

from scenegen_core.knowledge import default_knowledge
from scenegen_core.placement.answer import MODELS, Model, Query, Reason
from scenegen_core.placement.inspecting import dearest
from scenegen_core.placement.solve import solve
from scenegen_core.scene.files import read_scene

KNOWLEDGE = default_knowledge()
LIVING_ROOM = read_scene((Path(__file__).parents[2] / "fixtures/living_room.json").read_bytes())


def reasons(**contributions: float) -> tuple[Reason, ...]:
    return tuple(
        Reason(name, "", value, f"{name} {value}") for name, value in contributions.items()
    )


def test_the_three_dearest_differences_are_told_the_dearest_first() -> None:
    here = reasons(walls=-1.0, doors=0.5, middle=0.0, windows=2.0, height=-0.5)
    best = reasons(walls=2.0, doors=1.0, middle=1.0, windows=0.0, height=-0.25)
    costs = dearest(here, best)
    assert [(cost.relation, cost.difference, cost.here, cost.best) for cost in costs] == [
        ("walls", -3.0, "walls -1.0", "walls 2.0"),
        ("middle", -1.0, "middle 0.0", "middle 1.0"),
        ("doors", -0.5, "doors 0.5", "doors 1.0"),
    ]  # fmt: skip


def test_what_only_one_of_them_has_counts_as_nothing_for_the_other() -> None:
    (lost, bad) = dearest(reasons(doors=-1.0), reasons(walls=3.0))
    assert (lost.relation, lost.difference, lost.here, lost.best) == (
        "walls",
        -3.0,
        "",
        "walls 3.0",
    )
    assert (bad.relation, bad.difference, bad.here, bad.best) == ("doors", -1.0, "doors -1.0", "")


def test_what_is_better_here_or_hardly_felt_costs_nothing() -> None:
    assert dearest(reasons(walls=2.0, doors=0.0), reasons(walls=1.0, doors=0.09)) == ()


@pytest.mark.parametrize("model", MODELS)
def test_all_differences_to_the_best_pose_add_up_to_the_difference_of_the_scores(
    model: Model,
) -> None:
    solution = solve(LIVING_ROOM, Query("Sofa", model=model), KNOWLEDGE)
    best, *others = solution.answer.poses
    assert others
    for pose in others:
        seen = solution.inspect(pose.center, pose.heading)
        assert seen.score is not None
        mine = {(one.relation, one.group): one.contribution for one in seen.reasons}
        theirs = {(one.relation, one.group): one.contribution for one in best.reasons}
        differences = {
            about: mine.get(about, 0.0) - theirs.get(about, 0.0) for about in {**mine, **theirs}
        }
        assert sum(differences.values()) == pytest.approx(seen.score - best.score, abs=1e-6)
        told = {(cost.relation, cost.group): cost.difference for cost in seen.costs}
        assert len(told) <= 3
        least = sorted(differences.values())[: len(told)]
        assert sorted(told.values()) == pytest.approx(least)


def test_the_best_pose_costs_nothing_and_leads_nowhere() -> None:
    solution = solve(LIVING_ROOM, Query("Sofa"), KNOWLEDGE)
    best = solution.answer.poses[0]
    seen = solution.inspect(best.center, best.heading)
    assert (seen.costs, seen.elsewhere) == ((), None)


def test_a_better_place_is_offered_and_its_score_is_higher() -> None:
    solution = solve(LIVING_ROOM, Query("Sofa"), KNOWLEDGE)
    last = solution.answer.poses[-1]
    here = solution.inspect(last.center, last.heading)
    assert here.elsewhere is not None
    there = solution.inspect(here.elsewhere.center, here.elsewhere.heading)
    assert there.allowed
    assert there.score is not None
    assert here.score is not None
    assert there.score > here.score
