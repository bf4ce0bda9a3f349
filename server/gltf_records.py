"""The classes of pygltflib with the ranges of glTF 2.0, so that strangers' files are checked.

Specification: https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html
"""
# mypy: allow-subclassing-any

from __future__ import annotations

from dataclasses import dataclass, field
from struct import pack, unpack_from
from typing import Annotated, Any, Literal, Self

import msgspec
import pygltflib
from msgspec import Meta

MAX_NODES = 20_000
MAX_JSON_BYTES = 4_000_000  # about 40,000 arrays; pygltflib writes that in a second or two
JSON_START = 20  # bytes: the header of the file and that of its first part

Index = Annotated[int, Meta(ge=0)]
Length = Annotated[int, Meta(ge=1)]
Triple = Annotated[list[float], Meta(min_length=3, max_length=3)]
Quaternion = Annotated[list[float], Meta(min_length=4, max_length=4)]
Matrix = Annotated[list[float], Meta(min_length=16, max_length=16)]


@dataclass(kw_only=True)
class SceneNodes(pygltflib.Scene):
    """The roots of a scene."""

    nodes: list[Index] = field(default_factory=list)


@dataclass(kw_only=True)
class Node(pygltflib.Node):
    """A place in the tree."""

    children: list[Index] = field(default_factory=list)
    mesh: Index | None = None
    matrix: Matrix | None = None
    translation: Triple | None = None
    rotation: Quaternion | None = None
    scale: Triple | None = None


@dataclass(kw_only=True)
class Primitive(pygltflib.Primitive):
    """What is drawn at once."""

    attributes: dict[str, Index]
    indices: Index | None = None
    mode: Index = pygltflib.TRIANGLES
    targets: list[dict[str, Index]] = field(default_factory=list)


@dataclass(kw_only=True)
class MeshRecord(pygltflib.Mesh):
    """Primitives that belong together."""

    primitives: list[Primitive]


@dataclass(kw_only=True)
class Accessor(pygltflib.Accessor):
    """An array."""

    count: Length
    componentType: Literal[5120, 5121, 5122, 5123, 5125, 5126]  # noqa: N815
    type: Literal["SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"]
    bufferView: Index | None = None  # noqa: N815
    byteOffset: Index | None = None  # noqa: N815 (not 0: wrong without a bufferView)

    def __post_init__(self) -> None:
        """Refuse what lacks a part."""
        _require(self, "count", "componentType", "type")


@dataclass(kw_only=True)
class BufferView(pygltflib.BufferView):
    """A slice of the buffer."""

    buffer: Index
    byteLength: Length  # noqa: N815
    byteOffset: Index = 0  # noqa: N815
    byteStride: Annotated[int, Meta(ge=4, le=252)] | None = None  # noqa: N815

    def __post_init__(self) -> None:
        """Refuse what lacks a part."""
        _require(self, "buffer", "byteLength")


@dataclass(kw_only=True)
class Gltf(pygltflib.GLTF2):
    """A glTF document."""

    asset: pygltflib.Asset
    scene: Index = 0
    scenes: list[SceneNodes] = field(default_factory=list)
    nodes: Annotated[list[Node], Meta(max_length=MAX_NODES)] = field(default_factory=list)
    meshes: list[MeshRecord] = field(default_factory=list)
    accessors: list[Accessor] = field(default_factory=list)
    bufferViews: list[BufferView] = field(default_factory=list)  # noqa: N815

    @classmethod
    def from_json(cls, s: str, **_: Any) -> Self:
        """What pygltflib reads a file with: here checked, and a hundred times as fast."""
        return msgspec.json.decode(s, type=cls)


def read_glb(data: bytes) -> Gltf:
    """What pygltflib reads once the container is known to be whole; ValueError."""
    if len(data) < JSON_START or not data.startswith(pygltflib.MAGIC):
        raise ValueError("it is not a GLB file")
    version, total, length = unpack_from("<III", data, 4)
    if version != pygltflib.GLTF_VERSION:
        raise ValueError(f"it is glTF {version}; export it as glTF 2.0")
    if total != len(data):
        raise ValueError(f"it is cut short or damaged ({len(data)} of {total} bytes)")
    if data[16:20] != pygltflib.JSON.encode():
        raise ValueError("its first part is not JSON")
    if length > MAX_JSON_BYTES:
        raise ValueError(
            f"its JSON is larger than {MAX_JSON_BYTES / 1e6:.0f} MB; "
            "export it with fewer parts, and with its pictures as binary"
        )
    end = JSON_START + length
    if data[end + 4 : end + 8] == pygltflib.BIN.encode():
        end += 8 + unpack_from("<I", data, end)[0]
    if end > total:
        raise ValueError("one of its parts is cut short")
    try:  # the parts of extensions, which may follow, are left out
        gltf: Gltf = Gltf.load_from_bytes(data[:8] + pack("<I", end) + data[12:end])
    except msgspec.ValidationError as error:
        raise ValueError(f"its JSON is not that of a glTF: {error}") from None
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError) as error:
        raise ValueError(f"its JSON is damaged ({error})") from None
    return gltf


def _require(record: object, *names: str) -> None:
    """ValueError if one is not given: pygltflib has None for them all."""
    missing = [name for name in names if getattr(record, name) is None]
    if missing:
        raise ValueError(f"it has no {', '.join(missing)}")
