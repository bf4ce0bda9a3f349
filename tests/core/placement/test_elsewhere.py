"""The way to a place that would do, in rooms of 5 m by 4 m; distances worked out by hand."""

# ruff: noqa: E501 (a way is a line of its table)

from __future__ import annotations

from math import pi

import numpy as np
import pytest

from scenegen_core.graph.situation import Situation
from scenegen_core.graph.surroundings import Surroundings
from scenegen_core.placement.answer import Elsewhere
from scenegen_core.placement.elsewhere import (
    efforts,
    elsewhere,
    in_the_way,
    nearest_possible,
    way,
)
from scenegen_core.placement.feasible import RULES, Space, verdicts
from scenegen_core.placement.proposals import propose
from scenegen_core.placement.walking import Walking
from scenegen_core.scene.model import PAPER_CATEGORIES, Box, Opening, Scene, Symmetry
from tests.core.placement.drawn import DOOR, NORTH, SOUTH, WINDOW, category, room, situation, thing

CHEST, CHAIR = (0.4, 0.8, 0.8), (0.5, 0.5, 0.9)
BOX = thing("Table", 2.5, 2.0, (1.0, 1.0, 0.5), label="CoffeeTable")


def led_to(scene: Scene, pose: Box) -> tuple[str, Elsewhere]:
    """The rule that forbids a pose, and the nearest one that is possible."""
    around = Surroundings(scene, PAPER_CATEGORIES)
    asked, kind = situation(scene, pose), category(pose.category)
    space, walking = Space.of(around), Walking(around)
    rule = RULES[int(verdicts(asked, space)[0])]
    proposals = propose(around, kind, pose.size).candidates
    possible = proposals[verdicts(Situation(proposals, around), space) == -1]
    end = nearest_possible(
        asked.candidates, possible, np.zeros(len(possible)), space, walking, kind.symmetry
    )
    assert end is not None
    return rule, elsewhere(asked, end, kind, in_the_way(rule, asked))


FORBIDDEN: list[tuple[Scene, Box, str, float, str]] = [
    # half of 0.4 m must come out of the wall at x = 0: from 0.05 to 0.2
    (room(), thing("Storage", 0.05, 2.0, CHEST), "room", 0.15, "15 cm further from the west wall"),
    # the square of the door ends at y = 0.8, and half of the chair is 0.25: from 0.75 to 1.05
    (
        room(doors=(DOOR,)),
        thing("Chair", 1.4, 0.75, CHAIR, heading=NORTH),
        "door", 0.3, "30 cm further from the door",
    ),
    # 0.5 m before the window at y = 4 stay free: the cupboard's north side has to get to 3.5
    (
        room(windows=(WINDOW,)),
        thing("Table", 2.5, 3.2, (0.8, 0.8, 1.0)),
        "window", 0.1, "10 cm further from the window",
    ),
    # the coffee table begins at x = 2.0, and no seat goes under it: from 1.85 to 1.75
    (room(BOX), thing("Chair", 1.85, 2.0, CHAIR), "collision", 0.1,
     "10 cm further from the coffee table"),
]  # fmt: skip


@pytest.mark.parametrize(("scene", "pose", "rule", "distance", "text"), FORBIDDEN)
def test_the_nearest_possible_pose_is_just_beyond_what_forbids_it(
    scene: Scene, pose: Box, rule: str, distance: float, text: str
) -> None:
    found = led_to(scene, pose)
    assert found[0] == rule
    assert found[1].distance == pytest.approx(distance, abs=0.01)
    assert found[1].text == text
    assert found[1].heading == pytest.approx(pose.heading)


def test_the_pose_that_is_offered_is_possible() -> None:
    scene = room(BOX, doors=(DOOR,), windows=(WINDOW,))
    for x, y in ((0.1, 0.1), (1.4, 0.2), (2.5, 2.0), (4.99, 3.9), (7.0, 2.0)):
        pose = thing("Sofa", x, y, (0.9, 1.5, 0.8), heading=0.3)
        _, found = led_to(scene, pose)
        moved = thing("Sofa", *found.center[:2], pose.size, heading=found.heading)
        space = Space.of(Surroundings(scene, PAPER_CATEGORIES))
        assert verdicts(situation(scene, moved), space).tolist() == [-1]


def test_what_only_the_way_forbids_is_moved_until_the_way_is_free() -> None:
    """A corridor of 1.6 m: in the middle of it a table of 0.8 m leaves 0.4 m on each side."""
    corridor = room(
        corners=((0, 0), (6, 0), (6, 1.6), (0, 1.6)),
        doors=(Opening((0, 1.2), (0, 0.4), 0, 2, "a"), Opening((6, 0.4), (6, 1.2), 0, 2, "b")),
    )
    around = Surroundings(corridor, PAPER_CATEGORIES)
    pose = thing("Table", 3.0, 0.8, (0.8, 0.8, 0.7))
    walking = Walking(around)
    assert walking.blocked_by(pose) == "the door"
    asked = situation(corridor, pose)
    end = nearest_possible(
        asked.candidates,
        asked.candidates[:0],
        np.zeros(0),
        Space.of(around),
        walking,
        Symmetry.SYMMETRIC,
    )
    assert end is not None
    # a walker needs 0.6 m: 0.2 m more than there are, on the floor's grid of 0.1 m
    assert abs(end.centers[0, 1] - 0.8) == pytest.approx(0.2, abs=0.11)


def test_where_nothing_is_possible_there_is_no_way() -> None:
    around = Surroundings(room(), PAPER_CATEGORIES)
    asked = situation(room(), thing("Sofa", 2.5, 2.0, (0.9, 9.0, 0.8)))
    none = asked.candidates[:0]
    space, walking = Space.of(around), Walking(around)
    found = nearest_possible(
        asked.candidates, none, np.zeros(0), space, walking, Symmetry.ASYMMETRIC
    )
    assert found is None


def test_turning_by_a_half_is_as_much_work_as_a_metre() -> None:
    start = situation(room(), thing("Sofa", 1.0, 1.0, CHAIR)).candidates
    ends = situation(
        room(),
        thing("Sofa", 1.0, 1.0, CHAIR, heading=pi),
        thing("Sofa", 2.0, 1.0, CHAIR),
        thing("Sofa", 1.3, 1.4, CHAIR, heading=-pi / 2),
    ).candidates
    assert efforts(start, ends, Symmetry.ASYMMETRIC) == pytest.approx([1.0, 1.0, 1.0])
    assert efforts(start, ends, Symmetry.SYMMETRIC) == pytest.approx([0.0, 1.0, 1.0])


@pytest.mark.parametrize(
    ("end", "text"),
    [
        (thing("Chair", 2.0, 1.3, CHAIR), "30 cm to the north"),
        (thing("Chair", 3.2, 1.0, CHAIR), "1.2 m to the east"),
        (thing("Chair", 3.5, 1.6, CHAIR), "1.5 m to the east and 60 cm to the north"),
        (thing("Chair", 2.0, 1.0, CHAIR, heading=SOUTH), "turned to face south"),
        (thing("Chair", 1.8, 0.8, CHAIR, heading=pi), "30 cm to the south-west, turned to face west"),
        (thing("Chair", 2.0, 1.0, CHAIR, bottom=0.2), "20 cm higher"),
        (thing("Chair", 2.01, 1.0, CHAIR, heading=0.05), "right here"),
    ],
)  # fmt: skip
def test_a_way_is_told_as_one_would_say_it(end: Box, text: str) -> None:
    start = thing("Chair", 2.0, 1.0, CHAIR)
    poses = situation(room(), start, end).candidates
    assert way(poses[:1], poses[1:], category("Chair"), None) == text


def test_what_lies_beside_the_way_does_not_name_it() -> None:
    """Along the coffee table neither nearer nor further: then the direction says it."""
    poses = situation(
        room(BOX), thing("Chair", 1.7, 1.8, CHAIR), thing("Chair", 1.7, 2.2, CHAIR)
    ).candidates
    by = ("the coffee table", Surroundings(room(BOX), PAPER_CATEGORIES).footprints)
    assert way(poses[:1], poses[1:], category("Chair"), by) == "40 cm to the north"
    assert np.allclose(poses.headings, 0)
