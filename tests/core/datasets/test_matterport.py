"""Houses written by hand in the published format of Matterport3D become scenes."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from itertools import chain
from math import cos, pi, radians, sin
from pathlib import Path
from typing import Any

import pytest
from shapely import Polygon

from scenegen_core.datasets.formats import format_of, read_scenes
from scenegen_core.datasets.labels import categories_of
from scenegen_core.datasets.remarks import Remark, Skipped, UnknownLabel
from scenegen_core.errors import DataError
from scenegen_core.scene.files import read_scene, write_scene
from scenegen_core.scene.model import PAPER_CATEGORIES, Scene

FLOOR = 0.12  # metres; where the floor of the house below lies in its frame
ZEROS = "0 0 0 0 0"

# As in the published files: index, number and name of the label, number and name of the class.
CATEGORIES = ["door 4 door", "coffee#table 5 table", "dining#chair 3 chair", "wall 1 wall",
              "window 9 window", "vase 39 objects", "flux#capacitor 99 machine"]  # fmt: skip
DOOR, TABLE, CHAIR, WALL, WINDOW, VASE, MACHINE = range(7)

Numbers = Sequence[float]
Write = Callable[..., Path]


def line(*fields: object) -> str:
    return "  ".join(str(field) for field in fields)


def numbers(values: Numbers) -> str:
    return " ".join(f"{value:.6f}" for value in values)


def region(index: int, label: str, west: float, east: float, level: int = 0) -> str:
    box = (west, 0, FLOOR, east, 3, FLOOR + 2.5)
    return line("R", index, level, 0, 0, label, numbers(box[:3]), numbers(box), 2.5, "0 0 0 0")


def surface(index: int, region_index: int, corners: Sequence[tuple[float, float]]) -> list[str]:
    box = numbers((0,) * 6)
    head = line(
        "S", index, region_index, 0, "-", numbers((0, 0, 0)), numbers((0, 0, 1)), box, ZEROS
    )
    return [
        head,
        *(
            line("V", i, index, "-", numbers((x, y, FLOOR)), numbers((0, 0, 1)), "0 0 0")
            for i, (x, y) in enumerate(corners)
        ),
    ]


def thing(
    index: int,
    category: int,
    center: Numbers,
    half: Numbers,
    *,
    turn: float = 0.0,
    region_index: int = 0,
    axes: str = "",
) -> str:
    """A box whose first axis points along a plan direction (radians) and whose third is up."""
    level = numbers((cos(turn), sin(turn), 0, -sin(turn), cos(turn), 0))
    raised = (*center[:2], center[2] + FLOOR)
    fields = (numbers(raised), axes or level, numbers(half), "0 0 0 0 0 0 0 0")
    return line("O", index, region_index, category, *fields)


ROOMS = [region(0, "l", 0, 4), region(1, "b", 4.2, 7)]


@pytest.fixture
def write(tmp_path: Path) -> Write:
    """Write a house of two rooms with more in it, and pose labels beside it."""

    def write(
        *more: str | list[str], regions: Sequence[str] = ROOMS, poses: Any = None, head: str = ""
    ) -> Path:
        path = tmp_path / "17DRP5sb8fy.house"
        lists = [item if isinstance(item, list) else [item] for item in more]
        categories = [f"C {i} {10 * i} {names} {ZEROS}" for i, names in enumerate(CATEGORIES)]
        lines = ["ASCII 1.1", head or "H 17DRP5sb8fy -", "L 0 2 0  0 0 0  0 0 0 7 3 2.6  " + ZEROS,
                 "P 0 0 1 -  0 0 0 0 0 0  0 0 0 0", *regions, *chain(*lists), *categories,
                 "E 0 0 1 0.5  0 0 0  0 0 0 0 0 0  " + ZEROS]  # fmt: skip
        path.write_text("\n".join(lines) + "\n")
        if poses is not None:
            (tmp_path / "17DRP5sb8fy.poses.json").write_text(json.dumps(poses))
        return path

    return write


def read(path: Path, remarks: list[Remark] | None = None) -> list[Scene]:
    """The rooms of a house; what is said about it goes to ``remarks``, or must be nothing."""
    said: list[Remark] = []
    assert format_of(path).name == "matterport"
    scenes = list(read_scenes(path, said.append))
    if remarks is None:
        assert said == []
    else:
        remarks += said
    return scenes


def test_a_region_without_surfaces_is_its_box_with_its_floor_at_zero(write: Write) -> None:
    living, bedroom = read(write())
    assert list(living.room.corners) == [(0, 0), (4, 0), (4, 3), (0, 3)]
    assert living.room.height == pytest.approx(2.5)
    assert (living.id, living.room.room_type, living.source) == (
        "17DRP5sb8fy/r0", "living room", "matterport",
    )  # fmt: skip
    assert bedroom.room.room_type == "bedroom"


def test_the_surfaces_of_a_region_are_its_outline(write: Write) -> None:
    corner = [(0, 0), (4, 0), (4, 1), (2, 1), (2, 3), (0, 3)]
    living, _ = read(write(surface(0, 0, corner)))
    assert Polygon(living.room.corners).equals(Polygon(corner))
    assert Polygon(living.room.corners).exterior.is_ccw


def test_several_surfaces_of_a_region_are_joined(write: Write) -> None:
    west, east = [(0, 0), (2, 0), (2, 3), (0, 3)], [(2, 0), (4, 0), (4, 2), (2, 2)]
    living, _ = read(write(surface(0, 0, west), surface(1, 0, east)))
    assert Polygon(living.room.corners).area == pytest.approx(6 + 4)


def test_without_a_label_only_the_axes_of_a_box_are_known(write: Write) -> None:
    chair = thing(7, CHAIR, (1, 2, 0.5), (0.25, 0.3, 0.5), turn=0.4)
    (box,) = read(write(chair))[0].boxes
    assert (box.id, box.category, box.label) == ("7", "Chair", "dining chair")
    assert box.center == pytest.approx((1, 2, 0.5), abs=1e-4)
    assert box.size == pytest.approx((0.5, 0.6, 1.0))
    assert box.heading == pytest.approx(0.4, abs=1e-5)
    assert not box.front_known


@pytest.mark.parametrize(
    ("axes", "half"),
    [
        ("0 0 1  0.6 0.8 0", (0.5, 0.25, 0.3)),
        ("0.6 0.8 0  0 0 1", (0.25, 0.5, 0.3)),
        ("0 0 -1  0.6 0.8 0", (0.5, 0.25, 0.3)),
    ],
)
def test_the_upright_axis_can_be_any_of_the_three(write: Write, axes: str, half: Numbers) -> None:
    (box,) = read(write(thing(7, CHAIR, (1, 2, 0.5), half, axes=axes)))[0].boxes
    assert box.size == pytest.approx((0.5, 0.6, 1.0))
    assert (cos(box.heading), sin(box.heading)) == pytest.approx((0.6, 0.8))


@pytest.mark.parametrize(
    ("axis", "degrees", "depth", "width"),
    [(0, 30, 0.5, 0.6), (1, 120, 0.6, 0.5), (2, 210, 0.5, 0.6), (3, 300, 0.6, 0.5)],
)
def test_a_label_names_the_axis_that_is_the_front(
    write: Write, axis: int, degrees: float, depth: float, width: float
) -> None:
    chair = thing(7, CHAIR, (1, 2, 0.5), (0.25, 0.3, 0.5), turn=radians(30))
    (box,) = read(write(chair, poses={"7": {"axis": axis}}))[0].boxes
    ahead = radians(degrees)
    assert (cos(box.heading), sin(box.heading)) == pytest.approx((cos(ahead), sin(ahead)), abs=1e-5)
    assert box.size == pytest.approx((depth, width, 1.0))
    assert box.front_known


def test_a_labelled_heading_means_the_axis_nearest_to_it(write: Write) -> None:
    chair = thing(7, CHAIR, (1, 2, 0.5), (0.25, 0.3, 0.5), turn=0.1)
    (box,) = read(write(chair, poses={"7": {"heading": -1.4}}))[0].boxes
    assert cos(box.heading - (0.1 - pi / 2)) == pytest.approx(1)
    assert box.size == pytest.approx((0.6, 0.5, 1.0))


def test_objects_go_to_their_regions_and_parts_of_the_house_are_left_out(write: Write) -> None:
    living, bedroom = read(
        write(
            thing(0, TABLE, (1, 1, 0.2), (0.5, 0.5, 0.2)),
            thing(1, VASE, (5, 1, 0.2), (0.1, 0.1, 0.2), region_index=1),
            thing(2, WALL, (0, 1, 1), (0.1, 1, 1)),
        )
    )
    assert [box.category for box in living.boxes] == ["Table"]
    assert [box.category for box in bedroom.boxes] == ["Decor"]


def test_a_door_leads_to_both_rooms_and_a_window_to_one(write: Write) -> None:
    door = thing(0, DOOR, (4.1, 1.5, 1.0), (0.05, 0.45, 1.0))
    window = thing(1, WINDOW, (2, 3.02, 1.5), (0.6, 0.05, 0.6))
    living, bedroom = read(write(door, window))
    for scene, x in ((living, 4), (bedroom, 4.2)):
        (opening,) = scene.room.doors
        assert sorted([opening.start, opening.end]) == [(x, 1.05), (x, 1.95)]
        assert (opening.bottom, opening.top) == pytest.approx((0, 2))
    (opening,) = living.room.windows
    assert sorted([opening.start, opening.end]) == [(1.4, 3), (2.6, 3)]
    assert (opening.bottom, opening.top) == pytest.approx((0.9, 2.1))
    assert bedroom.room.windows == ()


def test_a_door_is_in_no_room_of_another_level(write: Write) -> None:
    above = region(1, "b", 4.2, 7, level=1)
    door = thing(0, DOOR, (4.1, 1.5, 1.0), (0.05, 0.45, 1.0))
    living, bedroom = read(write(door, regions=[ROOMS[0], above]))
    assert (len(living.room.doors), len(bedroom.room.doors)) == (1, 0)


def test_an_unknown_class_is_other_and_said(write: Write) -> None:
    said: list[Remark] = []
    path = write(thing(0, MACHINE, (1, 1, 0.2), (0.5, 0.5, 0.2)))
    (box,) = read(path, said)[0].boxes
    assert (box.category, box.label) == ("Other", "flux capacitor")
    assert said == [UnknownLabel(path, "matterport", "machine")]


def test_a_house_is_a_scene_file(write: Write) -> None:
    door = thing(0, DOOR, (4.1, 1.5, 1.0), (0.05, 0.45, 1.0))
    for scene in read(write(door, thing(7, CHAIR, (1, 2, 0.5), (0.25, 0.3, 0.5), turn=0.4))):
        assert read_scene(write_scene(scene)) == scene


@pytest.mark.parametrize(
    ("wrong", "what", "reason"),
    [
        ("O 1 0 2 1 2", "line 7", "no complete O line"),
        (thing(1, CHAIR, (1, 1, 1), (1, 1, 1), axes="1 0 0 1 0 0"), "line 7", "no complete O"),
        (thing(1, CHAIR, (1, 1, float("nan")), (1, 1, 1)), "line 7", "no complete O line"),
        (thing(1, CHAIR, (1, 1, 1), (1, 0, 1)), "object '1'", "size[1]"),
        (thing(1, CHAIR, (1, 1, 1), (1, 1, 1), region_index=-1), "object '1'", "no usable region"),
        (thing(1, DOOR, (2, 1.5, 1), (0.1, 0.5, 1)), "opening '1'", "in no wall"),
        ("R 5 zero", "line 7", "no complete R line"),
        (region(5, "b", 9, 9), "region 5", "corners"),
    ],
)
def test_what_is_broken_is_named_and_left_out(
    write: Write, wrong: str, what: str, reason: str
) -> None:
    said: list[Remark] = []
    living, _ = read(write(wrong, thing(0, CHAIR, (1, 2, 0.5), (0.25, 0.3, 0.5))), said)
    assert [box.id for box in living.boxes] == ["0"]
    (skipped,) = said
    assert isinstance(skipped, Skipped)
    assert skipped.what == what
    assert reason in skipped.reason


@pytest.mark.parametrize(
    ("poses", "reason"),
    [
        ({"9": {"axis": 1}}, "no such object"),
        ({"0": {"axis": 4}}, "<= 3"),
        ({"0": {}}, "either an axis or a heading"),
        ({"0": {"axis": 1, "heading": 0.0}}, "either an axis or a heading"),
    ],
)
def test_a_broken_label_is_named_and_left_out(write: Write, poses: Any, reason: str) -> None:
    said: list[Remark] = []
    chair = thing(0, CHAIR, (1, 2, 0.5), (0.25, 0.3, 0.5))
    living, _ = read(write(chair, poses=poses), said)
    assert not living.boxes[0].front_known
    (skipped,) = said
    assert isinstance(skipped, Skipped)
    assert skipped.path.name == "17DRP5sb8fy.poses.json"
    assert reason in skipped.reason


def test_labels_that_are_none_are_refused_with_a_sentence(write: Write) -> None:
    with pytest.raises(DataError, match=r"poses\.json does not hold pose labels"):
        read(write(poses=[1, 2]))


def test_a_file_that_was_cut_off_says_so(write: Write) -> None:
    said: list[Remark] = []
    path = write(head=f"H 17DRP5sb8fy - 0 0 0 0 0 12 7 2 0 1 {ZEROS}")
    read(path, said)
    assert said == [Skipped(path, "", "it has 0 objects, its head says 12")]


def test_a_house_without_regions_is_refused_with_a_sentence(write: Write) -> None:
    with pytest.raises(DataError, match="has no region"):
        read(write(regions=[]))


def test_the_reviewed_labels_lead_to_the_papers_categories() -> None:
    named = {category for category in categories_of("matterport").values() if category}
    assert named <= {category.name for category in PAPER_CATEGORIES}
    # The 41 classes of the data set, by the name of the table that it publishes.
    classes = """void wall floor chair door table picture cabinet cushion window sofa bed curtain
        chest_of_drawers plant sink stairs ceiling toilet stool towel mirror tv_monitor shower
        column bathtub counter fireplace lighting beam railing shelving blinds gym_equipment seating
        board_panel furniture appliances clothes objects misc unlabeled"""
    assert set(classes.split()) <= categories_of("matterport").keys()
