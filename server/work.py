"""The work that sessions want done, off the event loop: functions of effects and the world."""

from __future__ import annotations

from collections.abc import Callable
from time import perf_counter

from scenegen_core.graph.scene_graph import scene_graph
from scenegen_core.placement.answer import Cancelled, HeatMap
from scenegen_core.placement.remedies import find_remedy
from scenegen_core.placement.solve import solve
from scenegen_core.placement.what_if import what_matters
from server.effects import DrawGraph, Examine, FindRemedy, Furnish, Solve, Weigh
from server.engine import Cancel
from server.looks import look
from server.outbox import Unit
from server.protocol import Graph, Inspected, Maps, Matters, Weighing
from server.results import Furnished, Remedied, Solved
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


def solve_ask(world: World, wish: Solve, tell: Callable[[Unit], None], cancelled: Cancel) -> Solved:
    """Placements, heat maps and the model of the object.

    ``tell`` sends the heat maps ahead of all else. Then work goes on only if nothing newer waits:
    while a box is dragged maps follow it, and the offers come when it rests.
    """

    def drawn(maps: tuple[HeatMap, ...]) -> bool:
        frames = (heat_map_frame(one, ask=wish.ask, revision=wish.revision) for one in maps)
        tell((*frames, Maps(ask=wish.ask, revision=wish.revision)))
        return not cancelled.at_once()

    begin = perf_counter()
    query = query_of(wish.query, world.catalogue)
    solution = solve(wish.scene, query, world.knowledge, cancelled=cancelled, drawn=drawn)
    found = solution.answer
    asset = world.assets.digest(look(found.category, found.size, item=wish.query.item))
    answer = answer_message(
        found,
        ask=wish.ask,
        revision=wish.revision,
        asset=asset,
        elapsed=perf_counter() - begin,
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
