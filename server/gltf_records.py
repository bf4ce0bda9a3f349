"""The part of glTF 2.0 that is needed to measure a model, checked when it is read.

Specification: https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html
"""

from __future__ import annotations

from typing import Annotated, Any, Literal

from msgspec import Meta, Struct

MAX_NODES = 20_000
COMPONENT_BYTES = {5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4}
COMPONENTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT2": 4, "MAT3": 9, "MAT4": 16}

Loose = dict[str, Any]
"""Parts that are only copied."""
Index = Annotated[int, Meta(ge=0)]
Triple = tuple[float, float, float]
Matrix = Annotated[list[float], Meta(min_length=16, max_length=16)]


class Asset(Struct, frozen=True):
    """Which glTF it is."""

    version: str


class SceneNodes(Struct, frozen=True):
    """The roots of a scene."""

    nodes: list[Index] = []


class Node(Struct, frozen=True):
    """A place in the tree."""

    children: list[Index] = []
    mesh: Index | None = None
    matrix: Matrix | None = None
    translation: Triple = (0.0, 0.0, 0.0)
    rotation: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 1.0)
    scale: Triple = (1.0, 1.0, 1.0)


class Primitive(Struct, frozen=True):
    """What is drawn at once."""

    attributes: dict[str, Index]
    indices: Index | None = None
    mode: Index = 4


class MeshRecord(Struct, frozen=True):
    """Primitives that belong together."""

    primitives: list[Primitive]


class Accessor(Struct, frozen=True, rename="camel"):
    """An array."""

    count: Annotated[int, Meta(ge=1)]
    component_type: Literal[5120, 5121, 5122, 5123, 5125, 5126]
    type: Literal["SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"]
    byte_offset: Index = 0
    buffer_view: Index | None = None
    min: list[float] = []
    max: list[float] = []


class BufferView(Struct, frozen=True, rename="camel"):
    """A slice of the buffer."""

    buffer: Index
    byte_length: Annotated[int, Meta(ge=1)]
    byte_offset: Index = 0
    byte_stride: Annotated[int, Meta(ge=4, le=252)] | None = None


class External(Struct, frozen=True):
    """A buffer or an image; a uri means that it is another file."""

    uri: str | None = None


class Gltf(Struct, frozen=True, rename="camel"):
    """A glTF document."""

    asset: Asset
    scene: Index = 0
    scenes: list[SceneNodes] = []
    nodes: Annotated[list[Node], Meta(max_length=MAX_NODES)] = []
    meshes: list[MeshRecord] = []
    accessors: list[Accessor] = []
    buffer_views: list[BufferView] = []
    buffers: list[External] = []
    images: list[External] = []
    materials: list[Loose] = []
    textures: list[Loose] = []
    samplers: list[Loose] = []
    skins: list[Loose] = []
    extensions_used: list[str] = []
    extensions_required: list[str] = []
