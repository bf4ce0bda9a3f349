"""A scene of MR Utility Kit becomes the rooms it was drawn from.

The drawing is in our frame; what follows puts it into Unity's by hand: x stays, our y is Unity's z
(ahead), our z is Unity's y (up), and a yaw runs clockwise from straight ahead.
"""

from __future__ import annotations

import json
from math import cos, degrees, hypot, pi, radians, sin
from pathlib import Path
from typing import Any

import pytest
from shapely import Polygon

from scenegen_core.datasets.formats import format_of, read_scenes
from scenegen_core.datasets.labels import categories_of
from scenegen_core.datasets.remarks import Remark, Skipped, UnknownLabel
from scenegen_core.errors import DataError
from scenegen_core.scene.files import read_scene, write_scene
from scenegen_core.scene.model import PAPER_CATEGORIES, Point, Scene

TURN = 0.5  # radians; the drawn L is turned by that
FLOOR = 0.12  # metres; where the headset has its floor
HEIGHT = 2.6
L_SHAPE = ((0, 0), (5, 0), (5, 2), (3, 2), (3, 4), (0, 4))


def turned(u: float, v: float) -> Point:
    """A point of the drawing in the room."""
    return cos(TURN) * u - sin(TURN) * v - 2, sin(TURN) * u + cos(TURN) * v + 1


def anchor(label: str, x: float, y: float, z: float, rotation: Any, **bounds: Any) -> Any:
    return {
        "UUID": f"{label}-{x:.2f}-{y:.2f}",
        "SemanticClassifications": [label],
        "Transform": {
            "Translation": [x, z + FLOOR, y],
            "Rotation": rotation,
            "Scale": [1.0, 1.0, 1.0],
        },
        **bounds,
    }


def rectangle(width: float, height: float) -> Any:
    return {"Min": [-width / 2, -height / 2], "Max": [width / 2, height / 2]}


def panel(label: str, at: Point, z: float, facing: float, size: Point) -> Any:
    """An upright plane round a point of the drawing that looks along a heading of it (radians)."""
    yaw = 90 - degrees(facing + TURN)
    return anchor(label, *turned(*at), z, [0.0, yaw % 360, 0.0], PlaneBounds=rectangle(*size))


def block(label: str, at: Point, top: float, facing: float, size: tuple[float, ...]) -> Any:
    """A box of (depth, width, height) whose top is at that height, front along a heading."""
    depth, width, height = size
    yaw = 90 - degrees(facing + TURN)
    bounds = {"Min": [-width / 2, -depth / 2, -height], "Max": [width / 2, depth / 2, 0.0]}
    return anchor(label, *turned(*at), top, [270.0, yaw % 360, 0.0], VolumeBounds=bounds)


def wall(start: Point, end: Point) -> Any:
    """A wall of the drawing, which runs anticlockwise, so the room is on its left."""
    (x0, y0), (x1, y1) = start, end
    along = {(1, 0): 0.0, (0, 1): pi / 2, (-1, 0): pi, (0, -1): -pi / 2}[
        (x1 > x0) - (x1 < x0), (y1 > y0) - (y1 < y0)
    ]
    middle, length = ((x0 + x1) / 2, (y0 + y1) / 2), hypot(x1 - x0, y1 - y0)
    return panel("WALL_FACE", middle, HEIGHT / 2, along + pi / 2, (length, HEIGHT))


def floor(yaw: float = 40.0) -> Any:
    """The floor: on its back, its own x along the yaw's right, its own y straight back."""
    x0, y0 = turned(2, 1)
    right = cos(radians(yaw)), -sin(radians(yaw))
    back = -sin(radians(yaw)), -cos(radians(yaw))
    corners = [turned(u, v) for u, v in L_SHAPE]
    boundary = [
        [
            (x - x0) * right[0] + (y - y0) * right[1],
            (x - x0) * back[0] + (y - y0) * back[1],
        ]
        for x, y in corners
    ]
    return anchor("FLOOR", x0, y0, 0.0, [270.0, yaw, 0.0], PlaneBoundary2D=boundary)


WALLS = [wall(a, b) for a, b in zip(L_SHAPE, (*L_SHAPE[1:], L_SHAPE[0]), strict=True)]
CEILING = anchor("CEILING", 0, 0, HEIGHT, [90.0, 12.0, 0.0], PlaneBounds=rectangle(5, 4))
MESH = {**anchor("GLOBAL_MESH", 0, 0, 0, [0, 0, 0]), "GlobalMesh": {"Positions": [[0, 0, 0]]}}
SHELL = [floor(), CEILING, *WALLS, MESH]


@pytest.fixture
def file(tmp_path: Path) -> Path:
    return tmp_path / "home.json"


def write(file: Path, *rooms: list[Any], system: str = "Unity") -> Path:
    saved = [{"UUID": f"room {i}", "RoomLayout": {}, "Anchors": r} for i, r in enumerate(rooms)]
    file.write_text(json.dumps({"CoordinateSystem": system, "Rooms": saved}))
    return file


def read(file: Path, *rooms: list[Any], remarks: list[Remark] | None = None) -> list[Scene]:
    """The rooms; what is said about them goes to ``remarks``, or must be nothing."""
    said: list[Remark] = []
    scenes = list(read_scenes(write(file, *rooms), said.append))
    if remarks is None:
        assert said == []
    else:
        remarks += said
    return scenes


def outline_error(scene: Scene) -> float:
    true = Polygon([turned(u, v) for u, v in L_SHAPE])
    return Polygon(scene.room.corners).symmetric_difference(true).area


@pytest.mark.parametrize("yaw", [0.0, 40.0, 200.0])
def test_the_outline_is_the_boundary_of_the_floor(file: Path, yaw: float) -> None:
    (scene,) = read(file, [floor(yaw), CEILING])
    assert outline_error(scene) < 1e-3
    assert Polygon(scene.room.corners).exterior.is_ccw
    assert scene.room.height == pytest.approx(HEIGHT)


def test_without_a_floor_the_outline_is_where_the_walls_meet(file: Path) -> None:
    (scene,) = read(file, [*WALLS[::2], *WALLS[1::2]])
    assert outline_error(scene) < 1e-3
    assert scene.room.height == pytest.approx(HEIGHT)


# Where they stand in the drawing, the height of their top, where they look, depth, width, height.
BLOCKS = {
    "COUCH": ((1.5, 3.5), 0.8, -pi / 2, (0.9, 2.1, 0.8), "Sofa", True),
    "BED": ((4.0, 1.0), 0.5, pi, (2.0, 1.6, 0.5), "Bed", True),
    "SCREEN": ((0.2, 2.0), 1.5, 0.0, (0.1, 1.2, 0.7), "TV", True),
    "TABLE": ((1.5, 2.0), 0.4, 0.3, (0.6, 1.2, 0.4), "Table", False),
    "PLANT": ((2.7, 2.4), 1.1, 1.0, (0.3, 0.4, 1.1), "Decor", False),
}


@pytest.mark.parametrize("label", BLOCKS)
def test_a_box_stands_where_it_was_drawn_and_looks_there_too(file: Path, label: str) -> None:
    at, top, facing, size, category, front_known = BLOCKS[label]
    (scene,) = read(file, [*SHELL, block(label, at, top, facing, size)])
    (box,) = scene.boxes
    assert box.center == pytest.approx((*turned(*at), top - size[2] / 2), abs=1e-3)
    assert box.size == pytest.approx(size)
    assert cos(box.heading - facing - TURN) == pytest.approx(1)
    assert (box.category, box.front_known) == (category, front_known)


@pytest.mark.parametrize(("label", "category"), [("WALL_ART", "Picture"), ("SCREEN", "TV")])
def test_what_hangs_flat_on_a_wall_looks_into_the_room(
    file: Path, label: str, category: str
) -> None:
    (scene,) = read(file, [*SHELL, panel(label, (2.0, 0.0), 1.5, pi / 2, (0.8, 0.6))])
    (box,) = scene.boxes
    assert box.category == category
    assert box.center == pytest.approx((*turned(2.0, 0.01), 1.5), abs=1e-3)
    assert box.size == pytest.approx((0.02, 0.8, 0.6))
    assert cos(box.heading - pi / 2 - TURN) == pytest.approx(1)


def test_doors_and_windows_lie_on_the_outline_above_the_floor(file: Path) -> None:
    door = panel("DOOR_FRAME", (1.0, 0.03), 1.0, pi / 2, (0.9, 2.0))
    window = panel("WINDOW_FRAME", (0.02, 2.0), 1.5, 0.0, (1.2, 1.0))
    (scene,) = read(file, [*SHELL, door, window])
    for opening, ends, heights in (
        (scene.room.doors[0], ((0.55, 0), (1.45, 0)), (0, 2)),
        (scene.room.windows[0], ((0, 1.4), (0, 2.6)), (1, 2)),
    ):
        true = sorted(turned(u, v) for u, v in ends)
        found = sorted([opening.start, opening.end])
        assert found == [pytest.approx(point, abs=1e-3) for point in true]
        assert (opening.bottom, opening.top) == pytest.approx(heights, abs=1e-3)


def test_several_rooms_are_several_scenes(file: Path) -> None:
    couch = block("COUCH", (1.5, 3.5), 0.8, 0.0, (0.9, 2.1, 0.8))
    scenes = read(file, SHELL, [*SHELL, couch])
    assert [(scene.id, len(scene.boxes)) for scene in scenes] == [("home/1", 0), ("home/2", 1)]


def test_what_is_left_out_or_unknown_is_said(file: Path) -> None:
    far = block("COUCH", (4.5, 3.5), 0.8, 0.0, (0.9, 2.1, 0.8))
    flat = {**anchor("TABLE", 0, 0, 0.7, [270, 0, 0], PlaneBounds=rectangle(1, 1)), "UUID": "t"}
    odd = block("AQUARIUM", (1, 1), 1.0, 0.0, (0.4, 1.0, 1.0))
    remarks: list[Remark] = []
    (scene,) = read(file, [*SHELL, far, flat, odd, {"UUID": "broken"}], remarks=remarks)
    assert [(box.category, box.label) for box in scene.boxes] == [("Other", "Aquarium")]
    skipped = [remark.what for remark in remarks if isinstance(remark, Skipped)]
    assert sorted(skipped) == ["TABLE 't'", f"anchor {len(SHELL) + 4}", "object 'sofa-1'"]
    assert UnknownLabel(file, "mruk", "AQUARIUM") in remarks


def test_a_room_without_walls_and_floor_is_named_and_left_out(file: Path) -> None:
    remarks: list[Remark] = []
    (scene,) = read(file, [CEILING], SHELL, remarks=remarks)
    assert scene.id == "home/2"
    assert "room 1: The scan has fewer than three walls" in str(remarks[0])


@pytest.mark.parametrize("system", ["Unreal", ""])
def test_another_coordinate_system_is_refused_in_words(file: Path, system: str) -> None:
    write(file, SHELL, system=system)
    assert format_of(file).name == "mruk"
    with pytest.raises(DataError, match="save it again with the coordinate system 'Unity'"):
        list(read_scenes(file))


def test_a_saved_room_is_a_scene_file(file: Path) -> None:
    furniture = [block(label, *drawn[:4]) for label, drawn in BLOCKS.items()]
    (scene,) = read(file, [*SHELL, *furniture])
    assert len(scene.boxes) == len(BLOCKS)
    assert read_scene(write_scene(scene)) == scene


def test_the_reviewed_labels_lead_to_the_papers_categories() -> None:
    named = {category for category in categories_of("mruk").values() if category}
    assert named <= {category.name for category in PAPER_CATEGORIES}
    assert categories_of("mruk")["COUCH"] == "Sofa"
    assert categories_of("mruk")["WALL_FACE"] is None
