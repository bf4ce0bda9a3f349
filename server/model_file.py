"""A model that somebody else made: whether it is usable, and how large it is.

Nothing outside the file is ever opened.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from trimesh import transform_points
from trimesh.bounds import corners
from trimesh.transformations import quaternion_matrix

from server.furniture.mesh import Floats
from server.gltf_records import Accessor, Gltf, Node, Primitive, read_glb

OVERLAP = 2  # times its data that the slices of a file may be together; each is written by itself
COMPONENT_BYTES = {5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4}
COMPONENTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT2": 4, "MAT3": 9, "MAT4": 16}
MAX_DEPTH = 100  # nodes inside one another
MAX_TRIANGLES = 1_000_000
SMALLEST, LARGEST = 0.01, 20.0  # metres; nothing smaller or larger is furniture
TRIANGLE_MODES = (4, 5, 6)  # TRIANGLES, TRIANGLE_STRIP, TRIANGLE_FAN
READABLE = frozenset({
    "KHR_lights_punctual", "KHR_materials_anisotropy", "KHR_materials_clearcoat",
    "KHR_materials_dispersion", "KHR_materials_emissive_strength", "KHR_materials_ior",
    "KHR_materials_iridescence", "KHR_materials_sheen", "KHR_materials_specular",
    "KHR_materials_transmission", "KHR_materials_unlit", "KHR_materials_volume",
    "KHR_mesh_quantization", "KHR_texture_transform", "EXT_texture_webp", "EXT_texture_avif",
})  # fmt: skip
"""Extensions that every page can show; those that compress need a decoder."""


@dataclass(frozen=True, slots=True, eq=False)
class Model:
    """A model that was found usable."""

    gltf: Gltf
    roots: tuple[int, ...]
    """The root nodes of the scene that is shown."""
    bounds: Floats
    """Lowest and highest coordinates (2, 3), metres."""


def read_model(data: bytes) -> Model:
    """The model in a GLB; ValueError says why it is not usable."""
    gltf = read_glb(data)
    try:
        _check_self_contained(gltf, len(gltf.binary_blob() or b""))
        with np.errstate(over="ignore", invalid="ignore"):  # absurd numbers are refused below
            bounds = bounds_of(gltf)
    except IndexError:
        raise ValueError("it points to parts that are not there") from None
    return Model(gltf, tuple(roots_of(gltf)), bounds)


def roots_of(gltf: Gltf) -> list[int]:
    """The root nodes of the scene that is shown."""
    if gltf.scenes:
        return gltf.scenes[gltf.scene].nodes
    inner = {child for node in gltf.nodes for child in node.children}
    return [number for number in range(len(gltf.nodes)) if number not in inner]


def bounds_of(gltf: Gltf) -> Floats:
    """Lowest and highest coordinates (2, 3) of all triangles, through the nodes; ValueError."""
    outermost: list[Floats] = []
    triangles, seen = 0, set[int]()
    waiting = [(root, np.eye(4), 1) for root in roots_of(gltf)]
    while waiting:
        number, outer, depth = waiting.pop()
        if number in seen or depth > MAX_DEPTH:
            raise ValueError("its nodes go round in a circle or lie too deep in one another")
        seen.add(number)
        node = gltf.nodes[number]
        matrix = outer @ _matrix(node)
        waiting += [(child, matrix, depth + 1) for child in node.children]
        if node.mesh is not None:
            for primitive in gltf.meshes[node.mesh].primitives:
                if primitive.mode in TRIANGLE_MODES:
                    outermost.append(transform_points(_corners(gltf, primitive), matrix))
                    triangles += _count(gltf, primitive) // 3
    if triangles == 0:
        raise ValueError("it has no triangles")
    if triangles > MAX_TRIANGLES:
        raise ValueError(f"it has {triangles:,} triangles; simplify it to {MAX_TRIANGLES:,}")
    points = np.concatenate(outermost)
    if not np.isfinite(points).all():
        raise ValueError("some of its coordinates are not numbers")
    return np.array([points.min(axis=0), points.max(axis=0)])


def size_problem(size: Floats) -> str | None:
    """What is wrong with a size (3,), metres, or None; names the unit that it looks like."""
    longest = float(size.max())
    if longest > 100 * LARGEST:
        return f"it is {longest:,.0f} m long, as if in millimetres; scale it by 0.001"
    if longest > LARGEST:
        return f"it is {longest:,.0f} m long, as if in centimetres; scale it by 0.01"
    if longest < SMALLEST:
        return f"it is only {1000 * longest:.2g} mm long; export it in metres"
    return None


def _check_self_contained(gltf: Gltf, available: int) -> None:
    """ValueError if it needs other files, decoders or bytes that are not there."""
    if not gltf.asset.version.startswith("2."):
        raise ValueError(f"it is glTF {gltf.asset.version}; export it as glTF 2.0")
    unreadable = sorted(set(gltf.extensionsRequired) - READABLE)
    if unreadable:
        raise ValueError(f"it needs {', '.join(unreadable)}; export it without compression")
    if any(buffer.uri is not None for buffer in gltf.buffers) or len(gltf.buffers) > 1:
        raise ValueError("its data lies in other files; export it as one GLB")
    if any(image.uri and not image.uri.startswith("data:image/") for image in gltf.images):
        raise ValueError("its pictures lie in other files; export it as one GLB")
    for view in gltf.bufferViews:
        if view.buffer != 0 or view.byteOffset + view.byteLength > available:
            raise ValueError("it is cut short: some of its data is missing")
    if sum(view.byteLength for view in gltf.bufferViews) > OVERLAP * available:
        raise ValueError("its parts share their data over and over; export it again")
    if any(_needs(gltf, accessor) > 0 for accessor in gltf.accessors):
        raise ValueError("one of its arrays is longer than its data")


def _needs(gltf: Gltf, accessor: Accessor) -> int:
    """How many bytes an array reaches beyond its slice; none if 0 or less."""
    if accessor.bufferView is None:
        return 0
    view = gltf.bufferViews[accessor.bufferView]
    element = COMPONENT_BYTES[accessor.componentType] * COMPONENTS[accessor.type]
    stride = view.byteStride or element
    return (accessor.byteOffset or 0) + stride * (accessor.count - 1) + element - view.byteLength


def _matrix(node: Node) -> Floats:
    """The transform (4, 4) of a node."""
    if node.matrix is not None:
        return np.array(node.matrix).reshape(4, 4).T
    x, y, z, w = node.rotation or (0.0, 0.0, 0.0, 1.0)
    matrix: Floats = quaternion_matrix((w, x, y, z))
    matrix[:3, :3] *= node.scale or (1.0, 1.0, 1.0)
    matrix[:3, 3] = node.translation or (0.0, 0.0, 0.0)
    return matrix


def _corners(gltf: Gltf, primitive: Primitive) -> Floats:
    """The eight corners (8, 3) of a primitive's own bounds."""
    if "POSITION" not in primitive.attributes:
        raise ValueError("one of its parts has no positions")
    accessor = gltf.accessors[primitive.attributes["POSITION"]]
    if len(accessor.min) != 3 or len(accessor.max) != 3:  # noqa: PLR2004 (x, y, z)
        raise ValueError("one of its parts does not say how large it is")
    points: Floats = corners([accessor.min, accessor.max])
    return points


def _count(gltf: Gltf, primitive: Primitive) -> int:
    number = primitive.indices
    if number is None:
        number = primitive.attributes["POSITION"]
    return gltf.accessors[number].count
