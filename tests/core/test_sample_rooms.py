"""The sample rooms are rooms that a good interior designer would show."""

from __future__ import annotations

from itertools import combinations
from math import cos, dist, pi, sin
from pathlib import Path

import pytest
from shapely import LineString, MultiPolygon, Point, Polygon, box, union_all
from shapely.affinity import rotate, translate
from shapely.geometry.base import BaseGeometry

from scenegen_core.scene.files import read_scene
from scenegen_core.scene.model import PAPER_CATEGORIES, Box, Opening, Scene

ROOMS = Path(__file__).parents[2] / "web" / "public" / "rooms"
NAMES = ("bedroom", "kitchen-dining", "living-room", "office", "studio")
TOUCH = 0.02  # metres; an overlap below this is furniture that touches
WALKER = 0.6  # metres; the width a person needs


@pytest.fixture(params=NAMES)
def scene(request: pytest.FixtureRequest) -> Scene:
    name = str(request.param)
    return read_scene((ROOMS / f"{name}.json").read_bytes())


def footprint(item: Box) -> BaseGeometry:
    depth, width, _ = item.size
    flat = box(-depth / 2, -width / 2, depth / 2, width / 2)
    turned = rotate(flat, item.heading, origin=(0, 0), use_radians=True)
    return translate(turned, item.center[0], item.center[1])


def swing(room: Polygon, door: Opening) -> BaseGeometry:
    """The square inside the room that a door sweeps."""
    line = LineString([door.start, door.end])
    return line.buffer(line.length, cap_style="flat").intersection(room)


def belongs_together(one: Box, other: Box) -> bool:
    """A chair may stand partly under a table."""
    return {one.category, other.category} == {"Chair", "Table"}


def overlap(one: Box, other: Box) -> bool:
    apart = one.top <= other.bottom + TOUCH or other.top <= one.bottom + TOUCH
    return not apart and footprint(one).buffer(-TOUCH / 2).intersects(footprint(other))


def test_each_room_has_a_file_of_its_own() -> None:
    assert tuple(sorted(path.stem for path in ROOMS.glob("*.json"))) == NAMES


def test_a_room_says_what_it_is(scene: Scene) -> None:
    assert (ROOMS / f"{scene.id}.json").exists()
    assert scene.name
    assert scene.room.room_type
    assert all(item.label for item in scene.boxes)
    assert {item.category for item in scene.boxes} <= {group.name for group in PAPER_CATEGORIES}


def test_furniture_stands_inside_the_room(scene: Scene) -> None:
    room = Polygon(scene.room.corners)
    outside = [item.id for item in scene.boxes if not room.contains(footprint(item))]
    assert outside == []
    assert all(item.top <= scene.room.height for item in scene.boxes)


def test_nothing_stands_in_something_else(scene: Scene) -> None:
    pairs = [
        (one.id, other.id)
        for one, other in combinations(scene.boxes, 2)
        if overlap(one, other) and not belongs_together(one, other)
    ]
    assert pairs == []


def test_everything_stands_on_the_floor_on_its_parent_or_hangs_on_a_wall(scene: Scene) -> None:
    for item in scene.boxes:
        if item.parent is not None:
            parent = scene[item.parent]
            assert item.bottom == pytest.approx(parent.top)
            assert footprint(parent).contains(footprint(item))
        elif item.bottom > TOUCH:
            back = wall_distance(scene, item, item.heading + pi)
            assert back == pytest.approx(item.size[0] / 2, abs=TOUCH), item.id
        else:
            assert item.bottom == pytest.approx(0, abs=1e-9)


def test_doors_and_windows_lie_on_the_outline(scene: Scene) -> None:
    outline = Polygon(scene.room.corners).exterior
    for opening in (*scene.room.doors, *scene.room.windows):
        assert LineString([opening.start, opening.end]).within(outline.buffer(1e-6)), opening.id
        assert opening.top < scene.room.height


def test_every_door_swings_freely(scene: Scene) -> None:
    room = Polygon(scene.room.corners)
    assert scene.room.doors
    for door in scene.room.doors:
        blocking = [b.id for b in scene.boxes if footprint(b).intersects(swing(room, door))]
        assert blocking == []


def test_nothing_tall_stands_before_a_window(scene: Scene) -> None:
    room = Polygon(scene.room.corners)
    for window in scene.room.windows:
        line = LineString([window.start, window.end])
        before = line.buffer(0.4, cap_style="flat").intersection(room)
        tall = [
            b.id for b in scene.boxes if b.top > window.bottom and footprint(b).intersects(before)
        ]
        assert tall == []


def test_a_person_can_walk_from_the_door_to_every_front(scene: Scene) -> None:
    walkable = reachable(scene)
    for item in scene.boxes:
        if item.category in {"Bed", "Chair", "Sofa", "Storage"} and item.bottom < TOUCH:
            assert walkable.distance(footprint(item)) < WALKER, item.id


def test_big_pieces_have_their_back_to_a_wall_and_look_into_the_room(scene: Scene) -> None:
    for item in scene.boxes:
        if item.category in {"Bed", "Picture", "Sofa", "Storage"}:
            back = wall_distance(scene, item, item.heading + pi)
            assert back == pytest.approx(item.size[0] / 2, abs=0.06), item.id
            assert wall_distance(scene, item, item.heading) > item.size[0] / 2 + WALKER, item.id


def test_the_living_room_waits_for_a_sofa_opposite_its_television() -> None:
    scene = read_scene((ROOMS / "living-room.json").read_bytes())
    tv = scene["tv"]
    room = Polygon(scene.room.corners)
    # A sofa of 2 m with its back to the wall that the television looks at.
    ahead = wall_distance(scene, tv, tv.heading) - 0.45 - TOUCH
    spot = Box(
        id="spot",
        category="Sofa",
        center=(
            tv.center[0] + ahead * cos(tv.heading),
            tv.center[1] + ahead * sin(tv.heading),
            0.42,
        ),
        size=(0.9, 2.0, 0.84),
        heading=tv.heading + pi,
    )
    assert all(item.category != "Sofa" for item in scene.boxes)
    assert room.contains(footprint(spot))
    assert not any(overlap(spot, item) for item in scene.boxes)
    assert 2.0 < dist(spot.center[:2], tv.center[:2]) < 4.5
    assert 0.25 < footprint(spot).distance(footprint(scene["coffee-table"])) < 0.8


def wall_distance(scene: Scene, item: Box, direction: float) -> float:
    """How far the wall is from the middle of a box in a direction, metres."""
    x, y, _ = item.center
    far = 50.0
    ray = LineString([(x, y), (x + far * cos(direction), y + far * sin(direction))])
    return float(Point(x, y).distance(ray.intersection(Polygon(scene.room.corners).exterior)))


def reachable(scene: Scene) -> Polygon:
    """The floor that a person reaches from the first door, by the middle of the body."""
    room = Polygon(scene.room.corners)
    standing = [footprint(item) for item in scene.boxes if item.bottom < 1.2]
    free = room.buffer(-WALKER / 2).difference(union_all(standing).buffer(WALKER / 2))
    parts = free.geoms if isinstance(free, MultiPolygon) else [free]
    door = scene.room.doors[0]
    entrance = swing(room, door)
    return max(
        (p for p in parts if isinstance(p, Polygon)),
        key=lambda p: float(p.intersection(entrance).area),
    )
