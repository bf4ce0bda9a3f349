"""The model of choices: what it says is the sum of what it says of each subject."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from scenegen_core.errors import KnowledgeError
from scenegen_core.graph.candidates import Candidates
from scenegen_core.graph.own_relations import OWN_RELATIONS
from scenegen_core.graph.relations import measure
from scenegen_core.graph.situation import Situation
from scenegen_core.graph.surroundings import Surroundings
from scenegen_core.knowledge import Knowledge, default_knowledge
from scenegen_core.knowledge.choice import BINS, Choice, binned, choice_columns
from scenegen_core.placement.choice_model import ChoiceModel
from scenegen_core.scene.files import read_scene
from scenegen_core.scene.model import PAPER_CATEGORIES, Box
from tests.core.placement.drawn import NORTH, room, situation, thing

GROUPS = PAPER_CATEGORIES
COLUMNS = choice_columns(GROUPS)
PLACE = {(c.relation, c.group, c.part): i for i, c in enumerate(COLUMNS)}
KNOWLEDGE = default_knowledge()
LIVING_ROOM = read_scene((Path(__file__).parents[2] / "fixtures/living_room.json").read_bytes())

WALL, WALL_TURN = PLACE["W", "", "nearest"], PLACE["W", "", "turn"]
TABLE, HEIGHT, WIDTH = PLACE["N", "Table", "gap"], PLACE["H", "", ""], PLACE["SZ", "", "width"]
CHAIR = thing("Chair", 1.0, 1.0, (0.5, 0.5, 0.9), heading=NORTH)
SCENE = room(thing("Table", 2.5, 2.0, (0.8, 1.4, 0.75)))


def constant(number: float) -> np.ndarray[tuple[int, int], np.dtype[np.float32]]:
    """A surface that adds the same everywhere."""
    return np.full((BINS, BINS), number, dtype=np.float32)


def drawn(surfaces: dict[tuple[int, int], float], curves: dict[int, float]) -> Knowledge:
    """Knowledge of chairs whose curves and surfaces add the same everywhere."""
    table = np.zeros((len(COLUMNS), BINS), dtype=np.float32)
    for column, number in curves.items():
        table[column] = number
    choice = Choice(
        columns=COLUMNS,
        curves=table,
        pairs=np.array(list(surfaces), dtype=np.int64).reshape(-1, 2),
        surfaces=np.array(
            [constant(number) for number in surfaces.values()], dtype=np.float32
        ).reshape(-1, BINS, BINS),
        examples=np.zeros((1, len(COLUMNS)), dtype=np.uint8),
        rooms=("somewhere",),
    )
    return replace(KNOWLEDGE, choices={"Chair": choice})


def parts_of(knowledge: Knowledge, *poses: Box) -> dict[tuple[str, str], float]:
    """What each subject adds to the score of the first pose."""
    parts = ChoiceModel(knowledge, "Chair").parts(situation(SCENE, *poses))
    return dict(zip(parts.subjects, parts.values[0].tolist(), strict=True))


def test_curves_of_one_relation_are_one_part() -> None:
    parts = parts_of(drawn({}, {WALL: 1.0, WALL_TURN: 0.25, TABLE: -2.0}), CHAIR)
    assert parts["W", ""] == 1.25
    assert parts["N", "Table"] == -2.0
    assert sum(map(abs, parts.values())) == 3.25


def test_of_a_surface_each_of_its_two_subjects_gets_half() -> None:
    """The value of a player, averaged over both orders of coming in: (0 + 3) / 2 (Shapley)."""
    parts = parts_of(drawn({(WALL, TABLE): 3.0}, {HEIGHT: 1.0}), CHAIR)
    assert (parts["W", ""], parts["N", "Table"], parts["H", ""]) == (1.5, 1.5, 1.0)


def test_a_surface_within_a_relation_is_all_its_own() -> None:
    assert parts_of(drawn({(WALL, WALL_TURN): 3.0}, {}), CHAIR)["W", ""] == 3.0


def test_a_surface_with_the_object_s_own_size_is_all_about_the_other() -> None:
    parts = parts_of(drawn({(TABLE, WIDTH): 3.0}, {}), CHAIR)
    assert parts["N", "Table"] == 3.0
    assert all(relation != "SZ" for relation, _ in parts)


@pytest.mark.parametrize("name", KNOWLEDGE.choices)
def test_parts_add_up_to_the_score(name: str) -> None:
    rng = np.random.default_rng(5)
    poses = Candidates(
        name, KNOWLEDGE[name].usual_size, rng.uniform((0, 0, 0), (5, 4, 2), (200, 3)),
        rng.uniform(-np.pi, np.pi, 200),
    )  # fmt: skip
    here = Situation(poses, Surroundings(LIVING_ROOM, GROUPS))
    model = ChoiceModel(KNOWLEDGE, name)
    np.testing.assert_allclose(model.parts(here).values.sum(axis=1), model.total(here), atol=1e-5)


def test_measured_are_the_columns_of_each_subject_at_the_first_pose() -> None:
    parts = ChoiceModel(drawn({}, {}), "Chair").parts(situation(SCENE, CHAIR, CHAIR))
    seen = dict(zip(parts.subjects, parts.measured, strict=True))
    assert seen["W", ""]["nearest"] == pytest.approx(0.75)
    assert seen["H", ""] == {"": 0.0}
    assert seen["N", "Table"]["gap"] == pytest.approx((0.85**2 + 0.05**2) ** 0.5)
    assert np.isnan(seen["N", "Bed"]["gap"])


def test_rooms_whose_reasons_are_most_alike_are_named_first() -> None:
    """The first example stands as the chair does, the second further from the wall."""
    here = situation(SCENE, CHAIR)
    known = drawn({}, {})
    as_here = binned(measure(OWN_RELATIONS, here), COLUMNS)[0]
    elsewhere = as_here.copy()
    elsewhere[WALL] = 0
    curves = known.choices["Chair"].curves.copy()
    curves[WALL, 0], curves[WALL, as_here[WALL]] = -1.0, 1.0
    choice = replace(
        known.choices["Chair"],
        curves=curves,
        examples=np.stack([elsewhere, as_here, as_here]),
        rooms=("other", "alike", "alike"),
    )
    model = ChoiceModel(replace(known, choices={"Chair": choice}), "Chair")
    assert model.rooms(here) == ("alike", "other")


def test_a_category_without_choices_cannot_be_asked() -> None:
    with pytest.raises(KnowledgeError, match="too few examples of Bed"):
        ChoiceModel(drawn({}, {}), "Bed")
