"""The main job: placements, maps and reasons for one object in one room."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from itertools import combinations, product
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
from scenegen_core.placement.answer import MODELS, Answer, Cancelled, Model, Pose, Query, Surface
from scenegen_core.placement.choice_learning import gather, with_choices
from scenegen_core.placement.feasible import ALLOWED, Space, verdicts
from scenegen_core.placement.models import model_of
from scenegen_core.placement.mounts import Mount
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


@dataclass(frozen=True)
class Solved:
    """What a model answered."""

    model: Model
    solution: Solution

    @property
    def answer(self) -> Answer:
        return self.solution.answer


def solved(name: str, model: Model) -> Solved:
    return Solved(model, solve(LIVING_ROOM, Query(name, model=model), KNOWLEDGE))


@pytest.fixture(scope="module", params=product(MODELS, CATEGORIES), ids="-".join)
def every(request: pytest.FixtureRequest) -> Solved:
    """Each category in the drawn living room, by each model."""
    model, name = request.param
    return solved(name, model)


@pytest.fixture(scope="module", params=CATEGORIES)
def papers(request: pytest.FixtureRequest) -> Solved:
    """Each category in the drawn living room, by the paper's model."""
    return solved(request.param, "paper")


@pytest.fixture(scope="module", params=CATEGORIES)
def ours(request: pytest.FixtureRequest) -> Solved:
    """Each category in the drawn living room, by our model."""
    return solved(request.param, "scenegen")


# --- what every answer keeps ----------------------------------------------------------------------


def test_ranks_count_from_one_and_likelihoods_are_shares_of_the_legend(every: Solved) -> None:
    poses = every.answer.poses
    assert poses
    assert [pose.rank for pose in poses] == list(range(1, len(poses) + 1))
    likely = [pose.likelihood for pose in poses]
    assert all(0 <= value <= 1 for value in likely)
    by_score = sorted(poses, key=lambda pose: pose.score)
    assert sorted(likely) == [pose.likelihood for pose in by_score]


def test_the_paper_s_offers_are_in_the_order_of_their_scores(papers: Solved) -> None:
    scores = [pose.score for pose in papers.answer.poses]
    assert scores == sorted(scores, reverse=True)


def test_our_first_offer_is_no_more_than_two_nats_below_the_best_pose(ours: Solved) -> None:
    best = max(heat_map.high for heat_map in ours.answer.heat_maps)
    assert best - 2.0 <= ours.answer.poses[0].score <= best + 1e-6


def test_alternatives_are_three_quarters_of_a_meter_apart(every: Solved) -> None:
    centers = [pose.center[:2] for pose in every.answer.poses]
    assert all(dist(one, other) >= 0.75 for one, other in combinations(centers, 2))


def test_the_reasons_add_up_to_the_score(every: Solved) -> None:
    for pose in every.answer.poses:
        total = sum(reason.contribution for reason in pose.reasons)
        assert total == pytest.approx(pose.score, abs=1e-9)
        strengths = [abs(reason.contribution) for reason in pose.reasons]
        assert strengths == sorted(strengths, reverse=True)
        about = [(reason.relation, reason.group) for reason in pose.reasons]
        assert len(set(about)) == len(about)


def test_scores_differ_as_the_model_s_own_do(every: Solved) -> None:
    answer = every.answer
    model = model_of(every.model, KNOWLEDGE, answer.category)
    candidates = Candidates(
        answer.category,
        answer.size,
        np.array([pose.center for pose in answer.poses]),
        np.array([pose.heading for pose in answer.poses]),
    )
    around = Surroundings(LIVING_ROOM, KNOWLEDGE.groups)
    total = model.total(Situation(candidates, around))
    scores = np.array([pose.score for pose in answer.poses])
    assert scores - scores[0] == pytest.approx(total - total[0], abs=1e-6)


def test_inspecting_an_offered_pose_says_what_the_offer_said(every: Solved) -> None:
    for pose in every.answer.poses:
        seen = every.solution.inspect(pose.center, pose.heading)
        assert (seen.allowed, seen.rule) == (True, "")
        assert seen.score == pytest.approx(pose.score, abs=1e-6)
        assert seen.likelihood == pytest.approx(pose.likelihood, abs=1e-6)
        assert seen.sentence == pose.sentence
        assert [reason.text for reason in seen.reasons[:1]] == [
            reason.text for reason in pose.reasons[:1]
        ]


def test_the_rooms_named_are_among_those_learned_from(every: Solved) -> None:
    learned = set(KNOWLEDGE[every.answer.category].rooms)
    for pose in every.answer.poses:
        assert 1 <= len(pose.rooms) <= 3
        assert set(pose.rooms) <= learned


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("name", CATEGORIES)
def test_a_cell_is_as_bright_as_the_placement_there_is_likely(name: str, model: Model) -> None:
    scene = room(TABLE, corners=((0, 0), (6, 0), (6, 5), (0, 5)))  # nothing is in anyone's way
    answer = solve(scene, Query(name, model=model), KNOWLEDGE).answer
    (x, y, z), height = answer.poses[0].center, answer.size[2]
    maps = {heat_map.surface: heat_map for heat_map in answer.heat_maps}
    surface: Surface = "floor"
    if abs(z - height / 2 - 0.75) < 1e-9:
        surface = "tops"
    elif z > height / 2 + 1e-9:
        surface, (x, y) = "walls", unrolled(WALLS, np.array([[x, y, z]]))[0].tolist()
    heat_map = maps[surface]
    column, row = (
        int((at - low) / heat_map.cell) for at, low in zip((x, y), heat_map.origin, strict=True)
    )
    shown = round(1 + 254 * answer.poses[0].likelihood)
    assert heat_map.values[row, column] == pytest.approx(shown, abs=1)
    assert max(other.values.max() for other in answer.heat_maps) == 255


@pytest.mark.parametrize("name", CATEGORIES)
def test_where_no_way_is_closed_the_paper_s_first_placement_is_the_likeliest(name: str) -> None:
    scene = room(TABLE, corners=((0, 0), (6, 0), (6, 5), (0, 5)))
    assert solve(scene, Query(name, model="paper"), KNOWLEDGE).answer.poses[0].likelihood == 1


def test_a_cell_is_zero_exactly_where_no_pose_is_possible(ours: Solved) -> None:
    answer = ours.answer
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


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize(
    "query", [SOFA, Query("Chair"), Query("TV"), Query("Bed"), Query("Picture")]
)
@pytest.mark.parametrize(
    ("turn", "shift"), [(0, (3.0, -7.0)), (pi / 2, (4.0, 0.0)), (pi, (0.0, 9.0))]
)
def test_turning_and_moving_the_room_turns_and_moves_the_placements(
    query: Query, turn: float, shift: tuple[float, float], model: Model
) -> None:
    query = replace(query, model=model)
    here = solve(ODD, query, KNOWLEDGE).answer
    there = solve(moved(ODD, turn, shift), query, KNOWLEDGE).answer
    behind = [pose.score - here.poses[0].score for pose in here.poses]
    assert [pose.score - there.poses[0].score for pose in there.poses] == pytest.approx(
        behind, abs=1e-4
    )
    first, second = here.poses[0], there.poses[0]
    assert second.center[:2] == pytest.approx(moved_point(first.center[:2], turn, shift), abs=1e-6)
    assert np.exp(1j * (second.heading - first.heading - turn)) == pytest.approx(1, abs=1e-6)


@pytest.mark.parametrize("model", MODELS)
def test_the_heat_map_turns_with_the_room(model: Model) -> None:
    sofa = replace(SOFA, model=model)
    (here,) = solve(ODD, sofa, KNOWLEDGE).answer.heat_maps
    (there,) = solve(moved(ODD, pi / 2, (4, 0)), sofa, KNOWLEDGE).answer.heat_maps
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


def unnamed(answer: Answer) -> list[Pose]:
    """The offers without their names, which tell them apart from the others on offer."""
    return [replace(pose, name="") for pose in answer.poses]


@pytest.mark.parametrize("count", [1, 2, 3])
def test_as_many_are_offered_as_were_asked_for(count: int) -> None:
    answer = solve(LIVING_ROOM, replace(TABLES, count=count), KNOWLEDGE).answer
    more = solve(LIVING_ROOM, replace(TABLES, count=10), KNOWLEDGE).answer
    assert len(answer.poses) == count
    assert unnamed(answer) == unnamed(more)[:count]


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
        solve(LIVING_ROOM, replace(SOFA, model="paper"), learn(rooms, PAPER_CATEGORIES))


def test_a_category_of_too_few_choices_is_refused_with_a_way_on() -> None:
    rooms = [replace(LIVING_ROOM, id=f"room {number}") for number in range(4)]
    known = with_choices(learn(rooms, PAPER_CATEGORIES), gather(rooms, PAPER_CATEGORIES))
    with pytest.raises(KnowledgeError, match=r"too few examples of Sofa .* ask the model paper"):
        solve(LIVING_ROOM, SOFA, known)


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
