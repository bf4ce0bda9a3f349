"""Nothing that is offered collides, leaves the room, blocks a door or a window, or closes a way."""

from __future__ import annotations

from math import pi
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from scenegen_core.knowledge import default_knowledge
from scenegen_core.placement.answer import Answer, Query
from scenegen_core.placement.solve import solve
from scenegen_core.scene.files import read_scene
from scenegen_core.scene.model import Box, Opening, Point, Room, Scene
from tests.core.placement.by_shapely import faults
from tests.core.placement.drawn import L_SHAPE, RECTANGLE, moved, room, thing

KNOWLEDGE = default_knowledge()
CATEGORIES = tuple(KNOWLEDGE.categories)
ROOMS = sorted((Path(__file__).parents[3] / "web/public/rooms").glob("**/*.json"))


def offered(answer: Answer) -> list[Box]:
    """The boxes of the poses on offer."""
    return [
        Box(f"new-{pose.rank}", answer.category, pose.center, answer.size, pose.heading)
        for pose in answer.poses
    ]


def wrong(scene: Scene, answer: Answer) -> dict[str, set[str]]:
    """The faults of each pose on offer that has some."""
    found = {box.id: faults(scene, box) for box in offered(answer)}
    return {box_id: problems for box_id, problems in found.items() if problems}


@pytest.mark.parametrize("category", CATEGORIES)
@pytest.mark.parametrize("path", ROOMS, ids=[path.stem for path in ROOMS])
def test_offers_in_the_sample_rooms_and_scans_are_possible(path: Path, category: str) -> None:
    scene = read_scene(path.read_bytes())
    answer = solve(scene, Query(category, count=10), KNOWLEDGE).answer
    assert wrong(scene, answer) == {}
    assert bool(answer.poses) != (answer.no_good_place is not None)


@st.composite
def scenes(draw: st.DrawFn) -> Scene:
    """A rectangle or an L, at any angle, with a door or two, a window and some furniture."""
    corners: tuple[Point, ...] = draw(st.sampled_from([RECTANGLE, L_SHAPE]))
    along = st.floats(0, corners[1][0] - 1).map(lambda x: round(x, 2))
    at, to = draw(along), draw(along)
    doors = [Opening((at, 0), (at + 0.9, 0), 0, 2, "south")]
    if draw(st.booleans()):
        doors.append(Opening((0, 2.5), (0, 1.7), 0, 2, "west"))
    window = Opening((to, 0), (to + 1, 0), draw(st.sampled_from([0.0, 0.9])), 2.1, "window")
    boxes = draw(
        st.lists(
            st.builds(
                thing,
                st.sampled_from(["Bed", "Chair", "Sofa", "Storage", "Table", "Decor", "Other"]),
                st.floats(0.5, 3.0),
                st.floats(0.5, 3.5),
                st.tuples(st.floats(0.3, 1.5), st.floats(0.3, 2.0), st.floats(0.02, 2.0)),
                heading=st.floats(-pi, pi),
            ),
            max_size=4,
            unique_by=lambda box: box.id,
        )
    )
    scene = Scene(Room(corners, 2.6, tuple(doors), (window,)), tuple(boxes))
    return moved(scene, draw(st.floats(-pi, pi)))


@settings(max_examples=60)
@given(
    scenes(),
    st.sampled_from(CATEGORIES),
    st.none() | st.tuples(st.floats(0.1, 1.2), st.floats(0.3, 2.2), st.floats(0.02, 2.2)),
)
def test_offers_in_any_room_are_possible(
    scene: Scene, category: str, size: tuple[float, float, float] | None
) -> None:
    answer = solve(scene, Query(category, size=size), KNOWLEDGE).answer
    assert wrong(scene, answer) == {}


def test_the_check_itself_finds_every_fault() -> None:
    scene = room(
        thing("Table", 2.5, 2, (1, 1, 0.75)),
        doors=(Opening((1, 0), (1.9, 0), 0, 2, "door"),),
        windows=(Opening((3, 0), (4, 0), 0.9, 2, "window"),),
    )
    assert faults(scene, thing("Sofa", 1, 3, (0.9, 2, 0.8))) == set()
    assert faults(scene, thing("Sofa", 2, 2, (0.9, 2, 0.8))) == {"is in table"}
    assert faults(scene, thing("Sofa", 0.4, 3, (0.9, 2, 0.8))) == {"leaves the room"}
    assert faults(scene, thing("Storage", 1.5, 0.4, (0.5, 0.5, 2))) >= {"blocks a door"}
    assert faults(scene, thing("Storage", 3.5, 0.4, (0.5, 0.5, 2))) == {"covers a window"}
    assert faults(scene, thing("Bed", 4, 3, (1, 1, 3))) == {"is too high or too low"}
    bed = scene.with_box(thing("Bed", 1, 3.4, (1, 1, 0.5)))
    screen = thing("Table", 2.5, 1.8, (5, 0.1, 0.75), box_id="bar")
    assert faults(bed.without("table"), screen) == {"closes the way to bed"}
