"""Marginals, from rooms in which all can be counted by hand."""

from __future__ import annotations

from math import pi

import pytest

from scenegen_core.knowledge import learn
from scenegen_core.knowledge.marginals import Bar, CategoryMarginals, marginals
from scenegen_core.scene.model import PAPER_CATEGORIES, Box, Room, Scene

HALL = Room(corners=((0, 0), (8, 0), (8, 6), (0, 6)))


def chair(x: float, y: float, heading: float, *, known: bool = True) -> Box:
    return Box("c", "Chair", (x, y, 0.4), (0.5, 0.5, 0.8), heading, front_known=known)


def table(name: str, x: float, y: float) -> Box:
    return Box(name, "Table", (x, y, 0.4), (0.8, 0.8, 0.8))


SCENES = (
    Scene(HALL, (chair(4, 3, 0.0), table("t", 4.9, 3), table("u", 4, 4)), "two tables near"),
    Scene(HALL, (chair(0.5, 3, 0.0), table("t", 7, 1)), "at a wall, looks at the far one"),
    Scene(HALL, (chair(0.5, 3, pi),), "at a wall, looks at it"),
    Scene(HALL, (chair(0.5, 0.5, 0.0, known=False),), "in a corner, its front not known"),
)


@pytest.fixture(scope="module")
def found() -> dict[str, CategoryMarginals]:
    known = marginals(learn(SCENES, PAPER_CATEGORIES))
    return {part.category: part for part in known.categories}


def bars(of: tuple[Bar, ...]) -> dict[str, Bar]:
    return {bar.label: bar for bar in of}


def test_places_are_counted_by_how_many_walls_are_near(
    found: dict[str, CategoryMarginals],
) -> None:
    assert found["Chair"].position == (
        Bar("middle", 1, 0.25),
        Bar("edge", 2, 0.5),
        Bar("corner", 1, 0.25),
    )


def test_neighbors_are_counted_by_group_and_where_there_is_one(
    found: dict[str, CategoryMarginals],
) -> None:
    near = bars(found["Chair"].surrounded_by)
    assert near["Table"] == Bar("Table", 1, 0.25, several=1, possible=2)
    assert near["Sofa"] == Bar("Sofa", 0, 0.0)


def test_only_fronts_that_are_known_say_what_is_faced(
    found: dict[str, CategoryMarginals],
) -> None:
    part = found["Chair"]
    assert (part.examples, part.fronts) == (4, 3)
    assert bars(part.facing)["Table"] == Bar("Table", 1, 1 / 3, possible=2)
    assert [(bar.label, bar.count) for bar in part.towards_center] == [("yes", 2), ("no", 1)]


def test_what_has_no_front_faces_nothing(found: dict[str, CategoryMarginals]) -> None:
    assert found["Table"].fronts == 0
    assert found["Table"].facing == found["Table"].towards_center == ()
