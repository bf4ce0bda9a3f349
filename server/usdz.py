"""A GLB as USDZ, the form of 3D model that iPhones show in a room: metres, y up.

USDZ is a zip that is not compressed, whose files begin at multiples of 64 bytes, the stage first
(Pixar, *Usdz File Format Specification*, 1.3). Quick Look reads no colors of vertices: a part that
has some becomes several, one a color.
"""

from __future__ import annotations

from collections.abc import Iterator
from io import BytesIO
from struct import pack
from typing import Any
from zipfile import ZIP_STORED, ZipFile, ZipInfo

import numpy as np
from PIL import Image
from trimesh import Trimesh, load_scene, transform_points, unitize

from server.furniture.mesh import Floats, Ints
from server.usda import Part, Surface, stage

ALIGNMENT = 64  # bytes
HEADER = 30  # bytes before the name of a file in a zip (APPNOTE.TXT, 4.3.7)
PADDING_ID = 0x1986  # what Pixar's own tools mark the padding with
MOST_COLORS = 24  # of one part; beyond, it gets their mean
MOST_PIXELS = (2048, 2048)  # as Apple advises for textures


def usdz(glb: bytes) -> bytes:
    """The model in another form; the same bytes give the same bytes."""
    textures: dict[str, bytes] = {}
    parts = [part for mesh, place in _meshes(glb) for part in _parts(mesh, place, textures)]
    return packed({"model.usda": stage(parts).encode(), **textures})


def packed(files: dict[str, bytes]) -> bytes:
    """The files as one zip, stored, each beginning at a multiple of 64 bytes."""
    archive = BytesIO()
    with ZipFile(archive, "w", ZIP_STORED) as zipped:
        for name, data in files.items():
            entry = ZipInfo(name)
            begins = archive.tell() + HEADER + len(name.encode()) + 4  # 4: before the padding
            space = -begins % ALIGNMENT
            entry.extra = pack("<HH", PADDING_ID, space) + bytes(space)
            zipped.writestr(entry, data)
    return archive.getvalue()


def _meshes(glb: bytes) -> Iterator[tuple[Trimesh, Floats]]:
    """The meshes with the matrices (4, 4) that put them in their places."""
    scene = load_scene(BytesIO(glb), file_type="glb", process=False)
    for node in scene.graph.nodes_geometry:
        matrix, name = scene.graph[node]
        mesh = scene.geometry[name]
        if isinstance(mesh, Trimesh):  # lines and points are left out
            yield mesh, np.asarray(matrix, float)


def _parts(mesh: Trimesh, place: Floats, textures: dict[str, bytes]) -> Iterator[Part]:
    """A mesh in the frame of the model, by color."""
    positions = transform_points(mesh.vertices, place)
    normals = unitize(mesh.vertex_normals @ np.linalg.inv(place[:3, :3]))
    faces = mesh.faces if np.linalg.det(place[:3, :3]) > 0 else mesh.faces[:, ::-1]
    uv, texture = _texture(mesh, textures)
    for color, own in _by_color(mesh, np.asarray(faces)):
        used, numbers = np.unique(own, return_inverse=True)
        yield Part(
            positions=positions[used],
            normals=normals[used],
            faces=numbers.reshape(-1, 3),
            uv=None if uv is None else uv[used],
            surface=_surface(mesh, color, texture),
        )


def _by_color(mesh: Trimesh, faces: Ints) -> list[tuple[Floats, Ints]]:
    """The faces by the color of their first corner; white without colors."""
    visual: Any = mesh.visual
    if visual.kind == "vertex":  # a mesh that has colors and no material
        levels = visual.vertex_colors
    else:
        levels = getattr(visual, "vertex_attributes", {}).get("color")
    if levels is None:
        return [(np.ones(3), faces)]
    most = np.iinfo(levels.dtype).max if np.issubdtype(levels.dtype, np.integer) else 1
    of_faces = np.asarray(levels, float)[faces[:, 0], :3] / most
    colors, numbers = np.unique(of_faces, axis=0, return_inverse=True)
    if len(colors) > MOST_COLORS:
        return [(of_faces.mean(axis=0), faces)]
    return [(color, faces[numbers.ravel() == number]) for number, color in enumerate(colors)]


def _surface(mesh: Trimesh, color: Floats, texture: str | None) -> Surface:
    material: Any = getattr(mesh.visual, "material", None)
    if material is None:
        return Surface(color=(color[0], color[1], color[2]))
    own = material.baseColorFactor
    rgba = np.ones(4) if own is None else np.asarray(own, float) / 0xFF
    red, green, blue = rgba[:3] * color
    glow = np.zeros(3) if material.emissiveFactor is None else material.emissiveFactor
    return Surface(
        color=(red, green, blue),
        opacity=rgba[3] if material.alphaMode == "BLEND" else 1.0,
        metallic=_or(material.metallicFactor, 1.0),
        roughness=_or(material.roughnessFactor, 1.0),
        glow=(glow[0], glow[1], glow[2]),
        thin=bool(material.doubleSided),
        texture=texture,
    )


def _or(value: float | None, default: float) -> float:
    """The value, or what glTF 2.0 has in its place."""
    return default if value is None else value


def _texture(mesh: Trimesh, textures: dict[str, bytes]) -> tuple[Floats | None, str | None]:
    """Coordinates (vertices, 2) and the file of the picture on a mesh, added to the textures."""
    uv = getattr(mesh.visual, "uv", None)
    picture = getattr(getattr(mesh.visual, "material", None), "baseColorTexture", None)
    if uv is None or not isinstance(picture, Image.Image):
        return None, None
    small, file = picture.convert("RGB"), BytesIO()
    small.thumbnail(MOST_PIXELS)
    small.save(file, "PNG")
    data = file.getvalue()
    known = {content: name for name, content in textures.items()}
    name = known.get(data, f"textures/{len(textures)}.png")
    textures[name] = data
    return np.asarray(uv, float), name
