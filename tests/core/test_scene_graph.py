"""The scene graph: who is related to whom, in words, and as files for other programs."""

from __future__ import annotations

import io
import json
import shutil
import subprocess
from dataclasses import replace
from pathlib import Path

import networkx as nx
import pytest
from hypothesis import given
from hypothesis import strategies as st

from scenegen_core.graph.export import to_dot, to_graphml, to_json
from scenegen_core.graph.scene_graph import Edge, Node, SceneGraph, scene_graph
from scenegen_core.scene.files import read_scene
from scenegen_core.scene.model import PAPER_CATEGORIES, Box, Room, Scene

FIXTURES = Path(__file__).parents[1] / "fixtures"
NASTY = 'Tom\'s "b&b" <bed>\\ \n{x|y} \x07 ☃ \\N \\"'


@pytest.fixture(scope="module")
def living_room() -> Scene:
    """A sofa before a table with a vase, a TV on a cupboard, a chair, a stool, a picture."""
    return read_scene((FIXTURES / "living_room.json").read_bytes())


@pytest.fixture(scope="module")
def graph(living_room: Scene) -> SceneGraph:
    return scene_graph(living_room, PAPER_CATEGORIES)


def texts(graph: SceneGraph, source: str, target: str) -> set[str]:
    """What the graph says of two nodes."""
    return {e.text for e in graph.edges if (e.source, e.target) == (source, target)}


def test_nodes_are_the_objects_the_groups_that_are_there_and_the_room(graph: SceneGraph) -> None:
    assert [(node.kind, node.name) for node in graph.nodes] == [
        ("object", "Sofa"),
        ("object", "Table"),
        ("object", "Decor"),
        ("object", "Chair"),
        ("object", "Chair"),
        ("object", "Storage"),
        ("object", "Television"),  # its label
        ("object", "Picture"),
        ("group", "Chair"),
        ("group", "Decor"),
        ("group", "Picture"),
        ("group", "Sofa"),
        ("group", "Storage"),
        ("group", "Table"),
        ("group", "TV"),
        ("room", "living room"),
    ]


def test_nodes_stand_where_their_things_are(graph: SceneGraph) -> None:
    centers = {node.id: node.center for node in graph.nodes}
    assert centers["object:sofa"] == (2.5, 3.5, 0.4)
    assert centers["group:Chair"] == pytest.approx((2.4, 2.8, 0.35))
    assert centers["room"] == pytest.approx((2.5, 2.0, 0.0))


@pytest.mark.parametrize(
    ("source", "target", "text"),
    [
        ("object:sofa", "group:Sofa", "the only sofa"),
        ("object:stool", "group:Chair", "one of the chairs"),
        ("object:sofa", "room", "near one wall"),
        ("object:table", "room", "in the middle of the room"),
        ("object:sofa", "room", "has its back to the wall"),
        ("object:sofa", "room", "faces into the room"),
        ("object:sofa", "group:Table", "60 cm from the table"),
        ("object:table", "group:Chair", "1.0 m from the chairs"),
        ("object:vase", "group:Table", "right at the table"),
        ("object:sofa", "group:Chair", "close to 2 chairs"),
        ("object:table", "group:Chair", "close to one of the chairs"),
        ("object:sofa", "group:Table", "faces the table"),
        ("object:sofa", "group:Chair", "next to one of the chairs"),
        ("object:tv", "group:Storage", "stands on the storage piece"),
        ("object:cupboard", "group:TV", "is under the TV"),
    ],
)
def test_relations_to_the_room_and_to_groups_are_told(
    graph: SceneGraph, source: str, target: str, text: str
) -> None:
    assert text in texts(graph, source, target)


@pytest.mark.parametrize(
    ("source", "target", "told"),
    [
        ("object:sofa", "object:table", {"faces the table"}),
        ("object:sofa", "object:vase", {"faces the decor piece"}),
        (
            "object:sofa",
            "object:stool",
            {
                "30 cm from the chair",
                "next to the chair",
                "faces the opposite way to the chair",
            },
        ),
        ("object:sofa", "object:chair", set()),  # close, but neither nearest, ahead nor beside
        ("object:sofa", "object:tv", set()),  # ahead, but too far
        (
            "object:picture",  # the nearest thing, and no other relation
            "object:stool",
            {"1.2 m from the chair"},
        ),
        ("object:vase", "object:table", {"right at the table", "stands on the table"}),
        ("object:table", "object:vase", {"right at the decor piece", "is under the decor piece"}),
    ],
)
def test_relations_to_a_group_say_which_of_its_objects_they_are_about(
    graph: SceneGraph, source: str, target: str, told: set[str]
) -> None:
    assert texts(graph, source, target) == told


@pytest.mark.parametrize(
    ("label", "text"),
    [
        ("", "faces the table"),
        ("Coffee table", "faces the coffee table"),
        ("CoffeeTable", "faces the coffee table"),
        ("side_table", "faces the side table"),
        ("TV table", "faces the TV table"),
    ],
)
def test_an_object_is_called_by_its_label(living_room: Scene, label: str, text: str) -> None:
    scene = living_room.with_box(replace(living_room["table"], label=label))
    assert texts(scene_graph(scene, PAPER_CATEGORIES), "object:sofa", "object:table") == {text}


def test_what_has_no_front_faces_nothing(living_room: Scene) -> None:
    unknown = replace(living_room["sofa"], front_known=False)
    graph = scene_graph(living_room.with_box(unknown), PAPER_CATEGORIES)
    about_fronts = {"Facing", "NextTo", "TowardsCenter", "AwayFromWall", "DirectionSimilarity"}
    for source in ("object:sofa", "object:table"):
        assert about_fronts.isdisjoint(e.relation for e in graph.edges if e.source == source)


def test_a_category_that_nobody_knows_belongs_to_other(living_room: Scene) -> None:
    piano = Box("piano", "Piano", (4.5, 1.0, 0.6), (0.6, 0.5, 1.2), label="Grand piano")
    graph = scene_graph(living_room.with_box(piano), PAPER_CATEGORIES)
    assert texts(graph, "object:piano", "group:Other") == {"the only other thing"}
    assert Node("object:piano", "object", "Grand piano", piano.center) in graph.nodes


def test_an_empty_room_is_a_graph_of_one_node() -> None:
    graph = scene_graph(Scene(Room(((0, 0), (2, 0), (2, 2), (0, 2)))), PAPER_CATEGORIES)
    assert graph == SceneGraph((Node("room", "room", "room", (1.0, 1.0, 0.0)),), ())


def test_ids_that_look_like_groups_or_the_room_stay_apart() -> None:
    room = Room(((0, 0), (5, 0), (5, 5), (0, 5)))
    boxes = tuple(
        Box(name, "Bed", (2, 1 + i, 0.5), (1, 1, 1))
        for i, name in enumerate(("room", "group:Bed", "Other"))
    )
    graph = scene_graph(Scene(room, boxes), PAPER_CATEGORIES)
    assert len({node.id for node in graph.nodes}) == len(graph.nodes) == 5


def test_every_edge_joins_two_nodes(graph: SceneGraph) -> None:
    ids = {node.id for node in graph.nodes}
    assert {end for edge in graph.edges for end in (edge.source, edge.target)} <= ids


# --- files for other programs ---------------------------------------------------------------------


def nasty_graph(text: str) -> SceneGraph:
    """Two nodes and two edges between them, named as nobody should."""
    nodes = (
        Node("object:" + text, "object", text, (1.0, -2.5, 0.1)),
        Node("room", "room", text, (0.0, 0.0, 0.0)),
    )
    edges = tuple(Edge("object:" + text, "room", kind, 0.1, text) for kind in ("Facing", "NextTo"))
    return SceneGraph(nodes, edges)


def as_networkx(graph: SceneGraph) -> nx.MultiDiGraph:
    return nx.read_graphml(io.BytesIO(to_graphml(graph).encode()), force_multigraph=True)


def test_networkx_reads_the_graphml_back(graph: SceneGraph) -> None:
    read = as_networkx(graph)
    assert read.is_directed()
    assert list(read.nodes) == [node.id for node in graph.nodes]
    assert read.nodes["object:sofa"] == {
        "kind": "object",
        "name": "Sofa",
        "x": 2.5,
        "y": 3.5,
        "z": 0.4,
    }
    assert sorted(
        (source, target, data["relation"], data["value"], data["text"])
        for source, target, data in read.edges(data=True)
    ) == sorted((e.source, e.target, e.relation, e.value, e.text) for e in graph.edges)


@given(text=st.text(st.characters(exclude_categories=("Cc", "Cs", "Cn")), max_size=30))
def test_graphml_keeps_every_name(text: str) -> None:
    read = as_networkx(nasty_graph(text + "."))  # networkx reads an empty text as none
    assert read.nodes["room"]["name"] == text + "."
    assert read.number_of_edges() == 2


def test_graphml_replaces_what_xml_cannot_hold() -> None:
    read = as_networkx(nasty_graph("bell\x07 \ufffe"))
    assert read.nodes["room"]["name"] == "bell\ufffd \ufffd"


def test_json_holds_the_fields_of_nodes_and_edges(graph: SceneGraph) -> None:
    read = json.loads(to_json(graph))
    assert set(read) == {"nodes", "edges"}
    assert read["nodes"][-1] == {
        "id": "room",
        "kind": "room",
        "name": "living room",
        "center": [2.5, 2.0, 0.0],
    }
    assert {
        "source": "object:tv",
        "target": "group:Storage",
        "relation": "Support",
        "value": 1.0,
        "text": "stands on the storage piece",
    } in read["edges"]


def test_dot_quotes_backslashes_quotes_and_lines() -> None:
    lines = to_dot(nasty_graph('a "b" \\N\nc')).splitlines()
    assert lines[2] == (
        r'  "object:a \"b\" \\N\nc" [label="a \"b\" \\N\nc", shape=box];'
    )  # fmt: skip


@pytest.mark.skipif(shutil.which("dot") is None, reason="Graphviz is not installed")
@pytest.mark.parametrize("text", [NASTY, "", "\\", '"', '\\"', "<b>x</b>", "é" * 80])
def test_graphviz_draws_the_dot(text: str) -> None:
    drawn = subprocess.run(
        ["dot", "-Tsvg"],
        input=to_dot(nasty_graph(text)).encode(),
        capture_output=True,
        check=True,
    )
    assert drawn.stderr == b""
    assert drawn.stdout.count(b'class="node"') == 2
    assert drawn.stdout.count(b'class="edge"') == 2
