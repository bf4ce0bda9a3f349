"""The relations against their twins in by_the_book, in drawn, random, turned and real rooms."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace
from itertools import product
from math import cos, pi, sin
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from scenegen_core.datasets.rows import read_scenes
from scenegen_core.graph.candidates import Candidates
from scenegen_core.graph.relations import (
    ABSENT,
    NEAR_WALL,
    NEARBY,
    RELATIONS,
    SAME_DIRECTION,
    Column,
    columns,
    measure,
)
from scenegen_core.graph.situation import Situation
from scenegen_core.graph.surroundings import Surroundings
from scenegen_core.scene.files import read_scene
from scenegen_core.scene.model import PAPER_CATEGORIES, Box, Point, Room, Scene
from tests.core import by_the_book as book

GROUPS = PAPER_CATEGORIES
COLUMNS = columns(RELATIONS, GROUPS)
ROOT = Path(__file__).parents[2]
ROOM_FILES = [
    ROOT / "tests/fixtures/living_room.json",
    *sorted((ROOT / "web/public/rooms").glob("*.json")),
    *sorted((ROOT.parent / "shared/data/rooms").glob("*.jsonl.gz")),
]
ROOMS_A_FILE = 12
HAIR = 1e-6  # metres and radians; what is tied to that may go either way


def measured(scene: Scene, box: Box) -> dict[Column, float]:
    """What the relations say of a box where it is."""
    situation = Situation(Candidates.of(box), Surroundings(scene.without(box.id), GROUPS))
    values = measure(RELATIONS, situation)
    assert values.shape == (1, len(COLUMNS))
    return dict(zip(COLUMNS, values[0].tolist(), strict=True))


def _direction_similarity(box: Box, scene: Scene, part: str, hair: float) -> float:
    counts = book.direction_similarity(box, scene, NEARBY + hair, SAME_DIRECTION + hair)
    return counts[("same", "opposite").index(part)]


TWINS: dict[str, Callable[[Box, Scene, str, float], float]] = {
    "RP": lambda box, scene, _, hair: book.room_position(box, scene, NEAR_WALL + hair),
    "AD": lambda box, scene, group, _: book.average_distance(box, scene, group),
    "S": lambda box, scene, group, hair: book.surrounded_by(box, scene, group, NEARBY + hair),
    "SP": lambda box, scene, group, _: book.support(box, scene, group),
    "TC": lambda box, scene, *_: book.towards_center(box, scene),
    "AW": lambda box, scene, _, hair: book.away_from_wall(box, scene, SAME_DIRECTION + hair),
    "DS": _direction_similarity,
    "F": lambda box, scene, group, hair: book.facing(box, scene, group, NEARBY + hair),
    "NT": lambda box, scene, group, hair: book.next_to(box, scene, group, NEARBY + hair),
}


def by_the_book(scene: Scene, box: Box, column: Column, hair: float = 0) -> float:
    """What the paper's equation says; ``hair`` is added to its constants."""
    return TWINS[column.relation](box, scene, column.about, hair)


def nudged(box: Box) -> Iterable[Box]:
    """The box a hair away in every direction, a hair higher and lower, turned by a hair."""
    x, y, z = box.center
    for i, j, k, turn in product((0, -HAIR, HAIR), repeat=4):
        yield replace(box, center=(x + i, y + j, z + k), heading=box.heading + turn)


def agrees(value: float, scene: Scene, box: Box, column: Column) -> bool:
    """Whether a value is the book's; a count may be the book's where everything is a hair off."""
    if column.values == "continuous":
        return value == pytest.approx(by_the_book(scene, box, column), rel=1e-9, abs=1e-9)
    return any(
        value == by_the_book(scene, near, column, hair)
        for near in nudged(box)
        for hair in (0, -3 * HAIR, 3 * HAIR)
    )


def disagreements(scene: Scene, told: Scene) -> list[str]:
    """Where the relations in ``scene`` are not what the book says of ``told``."""
    return [
        f"{box.id} {column.relation} {column.about}: {value}, the book says "
        f"{by_the_book(told, told[box.id], column)}"
        for box in scene.boxes
        for column, value in measured(scene, box).items()
        if not agrees(value, told, told[box.id], column)
    ]


@pytest.fixture(scope="module")
def living_room() -> Scene:
    """A sofa before a table with a vase, a TV on a cupboard, a chair, a stool, a picture."""
    return read_scene((ROOT / "tests/fixtures/living_room.json").read_bytes())


def rooms_of(path: Path) -> list[Scene]:
    """Rooms from all over a file of them, or the one of a scene file."""
    if path.suffix == ".json":
        return [read_scene(path.read_bytes())]
    rooms = list(read_scenes(path, lambda _: None))
    return rooms[:: max(1, len(rooms) // ROOMS_A_FILE)]


# --- random rooms ---------------------------------------------------------------------------------

spans = st.floats(2, 8)
places = st.one_of(st.floats(-5, 5), st.integers(-20, 20).map(lambda n: n / 4))
angles = st.one_of(st.floats(-pi, pi), st.integers(-8, 8).map(lambda n: n * pi / 4))


@st.composite
def outlines(draw: st.DrawFn) -> tuple[Point, ...]:
    """Rectangles, L-shapes, and polygons round the origin, convex (equal radii) or not."""
    kind = draw(st.sampled_from(("rectangle", "L", "round", "star")))
    width, depth = draw(spans), draw(spans)
    left, low = -width / 2, -depth / 2
    if kind == "rectangle":
        return ((left, low), (-left, low), (-left, -low), (left, -low))
    if kind == "L":
        x, y = left + width * draw(st.floats(0.2, 0.8)), low + depth * draw(st.floats(0.2, 0.8))
        return ((left, low), (-left, low), (-left, y), (x, y), (x, -low), (left, -low))
    count = draw(st.integers(5, 9))
    corners = []
    for i in range(count):
        angle = (i + draw(st.floats(0, 0.8))) * 2 * pi / count
        radius = 1.0 if kind == "round" else draw(st.floats(0.4, 1))
        corners.append((radius * width / 2 * cos(angle), radius * depth / 2 * sin(angle)))
    return tuple(corners)


@st.composite
def scenes(draw: st.DrawFn) -> Scene:
    """Rooms with boxes anywhere: outside, overlapping, touching, on top of one another."""
    boxes: list[Box] = []
    for i in range(draw(st.integers(1, 5))):
        size = tuple(draw(st.floats(0.1, 2.5)) for _ in range(3))
        below = draw(st.sampled_from([None, *boxes]))
        rests = below is not None and draw(st.booleans())
        gap = draw(st.floats(-0.1, 0.1)) if rests else draw(st.floats(0, 2))
        bottom = below.top + gap if below is not None and rests else gap
        boxes.append(
            Box(
                id=f"b{i}",
                category=draw(st.sampled_from([group.name for group in GROUPS])),
                center=(draw(places), draw(places), bottom + size[2] / 2),
                size=(size[0], size[1], size[2]),
                heading=draw(angles),
                front_known=draw(st.booleans()),
                parent=below.id if below is not None and draw(st.booleans()) else None,
            )
        )
    return Scene(Room(draw(outlines())), tuple(boxes))


def moved(scene: Scene, turn: float, by: Point) -> Scene:
    """The whole room turned about the origin, then shifted."""

    def there(x: float, y: float) -> Point:
        return (x * cos(turn) - y * sin(turn) + by[0], x * sin(turn) + y * cos(turn) + by[1])

    boxes = (
        replace(box, center=(*there(*box.center[:2]), box.center[2]), heading=box.heading + turn)
        for box in scene.boxes
    )
    room = replace(scene.room, corners=tuple(there(*corner) for corner in scene.room.corners))
    return replace(scene, room=room, boxes=tuple(boxes))


@settings(max_examples=150, deadline=None)
@given(scene=scenes())
def test_every_relation_is_the_paper_s_in_any_room(scene: Scene) -> None:
    assert disagreements(scene, scene) == []


@settings(max_examples=60, deadline=None)
@given(scene=scenes(), turn=angles, x=st.floats(-100, 100), y=st.floats(-100, 100))
def test_turning_and_moving_the_room_changes_nothing(
    scene: Scene, turn: float, x: float, y: float
) -> None:
    assert disagreements(moved(scene, turn, (x, y)), scene) == []


@settings(max_examples=40, deadline=None)
@given(scene=scenes(), seed=st.integers(0, 2**32 - 1))
def test_many_poses_at_once_are_measured_as_one_by_one(scene: Scene, seed: int) -> None:
    rng = np.random.default_rng(seed)
    box = scene.boxes[0]
    around = Surroundings(scene.without(box.id), GROUPS)
    centers = rng.uniform((-4, -4, 0), (4, 4, 2), (7, 3))
    poses = replace(Candidates.of(box), centers=centers, headings=rng.uniform(-pi, pi, 7))
    together = measure(RELATIONS, Situation(poses, around))
    alone = [measure(RELATIONS, Situation(poses[i : i + 1], around)) for i in range(7)]
    np.testing.assert_array_equal(together, np.concatenate(alone))


# --- drawn and real rooms -------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("box", "relation", "group", "value"),
    [
        ("sofa", "RP", "", 1),  # its center is 0.5 m from one wall
        ("stool", "RP", "", 1),  # 0.5 m from one wall, exactly 1 m from another
        ("table", "RP", "", 0),
        ("picture", "RP", "", 1),
        ("sofa", "AD", "Table", 0.6),
        ("chair", "AD", "Table", 0.85),
        ("table", "AD", "Chair", (0.85 + (0.7**2 + 0.9**2) ** 0.5) / 2),
        ("tv", "AD", "Storage", 0.0),  # on top: nothing between them in the plan
        ("sofa", "AD", "Sofa", 1000),  # it does not count itself, and there is no other
        ("table", "S", "Chair", 1),
        ("table", "S", "Sofa", 1),
        ("tv", "SP", "Storage", 1),
        ("cupboard", "SP", "TV", -1),
        ("vase", "SP", "Table", 1),
        ("table", "SP", "Decor", -1),
        ("tv", "SP", "Table", 0),
        ("sofa", "TC", "", 1),
        ("chair", "TC", "", 1),
        ("stool", "TC", "", 0),  # it faces the wall right before it
        ("sofa", "AW", "", 1),
        ("stool", "AW", "", 0),
        ("sofa", "F", "Table", 1),
        ("sofa", "F", "Decor", 1),
        ("sofa", "F", "TV", 0),  # before it, but 2.7 m away
        ("chair", "F", "Table", 1),
        ("sofa", "NT", "Chair", 1),
        ("sofa", "NT", "Table", 0),
        ("sofa", "DS", "same", 0),
        ("sofa", "DS", "opposite", 1),  # the stool; the table has no known front
        ("cupboard", "DS", "same", 1),  # the television
    ],
)
def test_a_drawn_room_is_described_as_one_sees_it(
    living_room: Scene, box: str, relation: str, group: str, value: float
) -> None:
    values = measured(living_room, living_room[box])
    (found,) = (
        number
        for column, number in values.items()
        if (column.relation, column.about) == (relation, group)
    )
    assert found == pytest.approx(value)


def test_a_category_that_nobody_knows_counts_as_other(living_room: Scene) -> None:
    piano = replace(living_room["stool"], category="Piano")
    other = replace(living_room["stool"], category="Other")
    sofa = living_room["sofa"]
    assert measured(living_room.with_box(piano), sofa) == measured(
        living_room.with_box(other), sofa
    )


def test_an_empty_room_has_only_walls_to_measure() -> None:
    alone = Box("bed", "Bed", (1.0, 1.5, 0.3), (2.0, 1.4, 0.6))
    scene = Scene(Room(((0, 0), (5, 0), (5, 3), (0, 3))), (alone,))
    values = measured(scene, alone)
    assert {column.group for column, value in values.items() if value == ABSENT} == {
        group.name for group in GROUPS
    }
    assert values[Column("TC", "", "ordered")] == 1
    assert values[Column("AW", "", "ordered")] == 1


@pytest.mark.parametrize("path", ROOM_FILES, ids=lambda path: path.name)
def test_every_relation_is_the_paper_s_in_real_rooms(path: Path) -> None:
    scenes = rooms_of(path)
    assert [line for scene in scenes for line in disagreements(scene, scene)] == []
