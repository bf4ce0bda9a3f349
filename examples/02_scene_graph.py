"""The scene graph of a room: its objects, their groups, the room, and how they relate.

Run from the top of the repository: python examples/02_scene_graph.py
"""

from __future__ import annotations

from pathlib import Path

from scenegen_core.graph.scene_graph import object_node, scene_graph
from scenegen_core.scene.files import read_scene
from scenegen_core.scene.model import PAPER_CATEGORIES

ROOM = Path("web/public/rooms/living-room.json")


def main() -> None:
    """Print the relations of every object."""
    scene = read_scene(ROOM.read_bytes())
    graph = scene_graph(scene, PAPER_CATEGORIES)
    print(f"{scene.name}: {len(graph.nodes)} nodes, {len(graph.edges)} edges")
    for box in scene.boxes:
        print(f"\n{box.label}")
        for edge in graph.edges:
            if edge.source == object_node(box.id):
                print(f"  {edge.relation:<20} {edge.value:6.2f}  {edge.text}")


if __name__ == "__main__":
    main()
