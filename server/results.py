"""What comes of the work that a session wanted, and what it does to the session."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

from scenegen_core.placement.solve import Solution
from server.effects import Deed, FindRemedy, Offer, Push, Send
from server.looks import Look
from server.protocol import Answer, Graph, Inspected, Maps, Matters, Models
from server.session import Session, examine, wanted_looks, weigh
from server.wire import Binary

Step = tuple[Session, tuple[Deed, ...]]
"""Like a session's step; but what comes of a result never has to be stored."""


@dataclass(frozen=True, slots=True)
class Furnished:
    """Models that are ready: looks and digests by box id."""

    revision: int
    models: dict[str, tuple[Look, str]]


@dataclass(frozen=True, slots=True)
class Drawn:
    """Heat maps as they travel, and what is to be done next."""

    frames: tuple[Binary, ...]
    offer: Offer


@dataclass(frozen=True, slots=True)
class Solved:
    """An answer as it travels, and what it was made from."""

    solution: Solution
    answer: Answer


@dataclass(frozen=True, slots=True)
class Remedied:
    """The answer that there is no place, once more, with what would give one."""

    answer: Answer


def furnished(session: Session, result: Furnished) -> Step:
    """Models are ready; those of boxes that look different by now are dropped."""
    wanted = wanted_looks(session)
    ready = {box: made for box, made in result.models.items() if wanted.get(box) == made[0]}
    if not ready:
        return session, ()
    digests = {box: digest for box, (_, digest) in ready.items()}
    looks = {**session.looks, **{box: look for box, (look, _) in ready.items()}}
    session, pushes = _push(replace(session, looks=looks), digests.values())
    return session, (*pushes, Send(Models(revision=result.revision, boxes=digests)))


def drawn(session: Session, result: Drawn) -> Step:
    """Heat maps are ready; dropped if they are not for the ask.

    Those of an older revision are sent too: while a box is dragged they are the newest there are.
    Offers are for the scene as it is only.
    """
    wish = result.offer.wish
    if session.ask is None or wish.ask != session.ask.id:
        return session, ()
    maps = Send(Maps(ask=wish.ask, revision=wish.revision), result.frames)
    return session, (maps, result.offer) if wish.revision == session.revision else (maps,)


def solved(session: Session, result: Solved) -> Step:
    """An answer is ready; dropped if it is stale."""
    ask, answer = session.ask, result.answer
    if ask is None or answer.ask != ask.id or answer.revision != session.revision:
        return session, ()
    session, pushes = _push(session, (answer.asset,))
    sent = (*pushes, Send(answer))
    waiting = replace(session, solution=result.solution)
    seek = _seek(waiting, answer)
    return replace(waiting, inspect=None), (*sent, *examine(waiting), *weigh(waiting), *seek)


def remedied(session: Session, result: Remedied) -> Step:
    """What would give a place; dropped if it is stale or nothing would."""
    found = result.answer.no_good_place
    current = session.ask is not None and result.answer.ask == session.ask.id
    if not current or result.answer.revision != session.revision or found is None:
        return session, ()
    return session, (Send(result.answer),) if found.remedy else ()


def weighed(session: Session, message: Matters) -> Step:
    """What matters most; dropped if nobody waits for it any more."""
    if session.weigh is None or session.weigh.id != message.id:
        return session, ()
    return replace(session, weigh=None), (Send(message),)


def _seek(session: Session, answer: Answer) -> tuple[Deed, ...]:
    """Look for a remedy if there is no place."""
    if answer.no_good_place is None:
        return ()
    assert session.ask is not None
    assert session.ask.query is not None
    assert session.scene is not None
    return (FindRemedy(session.ask.query, session.scene, answer),)


def examined(session: Session, message: Inspected) -> Step:
    """What the solution thinks of a pose; dropped if it is stale."""
    current = session.ask is not None and message.ask == session.ask.id
    return session, (Send(message),) if current and message.revision == session.revision else ()


def graphed(session: Session, message: Graph) -> Step:
    """A scene graph is ready; dropped if nobody watches any more."""
    return session, (Send(message),) if session.watching else ()


def _push(session: Session, digests: Iterable[str]) -> tuple[Session, tuple[Deed, ...]]:
    """Send the models that the page lacks, once."""
    new = tuple(digest for digest in dict.fromkeys(digests) if digest not in session.assets)
    return replace(session, assets=session.assets.union(new)), tuple(map(Push, new))
