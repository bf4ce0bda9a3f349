"""Knowledge that grows: as if it had been learned with everything at once."""

from __future__ import annotations

import numpy as np
import pytest

from scenegen_core.knowledge import Knowledge, learn
from scenegen_core.knowledge.choice import choice_columns
from scenegen_core.knowledge.growing import together, with_groups
from scenegen_core.placement.choice_learning import gather, with_choices
from scenegen_core.scene.model import PAPER_CATEGORIES, Box, Category, Scene, Symmetry
from tests.core.evaluation.made import TELEVISION, bedroom

PIANO = Category("Piano", Symmetry.INSIDE_FACING)
WIDER = (*PAPER_CATEGORIES, PIANO)
ROOMS = [bedroom(number) for number in range(6)]
UPRIGHT = Box("piano", "Piano", (3.7, 1.0, 0.6), (0.6, 1.4, 1.2), 3.14159)
WITH_PIANO = [bedroom(number, UPRIGHT) for number in range(6, 12)]
WITH_TELEVISION = [bedroom(number, TELEVISION) for number in range(6, 12)]


def taught(rooms: list[Scene], groups: tuple[Category, ...]) -> Knowledge:
    return with_choices(learn(rooms, groups), gather(rooms, groups))


@pytest.fixture(scope="module")
def known() -> Knowledge:
    return taught(ROOMS, PAPER_CATEGORIES)


def assert_same_examples(one: Knowledge, other: Knowledge) -> None:
    assert list(one.categories) == list(other.categories)
    for name, part in one.categories.items():
        same = other[name]
        assert (part.columns, part.rooms) == (same.columns, same.rooms)
        for array in ("rows", "front_known", "sizes", "bottoms", "weights"):
            np.testing.assert_array_equal(getattr(part, array), getattr(same, array))


def test_a_further_group_is_as_if_it_had_been_asked_for_in_rooms_without_it(
    known: Knowledge,
) -> None:
    grown, at_once = with_groups(known, (PIANO,)), taught(ROOMS, WIDER)
    assert grown.groups == WIDER
    assert_same_examples(grown, at_once)
    for name, choice in grown.choices.items():
        assert choice.columns == choice_columns(WIDER)
        np.testing.assert_array_equal(choice.examples, at_once.choice(name).examples)


def test_a_further_group_changes_no_score(known: Knowledge) -> None:
    grown = with_groups(known, (PIANO,))
    rng = np.random.default_rng(0)
    wide = rng.normal(size=(50, len(choice_columns(WIDER))))
    place = {column: i for i, column in enumerate(choice_columns(WIDER))}
    narrow = wide[:, [place[column] for column in choice_columns(PAPER_CATEGORIES)]]
    for name, choice in known.choices.items():
        np.testing.assert_allclose(grown.choice(name).score(wide), choice.score(narrow))


def test_a_group_that_is_known_already_changes_nothing(known: Knowledge) -> None:
    grown = with_groups(known, PAPER_CATEGORIES[:3])
    assert grown.groups == known.groups
    assert_same_examples(grown, known)


def test_examples_of_both_are_those_of_all_rooms(known: Knowledge) -> None:
    grown = together(known, learn(WITH_TELEVISION, PAPER_CATEGORIES))
    assert_same_examples(grown, learn([*ROOMS, *WITH_TELEVISION], PAPER_CATEGORIES))
    assert grown.choices is known.choices


def test_six_rooms_teach_a_new_category_on_top_of_what_is_known(known: Knowledge) -> None:
    """The Bed's choices go on from what is known, the Piano's begin from what all share."""
    grown = with_groups(known, (PIANO,))
    grown = together(grown, learn(WITH_PIANO, WIDER))
    grown = with_choices(grown, gather(WITH_PIANO, WIDER), before=grown)
    assert grown["Piano"].examples == 6
    assert len(grown.choice("Piano").examples) == 6
    assert len(grown.choice("Bed").examples) == 12
    assert list(grown.choices) == ["Bed", "Storage", "Piano"]
