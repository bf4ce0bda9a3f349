"""Our own relations against their twins, in random, turned, drawn and real rooms."""

from __future__ import annotations

from dataclasses import replace
from math import isnan, nan, pi
from pathlib import Path

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from shapely import Polygon

from scenegen_core.graph.candidates import Candidates
from scenegen_core.graph.own_relations import OWN_RELATIONS
from scenegen_core.graph.relations import columns, measure
from scenegen_core.graph.situation import Situation
from scenegen_core.graph.surroundings import Surroundings
from scenegen_core.scene.model import PAPER_CATEGORIES, Box, Opening, Room, Scene
from tests.core.by_the_book import center, walls
from tests.core.own_by_the_book import Described, described
from tests.core.placement.drawn import DOOR, NORTH, SOUTH, WEST, WINDOW, moved, room, thing
from tests.core.test_relations import ROOM_FILES, angles, nudged, rooms_of
from tests.core.test_relations import scenes as unfurnished

GROUPS = PAPER_CATEGORIES
NAMED = [(column.relation, column.group, column.part) for column in columns(OWN_RELATIONS, GROUPS)]
SAME = 1e-7  # metres and radians between two ways to reckon the same
NUDGED = 1e-3  # metres and radians that a nudge may change where a ray grazes something


def measured(scene: Scene, box: Box) -> Described:
    """What the relations say of a box where it is."""
    situation = Situation(Candidates.of(box), Surroundings(scene.without(box.id), GROUPS))
    values = measure(OWN_RELATIONS, situation)
    return dict(zip(NAMED, values[0].tolist(), strict=True))


def disagreements(scene: Scene, told: Scene) -> list[str]:
    """Where the relations in ``scene`` are not what the book says of ``told``.

    What hangs on a hair may be the book's of a box that stands a hair elsewhere.
    """
    wrong = []
    for box in scene.boxes:
        found, book = measured(scene, box), described(told[box.id], told, GROUPS)
        assert found.keys() == book.keys()
        off = {
            key for key in found if found[key] != pytest.approx(book[key], abs=SAME, nan_ok=True)
        }
        for near in nudged(told[box.id]) if off else ():
            twin = described(near, told, GROUPS)
            off -= {k for k in off if found[k] == pytest.approx(twin[k], abs=NUDGED, nan_ok=True)}
            if not off:
                break
        wrong += [f"{box.id} {key}: {found[key]}, the book says {book[key]}" for key in sorted(off)]
    return wrong


BESIDE = 1e-6  # metres


@st.composite
def scenes(draw: st.DrawFn) -> Scene:
    """Rooms with boxes anywhere, with up to two doors and two windows.

    No box has its middle on a wall or in the middle of the room: on which side of that it is would
    be decided by rounding.
    """
    scene = draw(unfurnished())
    marks = [*walls(scene), Polygon(scene.room.corners).centroid]
    assume(all(mark.distance(center(box)) > BESIDE for box in scene.boxes for mark in marks))
    shares = st.floats(0, 0.8)

    def opening(number: int) -> Opening:
        (x0, y0), (x1, y1) = draw(st.sampled_from(scene.room.walls))
        start = draw(shares)
        end = draw(st.floats(start + 0.1, 1))
        at = [(x0 + share * (x1 - x0), y0 + share * (y1 - y0)) for share in (start, end)]
        return Opening(at[0], at[1], 0, 2, str(number))

    doors, windows = (
        tuple(opening(number) for number in range(draw(st.integers(0, 2)))) for _ in range(2)
    )
    return scene.with_room(replace(scene.room, doors=doors, windows=windows))


@settings(max_examples=120, deadline=None)
@given(scene=scenes())
def test_every_relation_is_its_description_in_any_room(scene: Scene) -> None:
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
    together = measure(OWN_RELATIONS, Situation(poses, around))
    alone = [measure(OWN_RELATIONS, Situation(poses[i : i + 1], around)) for i in range(7)]
    np.testing.assert_array_equal(together, np.concatenate(alone))


@pytest.mark.parametrize("path", ROOM_FILES, ids=lambda path: path.name)
def test_every_relation_is_its_description_in_real_rooms(path: Path) -> None:
    assert [line for scene in rooms_of(path) for line in disagreements(scene, scene)] == []


# --- drawn rooms: 5 m by 4 m, a door x 1..1.8 in the south wall, a window x 2..3 in the north ---

SOFA = thing("Sofa", 2.5, 3.5, (0.9, 2.0, 0.8), heading=SOUTH)
TELLY = thing("TV", 2.5, 0.25, (0.1, 1.0, 0.6), heading=NORTH, bottom=0.5)
BOARD = thing("Storage", 2.5, 0.25, (0.5, 1.6, 0.5), heading=NORTH)
TABLE = thing("Table", 2.5, 2.0, (0.8, 1.4, 0.75))
CHAIR = thing("Chair", 1.8, 2.0, (0.5, 0.5, 0.9))
FAR_CHAIR = thing("Chair", 4.7, 0.3, (0.5, 0.5, 0.9), heading=WEST, box_id="far")
LIVING = room(SOFA, TELLY, BOARD, TABLE, CHAIR, FAR_CHAIR, doors=(DOOR,), windows=(WINDOW,))


@pytest.mark.parametrize(
    ("box", "column", "value"),
    [
        # the back of the sofa, y = 3.95, is 5 cm from the north wall; its front is at y = 3.05
        ("sofa", ("W", "", "behind"), 0.05),
        ("sofa", ("W", "", "ahead"), 3.05),
        ("sofa", ("W", "", "side"), 1.5),
        ("sofa", ("W", "", "nearest"), 0.05),
        ("sofa", ("W", "", "second"), 1.5),
        ("sofa", ("W", "", "flush"), 1),
        ("sofa", ("W", "", "turn"), 0),
        ("sofa", ("W", "", "centered"), 0),
        ("far", ("W", "", "flush"), 2),  # in the corner, 5 cm from either wall
        ("far", ("W", "", "turn"), 0),  # its back is to one of them
        ("sofa", ("FS", "", "ahead"), 0.35),  # the far side of the table is x 2.1..2.9, y 1.3..2.7
        ("sofa", ("FS", "", "behind"), 0.05),
        ("sofa", ("FS", "", "nearest"), 0.35),
        ("tv", ("FS", "", "ahead"), 1.0),  # over the board and up to the table at y = 1.3
        ("tv", ("FS", "", "touching"), 0),  # the board ends where the TV begins
        ("tv", ("FS", "", "within a metre"), 1),  # the table is 1 m away, which is not within
        ("table", ("M", "", "distance"), 0),
        ("sofa", ("M", "", "distance"), 1.5 / 20**0.5),
        ("sofa", ("M", "", "bearing"), 0),
        ("sofa", ("WN", "", "gap"), 0.05),
        ("sofa", ("WN", "", "bearing"), pi),
        ("sofa", ("WN", "", "offset"), 0),
        ("table", ("DR", "", "offset"), 1.1),
        ("tv", ("H", "", ""), 0.5),
        ("sofa", ("N", "TV", "gap"), 2.75),  # from y = 3.05 to 0.3
        ("sofa", ("N", "TV", "before"), 3.2),  # its middle, from the screen at y = 0.3
        ("sofa", ("N", "TV", "offset"), 0),
        ("sofa", ("N", "TV", "faced"), 1),
        ("sofa", ("N", "TV", "bearing"), 0),
        ("sofa", ("N", "TV", "turn"), pi),
        ("tv", ("N", "Storage", "on"), 1),
        ("tv", ("N", "Storage", "turn"), 0),
        ("tv", ("N", "Table", "on"), 0),
        ("chair", ("N", "Table", "gap"), 0.05),
        ("chair", ("N", "Table", "top"), 0.75),
        ("chair", ("N", "Table", "long"), 1.4),
        ("sofa", ("N", "TV", "long"), nan),  # 2.75 m away
        ("chair", ("N", "Table", "before"), 0.3),
        ("chair", ("N", "Table", "faced"), nan),  # a table has no front
        ("sofa", ("N", "Bed", "gap"), nan),
        ("chair", ("TW", "", "gap"), (2.4**2 + 1.2**2) ** 0.5),
        ("far", ("MI", "", "distance"), 2.0),  # the seat opposite at (3.2, 2) is further than that
        ("sofa", ("TW", "", "gap"), nan),
        ("sofa", ("MI", "", "turn"), nan),
        ("sofa", ("SZ", "", "width"), 2.0),
        ("sofa", ("SZ", "", "room"), 20.0),
    ],
)  # fmt: skip
def test_a_drawn_room_is_described_as_one_sees_it(
    box: str, column: tuple[str, str, str], value: float
) -> None:
    assert measured(LIVING, LIVING[box])[column] == pytest.approx(value, abs=SAME, nan_ok=True)


def test_the_place_opposite_at_a_table_completes_a_pair() -> None:
    opposite = thing("Chair", 3.2, 2.0, (0.5, 0.5, 0.9), heading=WEST, box_id="opposite")
    scene = room(TABLE, CHAIR, opposite)
    seen = measured(scene, opposite)
    assert seen["MI", "", "distance"] == pytest.approx(0, abs=1e-9)
    assert seen["MI", "", "turn"] == pytest.approx(0, abs=1e-9)


def test_a_place_that_is_taken_completes_no_pair() -> None:
    opposite = thing("Chair", 3.2, 2.0, (0.5, 0.5, 0.9), heading=WEST, box_id="opposite")
    third = thing("Chair", 2.5, 3.2, (0.5, 0.5, 0.9), heading=SOUTH, box_id="third")
    assert isnan(measured(room(TABLE, CHAIR, opposite, third), third)["MI", "", "distance"])


def test_a_category_that_nobody_knows_counts_as_other() -> None:
    piano = thing("Piano", 4.0, 2.0, (0.6, 1.5, 1.2))
    seen = measured(room(piano, SOFA), SOFA)
    assert seen["N", "Other", "gap"] == pytest.approx(
        measured(room(replace(piano, category="Other"), SOFA), SOFA)["N", "Other", "gap"]
    )
    assert not isnan(seen["N", "Other", "gap"])


def test_what_has_no_front_is_measured_up_to_a_half_turn() -> None:
    corner = Room(((0, 0), (5, 0), (5, 4), (0, 4)))
    one, other = (thing("Table", 1.0, 1.5, (0.8, 1.4, 0.7), heading=h) for h in (0.3, 0.3 - pi))
    here, there = (measured(Scene(corner, (box, SOFA)), box) for box in (one, other))
    assert here == pytest.approx(there, nan_ok=True)
