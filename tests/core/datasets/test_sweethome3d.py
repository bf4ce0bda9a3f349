"""Homes of Sweet Home 3D become the rooms that are drawn in them."""

from __future__ import annotations

import gzip
import json
import os
import zipfile
from collections.abc import Callable
from itertools import pairwise
from math import cos, pi
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from shapely import Polygon

from scenegen_core.datasets.formats import format_of, read_scenes
from scenegen_core.datasets.labels import categories_of
from scenegen_core.datasets.remarks import Remark, Skipped, UnknownLabel
from scenegen_core.errors import DataError
from scenegen_core.scene.files import read_scene, write_scene
from scenegen_core.scene.model import PAPER_CATEGORIES, Box, Scene

Draw = Callable[..., Path]

# A flat of 6 m by 4 m with a wall 0.2 m thick between two rooms, y down the page, centimetres.
ROOMS = """
<room name='Living room #2'>
  <point x='0' y='0'/><point x='390' y='0'/><point x='390' y='400'/><point x='0' y='400'/>
</room>
<room name='Bedroom'>
  <point x='410' y='0'/><point x='600' y='0'/><point x='600' y='400'/><point x='410' y='400'/>
</room>
"""


@pytest.fixture
def draw(tmp_path: Path) -> Draw:
    """Write the XML of a home with more in it."""

    def write(*elements: str, rooms: str = ROOMS) -> Path:
        path = tmp_path / "flat.xml"
        inside = rooms + "".join(elements)
        path.write_text(
            f"<?xml version='1.0'?>\n<home version='7000' wallHeight='250'>{inside}</home>"
        )
        return path

    return write


def piece(name: str, x: float, y: float, size: tuple[float, float, float], more: str = "") -> str:
    depth, width, height = size
    return (
        f"<pieceOfFurniture name='{name}' x='{x}' y='{y}' depth='{depth}' width='{width}' "
        f"height='{height}' {more}/>"
    )


def read(path: Path, remarks: list[Remark] | None = None) -> list[Scene]:
    """The rooms of a file; what is said about it goes to ``remarks``, or must be nothing."""
    said: list[Remark] = []
    scenes = list(read_scenes(path, said.append))
    if remarks is None:
        assert said == []
    else:
        remarks += said
    return scenes


def test_rooms_keep_their_outlines_in_metres_with_y_up(draw: Draw) -> None:
    living, bedroom = read(draw())
    expected = Polygon([(0, 0), (0, -4), (3.9, -4), (3.9, 0)])
    assert Polygon(living.room.corners).symmetric_difference(expected).area < 1e-9
    assert Polygon(living.room.corners).exterior.is_ccw
    assert living.room.height == 2.5
    assert (living.id, living.name, living.source) == (
        "flat/l0/r0", "Living room #2", "sweethome3d",
    )  # fmt: skip
    assert [scene.room.room_type for scene in (living, bedroom)] == ["living room", "bedroom"]


@pytest.mark.parametrize(
    ("turn", "heading"),
    [(0, -pi / 2), (pi / 2, -pi), (pi, pi / 2), (3 * pi / 2, 0)],
    ids=["down", "left", "up", "right"],
)
def test_a_piece_faces_down_the_page_and_turns_clockwise(
    draw: Draw, turn: float, heading: float
) -> None:
    sofa = piece("Sofa", 100, 300, (80, 200, 90), f"angle='{turn}'")
    (box,) = read(draw(sofa))[0].boxes
    assert box.category == "Sofa"
    assert box.center == (1.0, -3.0, 0.45)
    assert box.size == pytest.approx((0.8, 2.0, 0.9))
    assert cos(box.heading - heading) == pytest.approx(1)
    assert box.front_known


def test_a_raised_piece_has_its_underside_at_its_elevation(draw: Draw) -> None:
    (box,) = read(draw(piece("Work lamp", 100, 100, (20, 20, 50), "elevation='75'")))[0].boxes
    assert (box.bottom, box.top) == pytest.approx((0.75, 1.25))


def test_a_tilted_piece_has_the_size_that_the_plan_shows(draw: Draw) -> None:
    tilted = "pitch='1.57' widthInPlan='30' depthInPlan='210' heightInPlan='40'"
    (box,) = read(draw(piece("Bookcase", 100, 150, (30, 40, 210), tilted)))[0].boxes
    assert box.size == pytest.approx((2.1, 0.3, 0.4))


def test_pieces_in_groups_go_to_the_rooms_that_contain_their_centers(draw: Draw) -> None:
    chairs = piece("Chair", 300, 100, (40, 40, 90)) + piece("Chair", 500, 100, (40, 40, 90))
    group = f"<furnitureGroup name='Both' x='400' y='100'>{chairs}</furnitureGroup>"
    living, bedroom = read(draw(group, piece("Bed", 450, 300, (200, 150, 50))))
    assert [(box.category, box.center[0]) for box in living.boxes] == [("Chair", 3.0)]
    assert [(box.category, box.center[0]) for box in bedroom.boxes] == [
        ("Chair", 5.0),
        ("Bed", 4.5),
    ]


def test_what_stands_in_no_room_is_named(draw: Draw) -> None:
    said: list[Remark] = []
    scenes = read(draw(piece("Potted plant", -50, 100, (30, 30, 90))), said)
    assert [scene.boxes for scene in scenes] == [(), ()]
    (what,) = said
    assert isinstance(what, Skipped)
    assert (what.what, what.reason) == ("object 'potted-plant-0'", "it stands in no room")


def test_levels_are_kept_apart(draw: Draw) -> None:
    levels = "<level id='low' elevation='-150' height='220'/><level id='high' elevation='82'/>"
    square = (
        "<point x='0' y='0'/><point x='300' y='0'/><point x='300' y='300'/><point x='0' y='300'/>"
    )
    rooms = f"<room level='low'>{square}</room><room level='high'>{square}</room>"
    bed = piece("Bed", 100, 100, (200, 150, 50), "level='high'")
    high, low = read(draw(levels, bed, rooms=rooms))
    assert (high.id, low.id) == ("flat/high/r1", "flat/low/r0")
    assert (high.room.height, low.room.height) == (2.5, 2.2)
    assert ([box.bottom for box in high.boxes], low.boxes) == ([0], ())


def test_rooms_of_levels_with_long_ids_keep_ids_of_their_own(draw: Draw) -> None:
    level = "level-7a1f0c1e-52b0-4d0c-9a55-0f7f0a1b2c3d"
    path = draw(rooms=ROOMS.replace("<room ", f"<room level='{level}' "))
    path = path.rename(path.with_name(f"{'long-' * 12}name.xml"))
    scenes = read(path)
    assert [read_scene(write_scene(scene)) for scene in scenes] == scenes
    assert [scene.id[-3:] for scene in scenes] == ["/r0", "/r1"]


def test_a_door_between_two_rooms_is_on_the_outlines_of_both(draw: Draw) -> None:
    # The leaf stands open: the box is 80 cm deep, of which the first 20 % are in the wall.
    door = (
        "<doorOrWindow name='Open door' x='430' y='200' angle='4.71238898' width='90' depth='80' "
        "height='200' wallThickness='0.2' wallDistance='0.025'/>"
    )
    living, bedroom = read(draw(door))
    for scene, x in ((living, 3.9), (bedroom, 4.1)):
        (opening,) = scene.room.doors
        assert sorted([opening.start, opening.end]) == [(x, -2.45), (x, -1.55)]
        assert (opening.bottom, opening.top) == (0, 2)
        assert scene.room.windows == ()


def test_what_begins_above_the_floor_or_cannot_be_opened_is_a_window(draw: Draw) -> None:
    window = "<doorOrWindow x='200' y='-10' width='100' depth='20' height='120' {}/>"
    scenes = read(
        draw(
            window.format("name='Window' elevation='90'"),
            window.format("name='Shop window' catalogId='eTeks#fixedWindow85x123'"),
        )
    )
    assert [scene.room.doors for scene in scenes] == [(), ()]
    high, low = scenes[0].room.windows
    assert sorted([high.start, high.end]) == [(1.5, 0), (2.5, 0)]
    assert (high.bottom, high.top) == pytest.approx((0.9, 2.1))
    assert (low.bottom, low.top) == pytest.approx((0.0, 1.2))
    assert scenes[1].room.windows == ()


def test_a_home_of_walls_alone_has_a_room_between_them(draw: Draw) -> None:
    ends = [(0, 0), (400, 0), (400, 300), (0, 300), (0, 0)]
    walls = "".join(
        f"<wall xStart='{x}' yStart='{y}' xEnd='{u}' yEnd='{v}' thickness='20'/>"
        for (x, y), (u, v) in pairwise(ends)
    )
    (scene,) = read(draw(walls, piece("Bed", 150, 150, (200, 150, 50)), rooms=""))
    expected = Polygon([(0.1, -0.1), (3.9, -0.1), (3.9, -2.9), (0.1, -2.9)])
    assert Polygon(scene.room.corners).symmetric_difference(expected).area < 1e-6
    assert [box.category for box in scene.boxes] == ["Bed"]


def test_ceilings_are_no_rooms(draw: Draw) -> None:
    ceiling = ROOMS.replace("<room ", "<room floorVisible='false' ")
    assert len(read(draw(rooms=ROOMS + ceiling))) == 2


def test_a_small_loop_of_an_outline_is_cut_off(draw: Draw) -> None:
    corners = [(0, 0), (300, 0), (300, 300), (0, 300), (5, -5)]
    crossing = "".join(f"<point x='{x}' y='{y}'/>" for x, y in corners)
    (scene,) = read(draw(rooms=f"<room>{crossing}</room>"))
    assert Polygon(scene.room.corners).area == pytest.approx(9, abs=0.1)


def test_a_renamed_piece_counts_as_what_it_is_called_and_a_foreign_name_as_its_model(
    draw: Draw,
) -> None:
    model = "catalogId='eTeks#bedsideTable'"
    boxes = read(
        draw(
            piece("Coffee table", 100, 100, (40, 40, 40), model),
            piece("Table de chevet", 200, 100, (40, 40, 40), model),
        )
    )[0].boxes
    assert [box.category for box in boxes] == ["Table", "Storage"]
    assert boxes[1].label == "Table de chevet"


def test_an_unknown_name_is_other_and_said(draw: Draw) -> None:
    said: list[Remark] = []
    path = draw(piece("Spaceship", 100, 100, (40, 40, 40)))
    (box,) = read(path, said)[0].boxes
    assert (box.category, box.label) == ("Other", "Spaceship")
    assert said == [UnknownLabel(path, "sweethome3d", "Spaceship")]


@pytest.mark.parametrize(
    ("element", "reason"),
    [
        (piece("Bed", 100, 100, (40, 40, 40)).replace("x='100'", "x='?'"), "x is missing"),
        (piece("Bed", 100, 100, (40, 40, 40)).replace("width", "w"), "width is missing"),
        (piece("Bed", 100, 100, (40, 40, -40)), "size[2]"),
        (piece("Bed", 100, 100, (40, 40, 40), "visible='false'"), "hidden"),
        ("<doorOrWindow name='Door' x='1' y='2'/>", "depth is missing"),
        ("<room><point x='0' y='0'/><point x='9' y='0'/></room>", "Expected `array`"),
        ("<room><point x='0'/></room>", "y is missing"),
    ],
)
def test_what_is_broken_is_named_and_left_out(draw: Draw, element: str, reason: str) -> None:
    said: list[Remark] = []
    sound = piece("Chair", 200, 200, (40, 40, 90))
    living, _ = read(draw(element, sound), said)
    assert [box.category for box in living.boxes] == ["Chair"]
    (what,) = said
    assert isinstance(what, Skipped)
    assert reason in what.reason


def test_a_saved_home_is_read_too(draw: Draw, tmp_path: Path) -> None:
    bare = read(draw(piece("Bed", 150, 150, (200, 150, 50))))
    saved = tmp_path / "flat.sh3d"
    with zipfile.ZipFile(saved, "w") as archive:
        archive.writestr("Home", b"\xac\xed")
        archive.write(tmp_path / "flat.xml", "Home.xml")
    assert format_of(saved).name == "sweethome3d"
    assert read(saved) == bare


def test_a_home_of_an_old_version_is_refused_with_what_to_do(tmp_path: Path) -> None:
    saved = tmp_path / "old.sh3d"
    with zipfile.ZipFile(saved, "w") as archive:
        archive.writestr("Home", b"\xac\xed")
    with pytest.raises(DataError, match=r"old\.sh3d was saved by an old version.*save it again"):
        read(saved)


def test_a_broken_home_is_refused_with_what_to_do(draw: Draw) -> None:
    with pytest.raises(DataError, match="broken XML"):
        read(draw(rooms="<room>"))
    with pytest.raises(DataError, match="neither rooms nor walls"):
        read(draw(rooms=""))


def test_the_reviewed_labels_lead_to_the_papers_categories() -> None:
    named = {category for category in categories_of("sweethome3d").values() if category}
    assert named <= {category.name for category in PAPER_CATEGORIES}


ROOT = Path(__file__).parents[3]
CORPUS = ROOT.parent / "shared" / "data" / "rooms" / "sweethome3d.jsonl.gz"
# Debian's package of Sweet Home 3D; or wherever its jar is.
JAR = Path(os.environ.get("SWEETHOME3D_JAR", "/usr/share/sweethome3d/sweethome3d.jar"))
EXAMPLES = "com/eteks/sweethome3d/io/resources/examples/"


@pytest.fixture(scope="module")
def examples(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Scene]:
    """Every room of the example homes, by its id."""
    if not JAR.exists():
        pytest.skip("Sweet Home 3D is not installed")
    folder = tmp_path_factory.mktemp("examples")
    rooms: dict[str, Scene] = {}
    with zipfile.ZipFile(JAR) as jar:
        names = [n for n in jar.namelist() if n.startswith(EXAMPLES) and n.endswith(".xml")]
        for name in names:
            path = folder / Path(name).name
            path.write_bytes(jar.read(name))
            rooms |= {scene.id: scene for scene in read_scenes(path, lambda _: None)}
    assert len(names) == 9
    return rooms


def test_the_example_homes_are_scene_files(examples: dict[str, Scene]) -> None:
    assert (
        len(examples) == 83
    )  # counted in the XML: 90 rooms; six are ceilings, one is round a hole
    for scene in examples.values():
        assert read_scene(write_scene(scene)) == scene


@pytest.mark.skipif(not CORPUS.exists(), reason="the corpus of rooms is not at hand")
def test_the_example_homes_agree_with_the_corpus_that_others_made(
    examples: dict[str, Scene],
) -> None:
    with gzip.open(CORPUS, "rt", encoding="utf-8") as lines:
        known = [json.loads(line) for line in lines]
    compared = [room for room in known if room["id"] in examples]
    assert len(compared) >= len(known) - 1  # an attic round a hole is refused here
    for room in compared:
        scene = examples[room["id"]]
        outline = Polygon(scene.room.corners)
        assert outline.symmetric_difference(Polygon(room["polygon"])).area < 1e-3
        theirs = [thing for thing in room["objects"] if thing["category"]]
        for thing in theirs:
            assert any(same(box, thing) for box in scene.boxes), (room["id"], thing)
        openings = [*scene.room.doors, *scene.room.windows]
        for opening in (*room["doors"], *room["windows"]):  # there in the middles of the walls
            middle = np.mean(opening["segment"], axis=0)
            ours = [np.mean([other.start, other.end], axis=0) for other in openings]
            assert min(np.linalg.norm(middle - other) for other in ours) < 0.35


def same(box: Box, thing: Any) -> bool:
    """Whether a box is the same as an object of the corpus, to 2 mm."""
    return (
        box.category == thing["category"]
        and box.label == thing["label"]
        and box.center == pytest.approx(thing["center"], abs=2e-3)
        and box.size == pytest.approx([2 * half for half in thing["half"]], abs=2e-3)
        and cos(box.heading - thing["yaw"]) > 0.9999
        and box.front_known == thing["front_known"]
    )
