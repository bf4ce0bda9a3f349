"""Scene files: what goes in comes out, and what is wrong is refused in words that help."""

from __future__ import annotations

import json
from math import pi
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from scenegen_core.errors import SceneError
from scenegen_core.scene.files import read_scene, write_scene
from scenegen_core.scene.model import Box, Opening, Room, Scene

LIVING_ROOM = (Path(__file__).parents[1] / "fixtures/living_room.json").read_bytes()

coordinates = st.floats(-1000, 1000)
lengths = st.floats(0, 100, exclude_min=True)
names = st.text(max_size=40)
boxes = st.builds(
    Box,
    id=st.text(min_size=1, max_size=20),
    category=st.text(min_size=1, max_size=20),
    center=st.tuples(coordinates, coordinates, coordinates),
    size=st.tuples(lengths, lengths, lengths),
    heading=st.floats(-100, 100),
    label=names,
    front_known=st.booleans(),
    front_from_wall=st.booleans(),
    parent=st.none() | st.text(min_size=1, max_size=20),
    placed=st.booleans(),
    item=st.none() | st.text(min_size=1, max_size=20),
)
openings = st.builds(
    Opening,
    start=st.tuples(coordinates, coordinates),
    end=st.tuples(coordinates, coordinates),
    bottom=st.floats(0, 1),
    top=st.floats(1.1, 3),
    id=st.text(min_size=1, max_size=20),
)
rooms = st.builds(
    lambda x, y, width, depth, **rest: Room(
        corners=((x, y), (x + width, y), (x + width, y + depth), (x, y + depth)), **rest
    ),
    *(st.floats(-100, 100), st.floats(-100, 100), st.floats(1, 50), st.floats(1, 50)),
    height=lengths,
    doors=st.lists(openings, max_size=3).map(tuple),
    windows=st.lists(openings, max_size=3).map(tuple),
    room_type=names,
)
scenes = st.builds(
    Scene,
    room=rooms,
    boxes=st.lists(boxes, max_size=5, unique_by=lambda box: box.id).map(tuple),
    id=names,
    name=names,
    source=names,
)


def written(**changes: Any) -> bytes:
    """The file of a square room with one bed, its fields changed."""
    record: dict[str, Any] = {
        "format": "scenegen.scene",
        "version": 1,
        "room": {"corners": [[0, 0], [4, 0], [4, 4], [0, 4]]},
        "boxes": [bed()],
    }
    return json.dumps(record | changes).encode()


def bed(**changes: Any) -> dict[str, Any]:
    return {"id": "bed", "category": "Bed", "center": [1, 2, 0.3], "size": [2, 1.4, 0.6]} | changes


def outline(*corners: Any) -> bytes:
    return written(room={"corners": corners})


@given(scene=scenes)
def test_a_scene_that_is_written_and_read_is_the_same(scene: Scene) -> None:
    assert read_scene(write_scene(scene)) == scene


def test_a_file_that_is_read_and_written_is_the_same() -> None:
    assert json.loads(write_scene(read_scene(LIVING_ROOM))) == json.loads(LIVING_ROOM)


def test_the_smallest_file_has_usual_values_for_the_rest() -> None:
    scene = read_scene(
        b'{"format":"scenegen.scene","version":1,"room":{"corners":[[0,0],[1,0],[1,1]]}}'
    )
    assert scene == Scene(Room(((0, 0), (1, 0), (1, 1)), height=2.6))


def test_a_box_is_what_the_file_says() -> None:
    box = bed(heading=pi / 2, label="Futon", front_known=False, parent="rug")
    assert read_scene(written(boxes=[box]))["bed"] == Box(
        "bed", "Bed", (1, 2, 0.3), (2, 1.4, 0.6), pi / 2, "Futon", front_known=False, parent="rug"
    )


def test_categories_are_data_so_a_file_may_have_its_own() -> None:
    assert read_scene(written(boxes=[bed(category="Aquarium")]))["bed"].category == "Aquarium"


def test_an_outline_is_turned_anticlockwise() -> None:
    corners = read_scene(outline([0, 0], [0, 4], [4, 4], [4, 0])).room.corners
    assert corners == ((4, 0), (4, 4), (0, 4), (0, 0))


def test_a_repeated_corner_is_one_corner() -> None:
    corners = read_scene(outline([0, 0], [4, 0], [4, 0], [4, 4], [0, 0])).room.corners
    assert corners == ((0, 0), (4, 0), (4, 4))


BAD: dict[str, tuple[bytes, str]] = {
    "an open outline": (outline([0, 0], [4, 0]), r"length >= 3 - at `\$.room.corners`"),
    "an outline that closes on its second corner": (
        outline([0, 0], [4, 0], [0, 0]),
        "fewer than three corners; add some",
    ),
    "a self-crossing outline": (
        outline([0, 0], [4, 4], [4, 0], [0, 4]),
        r"crosses or touches itself \(Self-intersection\[2 2\]\); move the corners",
    ),
    "an outline of one corner": (outline([1, 1], [1, 1], [1, 1]), "fewer than three corners"),
    "a flat outline": (outline([0, 0], [4, 0], [8, 0]), "move the corners|check the outline"),
    "an outline in kilometres": (
        outline([0, 0], [0.004, 0], [0.004, 0.004], [0, 0.004]),
        r"only 0\.00 m² of floor; check the outline \(metres\)",
    ),
    "an outline of 300 corners": (
        outline(*([i, i * i / 1000] for i in range(300))),
        r"length <= 200 - at `\$.room.corners`",
    ),
    "a corner with a height": (outline([0, 0, 0], [4, 0, 0], [4, 4, 0]), "at `.*corners"),
    "a corner on the moon": (outline([0, 0], [3e8, 0], [4, 4]), "<= 1000"),
    "a size of zero": (
        written(boxes=[bed(size=[0, 1, 1])]),
        r"> 0(\.0)? - at `\$.boxes\[0\].size\[0\]`",
    ),
    "a negative size": (
        written(boxes=[bed(size=[1, 1, -1])]),
        r"> 0(\.0)? - at `\$.boxes\[0\].size\[2\]`",
    ),
    "a huge size": (
        written(boxes=[bed(size=[1e30, 1, 1])]),
        r"<= 100(\.0)? - at `\$.boxes\[0\].size\[0\]`",
    ),
    "a number that is none": (written(boxes=[bed(center=[0, 0, float("nan")])]), "Save it again"),
    "an infinite number": (written(boxes=[bed(heading=float("inf"))]), "Save it again"),
    "a number beyond all numbers": (written().replace(b"0.3", b"1e999"), "out of range"),
    "a number in words": (written(boxes=[bed(heading="north")]), r"at `\$.boxes\[0\].heading`"),
    "an unknown field": (
        written(boxes=[bed(colour="red")]),
        r"unknown field `colour` - at `\$.boxes\[0\]`",
    ),
    "an unknown field of the scene": (written(author="me"), "unknown field `author`"),
    "a box without a center": (written(boxes=[{"id": "a", "category": "Bed"}]), "`center`"),
    "a box without a name": (written(boxes=[bed(id="")]), r"length >= 1 - at `\$.boxes\[0\].id`"),
    "half a file": (LIVING_ROOM[: len(LIVING_ROOM) // 2], "not a scene file.*Save it again"),
    "an empty file": (b"", "not a scene file.*Save it again"),
    "a picture": (b"\x89PNG\r\n\x1a\n\x00\x00\x00\rIHDR", "not a scene file"),
    "bytes that are no text": (b'{"format": "\xff\xfe"}', "not a scene file"),
    "a label that is no text": (
        written(boxes=[bed(label="bed?")]).replace(b"bed?", b"\xff\xfe"),
        "The scene file is wrong",
    ),
    "a list": (b"[1, 2, 3]", "not a scene file"),
    "very deep nesting": (b'{"format":' + b"[" * 100_000, "not a scene file"),
    "another program's file": (b'{"asset": {"version": "2.0"}}', "format is not 'scenegen.scene'"),
    "another format": (written(format="scenegen.knowledge"), "format is not 'scenegen.scene'"),
    "a newer version": (written(version=2), "has version 2; this program reads version 1"),
    "a version in words": (written(version="one"), "not a scene file"),
    "10,000 boxes": (
        written(boxes=[bed(id=str(i)) for i in range(10_000)]),
        r"length <= 500 - at `\$.boxes`",
    ),
    "two boxes of one id": (
        written(boxes=[bed(), bed()]),
        "Two boxes have the id 'bed'; give each",
    ),
    "a door upside down": (
        written(
            room={
                "corners": [[0, 0], [4, 0], [4, 4]],
                "doors": [{"id": "d", "start": [1, 0], "end": [2, 0], "bottom": 2, "top": 1}],
            }
        ),
        "opening 'd' ends below where it begins; swap the heights",
    ),
}


@pytest.mark.parametrize("case", BAD)
def test_a_bad_file_is_refused_in_words_that_help(case: str) -> None:
    content, words = BAD[case]
    with pytest.raises(SceneError, match=words):
        read_scene(content)


@given(content=st.binary(max_size=200))
def test_noise_is_refused(content: bytes) -> None:
    with pytest.raises(SceneError):
        read_scene(content)


@given(cut=st.integers(0, len(LIVING_ROOM) - 3))
def test_a_file_cut_off_anywhere_is_refused(cut: int) -> None:
    with pytest.raises(SceneError):
        read_scene(LIVING_ROOM[:cut])
