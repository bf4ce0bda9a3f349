"""Between the core's values and the wire's messages."""

from __future__ import annotations

from dataclasses import asdict

from msgspec.structs import replace

from scenegen_core.graph.scene_graph import SceneGraph
from scenegen_core.knowledge.knowledge import MIN_EXAMPLES, Knowledge
from scenegen_core.placement import answer as core
from scenegen_core.scene.model import OTHER
from server import protocol as wire
from server.assets import Assets
from server.catalogue import Catalogue
from server.looks import look
from server.wire import Binary

UNKNOWN_SIZE = (0.5, 0.5, 0.5)  # metres; of a category without examples


def query_of(query: wire.Query, catalogue: Catalogue) -> core.Query:
    """The core's query; the size of a catalogue item counts when the page gives none."""
    item = catalogue.by_id.get(query.item or "")
    item_size = None if item is None else item.size
    return core.Query(
        category=query.category,
        size=query.size or item_size,
        count=query.count,
        model=query.model,
        relaxed=query.relaxed,
    )


def answer_message(
    answer: core.Answer, *, ask: str, revision: int, asset: str, elapsed: float
) -> wire.Answer:
    """The answer on the wire; ``elapsed`` is in seconds."""
    return wire.Answer(
        ask=ask,
        revision=revision,
        category=answer.category,
        size=answer.size,
        asset=asset,
        placements=tuple(map(_placement, answer.poses)),
        no_good_place=_no_good_place(answer.no_good_place),
        elapsed_ms=round(elapsed * 1000, 1),
    )


def with_remedy(answer: wire.Answer, remedy: core.Remedy | None) -> wire.Answer:
    """The answer that there is no place, with what would give one."""
    if remedy is None or answer.no_good_place is None:
        return answer
    found = replace(answer.no_good_place, remedy=wire.Remedy(**asdict(remedy)))
    return replace(answer, no_good_place=found)


def heat_map_frame(heat_map: core.HeatMap, *, ask: str, revision: int) -> Binary:
    """A heat map as a binary frame: its raster row by row."""
    rows, columns = heat_map.values.shape
    header = wire.HeatMapHeader(
        ask=ask,
        revision=revision,
        surface=heat_map.surface,
        origin=heat_map.origin,
        cell=heat_map.cell,
        shape=(rows, columns),
        min=heat_map.low,
        max=heat_map.high,
    )
    return Binary(header, heat_map.values.tobytes())


def inspected_message(
    inspection: core.Inspection, *, inspect: wire.Inspect, ask: str, revision: int
) -> wire.Inspected:
    """What the model says of a pose, on the wire."""
    return wire.Inspected(
        id=inspect.id,
        ask=ask,
        revision=revision,
        allowed=inspection.allowed,
        rule=inspection.rule,
        score=inspection.score,
        likelihood=inspection.likelihood,
        sentence=inspection.sentence,
        reasons=tuple(map(_reason, inspection.reasons)),
        costs=tuple(map(_cost, inspection.costs)),
        elsewhere=_elsewhere(inspection.elsewhere),
    )


def matters_message(
    found: core.Counterfactual | None, *, question: str, ask: str, revision: int
) -> wire.Matters:
    """What matters most, on the wire."""
    return wire.Matters(
        id=question,
        ask=ask,
        revision=revision,
        found=None if found is None else wire.Counterfactual(**asdict(found)),
    )


def graph_message(graph: SceneGraph, *, revision: int) -> wire.Graph:
    """The scene graph on the wire."""
    return wire.Graph(
        revision=revision,
        nodes=tuple(
            wire.GraphNode(id=node.id, kind=node.kind, name=node.name, center=node.center)
            for node in graph.nodes
        ),
        edges=tuple(
            wire.GraphEdge(
                source=edge.source,
                target=edge.target,
                relation=edge.relation,
                value=edge.value,
                text=edge.text,
            )
            for edge in graph.edges
        ),
    )


def category_infos(knowledge: Knowledge) -> tuple[wire.CategoryInfo, ...]:
    """What can be drawn or placed, in the order of the knowledge's groups."""
    infos = []
    for category in knowledge.groups:
        learnt = knowledge.categories.get(category.name)
        examples = 0 if learnt is None else learnt.examples
        infos.append(
            wire.CategoryInfo(
                name=category.name,
                symmetry=category.symmetry.value,
                placeable=category.name != OTHER and examples >= MIN_EXAMPLES,
                size=UNKNOWN_SIZE if learnt is None else learnt.usual_size,
                examples=examples,
            )
        )
    return tuple(infos)


def catalogue_items(catalogue: Catalogue, assets: Assets) -> tuple[wire.CatalogueItem, ...]:
    """The user's own models on the wire."""
    return tuple(
        wire.CatalogueItem(
            id=item.id,
            name=item.name,
            category=item.category,
            size=item.size,
            asset=assets.digest(look(item.category, item.size, item=item.id)),
        )
        for item in catalogue.items
    )


def _no_good_place(found: core.NoGoodPlace | None) -> wire.NoGoodPlace | None:
    if found is None:
        return None
    return wire.NoGoodPlace(rule=found.rule, text=found.text, remedy=None)


def _elsewhere(found: core.Elsewhere | None) -> wire.Elsewhere | None:
    return None if found is None else wire.Elsewhere(**asdict(found))


def _cost(cost: core.Cost) -> wire.Cost:
    return wire.Cost(**asdict(cost))


def _placement(pose: core.Pose) -> wire.Placement:
    return wire.Placement(
        rank=pose.rank,
        center=pose.center,
        heading=pose.heading,
        score=pose.score,
        likelihood=pose.likelihood,
        name=pose.name,
        sentence=pose.sentence,
        reasons=tuple(map(_reason, pose.reasons)),
        rooms=pose.rooms,
    )


def _reason(reason: core.Reason) -> wire.Reason:
    return wire.Reason(
        relation=reason.relation,
        group=reason.group,
        contribution=reason.contribution,
        text=reason.text,
    )
