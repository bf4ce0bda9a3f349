"""The work that sessions want done, off the event loop: functions of effects and the world."""

from __future__ import annotations

from collections.abc import Callable
from time import perf_counter

from scenegen_core.graph.scene_graph import scene_graph
from scenegen_core.placement.answer import Cancelled
from scenegen_core.placement.remedies import find_remedy
from scenegen_core.placement.solve import draw
from scenegen_core.placement.what_if import what_matters
from server.effects import DrawGraph, Examine, FindRemedy, Furnish, Offer, Solve, Weigh
from server.engine import Cancel
from server.looks import look
from server.protocol import Graph, Inspected, Matters, Weighing
from server.results import Drawn, Furnished, Remedied, Solved
from server.translate import (
    answer_message,
    graph_message,
    heat_map_frame,
    inspected_message,
    matters_message,
    query_of,
    with_remedy,
)
from server.world import World


def draw_maps(world: World, wish: Solve, cancelled: Cancel) -> Drawn:
    """Heat maps, and what offers are chosen from."""
    begin = perf_counter()
    query = query_of(wish.query, world.catalogue)
    drawing = draw(wish.scene, query, world.knowledge, cancelled=cancelled)
    frames = (heat_map_frame(one, ask=wish.ask, revision=wish.revision) for one in drawing.maps)
    return Drawn(tuple(frames), Offer(wish, drawing, perf_counter() - begin))


def make_offer(world: World, offer: Offer, cancelled: Cancel) -> Solved:
    """Placements with reasons, and the model of the object."""
    begin, wish = perf_counter(), offer.wish
    solution = offer.drawing.solution(cancelled=cancelled)
    found = solution.answer
    asset = world.assets.digest(look(found.category, found.size, item=wish.query.item))
    answer = answer_message(
        found,
        ask=wish.ask,
        revision=wish.revision,
        asset=asset,
        elapsed=offer.elapsed + perf_counter() - begin,
    )
    return Solved(solution, answer)


def seek_remedy(world: World, wish: FindRemedy, cancelled: Cancel) -> Remedied:
    """The same answer with the nearest thing that would give a place."""
    query = query_of(wish.query, world.catalogue)
    remedy = find_remedy(wish.scene, query, world.knowledge, cancelled=cancelled)
    return Remedied(with_remedy(wish.answer, remedy))


def weigh(
    world: World, wish: Weigh, tell: Callable[[Weighing], None], cancelled: Cancel
) -> Matters:
    """Which box matters most; ``tell`` sends how far the search has come."""
    total = len(wish.scene.boxes)
    found = what_matters(
        wish.scene,
        query_of(wish.query, world.catalogue),
        wish.solution.answer,
        world.knowledge,
        progress=lambda done: tell(Weighing(id=wish.question, done=done, total=total)),
        cancelled=cancelled,
    )
    return matters_message(found, question=wish.question, ask=wish.ask, revision=wish.revision)


def make_models(world: World, wish: Furnish, cancelled: Cancel) -> Furnished:
    """The models of boxes."""
    models = {}
    for box, wanted in wish.looks.items():
        if cancelled():
            raise Cancelled
        models[box] = wanted, world.assets.digest(wanted)
    return Furnished(wish.revision, models)


def examine(wish: Examine, _: Cancel) -> Inspected:
    """What the solution thinks of a pose."""
    inspection = wish.solution.inspect(wish.inspect.center, wish.inspect.heading)
    return inspected_message(inspection, inspect=wish.inspect, ask=wish.ask, revision=wish.revision)


def draw_graph(world: World, wish: DrawGraph, _: Cancel) -> Graph:
    """The scene graph."""
    graph = scene_graph(wish.scene, world.knowledge.groups)
    return graph_message(graph, revision=wish.revision)
