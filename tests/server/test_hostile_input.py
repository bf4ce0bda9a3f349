"""What breaks other servers: each frame is refused in words, and the room goes on."""

from __future__ import annotations

import json
from collections.abc import Iterator
from contextlib import contextmanager, suppress

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st
from websockets.exceptions import ConnectionClosed, InvalidStatus
from websockets.typing import Origin

from scenegen_core.scene.files import SceneRecord
from server.protocol import (
    CLOSE_TOO_MANY_ERRORS,
    MAX_ERRORS,
    MAX_MESSAGES_A_SECOND,
    Ack,
    ClientMessage,
    Hello,
    Models,
    Ping,
    Pong,
    Problem,
    PutBoxes,
    PutScene,
    Welcome,
)
from server.wire import decode
from tests.server.driving import ROOM, SCENE, TABLE, Page, closed, page

BOX = {"id": "b", "category": "Table", "center": [1, 1, 0.4], "size": [1, 1, 0.8]}
CROSSING = [[0, 0], [4, 4], [4, 0], [0, 4]]


def put_boxes(**changes: object) -> str:
    return json.dumps({"type": "put_boxes", "seq": 5, "boxes": [BOX | changes]})


def put_scene(*, corners: object, boxes: int = 0) -> str:
    many = [BOX | {"id": str(i)} for i in range(boxes)]
    scene = {"room": {"corners": corners}, "boxes": many}
    return json.dumps({"type": "put_scene", "seq": 5, "scene": scene}, separators=(",", ":"))


SQUARE = [[0, 0], [4, 0], [4, 4], [0, 4]]
BAD_FRAMES = {
    "NaN": (put_boxes(center=[1, float("nan"), 0]), "bad_json", None, None),
    "infinity": (put_boxes(center=[1, float("inf"), 0]), "bad_json", None, None),
    "half a JSON": (put_boxes()[:40], "bad_json", None, None),
    "nothing": ("", "bad_json", None, None),
    "deep nesting": ('{"seq":' + "[" * 100_000, "bad_json", None, None),
    "half an unknown message": ('{"type":"photo"', "bad_message", "$.type", None),
    "a large number": (
        put_boxes(heading=0)[:-3] + ".1e999}]}", "bad_message", "$.boxes[0].heading", 5
    ),
    "far away": (put_boxes(center=[1, 1e6, 0]), "bad_message", "$.boxes[0].center[1]", 5),
    "no size": (put_boxes(size=[1, 0, 1]), "bad_message", "$.boxes[0].size[1]", 5),
    "a huge size": (put_boxes(size=[1, 1, 1e9]), "bad_message", "$.boxes[0].size[2]", 5),
    "two numbers for three": (put_boxes(size=[1, 1]), "bad_message", "$.boxes[0].size", 5),
    "a text for a number": (put_boxes(heading="north"), "bad_message", "$.boxes[0].heading", 5),
    "an unknown field": (put_boxes(photo="AAAA"), "bad_message", "$.boxes[0]", 5),
    "an unknown message": ('{"type":"photo"}', "bad_message", "$.type", None),
    "no message": ("[]", "bad_message", "$", None),
    "a bad number of an edit": ('{"type":"put_boxes","seq":-1}', "bad_message", "$.seq", None),
    "an unknown category": (put_boxes(category="Ship"), "bad_scene", "$.boxes[0].category", 5),
    "a crossing outline": (put_scene(corners=CROSSING), "bad_scene", "$.scene", 5),
    "two corners": (put_scene(corners=SQUARE[:2]), "bad_message", "$.scene.room.corners", 5),
    "a line of a room": (put_scene(corners=[[0, 0], [4, 0], [8, 0]]), "bad_scene", "$.scene", 5),
    "10,000 boxes": (put_scene(corners=SQUARE, boxes=10_000), "too_many_boxes", "$.scene.boxes", 5),
    "501 boxes": (put_scene(corners=SQUARE, boxes=501), "too_many_boxes", "$.scene.boxes", 5),
    "a long text": (put_boxes(label="x" * 1_000_001), "too_large", None, None),
    "bytes": (b"\x89PNG\r\n", "bad_message", None, None),
}  # fmt: skip


KEYS = st.sampled_from(["type", "seq", "box", "scene", "room", "id", "center", "query", "nonce"])
LEAVES = st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=5)
ANYTHING = st.recursive(
    LEAVES | st.sampled_from(["put_boxes", "put_scene", "ask", "ping"]),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(KEYS, inner, max_size=4),
)


@given(ANYTHING.map(json.dumps) | st.text() | ANYTHING.map(lambda value: json.dumps(value)[:-1]))
def test_any_text_is_a_message_or_a_problem_in_words(text: str) -> None:
    decoded = decode(text)
    if isinstance(decoded, Problem):
        assert decoded.text.endswith(".")
    else:
        assert msgspec.json.decode(text, type=ClientMessage) == decoded


@contextmanager
def drawn(url: str) -> Iterator[Page]:
    """A page whose room the server holds in revision 1."""
    with page(url) as here:
        here.open()
        here.until(Ack)
        yield here


@pytest.mark.parametrize(
    ("frame", "code", "path", "seq"), BAD_FRAMES.values(), ids=BAD_FRAMES.keys()
)
def test_a_bad_frame_is_refused_with_its_path_and_nothing_changes(
    url: str, frame: str | bytes, code: str, path: str | None, seq: int | None
) -> None:
    with drawn(url) as here:
        here.socket.send(frame)
        problem = here.until(Problem)
        assert (problem.code, problem.path, problem.seq) == (code, path, seq)
        assert problem.text.endswith(".")
        here.send(PutBoxes(seq=6, boxes=(TABLE,)))
        assert here.until(Ack) == Ack(seq=6, revision=2)


def test_a_frame_of_100_mb_closes_the_socket_and_the_room_can_be_resumed(url: str) -> None:
    with page(url) as here:
        session = here.open().session
        here.until(Models)
        with suppress(ConnectionClosed):  # the server may hang up before it has read everything
            here.socket.send("x" * 100_000_000)
        with pytest.raises(ConnectionClosed):
            here.next()
    with page(url) as again:
        again.send(Hello(session=session, revision=1))
        assert again.until(Welcome).resumed


def test_too_many_bad_frames_close_the_socket_with_a_sentence(url: str) -> None:
    with drawn(url) as here:
        for _ in range(MAX_ERRORS):
            here.socket.send("no")
        problems = [here.until(Problem).code for _ in range(MAX_ERRORS)]
        assert problems == ["bad_json"] * MAX_ERRORS
        code, reason = closed(here)
    assert code == CLOSE_TOO_MANY_ERRORS
    assert "reload" in reason


def test_refused_edits_do_not_count_as_bad_frames(url: str) -> None:
    """A corner that is dragged across a wall gives many bad outlines in a row."""
    with drawn(url) as here:
        for _ in range(MAX_ERRORS + 1):
            here.socket.send(put_scene(corners=CROSSING))
            assert here.until(Problem).code == "bad_scene"
        here.send(Ping(nonce=1))
        assert here.until(Pong).nonce == 1


def test_messages_that_come_too_fast_are_refused_with_their_number(url: str) -> None:
    with drawn(url) as here:
        for seq in range(3 * MAX_MESSAGES_A_SECOND):
            try:
                here.send(PutBoxes(seq=seq, boxes=(TABLE,)))
            except ConnectionClosed:
                break
        problem = here.until(Problem)
        assert problem.code == "too_fast"
        assert problem.seq is not None
        assert closed(here)[0] == CLOSE_TOO_MANY_ERRORS


def test_the_largest_room_that_is_allowed_is_taken(url: str) -> None:
    boxes = tuple(msgspec.structs.replace(TABLE, id=f"table {i}") for i in range(500))
    with drawn(url) as here:
        here.send(PutScene(seq=2, scene=SceneRecord(room=ROOM, boxes=boxes)))
        assert here.until(Ack) == Ack(seq=2, revision=2)


@pytest.mark.parametrize("origin", ["https://elsewhere.example", "null"])
def test_a_page_of_another_site_cannot_open_a_socket(url: str, origin: str) -> None:
    with (
        pytest.raises(InvalidStatus) as error,
        page(url, origin=Origin(origin)),
    ):
        pass
    assert error.value.response.status_code == 403
    assert b"another site" in error.value.response.body


@pytest.mark.parametrize("site", ["http://localhost:5173", "same"])
def test_the_own_page_and_pages_of_this_machine_can(url: str, site: str) -> None:
    origin = url.replace("ws:", "http:") if site == "same" else site
    with page(url, origin=Origin(origin)) as here:
        here.open(SCENE)
        assert here.until(Ack).seq == 1
