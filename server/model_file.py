"""A model that somebody else made: whether it is usable, and how large it is.

Nothing outside the file is ever opened.
"""

from __future__ import annotations

from dataclasses import dataclass

import msgspec
import numpy as np

from server.furniture.glb import Document, read_glb
from server.furniture.mesh import Floats
from server.gltf_records import COMPONENT_BYTES, COMPONENTS, Accessor, Gltf, Node, Primitive

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

    document: Document
    binary: bytes
    roots: tuple[int, ...]
    """The root nodes of the scene that is shown."""
    bounds: Floats
    """Lowest and highest coordinates (2, 3), metres."""


def read_model(data: bytes) -> Model:
    """The model in a GLB; ValueError says why it is not usable."""
    document, binary = read_glb(data)
    try:
        gltf = msgspec.convert(document, Gltf)
    except msgspec.ValidationError as error:
        raise ValueError(f"its JSON is not that of a glTF: {error}") from None
    try:
        _check_self_contained(gltf, len(binary))
        with np.errstate(over="ignore", invalid="ignore"):  # absurd numbers are refused below
            bounds = bounds_of(gltf)
    except IndexError:
        raise ValueError("it points to parts that are not there") from None
    return Model(document, binary, tuple(roots_of(gltf)), bounds)


def roots_of(gltf: Gltf) -> list[int]:
    """The root nodes of the scene that is shown."""
    if gltf.scenes:
        return gltf.scenes[gltf.scene].nodes
    inner = {child for node in gltf.nodes for child in node.children}
    return [number for number in range(len(gltf.nodes)) if number not in inner]


def bounds_of(gltf: Gltf) -> Floats:
    """Lowest and highest coordinates (2, 3) of all triangles, through the nodes; ValueError."""
    corners: list[Floats] = []
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
                    corners.append(_corners(gltf, primitive) @ matrix[:3, :3].T + matrix[:3, 3])
                    triangles += _count(gltf, primitive) // 3
    if triangles == 0:
        raise ValueError("it has no triangles")
    if triangles > MAX_TRIANGLES:
        raise ValueError(f"it has {triangles:,} triangles; simplify it to {MAX_TRIANGLES:,}")
    points = np.concatenate(corners)
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
    unreadable = sorted(set(gltf.extensions_required) - READABLE)
    if unreadable:
        raise ValueError(f"it needs {', '.join(unreadable)}; export it without compression")
    if any(buffer.uri is not None for buffer in gltf.buffers) or len(gltf.buffers) > 1:
        raise ValueError("its data lies in other files; export it as one GLB")
    if any(image.uri and not image.uri.startswith("data:image/") for image in gltf.images):
        raise ValueError("its pictures lie in other files; export it as one GLB")
    for view in gltf.buffer_views:
        if view.buffer != 0 or view.byte_offset + view.byte_length > available:
            raise ValueError("it is cut short: some of its data is missing")
    if any(_needs(gltf, accessor) > 0 for accessor in gltf.accessors):
        raise ValueError("one of its arrays is longer than its data")


def _needs(gltf: Gltf, accessor: Accessor) -> int:
    """How many bytes an array reaches beyond its slice; none if 0 or less."""
    if accessor.buffer_view is None:
        return 0
    view = gltf.buffer_views[accessor.buffer_view]
    element = COMPONENT_BYTES[accessor.component_type] * COMPONENTS[accessor.type]
    stride = view.byte_stride or element
    return accessor.byte_offset + stride * (accessor.count - 1) + element - view.byte_length


def _matrix(node: Node) -> Floats:
    """The transform (4, 4) of a node."""
    if node.matrix is not None:
        return np.array(node.matrix).reshape(4, 4).T
    x, y, z, w = node.rotation
    matrix = np.eye(4)
    matrix[:3, :3] = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ]
    matrix[:3, :3] *= node.scale
    matrix[:3, 3] = node.translation
    return matrix


def _corners(gltf: Gltf, primitive: Primitive) -> Floats:
    """The eight corners (8, 3) of a primitive's own bounds."""
    if "POSITION" not in primitive.attributes:
        raise ValueError("one of its parts has no positions")
    accessor = gltf.accessors[primitive.attributes["POSITION"]]
    if len(accessor.min) != 3 or len(accessor.max) != 3:  # noqa: PLR2004 (x, y, z)
        raise ValueError("one of its parts does not say how large it is")
    limits = np.array([accessor.min, accessor.max])
    return limits[np.indices((2, 2, 2)).reshape(3, 8).T, np.arange(3)]


def _count(gltf: Gltf, primitive: Primitive) -> int:
    number = primitive.indices
    if number is None:
        number = primitive.attributes["POSITION"]
    return gltf.accessors[number].count
