"""What a session does with each message, without sockets and threads."""

from __future__ import annotations

from dataclasses import replace

import msgspec
import pytest

from scenegen_core.placement.answer import Query as CoreQuery
from scenegen_core.placement.answer import Remedy as CoreRemedy
from scenegen_core.placement.solve import draw, solve
from scenegen_core.scene.files import BoxRecord, RoomRecord, SceneRecord, scene_of
from server.edits import Vocabulary
from server.effects import (
    DrawGraph,
    Effect,
    Examine,
    FindRemedy,
    Furnish,
    Offer,
    Push,
    Save,
    Send,
    Solve,
    StopSolving,
    StopWeighing,
    Weigh,
)
from server.looks import look_of
from server.protocol import (
    Ack,
    Answer,
    Ask,
    ClientMessage,
    Graph,
    Hello,
    Inspect,
    Inspected,
    Maps,
    Matters,
    Models,
    NoGoodPlace,
    Ping,
    Pong,
    Problem,
    PutBoxes,
    PutRoom,
    PutScene,
    Query,
    Remedy,
    RemoveBox,
    WatchGraph,
    Welcome,
    WhatMatters,
)
from server.results import (
    Drawn,
    Furnished,
    Remedied,
    Solved,
    drawn,
    examined,
    furnished,
    graphed,
    remedied,
    solved,
    weighed,
)
from server.session import Session, greet, handle
from server.translate import heat_map_frame, with_remedy
from server.world import World
from tests.server.driving import ROOM, SCENE, TABLE

WORDS = Vocabulary(categories=("Table", "Sofa", "Other"), placeable=("Table", "Sofa"), items=())
LISTS = Welcome("", 0, False, None, (), (), (), ("paper",))
DRAWN = Session(id="s", revision=4, scene=scene_of(SCENE))
SOFA = Ask(id="a", query=Query(category="Sofa"))
CROSSING = RoomRecord(corners=((0.0, 0.0), (4.0, 4.0), (4.0, 0.0), (0.0, 4.0)))
DIGEST, OTHER_DIGEST = "0" * 32, "1" * 32


def after(session: Session, *messages: ClientMessage) -> tuple[Session, list[Effect]]:
    """The session after messages, and all that it wanted."""
    wanted: list[Effect] = []
    for message in messages:
        session, effects = handle(session, message, WORDS)
        wanted += effects
    return session, wanted


def sent(session: Session, *messages: ClientMessage) -> list[object]:
    """The messages that messages were answered with."""
    _, effects = after(session, *messages)
    return [effect.message for effect in effects if isinstance(effect, Send)]


def kinds(effects: list[Effect]) -> list[type]:
    return [type(effect) for effect in effects]


def test_a_new_page_is_welcomed_and_told_to_upload() -> None:
    session, effects = greet(Session(id="s"), Hello(), lists=LISTS)
    assert effects == (Send(msgspec.structs.replace(LISTS, session="s")),)
    assert session.scene is None


def test_a_page_that_comes_back_up_to_date_gets_no_scene_but_all_models() -> None:
    hello = Hello(session="s", revision=4, assets=(DIGEST,))
    session, effects = greet(DRAWN, hello, lists=LISTS)
    welcome, furnish = effects
    assert isinstance(welcome, Send)
    assert welcome.message == msgspec.structs.replace(LISTS, session="s", revision=4, resumed=True)
    assert furnish == Furnish(4, {"table": look_of(DRAWN.scene["table"])})  # type: ignore[index]
    assert session.assets == {DIGEST}


@pytest.mark.parametrize("hello", [Hello(session="s", revision=3), Hello(session="lost")])
def test_a_page_that_knows_another_revision_gets_the_scene(hello: Hello) -> None:
    _, (welcome, *_) = greet(DRAWN, hello, lists=LISTS)
    assert isinstance(welcome, Send)
    assert isinstance(welcome.message, Welcome)
    assert welcome.message.scene == SCENE
    assert welcome.message.resumed == (hello.session == "s")


def test_an_edit_is_saved_before_it_is_acknowledged_under_the_next_revision() -> None:
    moved = msgspec.structs.replace(TABLE, center=(1.0, 1.0, 0.35))
    session, effects = after(DRAWN, PutBoxes(seq=9, boxes=(moved,)))
    assert session.scene is not None
    assert effects[:2] == [Save("s", 5, session.scene), Send(Ack(seq=9, revision=5))]
    assert session.scene["table"].center == (1.0, 1.0, 0.35)


def test_boxes_that_move_together_make_one_revision_or_none() -> None:
    moved = msgspec.structs.replace(TABLE, center=(1.0, 1.0, 0.35))
    vase = msgspec.structs.replace(TABLE, id="vase", category="Other", center=(1.0, 1.0, 0.8))
    session, effects = after(DRAWN, PutBoxes(seq=9, boxes=(moved, vase)))
    assert session.scene is not None
    assert effects[:2] == [Save("s", 5, session.scene), Send(Ack(seq=9, revision=5))]
    assert session.scene["table"].center == (1.0, 1.0, 0.35)
    assert session.scene["vase"].center == (1.0, 1.0, 0.8)
    ship = msgspec.structs.replace(vase, category="Ship")
    wrong, effects = after(DRAWN, PutBoxes(seq=9, boxes=(moved, ship)))
    assert wrong.scene == DRAWN.scene
    (problem,) = effects
    assert isinstance(problem, Send)
    assert isinstance(problem.message, Problem)
    assert problem.message.path == "$.boxes[1].category"


def test_edits_add_up_to_the_scene_of_the_page() -> None:
    chair = BoxRecord(id="chair", category="Other", center=(1.0, 1.0, 0.5), size=(0.5, 0.5, 1.0))
    large = RoomRecord(corners=((0.0, 0.0), (9.0, 0.0), (9.0, 9.0), (0.0, 9.0)))
    session, _ = after(
        Session(id="s"),
        PutRoom(seq=1, room=ROOM),
        PutBoxes(seq=2, boxes=(chair,)),
        PutBoxes(seq=3, boxes=(TABLE,)),
        RemoveBox(seq=4, id="chair"),
        RemoveBox(seq=5, id="never there"),
        PutRoom(seq=6, room=large),
    )
    assert session.scene == scene_of(SceneRecord(room=large, boxes=(TABLE,)))
    assert session.revision == 6


def test_a_box_outside_the_room_is_taken() -> None:
    outside = msgspec.structs.replace(TABLE, id="far", center=(50.0, -3.0, 0.35))
    assert sent(DRAWN, PutBoxes(seq=1, boxes=(outside,))) == [Ack(seq=1, revision=5)]


def test_a_box_without_a_room_is_refused_with_what_to_do() -> None:
    assert sent(Session(id="s"), PutBoxes(seq=1, boxes=(TABLE,))) == [
        Problem("bad_scene", "There is no room yet; draw its walls first.", "$.boxes", 1)
    ]


def test_a_box_can_be_removed_from_no_room() -> None:
    assert sent(Session(id="s"), RemoveBox(seq=1, id="b")) == [Ack(seq=1, revision=0)]


def test_an_outline_that_crosses_itself_is_refused_and_nothing_changes() -> None:
    session, effects = after(DRAWN, PutRoom(seq=7, room=CROSSING))
    assert session == DRAWN
    (effect,) = effects
    assert isinstance(effect, Send)
    assert isinstance(effect.message, Problem)
    assert (effect.message.code, effect.message.path, effect.message.seq) == (
        "bad_scene", "$.room", 7,
    )  # fmt: skip
    assert "walls do not cross" in effect.message.text


def test_an_unknown_category_is_refused_with_the_list_of_those_there_are() -> None:
    spaceship = msgspec.structs.replace(TABLE, id="x", category="Spaceship")
    scene = SceneRecord(room=ROOM, boxes=(TABLE, spaceship))
    text = "There is no category 'Spaceship'; choose one of Table, Sofa, Other."
    assert sent(DRAWN, PutBoxes(seq=1, boxes=(spaceship,)), PutScene(seq=2, scene=scene)) == [
        Problem("bad_scene", text, "$.boxes[0].category", 1),
        Problem("bad_scene", text, "$.scene.boxes[1].category", 2),
    ]


def test_two_boxes_of_one_id_are_refused() -> None:
    (problem,) = sent(DRAWN, PutScene(seq=1, scene=SceneRecord(room=ROOM, boxes=(TABLE, TABLE))))
    assert isinstance(problem, Problem)
    assert problem.path == "$.scene"


def test_the_501st_box_is_refused() -> None:
    boxes = tuple(msgspec.structs.replace(TABLE, id=f"table {i}") for i in range(500))
    full = Session(id="s", scene=scene_of(SceneRecord(room=ROOM, boxes=boxes)))
    replies = sent(full, PutBoxes(seq=1, boxes=(boxes[7],)), PutBoxes(seq=2, boxes=(TABLE,)))
    assert replies[0] == Ack(seq=1, revision=1)
    assert isinstance(replies[1], Problem)
    assert (replies[1].code, replies[1].seq) == ("too_many_boxes", 2)


def test_an_ask_is_answered_now_and_after_every_edit_until_it_stops() -> None:
    session, effects = after(
        DRAWN,
        SOFA,
        PutBoxes(seq=1, boxes=(TABLE,)),
        Ask(id="b", query=None),
        RemoveBox(seq=2, id="x"),
    )
    solves = [effect for effect in effects if isinstance(effect, Solve)]
    assert [(solve.ask, solve.revision) for solve in solves] == [("a", 4), ("a", 5)]
    assert StopSolving() in effects
    assert session.ask is None


def test_an_ask_before_there_is_a_room_is_answered_once_there_is_one() -> None:
    session, effects = after(Session(id="s"), SOFA)
    assert effects == []
    _, effects = after(session, PutRoom(seq=1, room=ROOM))
    assert Solve in kinds(effects)


@pytest.mark.parametrize(
    ("query", "path"),
    [
        (Query(category="Spaceship"), "$.query.category"),
        (Query(category="Other"), "$.query.category"),
        (Query(category="Sofa", item="gone"), "$.query.item"),
    ],
)
def test_a_query_that_cannot_be_answered_is_refused_and_the_old_one_stays(
    query: Query, path: str
) -> None:
    session, _ = after(DRAWN, SOFA)
    refused, effects = after(session, Ask(id="b", query=query))
    assert refused == session
    (effect,) = effects
    assert isinstance(effect, Send)
    assert isinstance(effect.message, Problem)
    assert (effect.message.code, effect.message.path) == ("bad_query", path)


def test_the_graph_is_drawn_now_and_after_every_edit_while_it_is_watched() -> None:
    _, effects = after(
        DRAWN,
        WatchGraph(on=True),
        PutBoxes(seq=1, boxes=(TABLE,)),
        WatchGraph(on=False),
        PutBoxes(seq=2, boxes=(TABLE,)),
    )
    graphs = [effect for effect in effects if isinstance(effect, DrawGraph)]
    assert [graph.revision for graph in graphs] == [4, 5]


def test_a_ping_is_answered_with_its_number() -> None:
    assert sent(DRAWN, Ping(nonce=3)) == [Pong(nonce=3)]


def test_a_second_hello_is_refused() -> None:
    (problem,) = sent(DRAWN, Hello())
    assert isinstance(problem, Problem)


def test_a_model_is_made_for_a_new_look_and_not_for_a_new_place() -> None:
    session, effects = after(DRAWN, PutBoxes(seq=1, boxes=(TABLE,)))
    assert Furnish in kinds(effects)
    look = look_of(scene_of(SCENE)["table"])
    session, _ = furnished(session, Furnished(5, {"table": (look, DIGEST)}))
    moved = msgspec.structs.replace(TABLE, center=(1.0, 1.0, 0.35))
    grown = msgspec.structs.replace(TABLE, size=(0.8, 1.5, 0.7))
    assert Furnish not in kinds(after(session, PutBoxes(seq=2, boxes=(moved,)))[1])
    assert Furnish in kinds(after(session, PutBoxes(seq=2, boxes=(grown,)))[1])


def test_less_than_a_centimetre_is_no_new_look() -> None:
    box = scene_of(SCENE)["table"]
    hair = BoxRecord("table", "Table", box.center, (0.801, 1.199, 0.702))
    assert look_of(scene_of(SceneRecord(room=ROOM, boxes=(hair,)))["table"]) == look_of(box)


def test_a_model_is_pushed_once_and_told_again_after_the_box_came_back() -> None:
    result = Furnished(4, {"table": (look_of(scene_of(SCENE)["table"]), DIGEST)})
    models = Send(Models(revision=4, boxes={"table": DIGEST}))
    session, effects = furnished(DRAWN, result)
    assert effects == (Push(DIGEST), models)
    session, _ = after(session, RemoveBox(seq=1, id="table"), PutBoxes(seq=2, boxes=(TABLE,)))
    assert furnished(session, result)[1] == (models,)


def test_models_of_boxes_that_are_gone_or_look_different_by_now_are_dropped() -> None:
    old = Furnished(4, {"table": (look_of(scene_of(SCENE)["table"]), DIGEST)})
    grown = msgspec.structs.replace(TABLE, size=(0.8, 1.5, 0.7))
    for edit in (RemoveBox(seq=1, id="table"), PutBoxes(seq=1, boxes=(grown,))):
        session, _ = after(DRAWN, edit)
        assert furnished(session, old) == (session, ())


@pytest.fixture(scope="module")
def result(world: World) -> Solved:
    """The answer to SOFA in revision 4 of the drawn room."""
    solution = solve(scene_of(SCENE), CoreQuery("Sofa"), world.knowledge)
    answer = Answer("a", 4, "Sofa", (1.0, 2.0, 0.8), DIGEST, (), None, 1.0)
    return Solved(solution, answer)


def test_an_answer_comes_behind_the_model_of_its_object(result: Solved) -> None:
    session, _ = after(DRAWN, SOFA)
    session, effects = solved(session, result)
    assert effects == (Push(DIGEST), Send(result.answer))
    assert session.assets == {DIGEST}


def maps_of(revision: int, world: World) -> Drawn:
    """The maps of SOFA in a revision of the drawn room."""
    drawing = draw(scene_of(SCENE), CoreQuery("Sofa"), world.knowledge)
    wish = Solve("a", Query(category="Sofa"), revision, scene_of(SCENE))
    frame = heat_map_frame(drawing.maps[0], ask="a", revision=revision)
    return Drawn((frame,), Offer(wish, drawing, 0.1))


def test_maps_are_sent_and_then_offers_are_made(world: World) -> None:
    session, _ = after(DRAWN, SOFA)
    maps = maps_of(session.revision, world)
    sent_maps = Send(Maps(ask="a", revision=session.revision), maps.frames)
    assert drawn(session, maps) == (session, (sent_maps, maps.offer))


def test_while_a_box_is_dragged_maps_on_the_way_are_sent_but_no_offers(world: World) -> None:
    session, _ = after(DRAWN, SOFA, PutBoxes(seq=1, boxes=(TABLE,)))
    maps = maps_of(session.revision - 1, world)
    sent_maps = Send(Maps(ask="a", revision=session.revision - 1), maps.frames)
    assert drawn(session, maps) == (session, (sent_maps,))
    for other in (Ask(id="b", query=Query(category="Sofa")), Ask(id="b", query=None)):
        elsewhere, _ = after(session, other)
        assert drawn(elsewhere, maps) == (elsewhere, ())


def test_an_answer_to_an_older_revision_is_dropped(result: Solved) -> None:
    pose = Inspect(id="i", center=(1.0, 1.0, 0.4), heading=0.0)
    session, _ = after(DRAWN, SOFA, PutBoxes(seq=1, boxes=(TABLE,)), pose)
    assert solved(session, result) == (session, ())
    assert session.inspect == pose


def test_an_answer_to_an_older_ask_is_dropped(result: Solved) -> None:
    for messages in (
        (SOFA, Ask(id="b", query=Query(category="Sofa"))),
        (SOFA, Ask(id="b", query=None)),
    ):
        session, _ = after(DRAWN, *messages)
        assert solved(session, result) == (session, ())


def test_of_the_poses_that_wait_for_the_answer_the_newest_is_examined(result: Solved) -> None:
    first = Inspect(id="i", center=(1.0, 1.0, 0.4), heading=0.0)
    newest = Inspect(id="j", center=(2.0, 1.0, 0.4), heading=0.0)
    session, effects = after(DRAWN, SOFA, first, newest)
    assert Examine not in kinds(effects)
    session, deeds = solved(session, result)
    assert deeds[-1] == Examine(result.solution, newest, "a", 4)
    _, effects = after(session, first)
    assert effects == [Examine(result.solution, first, "a", 4)]


def test_inspecting_without_an_ask_is_refused() -> None:
    (problem,) = sent(DRAWN, Inspect(id="i", center=(1.0, 1.0, 0.4), heading=0.0))
    assert isinstance(problem, Problem)
    assert problem.code == "bad_query"


def test_a_pose_examined_in_an_older_scene_is_dropped_and_a_graph_when_unwatched() -> None:
    session, _ = after(DRAWN, SOFA, WatchGraph(on=True))
    fresh = Inspected("i", "a", 4, True, "", None, None, "", (), (), None)
    graph = Graph(revision=4, nodes=(), edges=())
    assert examined(session, fresh)[1] == (Send(fresh),)
    assert graphed(session, graph)[1] == (Send(graph),)
    session, _ = after(session, PutBoxes(seq=1, boxes=(TABLE,)))
    assert examined(session, fresh)[1] == ()
    assert graphed(session, graph)[1] == (Send(graph),)
    session, _ = after(session, WatchGraph(on=False))
    assert graphed(session, graph)[1] == ()


# --- what matters, and what would help ------------------------------------------------------------

WONDER = WhatMatters(id="m")


def test_what_matters_is_weighed_once_the_ask_is_solved(result: Solved) -> None:
    session, effects = after(DRAWN, SOFA, WONDER)
    assert Weigh not in kinds(effects)
    session, deeds = solved(session, result)
    assert SOFA.query is not None
    assert DRAWN.scene is not None
    assert deeds[-1] == Weigh("m", "a", SOFA.query, 4, DRAWN.scene, result.solution)
    told = Matters(id="m", ask="a", revision=4, found=None)
    assert weighed(session, told) == (untroubled(session), (Send(told),))


def untroubled(session: Session) -> Session:
    """The session once the page has been told what matters."""
    return replace(session, weigh=None)


def test_a_newer_question_of_what_matters_replaces_the_older_one(result: Solved) -> None:
    session, _ = after(DRAWN, SOFA)
    session, _ = solved(session, result)
    session, effects = after(session, WONDER, WhatMatters(id="n"))
    assert [effect.question for effect in effects if isinstance(effect, Weigh)] == ["m", "n"]
    assert weighed(session, Matters(id="m", ask="a", revision=4, found=None)) == (session, ())


@pytest.mark.parametrize(
    "message",
    [
        RemoveBox(seq=1, id="table"),
        WhatMatters(id="m", on=False),
        Ask(id="b", query=Query(category="Table")),
        Ask(id="b", query=None),
    ],
)
def test_an_edit_another_ask_or_a_word_of_the_page_ends_the_weighing(
    result: Solved, message: ClientMessage
) -> None:
    session, _ = after(DRAWN, SOFA, WONDER)
    session, _ = solved(session, result)
    session, effects = after(session, message)
    assert StopWeighing() in effects
    assert session.weigh is None


def test_what_matters_without_an_ask_is_refused() -> None:
    (problem,) = sent(DRAWN, WONDER)
    assert isinstance(problem, Problem)
    assert problem.code == "bad_query"


def test_where_there_is_no_place_a_remedy_is_sought_and_the_answer_comes_again(
    result: Solved,
) -> None:
    session, _ = after(DRAWN, SOFA)
    none = NoGoodPlace(rule="room", text="No good place.", remedy=None)
    answer = msgspec.structs.replace(result.answer, no_good_place=none)
    session, deeds = solved(session, Solved(result.solution, answer))
    assert SOFA.query is not None
    assert DRAWN.scene is not None
    assert deeds[-1] == FindRemedy(SOFA.query, DRAWN.scene, answer)
    remedy = Remedy("box", "Without the table.", (1.0, 1.0, 0.4), 0.0, None, "table", None)
    helped = with_remedy(answer, remedy_of(remedy))
    assert helped.no_good_place == msgspec.structs.replace(none, remedy=remedy)
    assert remedied(session, Remedied(helped)) == (session, (Send(helped),))
    assert remedied(session, Remedied(answer)) == (session, ())  # nothing helps
    edited_since, _ = after(session, PutBoxes(seq=1, boxes=(TABLE,)))
    assert remedied(edited_since, Remedied(helped)) == (edited_since, ())


def remedy_of(message: Remedy) -> CoreRemedy:
    """The same remedy as the core has it."""
    return CoreRemedy(**msgspec.structs.asdict(message))
