"""The main job: placements, maps and reasons for one object in one room."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from itertools import combinations
from math import dist, pi
from pathlib import Path

import numpy as np
import pytest

from scenegen_core.errors import KnowledgeError, SceneError
from scenegen_core.graph.candidates import Candidates
from scenegen_core.graph.situation import Situation
from scenegen_core.graph.surroundings import Surroundings
from scenegen_core.knowledge import default_knowledge
from scenegen_core.knowledge.learning import learn
from scenegen_core.placement.answer import Cancelled, Pose, Query, Surface
from scenegen_core.placement.feasible import ALLOWED, Space, verdicts
from scenegen_core.placement.mounts import Mount
from scenegen_core.placement.paper_model import PaperModel
from scenegen_core.placement.proposals import SURFACES, propose, unrolled
from scenegen_core.placement.solve import Solution, solve
from scenegen_core.scene.files import read_scene
from scenegen_core.scene.model import PAPER_CATEGORIES, Scene, Vector3
from tests.core.placement.drawn import (
    DOOR,
    NORTH,
    WEST,
    category,
    moved,
    moved_point,
    room,
    thing,
)

KNOWLEDGE = default_knowledge()
CATEGORIES = tuple(KNOWLEDGE.categories)
LIVING_ROOM = read_scene((Path(__file__).parents[2] / "fixtures/living_room.json").read_bytes())
ODD = replace(
    LIVING_ROOM,
    boxes=tuple(
        replace(box, center=(box.center[0] + 0.0137, box.center[1] - 0.0171, box.center[2]))
        for box in LIVING_ROOM.boxes
    ),
)
"""The living room with nothing on a round number, so that rounding decides nothing."""
TABLE = thing("Table", 3.0, 2.5, (0.8, 1.4, 0.75))
WALLS = np.array([((0, 0), (6, 0)), ((6, 0), (6, 5)), ((6, 5), (0, 5)), ((0, 5), (0, 0))], float)
SOFA = Query("Sofa", size=(0.9, 1.5, 0.8))
TABLES = Query("Table", size=(0.5, 0.9, 0.7))


@pytest.fixture(scope="module", params=CATEGORIES)
def solution(request: pytest.FixtureRequest) -> Solution:
    """Each category in the drawn living room."""
    return solve(LIVING_ROOM, Query(str(request.param)), KNOWLEDGE)


# --- what every answer keeps ----------------------------------------------------------------------


def test_ranks_are_in_the_order_of_the_scores(solution: Solution) -> None:
    poses = solution.answer.poses
    assert poses
    assert [pose.rank for pose in poses] == list(range(1, len(poses) + 1))
    scores = [pose.score for pose in poses]
    assert scores == sorted(scores, reverse=True)
    likely = [pose.likelihood for pose in poses]
    assert likely == sorted(likely, reverse=True)
    assert all(0 <= value <= 1 for value in likely)


def test_alternatives_are_three_quarters_of_a_meter_apart(solution: Solution) -> None:
    centers = [pose.center[:2] for pose in solution.answer.poses]
    assert all(dist(one, other) >= 0.75 for one, other in combinations(centers, 2))


def test_the_reasons_add_up_to_the_score(solution: Solution) -> None:
    for pose in solution.answer.poses:
        total = sum(reason.contribution for reason in pose.reasons)
        assert total == pytest.approx(pose.score, abs=1e-9)
        strengths = [abs(reason.contribution) for reason in pose.reasons]
        assert strengths == sorted(strengths, reverse=True)
        about = [(reason.relation, reason.group) for reason in pose.reasons]
        assert len(set(about)) == len(about)


def test_scores_differ_as_the_log_densities_of_the_model_do(solution: Solution) -> None:
    answer = solution.answer
    model = PaperModel(KNOWLEDGE, answer.category)
    candidates = Candidates(
        answer.category,
        answer.size,
        np.array([pose.center for pose in answer.poses]),
        np.array([pose.heading for pose in answer.poses]),
    )
    around = Surroundings(LIVING_ROOM, KNOWLEDGE.groups)
    total = model.score(Situation(candidates, around)).total
    scores = np.array([pose.score for pose in answer.poses])
    assert scores - scores[0] == pytest.approx(total - total[0], abs=1e-6)


def test_inspecting_an_offered_pose_says_what_the_offer_said(solution: Solution) -> None:
    for pose in solution.answer.poses:
        seen = solution.inspect(pose.center, pose.heading)
        assert (seen.allowed, seen.rule) == (True, "")
        assert seen.score == pytest.approx(pose.score, abs=1e-6)
        assert seen.likelihood == pytest.approx(pose.likelihood, abs=1e-6)
        assert seen.sentence == pose.sentence
        assert [reason.text for reason in seen.reasons[:1]] == [
            reason.text for reason in pose.reasons[:1]
        ]


def test_the_rooms_named_are_among_those_learned_from(solution: Solution) -> None:
    learned = set(KNOWLEDGE[solution.answer.category].rooms)
    for pose in solution.answer.poses:
        assert 1 <= len(pose.rooms) <= 3
        assert set(pose.rooms) <= learned


@pytest.mark.parametrize("name", CATEGORIES)
def test_the_brightest_cell_is_where_the_first_placement_is(name: str) -> None:
    scene = room(TABLE, corners=((0, 0), (6, 0), (6, 5), (0, 5)))  # nothing is in anyone's way
    answer = solve(scene, Query(name), KNOWLEDGE).answer
    (x, y, z), height = answer.poses[0].center, answer.size[2]
    shown = {heat_map.surface: heat_map for heat_map in answer.heat_maps}
    surface: Surface = "floor"
    if abs(z - height / 2 - 0.75) < 1e-9:
        surface = "tops"
    elif z > height / 2 + 1e-9:
        surface, (x, y) = "walls", unrolled(WALLS, np.array([[x, y, z]]))[0].tolist()
    heat_map = shown[surface]
    column, row = (
        int((at - low) / heat_map.cell) for at, low in zip((x, y), heat_map.origin, strict=True)
    )
    assert heat_map.values[row, column] == 255
    assert max(other.values.max() for other in answer.heat_maps) == 255


def test_a_cell_is_zero_exactly_where_no_pose_is_possible(solution: Solution) -> None:
    answer = solution.answer
    around = Surroundings(LIVING_ROOM, KNOWLEDGE.groups)
    found = propose(around, category(answer.category), answer.size)
    allowed = verdicts(Situation(found.candidates, around), Space.of(around)) == ALLOWED
    for heat_map in answer.heat_maps:
        mount = Mount(SURFACES.index(heat_map.surface))
        here = found.candidates.centers[allowed & (found.mounts == mount)]
        places = unrolled(around.walls, here) if mount is Mount.WALL else here[:, :2]
        row, column = heat_map.values.shape
        expected = np.zeros((row, column), dtype=bool)
        index = np.floor((places - heat_map.origin) / heat_map.cell).astype(int)
        expected[index[:, 1].clip(0, row - 1), index[:, 0].clip(0, column - 1)] = True
        assert ((heat_map.values > 0) == expected).all()
        assert (heat_map.values == 0).any() or heat_map.surface == "tops"


# --- turning, moving, seeds -----------------------------------------------------------------------


def best(scene: Scene, query: Query = SOFA) -> Pose:
    return solve(scene, query, KNOWLEDGE).answer.poses[0]


@pytest.mark.parametrize(
    "query", [SOFA, Query("Chair"), Query("TV"), Query("Bed"), Query("Picture")]
)
@pytest.mark.parametrize(
    ("turn", "shift"), [(0, (3.0, -7.0)), (pi / 2, (4.0, 0.0)), (pi, (0.0, 9.0))]
)
def test_turning_and_moving_the_room_turns_and_moves_the_placements(
    query: Query, turn: float, shift: tuple[float, float]
) -> None:
    here = solve(ODD, query, KNOWLEDGE).answer
    there = solve(moved(ODD, turn, shift), query, KNOWLEDGE).answer
    behind = [pose.score - here.poses[0].score for pose in here.poses]
    assert [pose.score - there.poses[0].score for pose in there.poses] == pytest.approx(
        behind, abs=1e-4
    )
    first, second = here.poses[0], there.poses[0]
    assert second.center[:2] == pytest.approx(moved_point(first.center[:2], turn, shift), abs=1e-6)
    assert np.exp(1j * (second.heading - first.heading - turn)) == pytest.approx(1, abs=1e-6)


def test_the_heat_map_turns_with_the_room() -> None:
    (here,) = solve(ODD, SOFA, KNOWLEDGE).answer.heat_maps
    (there,) = solve(moved(ODD, pi / 2, (4, 0)), SOFA, KNOWLEDGE).answer.heat_maps
    turned = np.rot90(here.values, -1)  # row 0 has the smallest y, so it turns the other way
    assert there.values.shape == (50, 40)
    assert np.abs(there.values.astype(int) - turned).max() <= 1


def test_the_same_seed_gives_the_same_answer() -> None:
    one, two = (solve(LIVING_ROOM, replace(SOFA, seed=7), KNOWLEDGE).answer for _ in range(2))
    assert one.poses == two.poses
    assert (one.heat_maps[0].values == two.heat_maps[0].values).all()


def test_a_seed_decides_between_equal_places() -> None:
    square = room(corners=((0, 0), (4, 0), (4, 4), (0, 4)))
    centers = {
        best(square, Query("Decor", size=(0.3, 0.3, 0.9), seed=seed)).center for seed in range(12)
    }
    assert len(centers) > 1


# --- what is asked --------------------------------------------------------------------------------


@pytest.mark.parametrize("count", [1, 2, 3])
def test_as_many_are_offered_as_were_asked_for(count: int) -> None:
    answer = solve(LIVING_ROOM, replace(TABLES, count=count), KNOWLEDGE).answer
    more = solve(LIVING_ROOM, replace(TABLES, count=10), KNOWLEDGE).answer
    assert len(answer.poses) == count
    assert answer.poses == more.poses[:count]


def test_without_a_size_the_usual_one_is_placed() -> None:
    assert (
        solve(LIVING_ROOM, Query("Table"), KNOWLEDGE).answer.size == KNOWLEDGE["Table"].usual_size
    )
    assert solve(LIVING_ROOM, TABLES, KNOWLEDGE).answer.size == (0.5, 0.9, 0.7)


@pytest.mark.parametrize("size", [(0, 1, 1), (1, -1, 1), (1, 1, 25), (float("nan"), 1, 1)])
def test_an_impossible_size_is_refused_with_the_limits(size: Vector3) -> None:
    with pytest.raises(SceneError, match=r"between 0\.01 and 20 metres"):
        solve(LIVING_ROOM, Query("Sofa", size=size), KNOWLEDGE)


def test_a_category_that_was_never_seen_is_refused_by_name() -> None:
    with pytest.raises(KnowledgeError, match=r"no examples of Piano; choose one of Bed, Chair"):
        solve(LIVING_ROOM, Query("Piano"), KNOWLEDGE)


def test_a_category_with_four_examples_is_refused_with_their_number() -> None:
    rooms = [replace(LIVING_ROOM, id=f"room {number}") for number in range(4)]
    with pytest.raises(KnowledgeError, match="only 4 examples of Sofa, and 5 are needed"):
        solve(LIVING_ROOM, SOFA, learn(rooms, PAPER_CATEGORIES))


@pytest.mark.parametrize("patience", range(4))
def test_work_that_nobody_waits_for_is_abandoned(patience: int) -> None:
    asked = 0

    def cancelled() -> bool:
        nonlocal asked
        asked += 1
        return asked > patience

    with pytest.raises(Cancelled):
        solve(LIVING_ROOM, SOFA, KNOWLEDGE, cancelled=cancelled)
    assert asked == patience + 1


# --- rooms of every kind --------------------------------------------------------------------------


@pytest.mark.parametrize("name", CATEGORIES)
def test_an_empty_room_has_a_place_for_everything(name: str) -> None:
    answer = solve(room(doors=(DOOR,)), Query(name), KNOWLEDGE).answer
    assert answer.poses
    assert answer.no_good_place is None


def test_a_room_of_three_corners_is_a_room() -> None:
    triangle = room(corners=((0, 0), (6, 0), (0, 5)))
    for query in (SOFA, Query("Picture"), Query("Storage"), TABLES):
        assert len(solve(triangle, query, KNOWLEDGE).answer.poses) == 5


def test_two_hundred_boxes_are_no_trouble() -> None:
    stools = tuple(
        thing("Chair", 0.6 + 0.6 * i, 0.6 + 0.6 * j, (0.3, 0.3, 0.4), box_id=f"{i}-{j}")
        for i in range(20)
        for j in range(10)
    )
    hall = room(*stools, corners=((0, 0), (16, 0), (16, 9), (0, 9)))
    answer = solve(hall, SOFA, KNOWLEDGE).answer
    assert answer.poses
    assert all(x > 12 or y > 6 for x, y, _ in (pose.center for pose in answer.poses))


Refusal = tuple[Scene, Query, str, str]
BED = thing("Bed", 2, 2, (3.0, 3.0, 0.5), label="Huge bed")
WARDROBE = thing("Storage", 2.5, 3.7, (0.6, 5.0, 2.0), heading=-NORTH, label="Closet")
REFUSALS: dict[str, Callable[[], Refusal]] = {
    "too large for any room": lambda: (
        room(),
        Query("Sofa", size=(4.5, 4.5, 1)),
        "room",
        (
            "a sofa of 4.5 × 4.5 × 1 m: no stretch of floor or wall is large enough for it. "
            "Try a smaller one."
        ),
    ),
    "other things everywhere": lambda: (
        room(thing("Bed", 2.5, 2, (4.0, 3.0, 0.5))),
        Query("Sofa", size=(0.9, 2.0, 0.8)),
        "collision",
        (
            "a sofa of 0.9 × 2 × 0.8 m: other furniture is in the way nearly everywhere. "
            "Try a smaller one, or move something."
        ),
    ),
    "nothing to stand on": lambda: (
        room(),
        Query("TV", size=(0.5, 0.7, 0.6)),
        "mount",
        "There is nothing here that a TV of 0.5 × 0.7 × 0.6 m could stand or hang on.",
    ),
    "only where people walk": lambda: (
        room(
            WARDROBE,
            corners=((0, 0), (5, 0), (5, 4), (0, 4)),
            doors=(DOOR,),
        ),
        Query("Table", size=(0.5, 4.8, 0.7)),
        "path",
        (
            "a table of 0.5 × 4.8 × 0.7 m: wherever it fits it would close the way to the closet. "
            "Try a smaller one, or move something."
        ),
    ),
}


@pytest.mark.parametrize("name", REFUSALS)
def test_where_nothing_fits_the_sentence_says_why_and_what_to_do(name: str) -> None:
    scene, query, rule, text = REFUSALS[name]()
    solution = solve(scene, query, KNOWLEDGE)
    assert solution.answer.poses == ()
    assert solution.answer.no_good_place is not None
    assert solution.answer.no_good_place.rule == rule
    assert solution.answer.no_good_place.text in (text, f"No good place for {text}")
    if rule != "path":
        assert all((heat_map.values == 0).all() for heat_map in solution.answer.heat_maps)


@pytest.mark.parametrize(
    ("center", "rule", "text"),
    [
        ((0.0, 2.0, 0.4), "room", "It would stick through a wall or out of the room."),
        ((2.5, 2.1, 0.4), "collision", "It would stand in the table and the decor piece."),
        ((2.5, 2.1, 5.4), "room", "It would stick through a wall or out of the room."),
        ((3.9, 1.9, 0.9), "mount", "It would hang in the air."),
        ((0.5, 0.9, 0.4), "door", "It would stand in the way of a door."),
    ],
)
def test_inspecting_an_impossible_pose_says_which_rule_forbids_it(
    center: Vector3, rule: str, text: str
) -> None:
    seen = solve(LIVING_ROOM, SOFA, KNOWLEDGE).inspect(center, WEST)
    assert (seen.allowed, seen.rule, seen.sentence) == (False, rule, text)
    assert (seen.score, seen.likelihood, seen.reasons) == (None, None, ())


def test_inspecting_what_closes_a_way_names_whose() -> None:
    scene = room(thing("Bed", 1.2, 3.4, (2, 1, 0.5)), doors=(DOOR,))
    bar = solve(scene, Query("Table", size=(0.5, 5.0, 0.7)), KNOWLEDGE)
    seen = bar.inspect((2.5, 2.2, 0.35), NORTH)
    assert (seen.allowed, seen.rule) == (False, "path")
    assert seen.sentence == "It would close the way to the bed."


def test_groups_of_the_shipped_knowledge_are_the_papers() -> None:
    assert KNOWLEDGE.groups == PAPER_CATEGORIES
