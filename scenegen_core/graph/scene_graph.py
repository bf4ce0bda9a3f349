"""The scene graph G of a room: objects, groups and the room, and the relations between them.

Made for showing and export; it measures with the same relations that knowledge is learned from.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from shapely import Polygon

from scenegen_core.graph.candidates import Candidates
from scenegen_core.graph.relations import (
    AVERAGE_DISTANCE,
    AWAY_FROM_WALL,
    BY_SHORT,
    DIRECTION_SIMILARITY,
    FACING,
    NEARBY,
    NEXT_TO,
    ROOM_POSITION,
    SUPPORT,
    SURROUNDED_BY,
    TOWARDS_CENTER,
    Relation,
    columns,
    measure,
)
from scenegen_core.graph.situation import Situation
from scenegen_core.graph.surroundings import Surroundings
from scenegen_core.graph.wording import (
    about_direction,
    about_group,
    about_membership,
    about_room,
)
from scenegen_core.scene.model import OTHER, Box, Category, Scene, Symmetry, Vector3

NodeKind = Literal["object", "group", "room"]

BELONGS = "BelongsTo"
ROOM_NODE = "room"

FOR_ALL: tuple[Relation, ...] = (ROOM_POSITION, AVERAGE_DISTANCE, SURROUNDED_BY, SUPPORT)
FOR_FRONTS: tuple[Relation, ...] = (TOWARDS_CENTER, AWAY_FROM_WALL, FACING, NEXT_TO)
"""Only for things with a front (paper, "Orientation Relationships")."""
BETWEEN_BOXES = (AVERAGE_DISTANCE, SUPPORT, FACING, NEXT_TO)


@dataclass(frozen=True, slots=True)
class Node:
    """An object, a group or the room; ``center`` in metres, a group's is the mean of its boxes."""

    id: str
    """``object:<box id>``, ``group:<category>`` or ``room``."""
    kind: NodeKind
    name: str
    center: Vector3


@dataclass(frozen=True, slots=True)
class Edge:
    """A relation of ``source`` to ``target``: its value as measured, and what that means."""

    source: str
    target: str
    relation: str
    value: float
    text: str


@dataclass(frozen=True, slots=True)
class SceneGraph:
    """Nodes and the edges between them, both in the order of the scene's boxes."""

    nodes: tuple[Node, ...]
    edges: tuple[Edge, ...]


def object_node(box_id: str) -> str:
    """The id of a box's node."""
    return f"object:{box_id}"


def group_node(category: str) -> str:
    """The id of a group's node."""
    return f"group:{category}"


def scene_graph(scene: Scene, groups: tuple[Category, ...]) -> SceneGraph:
    """The graph of a scene, its boxes sorted into ``groups``, of which Other takes the rest.

    Every relation that is not zero is an edge, RoomPosition always ("in the middle"). What needs a
    front is left out for symmetric objects and for those whose front is not known. Of the other
    boxes, edges name the nearest one and those that are faced, beside, above, below or parallel.
    """
    regrouped = _regrouped(scene, groups)
    return SceneGraph(
        nodes=tuple(_nodes(regrouped, groups)),
        edges=tuple(edge for box in regrouped.boxes for edge in _edges(box, regrouped, groups)),
    )


def _regrouped(scene: Scene, groups: tuple[Category, ...]) -> Scene:
    """The scene with every box in one of the groups."""
    names = {group.name for group in groups}
    boxes = (box if box.category in names else replace(box, category=OTHER) for box in scene.boxes)
    return replace(scene, boxes=tuple(boxes))


def _nodes(scene: Scene, groups: tuple[Category, ...]) -> Iterator[Node]:
    for box in scene.boxes:
        yield Node(object_node(box.id), "object", _name(box), box.center)
    for group in groups:
        centers = [box.center for box in scene.boxes if box.category == group.name]
        if centers:
            x, y, z = np.mean(centers, axis=0).tolist()
            yield Node(group_node(group.name), "group", group.name, (x, y, z))
    middle = Polygon(scene.room.corners).centroid
    yield Node(ROOM_NODE, "room", scene.room.room_type or "room", (middle.x, middle.y, 0.0))


def _name(box: Box) -> str:
    return box.label or box.category


def _edges(box: Box, scene: Scene, groups: tuple[Category, ...]) -> Iterator[Edge]:
    members = Counter(other.category for other in scene.boxes)
    fronts = {group.name for group in groups if group.symmetry is not Symmetry.SYMMETRIC}
    has_front = box.front_known and box.category in fronts
    relations = FOR_ALL + FOR_FRONTS if has_front else FOR_ALL
    others = scene.without(box.id)
    text = about_membership(box.category, members[box.category])
    yield Edge(object_node(box.id), group_node(box.category), BELONGS, 1.0, text)
    members[box.category] -= 1
    for relation, name, value in _measured(relations, box, others, groups):
        if not relation.per_group and (value or relation is ROOM_POSITION):
            text = about_room(relation.name, value)
            yield Edge(object_node(box.id), ROOM_NODE, relation.name, value, text)
        elif members[name] and (value or relation is AVERAGE_DISTANCE):
            text = about_group(relation.name, value, name, members[name])
            yield Edge(object_node(box.id), group_node(name), relation.name, value, text)
    if others.boxes:
        yield from _edges_to_boxes(relations, box, others)
    if has_front:
        yield from _edges_to_parallel(box, others, fronts)


def _edges_to_boxes(relations: tuple[Relation, ...], box: Box, others: Scene) -> Iterator[Edge]:
    """The same relations to each other box, by taking it for a group of its own."""
    alone = tuple(replace(other, category=other.id) for other in others.boxes)
    each = tuple(Category(other.id, Symmetry.SYMMETRIC) for other in alone)
    pairwise = tuple(relation for relation in relations if relation in BETWEEN_BOXES)
    found = list(_measured(pairwise, box, replace(others, boxes=alone), each))
    gaps = {other: value for relation, other, value in found if relation is AVERAGE_DISTANCE}
    nearest = min(gaps, key=gaps.__getitem__)
    for relation, other, value in found:
        if other == nearest if relation is AVERAGE_DISTANCE else value:
            text = about_group(relation.name, value, _name(others[other]), 1)
            yield Edge(object_node(box.id), object_node(other), relation.name, value, text)


def _edges_to_parallel(box: Box, others: Scene, fronts: set[str]) -> Iterator[Edge]:
    """DirectionSimilarity to each neighbor with a front, measured with nobody else there."""
    gaps = Situation(Candidates.of(box), Surroundings(others, ())).gaps[0]
    for other, gap in zip(others.boxes, gaps, strict=True):
        if gap > NEARBY or other.category not in fronts:
            continue
        alone = replace(others, boxes=(other,))
        for relation, part, value in _measured((DIRECTION_SIMILARITY,), box, alone, ()):
            if value:
                text = about_direction(part, _name(other))
                yield Edge(object_node(box.id), object_node(other.id), relation.name, value, text)


def _measured(
    relations: tuple[Relation, ...], box: Box, others: Scene, groups: tuple[Category, ...]
) -> Iterator[tuple[Relation, str, float]]:
    """Each relation of a box among others, with the group or part that the value is about."""
    situation = Situation(Candidates.of(box), Surroundings(others, groups))
    values = measure(relations, situation)[0].tolist()
    for column, value in zip(columns(relations, groups), values, strict=True):
        yield BY_SHORT[column.relation], column.about, value
