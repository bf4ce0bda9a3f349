"""A session as a value: ``(session, message) -> (session, effects)``; no sockets, no threads.

The page is the truth for its scene: every well-formed edit is taken as it is, boxes outside the
room too (a phone may draw the walls later).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import assert_never

from msgspec.structs import replace as replace_fields

from scenegen_core.placement.solve import Solution
from scenegen_core.scene.files import record_of
from scenegen_core.scene.model import Scene
from server.edits import Vocabulary, edited, wrong_query
from server.effects import (
    Deed,
    DrawGraph,
    Effect,
    Examine,
    Furnish,
    Save,
    Send,
    Solve,
    StopSolving,
    StopWeighing,
    Weigh,
)
from server.looks import Look, look_of
from server.protocol import (
    Ack,
    Ask,
    ClientMessage,
    Edit,
    Hello,
    Inspect,
    Ping,
    Pong,
    Problem,
    PutBoxes,
    PutRoom,
    PutScene,
    RemoveBox,
    WatchGraph,
    Welcome,
    WhatMatters,
)


@dataclass(frozen=True, slots=True)
class Session:
    """What the server holds for a page while its socket is open."""

    id: str
    revision: int = 0
    scene: Scene | None = None
    """None until the page has sent a room."""
    assets: frozenset[str] = frozenset()
    """Models that the page has."""
    looks: Mapping[str, Look] = field(default_factory=dict)
    """Boxes whose model the page was told, and how they looked then."""
    ask: Ask | None = None
    solution: Solution | None = None
    """Of the ask, for the scene as it is; None while it is being computed."""
    inspect: Inspect | None = None
    """A pose that waits for the solution."""
    weigh: WhatMatters | None = None
    """What the page wants to know, until it is told."""
    watching: bool = False
    """Whether the page wants the graph."""


Step = tuple[Session, tuple[Effect, ...]]


def greet(session: Session, hello: Hello, *, lists: Welcome) -> Step:
    """The first step on a socket; ``lists`` is a welcome without what is the session's own."""
    resumed = hello.session == session.id
    known = resumed and hello.revision == session.revision
    welcome = replace_fields(
        lists,
        session=session.id,
        revision=session.revision,
        resumed=resumed,
        scene=None if known or session.scene is None else record_of(session.scene),
    )
    greeted = replace(session, assets=frozenset(hello.assets))
    return greeted, (Send(welcome), *_furnish(greeted))


def handle(session: Session, message: ClientMessage, words: Vocabulary) -> Step:
    """What a message of the page does."""
    match message:
        case PutScene() | PutRoom() | PutBoxes() | RemoveBox():
            return _edit(session, message, words)
        case Ask():
            return _ask(session, message, words)
        case Inspect() | WhatMatters():
            return _question(session, message)
        case WatchGraph():
            watching = replace(session, watching=message.on)
            return watching, _draw_graph(watching)
        case Ping():
            return session, (Send(Pong(nonce=message.nonce)),)
        case Hello():
            text = "This socket has said hello already; open another one to start again."
            return session, (Send(Problem(code="bad_message", text=text, path="$.type")),)
        case _:
            assert_never(message)


def _edit(session: Session, edit: Edit, words: Vocabulary) -> Step:
    scene = edited(session.scene, edit, words)
    if isinstance(scene, Problem):
        return session, (Send(scene),)
    if scene is None:  # a box was removed from no room
        return session, (Send(Ack(seq=edit.seq, revision=session.revision)),)
    session, stopped = _stop_weighing(session)
    session = replace(
        session,
        revision=session.revision + 1,
        scene=scene,
        looks={box: look for box, look in session.looks.items() if box in scene},
        solution=None,
    )
    return session, (
        Save(session.id, session.revision, scene),
        Send(Ack(seq=edit.seq, revision=session.revision)),
        *stopped,
        *_furnish(session),
        *_solve(session),
        *_draw_graph(session),
    )


def _ask(session: Session, ask: Ask, words: Vocabulary) -> Step:
    if ask.query is None:
        session, stopped = _stop_weighing(session)
        return replace(session, ask=None, solution=None, inspect=None), (StopSolving(), *stopped)
    problem = wrong_query(ask.query, words)
    if problem is not None:
        return session, (Send(problem),)
    session, stopped = _stop_weighing(session)
    session = replace(session, ask=ask, solution=None, inspect=None)
    return session, (*stopped, *_solve(session))


def _question(session: Session, question: Inspect | WhatMatters) -> Step:
    """A question about the ask: it waits until the ask is solved."""
    if isinstance(question, WhatMatters) and not question.on:
        return _stop_weighing(session)
    if session.ask is None:
        text = "There is nothing to be placed yet; ask first."
        return session, (Send(Problem(code="bad_query", text=text, path="$.type")),)
    if isinstance(question, WhatMatters):
        waiting = replace(session, weigh=question)
        return waiting, () if session.solution is None else weigh(waiting)
    waiting = replace(session, inspect=question)
    return (waiting, ()) if session.solution is None else (session, examine(waiting))


def examine(session: Session) -> tuple[Deed, ...]:
    """Have the solution, which is there, look at the pose that waits, if one does."""
    if session.inspect is None:
        return ()
    assert session.ask is not None
    assert session.solution is not None
    return (Examine(session.solution, session.inspect, session.ask.id, session.revision),)


def weigh(session: Session) -> tuple[Deed, ...]:
    """Have it found out what matters to the solution, which is there, if the page wants to know."""
    if session.weigh is None:
        return ()
    assert session.ask is not None
    assert session.ask.query is not None
    assert session.scene is not None
    assert session.solution is not None
    return (
        Weigh(
            session.weigh.id,
            session.ask.id,
            session.ask.query,
            session.revision,
            session.scene,
            session.solution,
        ),
    )


def _stop_weighing(session: Session) -> tuple[Session, tuple[Deed, ...]]:
    if session.weigh is None:
        return session, ()
    return replace(session, weigh=None), (StopWeighing(),)


def _solve(session: Session) -> tuple[Deed, ...]:
    if session.ask is None or session.ask.query is None or session.scene is None:
        return ()
    return (Solve(session.ask.id, session.ask.query, session.revision, session.scene),)


def _draw_graph(session: Session) -> tuple[Deed, ...]:
    if session.scene is None or not session.watching:
        return ()
    return (DrawGraph(session.revision, session.scene),)


def _furnish(session: Session) -> tuple[Deed, ...]:
    """The models to be made: also those still in the making, since newer work replaces older."""
    wanted = wanted_looks(session).items()
    looks = {box: look for box, look in wanted if session.looks.get(box) != look}
    return (Furnish(session.revision, looks),) if looks else ()


def wanted_looks(session: Session) -> dict[str, Look]:
    """How the boxes look now, by their id."""
    boxes = () if session.scene is None else session.scene.boxes
    return {box.id: look_of(box) for box in boxes}
