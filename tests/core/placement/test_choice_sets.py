"""Choice sets: what counts as chosen, and what it was chosen from."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from scenegen_core.graph.candidates import Candidates
from scenegen_core.graph.own_relations import OWN_RELATIONS
from scenegen_core.graph.relations import measure
from scenegen_core.graph.situation import Situation
from scenegen_core.graph.surroundings import Surroundings
from scenegen_core.knowledge.choice import MISSING, Bins, binned, choice_columns
from scenegen_core.placement.choice_sets import ChoiceSet, choice_sets
from scenegen_core.placement.feasible import ALLOWED, Space, verdicts
from scenegen_core.placement.proposals import propose
from scenegen_core.scene.model import PAPER_CATEGORIES, Box, Scene
from tests.core.placement.drawn import NORTH, SOUTH, category, room, thing

GROUPS = PAPER_CATEGORIES
COLUMNS = choice_columns(GROUPS)
FLUSH_BED = thing("Bed", 1.02, 0.72, (2.0, 1.4, 0.5))
"""2 cm from the walls x = 0 and y = 0 of a room of 5 m by 4 m: where it would be proposed."""
CUPBOARD = thing("Storage", 3.5, 0.27, (0.5, 1.0, 1.8), heading=NORTH)


def bins_of(box: Box, scene: Scene) -> Bins:
    """The bins of a box where it is."""
    around = Surroundings(scene.without(box.id), GROUPS)
    bins: Bins = binned(measure(OWN_RELATIONS, Situation(Candidates.of(box), around)), COLUMNS)[0]
    return bins


def only(scene: Scene) -> ChoiceSet:
    (found,) = choice_sets([scene], GROUPS)
    return found


def value(found: ChoiceSet, relation: str, part: str, group: str = "") -> int:
    """The bin of a column of what was chosen."""
    names = [(column.relation, column.part, column.group) for column in COLUMNS]
    return int(found.bins[0, names.index((relation, part, group))])


def possible(scene: Scene, box: Box) -> int:
    """How many proposals for the box in the room without it are possible."""
    around = Surroundings(scene.without(box.id), GROUPS)
    found = propose(around, category(box.category), box.size)
    allowed = verdicts(Situation(found.candidates, around), Space.of(around)) == ALLOWED
    return int(np.count_nonzero(allowed))


def test_what_stands_where_it_would_be_proposed_is_itself_chosen() -> None:
    scene = room(FLUSH_BED)
    np.testing.assert_array_equal(only(scene).bins[0], bins_of(FLUSH_BED, scene))


def test_what_stands_between_proposals_is_snapped_to_the_nearest() -> None:
    near = replace(FLUSH_BED, center=(1.025, 0.71, 0.25), heading=0.05)
    np.testing.assert_array_equal(only(room(near)).bins[0], bins_of(FLUSH_BED, room(FLUSH_BED)))


def test_the_chosen_pose_is_possible_where_the_true_one_is_not() -> None:
    """The true bed reaches 15 cm into a cupboard; the one that counts stands clear of it."""
    cupboard = thing("Storage", 2.35, 1.0, (0.6, 1.0, 1.8))
    scene = room(replace(FLUSH_BED, center=(1.2, 0.72, 0.25)), cupboard)
    chosen = next(one for one in choice_sets([scene], GROUPS) if one.category == "Bed")
    nearest = [(column.relation, column.part) for column in COLUMNS].index(("FS", "nearest"))
    assert bins_of(scene["bed"], scene)[nearest] < 9  # the edges below 0 are nine
    assert value(chosen, "FS", "nearest") > 9


@pytest.mark.parametrize(
    "box",
    [
        replace(FLUSH_BED, center=(0.2, 0.72, 0.25)),  # 80 cm in the wall
        replace(FLUSH_BED, center=(8.0, 8.0, 0.25)),
        thing("Picture", 2.5, 2.0, (0.04, 0.6, 0.5), bottom=1.3),  # hangs in the air
        thing("Bed", 2.5, 2.0, (4.9, 3.9, 0.5), heading=NORTH),
    ],
)
def test_what_stands_where_nothing_like_it_could_is_no_choice(box: Box) -> None:
    assert choice_sets([room(box)], GROUPS) == ()


def test_other_things_are_not_chosen() -> None:
    stove, piano = (thing(name, 2.5, 2, (0.6, 0.6, 0.9)) for name in ("Other", "Piano"))
    assert choice_sets([room(stove, piano)], GROUPS) == ()


def test_every_box_is_chosen_in_the_room_without_it() -> None:
    found = choice_sets([room(FLUSH_BED, CUPBOARD)], GROUPS)
    assert [one.category for one in found] == ["Bed", "Storage"]
    assert value(found[0], "N", "gap", "Storage") != MISSING
    assert value(found[0], "N", "gap", "Bed") == MISSING


@pytest.mark.parametrize("box", [FLUSH_BED, CUPBOARD], ids=["Bed", "Storage"])
def test_the_others_stand_for_all_possible_poses(box: Box) -> None:
    """As many are drawn as tried, so their number is right but for chance (a tenth of it)."""
    scene = room(FLUSH_BED, CUPBOARD)
    found = next(one for one in choice_sets([scene], GROUPS) if one.category == box.category)
    assert np.exp(found.log_weights[1:]).sum() == pytest.approx(possible(scene, box) - 1, rel=0.2)
    assert found.log_weights[0] == 0


def test_where_all_are_tried_each_other_pose_is_there_once() -> None:
    """On a small sideboard a TV has few places: none is left out, and the chosen is not again."""
    board = thing("Storage", 2.5, 0.27, (0.5, 0.9, 0.5), heading=NORTH)
    screen = thing("TV", 2.5, 0.27, (0.4, 0.5, 0.4), heading=NORTH, bottom=0.5)
    scene = room(board, screen)
    found = next(one for one in choice_sets([scene], GROUPS) if one.category == "TV")
    assert len(found.bins) == possible(scene, screen)
    assert not found.log_weights.any()


def test_of_what_has_an_unknown_front_the_axes_count() -> None:
    guessed = replace(FLUSH_BED, heading=SOUTH * 2, front_known=False)
    ((found,), (known,)) = (choice_sets([room(box)], GROUPS) for box in (guessed, FLUSH_BED))
    np.testing.assert_array_equal(found.bins[0], known.bins[0])


def test_a_choice_is_the_same_wherever_and_whenever_it_is_made() -> None:
    rooms = [replace(room(FLUSH_BED, CUPBOARD), id=f"r{i}", source="s") for i in range(3)]
    forth = choice_sets(rooms, GROUPS)
    back = [one for scene in reversed(rooms) for one in reversed(choice_sets([scene], GROUPS))]
    for one, other in zip(forth, reversed(back), strict=True):
        assert (one.category, one.room, one.source) == (other.category, other.room, other.source)
        np.testing.assert_array_equal(one.bins, other.bins)
        np.testing.assert_array_equal(one.log_weights, other.log_weights)
    beds = [one.bins for one in forth if one.category == "Bed"]
    assert all(not np.array_equal(*two) for two in pairwise(beds))  # chance of their own
