"""Parametric furniture as GLB: any category at any size."""

from __future__ import annotations

import numpy as np
from trimesh import unitize

from scenegen_core.scene.model import Vector3
from server.furniture import beds, chairs, decor, others, pictures, sofas, storage, tables
from server.furniture.design import Design, bounds
from server.furniture.glb import Packer
from server.furniture.materials import Material
from server.furniture.mesh import Floats, Mesh, merged

__all__ = ["furniture_glb", "on_wall"]

CHOICES = {
    "Bed": beds.choose,
    "Chair": chairs.choose,
    "Decor": decor.choose,
    "Picture": pictures.choose_picture,
    "Sofa": sofas.choose,
    "Storage": storage.choose,
    "Table": tables.choose,
}


def on_wall(category: str, *, wall: bool = False) -> bool:
    """Whether a model of that category has its origin at the center of its back."""
    return category == "Picture" or (wall and category == "TV")


def furniture_glb(category: str, size: Vector3, label: str = "", *, wall: bool = False) -> bytes:
    """A piece of furniture as GLB: metres, y up, its front looks along +z.

    The same arguments give the same bytes. An unknown category gives a plain soft box.

    Args:
        category: Name of a category, as in ``PAPER_CATEGORIES``.
        size: Depth (z), width (x) and height (y) that the geometry fills exactly, metres.
        label: What it is called, for a more fitting shape: "corner sofa", "bookcase".
        wall: Whether a TV hangs on the wall.

    Returns:
        The file; its origin is the center of the base, or of the back if it hangs on the wall.
    """
    design = _design(category, size, label.lower(), wall=wall)
    parts = design.parts(size)
    depth, width, height = size
    low = np.array([-width / 2, 0.0, -depth / 2])
    if on_wall(category, wall=wall):
        low = np.array([-width / 2, -height / 2, 0.0])
    return _pack(design.name, parts, low, np.array([width, height, depth]))


def _design(category: str, size: Vector3, label: str, *, wall: bool) -> Design:
    if category == "TV":
        return pictures.choose_screen(size, wall=wall)
    return CHOICES.get(category, others.choose)(size, label)


def _pack(name: str, parts: list[tuple[Material, Mesh]], low: Floats, size: Floats) -> bytes:
    """The parts stretched to fill the box of that size at ``low``, one primitive a material."""
    was_low, was_high = bounds(parts)
    scale = size / (was_high - was_low)
    packer = Packer()
    primitives = []
    for material in dict.fromkeys(material for material, _ in parts):
        positions, normals, colors, faces = merged(mesh for own, mesh in parts if own is material)
        primitives.append(
            packer.primitive(
                packer.material(material),
                (positions - was_low) * scale + low,
                unitize(normals / scale),
                colors if material.painted else None,
                faces,
            )
        )
    return packer.glb([packer.mesh_node(name, primitives)])
