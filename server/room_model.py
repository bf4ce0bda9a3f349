"""The furnished room as one GLB, for any viewer: metres, y up.

Walls show their inner side only, so that one looks into the room from outside as into a doll's
house; there is no ceiling.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from math import cos, sin

import numpy as np
from trimesh.transformations import rotation_matrix

from scenegen_core.scene.frames import page_turn, to_page
from scenegen_core.scene.model import Box, Room, Scene
from server.furniture.embedding import Guest
from server.furniture.glb import Packer
from server.furniture.materials import Material, linear
from server.furniture.mesh import Mesh
from server.model_file import Model, read_model
from server.room_shell import floor_mesh, glass_mesh, wall_mesh

FLOOR = Material("floor", linear("#d8bd98"), 0.7)
WALL = Material("wall", linear("#f2ede4"), 0.9)
GLASS = Material("window glass", linear("#dfeaee"), 0.1, thin=True, opacity=0.25)
CLOSE = 0.001  # metres; a model that is off by less is not stretched


def room_glb(scene: Scene, model_of: Callable[[Box], bytes]) -> bytes:
    """The room with all that stands in it, placed objects too, as one valid GLB.

    Args:
        scene: What to show.
        model_of: The GLB of a box, its front along +z, its origin anywhere; it is stretched to
            the box. Equal bytes are stored once.

    Raises:
        ValueError: A model is not usable; says why.
    """
    packer = Packer()
    nodes = _shell(packer, scene.room)
    nodes += _all_furniture(packer, scene.boxes, model_of)
    return packer.glb([packer.node(scene.name or "room", children=nodes)])


def boxes_glb(boxes: Sequence[Box], model_of: Callable[[Box], bytes]) -> bytes:
    """Furniture as it stands to one another, without a room, round the origin of the floor.

    Args:
        boxes: At least one.
        model_of: As for a room.

    Raises:
        ValueError: A model is not usable; says why.
    """
    packer = Packer()
    centers = to_page(np.array([box.center for box in boxes]))
    x, _, z = (centers.min(axis=0) + centers.max(axis=0)) / 2
    nodes = _all_furniture(packer, boxes, model_of)
    return packer.glb([packer.node("furniture", children=nodes, translation=[-x, 0.0, -z])])


def _all_furniture(
    packer: Packer, boxes: Iterable[Box], model_of: Callable[[Box], bytes]
) -> list[int]:
    """The nodes of the models in their boxes."""
    nodes = []
    guests: dict[bytes, tuple[Guest, Model]] = {}
    for box in boxes:
        data = model_of(box)
        if data not in guests:
            model = read_model(data)
            guests[data] = Guest(packer, model.gltf), model
        nodes.append(_furniture(packer, box, *guests[data]))
    return nodes


def _shell(packer: Packer, room: Room) -> list[int]:
    """The nodes of floor, walls and window panes."""
    parts: list[tuple[str, Material, Mesh | None]] = [
        ("floor", FLOOR, floor_mesh(room)),
        ("walls", WALL, wall_mesh(room)),
        ("windows", GLASS, glass_mesh(room)),
    ]
    nodes = []
    for name, material, mesh in parts:
        if mesh is None:
            continue
        primitive = packer.primitive(
            packer.material(material), mesh.positions, mesh.normals, None, mesh.faces
        )
        nodes.append(packer.mesh_node(name, [primitive]))
    return nodes


def _furniture(packer: Packer, box: Box, guest: Guest, model: Model) -> int:
    """The node that puts a model's middle where the box has its own, turned and stretched."""
    depth, width, height = box.size
    bounds = model.bounds
    wanted, own = np.array([width, height, depth]), bounds[1] - bounds[0]
    scale = np.where(
        (np.abs(wanted - own) > CLOSE) & (own > CLOSE), wanted / np.maximum(own, CLOSE), 1.0
    )
    half = page_turn(box.heading) / 2
    turn = rotation_matrix(2 * half, (0, 1, 0))[:3, :3]
    place = to_page(np.array(box.center)) - turn @ (scale * bounds.mean(axis=0))
    return packer.node(
        box.label or box.category,
        children=guest.stand(model.roots),
        translation=place.tolist(),
        rotation=[0.0, sin(half), 0.0, cos(half)],
        scale=scale.tolist() if (scale != 1).any() else None,
    )
