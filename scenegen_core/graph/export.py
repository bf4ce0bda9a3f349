"""Scene graphs as text for other programs: JSON, GraphML (yEd, Gephi, NetworkX), DOT (Graphviz)."""

from __future__ import annotations

import re
from collections.abc import Callable
from xml.etree.ElementTree import Element, SubElement, indent, tostring

import msgspec

from scenegen_core.graph.scene_graph import SceneGraph

DECLARATION = '<?xml version="1.0" encoding="UTF-8"?>\n'
NAMESPACE = "http://graphml.graphdrawing.org/xmlns"
KEYS = (
    ("node", "kind", "string"),
    ("node", "name", "string"),
    ("node", "x", "double"),
    ("node", "y", "double"),
    ("node", "z", "double"),
    ("edge", "relation", "string"),
    ("edge", "value", "double"),
    ("edge", "text", "string"),
)
FORBIDDEN = re.compile("[^\t\n\r\u0020-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
"""What XML 1.0 has no way to write; a lost character shows as a replacement."""

SHAPES = {"object": "box", "group": "ellipse", "room": "house"}


def to_json(graph: SceneGraph) -> str:
    """``{"nodes": [...], "edges": [...]}`` with the fields of Node and Edge."""
    return msgspec.json.format(msgspec.json.encode(graph), indent=2).decode() + "\n"


def to_graphml(graph: SceneGraph) -> str:
    """A directed multigraph whose nodes and edges carry their fields as typed data."""
    root = Element("graphml", xmlns=NAMESPACE)
    for domain, name, kind in KEYS:
        attributes = {"id": f"{domain}-{name}", "for": domain}
        SubElement(root, "key", attributes | {"attr.name": name, "attr.type": kind})
    body = SubElement(root, "graph", edgedefault="directed")
    for node in graph.nodes:
        x, y, z = node.center
        element = SubElement(body, "node", id=_xml(node.id))
        _add_data(element, {"kind": node.kind, "name": node.name, "x": x, "y": y, "z": z})
    for number, edge in enumerate(graph.edges):
        ends = {"source": _xml(edge.source), "target": _xml(edge.target)}
        element = SubElement(body, "edge", {"id": f"e{number}"} | ends)
        _add_data(element, {"relation": edge.relation, "value": edge.value, "text": edge.text})
    indent(root)
    return DECLARATION + tostring(root, encoding="unicode") + "\n"


def to_dot(graph: SceneGraph) -> str:
    """A digraph that Graphviz draws, edges labelled with what they mean."""
    nodes = (
        f"  {_dot(node.id)} [label={_dot(node.name)}, shape={SHAPES[node.kind]}];"
        for node in graph.nodes
    )
    edges = (
        f"  {_dot(edge.source)} -> {_dot(edge.target)} "
        f"[label={_dot(edge.text)}, tooltip={_dot(edge.relation)}];"
        for edge in graph.edges
    )
    return "\n".join(["digraph scene {", "  rankdir=LR;", *nodes, *edges, "}", ""])


FORMATS: dict[str, Callable[[SceneGraph], str]] = {
    "json": to_json,
    "graphml": to_graphml,
    "dot": to_dot,
}


def _add_data(element: Element, values: dict[str, str | float]) -> None:
    for name, value in values.items():
        SubElement(element, "data", key=f"{element.tag}-{name}").text = _xml(str(value))


def _xml(text: str) -> str:
    """Text that XML can hold (the writer escapes markup itself)."""
    return FORBIDDEN.sub("\ufffd", text)


def _dot(text: str) -> str:
    """A quoted DOT string: backslashes and quotes escaped, lines broken, nothing interpreted."""
    plain = FORBIDDEN.sub("\ufffd", text).replace("\\", "\\\\").replace('"', '\\"')
    return '"' + plain.replace("\r", "").replace("\n", "\\n") + '"'
