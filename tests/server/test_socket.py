"""A real server and its socket: what a page experiences."""

from __future__ import annotations

import sqlite3
from pathlib import Path

import msgspec
import numpy as np
import pytest

from scenegen_core.scene.files import BoxRecord, SceneRecord
from server.protocol import (
    CLOSE_REPLACED,
    CLOSE_TOO_MANY_SESSIONS,
    CLOSE_WRONG_PROTOCOL,
    MAX_SESSIONS_AN_ADDRESS,
    Ack,
    Answer,
    Ask,
    AssetHeader,
    Graph,
    HeatMapHeader,
    Hello,
    Inspect,
    Inspected,
    Models,
    Ping,
    Pong,
    Problem,
    PutBoxes,
    PutRoom,
    PutScene,
    Query,
    RemoveBox,
    WatchGraph,
    Welcome,
)
from server.settings import Settings
from server.world import World
from tests.server.driving import ROOM, SCENE, TABLE, closed, page, serving

SOFA = Ask(id="sofa", query=Query(category="Sofa"))


def test_a_new_page_is_welcomed_with_what_it_can_draw_and_open(url: str) -> None:
    with page(url) as here:
        here.send(Hello())
        welcome = here.until(Welcome)
    assert not welcome.resumed
    assert welcome.scene is None
    names = {info.name for info in welcome.categories if info.placeable}
    assert names == {"Bed", "Chair", "Decor", "Picture", "Sofa", "Storage", "Table", "TV"}
    assert [(room.id, room.kind) for room in welcome.rooms] == [
        ("living-room", "sample"),
        ("scan", "scan"),
    ]


def test_every_edit_is_acknowledged_and_its_furniture_pushed_once(url: str) -> None:
    with page(url) as here:
        here.open()
        assert here.until(Ack) == Ack(seq=1, revision=1)
        digest = here.until(Models).boxes["table"]
        (header, glb), = here.frames  # fmt: skip
        assert header == AssetHeader(digest=digest)
        assert glb[:4] == b"glTF"
        twin = msgspec.structs.replace(TABLE, id="twin", center=(1.0, 1.0, 0.35))
        here.send(PutBoxes(seq=2, boxes=(twin,)))
        assert here.until(Ack) == Ack(seq=2, revision=2)
        assert here.until(Models).boxes == {"twin": digest}
        assert len(here.frames) == 1


def test_an_answer_comes_with_its_maps_its_model_and_the_revision(url: str) -> None:
    with page(url) as here:
        here.open()
        here.send(SOFA)
        answer = here.until(Answer)
        assert (answer.ask, answer.revision, answer.category) == ("sofa", 1, "Sofa")
        assert [placement.rank for placement in answer.placements] == [1, 2, 3, 4, 5]
        assert AssetHeader(digest=answer.asset) in [header for header, _ in here.frames]
        maps = [(h, data) for h, data in here.frames if isinstance(h, HeatMapHeader)]
        assert [(h.ask, h.revision, h.surface) for h, _ in maps] == [("sofa", 1, "floor")]


def test_row_0_of_the_map_lies_at_the_smallest_y_and_column_0_at_the_smallest_x(url: str) -> None:
    """A wardrobe fills the south east of the room: nobody can stand there."""
    wardrobe = BoxRecord(id="w", category="Storage", center=(4.0, 1.0, 1.0), size=(2.0, 2.0, 2.0))
    with page(url) as here:
        here.open(SceneRecord(room=ROOM, boxes=(wardrobe,)))
        here.send(Ask(id="chair", query=Query(category="Chair")))
        here.until(Answer)
    header, data = next((h, data) for h, data in here.frames if isinstance(h, HeatMapHeader))
    values = np.frombuffer(data, np.uint8).reshape(header.shape)
    rows, columns = np.nonzero(values)
    x = header.origin[0] + (columns + 0.5) * header.cell
    y = header.origin[1] + (rows + 0.5) * header.cell
    assert not np.any((x > 3) & (y < 2))
    for east, north in ((True, True), (False, True), (False, False)):
        assert np.any(((x > 2.5) == east) & ((y > 2) == north))


def test_an_ask_is_answered_again_after_an_edit(url: str) -> None:
    with page(url) as here:
        here.open()
        here.send(SOFA)
        assert here.until(Answer).revision == 1
        here.send(RemoveBox(seq=2, id="table"))
        assert here.until(Answer).revision == 2


def test_a_pose_is_inspected_for_the_current_ask(url: str) -> None:
    with page(url) as here:
        here.open()
        here.send(SOFA, Inspect(id="outside", center=(9.0, 9.0, 0.4), heading=0.0))
        outside = here.until(Inspected)
        assert (outside.id, outside.ask, outside.allowed) == ("outside", "sofa", False)
        here.send(SOFA)
        best = here.until(Answer).placements[0]
        here.send(Inspect(id="best", center=best.center, heading=best.heading))
        inspected = here.until(Inspected)
        assert inspected.allowed
        assert inspected.score == pytest.approx(best.score, abs=1e-6)


def test_the_graph_names_the_boxes_of_the_room(url: str) -> None:
    with page(url) as here:
        here.open()
        here.send(WatchGraph(on=True))
        graph = here.until(Graph)
    assert {"object:table", "group:Table", "room"} <= {node.id for node in graph.nodes}


def test_a_ping_is_answered(url: str) -> None:
    with page(url) as here:
        here.open()
        here.send(Ping(nonce=17))
        assert here.until(Pong).nonce == 17


def test_a_page_goes_on_with_its_session_after_its_socket_dropped(url: str) -> None:
    with page(url) as before:
        session = before.open().session
        before.until(Ack)
        digest = before.until(Models).boxes["table"]
    with page(url) as here:
        here.send(Hello(session=session, revision=1, assets=(digest,)))
        welcome = here.until(Welcome)
        assert (welcome.resumed, welcome.revision, welcome.scene) == (True, 1, None)
        assert here.until(Models).boxes == {"table": digest}
        assert here.frames == []
    with page(url) as forgetful:
        forgetful.send(Hello(session=session, revision=0))
        assert forgetful.until(Welcome).scene == SCENE


def test_an_unknown_session_is_a_new_one(url: str) -> None:
    with page(url) as here:
        here.send(Hello(session="lost", revision=9))
        welcome = here.until(Welcome)
    assert (welcome.resumed, welcome.revision) == (False, 0)
    assert welcome.session != "lost"


def test_sessions_come_back_after_the_server_was_restarted(
    world: World, page_files: Path, tmp_path: Path
) -> None:
    settings = Settings(port=0, store=tmp_path / "sessions.sqlite3", page=page_files)
    with serving(settings, world) as url, page(url) as before:
        session = before.open().session
        before.send(RemoveBox(seq=2, id="table"))
        while before.until(Ack).seq < 2:
            pass
    with serving(settings, world) as url, page(url) as here:
        here.send(Hello(session=session, revision=1))
        welcome = here.until(Welcome)
        assert (welcome.resumed, welcome.revision) == (True, 2)
        assert welcome.scene == SceneRecord(room=ROOM)


def test_a_second_socket_of_a_session_replaces_the_first(url: str) -> None:
    with page(url) as first:
        session = first.open().session
        first.until(Ack)
        with page(url) as second:
            second.send(Hello(session=session, revision=1))
            assert second.until(Welcome).resumed
            code, reason = closed(first)
            assert code == CLOSE_REPLACED
            assert "elsewhere" in reason
            second.send(RemoveBox(seq=2, id="table"))
            assert second.until(Ack) == Ack(seq=2, revision=2)


def test_of_two_servers_with_one_store_the_one_with_the_newer_room_goes_on(
    world: World, page_files: Path, tmp_path: Path
) -> None:
    settings = Settings(port=0, store=tmp_path / "sessions.sqlite3", page=page_files)
    with serving(settings, world) as url, page(url) as first:
        session = first.open().session
        first.until(Ack)
        with serving(settings, world) as other, page(other) as second:
            second.send(Hello(session=session, revision=1))
            assert second.until(Welcome).resumed
            second.send(RemoveBox(seq=2, id="table"))
            assert second.until(Ack) == Ack(seq=2, revision=2)
            first.send(PutRoom(seq=2, room=ROOM))
            code, reason = closed(first)
            assert code == CLOSE_REPLACED
            assert "elsewhere" in reason
            second.send(RemoveBox(seq=3, id="table"))
            assert second.until(Ack) == Ack(seq=3, revision=3)


def test_a_session_survives_that_its_first_socket_ends_after_its_second(url: str) -> None:
    with page(url) as first:
        session = first.open().session
        first.until(Ack)
        with page(url) as second:
            second.send(Hello(session=session, revision=1))
            second.until(Welcome)
        closed(first)
    with page(url) as third:
        third.send(Hello(session=session, revision=1))
        assert third.until(Welcome).resumed


def test_an_edit_that_cannot_be_stored_is_not_acknowledged(
    world: World, page_files: Path, tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    settings = Settings(port=0, store=tmp_path / "sessions.sqlite3", page=page_files)
    with serving(settings, world) as url, page(url) as here:
        here.open()
        assert here.until(Ack).seq == 1
        with sqlite3.connect(settings.store) as database:
            database.execute("DROP TABLE sessions")
        database.close()
        here.send(RemoveBox(seq=2, id="table"), Ping(nonce=1))
        problem = here.until(Problem)
        assert (problem.code, problem.seq) == ("internal", 2)
        assert here.until(Pong).nonce == 1
    assert "no such table" in caplog.text


def test_another_version_of_the_page_is_told_to_reload(url: str) -> None:
    with page(url, subprotocol="scenegen.0") as old:
        code, reason = closed(old)
    assert code == CLOSE_WRONG_PROTOCOL
    assert "reload" in reason


def test_too_many_pages_from_one_address_are_turned_away_one_by_one(
    world: World, page_files: Path, tmp_path: Path
) -> None:
    settings = Settings(port=0, store=tmp_path / "sessions.sqlite3", page=page_files)
    with serving(settings, world) as url:
        opened = [page(url) for _ in range(MAX_SESSIONS_AN_ADDRESS)]
        for each in opened:
            here = each.__enter__()
            here.send(Ping(nonce=1))
            here.next()
        with page(url) as refused:
            assert closed(refused)[0] == CLOSE_TOO_MANY_SESSIONS
        opened.pop().__exit__(None, None, None)
        with page(url) as accepted:
            accepted.send(Hello())
            accepted.until(Welcome)
        for each in opened:
            each.__exit__(None, None, None)


def test_a_slow_reader_gets_every_acknowledgement_but_only_the_newest_results(url: str) -> None:
    """It does not read while it edits; what waits for it meanwhile does not grow."""
    boxes = tuple(
        msgspec.structs.replace(TABLE, id=f"b{i}", center=(i % 5 + 0.5, i // 5 + 0.5, 0.35))
        for i in range(20)
    )
    edits = 60
    with page(url) as slow:
        slow.open(SceneRecord(room=ROOM, boxes=boxes))
        slow.send(WatchGraph(on=True), SOFA)
        for i in range(edits):
            slow.send(PutBoxes(seq=i + 2, boxes=(boxes[i % 20],)))
        last = edits + 1
        acks: list[int] = []
        graphs: list[int] = []
        answers: list[int] = []
        while graphs[-1:] != [last] or answers[-1:] != [last]:
            match slow.next():
                case Ack(seq=seq):
                    acks.append(seq)
                case Graph(revision=revision):
                    graphs.append(revision)
                case Answer(revision=revision):
                    answers.append(revision)
                case _:
                    pass
    assert acks == [*range(1, edits + 2)]
    assert len(graphs) + len(answers) < edits
    assert graphs == sorted(graphs)
    assert answers == sorted(answers)


def test_hello_comes_first(url: str) -> None:
    with page(url) as here:
        here.send(PutScene(seq=1, scene=SCENE))
        assert "hello" in str(here.next())
        here.open()
        assert here.until(Ack).seq == 1


def test_a_large_message_may_come_in_pieces(url: str) -> None:
    text = msgspec.json.encode(PutScene(seq=1, scene=SCENE)).decode()
    with page(url) as here:
        here.send(Hello())
        here.socket.send(text[i : i + 40] for i in range(0, len(text), 40))
        assert here.until(Ack) == Ack(seq=1, revision=1)
