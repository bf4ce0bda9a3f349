"""GLB, the binary form of glTF 2.0: the container, and meshes packed into one.

Specification: https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html
"""

from __future__ import annotations

from struct import pack, unpack_from
from typing import Any

import msgspec
import numpy as np

from server.furniture.materials import Material
from server.furniture.mesh import Floats, Ints

Document = dict[str, Any]
"""The JSON of a glTF."""

MAGIC, VERSION = 0x46546C67, 2  # "glTF"
JSON_CHUNK, BINARY_CHUNK = 0x4E4F534A, 0x004E4942
HEADER_BYTES, CHUNK_BYTES = 12, 8
FLOAT, UNSIGNED_SHORT, UNSIGNED_INT = 5126, 5123, 5125
VERTICES, INDICES = 34962, 34963
ASSET = {"version": "2.0", "generator": "SceneGen"}


def write_glb(document: Document, binary: bytes) -> bytes:
    """The bytes of a GLB with one buffer."""
    text = msgspec.json.encode(document)
    text += b" " * (-len(text) % 4)
    binary += b"\0" * (-len(binary) % 4)
    total = HEADER_BYTES + 2 * CHUNK_BYTES + len(text) + len(binary)
    return b"".join(
        (
            pack("<III", MAGIC, VERSION, total),
            pack("<II", len(text), JSON_CHUNK),
            text,
            pack("<II", len(binary), BINARY_CHUNK),
            binary,
        )
    )


def read_glb(data: bytes) -> tuple[Document, bytes]:
    """The JSON and the binary chunk of a GLB; ValueError says what is wrong with it."""
    if len(data) < HEADER_BYTES + CHUNK_BYTES or unpack_from("<I", data)[0] != MAGIC:
        raise ValueError("it is not a GLB file")
    _, version, total = unpack_from("<III", data)
    if version != VERSION:
        raise ValueError(f"it is glTF {version}; export it as glTF 2.0")
    if total != len(data):
        raise ValueError(f"it is cut short or damaged ({len(data)} of {total} bytes)")
    chunks = _chunks(data)
    if chunks[0][0] != JSON_CHUNK:
        raise ValueError("its first part is not JSON")
    try:
        document = msgspec.json.decode(chunks[0][1], type=dict)
    except (msgspec.DecodeError, RecursionError) as error:
        raise ValueError(f"its JSON is damaged ({error})") from None
    binary = next((content for kind, content in chunks[1:] if kind == BINARY_CHUNK), b"")
    return document, binary


def _chunks(data: bytes) -> list[tuple[int, bytes]]:
    """Kind and content of every chunk."""
    chunks, at = [], HEADER_BYTES
    while at + CHUNK_BYTES <= len(data):
        length, kind = unpack_from("<II", data, at)
        at += CHUNK_BYTES
        if at + length > len(data):
            raise ValueError("one of its parts is cut short")
        chunks.append((kind, data[at : at + length]))
        at += length
    return chunks


class Packer:
    """Collects materials and meshes into one document and its binary."""

    def __init__(self) -> None:
        self.document: Document = {"asset": ASSET, "scene": 0}
        self.binary = bytearray()

    def add(self, kind: str, value: Document) -> int:
        """Append to one of the document's lists; its index."""
        values = self.document.setdefault(kind, [])
        values.append(value)
        return len(values) - 1

    def material(self, material: Material) -> int:
        """Add a finish."""
        value: Document = {
            "name": material.name,
            "pbrMetallicRoughness": {
                "baseColorFactor": [*material.color, material.opacity],
                "metallicFactor": material.metallic,
                "roughnessFactor": material.roughness,
            },
        }
        if any(material.glow):
            value["emissiveFactor"] = material.glow
        if material.opacity < 1:
            value["alphaMode"] = "BLEND"
        if material.thin:
            value["doubleSided"] = True
        return self.add("materials", value)

    def primitive(
        self, material: int, positions: Floats, normals: Floats, colors: Floats | None, faces: Ints
    ) -> Document:
        """Add the arrays of a mesh of one material; the primitive that draws them."""
        attributes = {
            "POSITION": self._vectors(positions, bounds=True),
            "NORMAL": self._vectors(normals, bounds=False),
        }
        if colors is not None:
            attributes["COLOR_0"] = self._colors(colors)
        return {"attributes": attributes, "indices": self._indices(faces), "material": material}

    def glb(self, nodes: list[int]) -> bytes:
        """The finished file, whose scene has these root nodes."""
        self.add("scenes", {"nodes": nodes})
        self.document["buffers"] = [{"byteLength": len(self.binary)}]
        return write_glb(self.document, bytes(self.binary))

    def _vectors(self, values: Floats, *, bounds: bool) -> int:
        array = values.astype("<f4")
        accessor: Document = {"componentType": FLOAT, "count": len(array), "type": "VEC3"}
        if bounds:
            accessor |= {"min": array.min(axis=0).tolist(), "max": array.max(axis=0).tolist()}
        return self._accessor(accessor, array.tobytes(), VERTICES)

    def _colors(self, values: Floats) -> int:
        rgba = np.concatenate([values, np.ones((len(values), 1))], axis=1)
        array = np.rint(rgba * 0xFFFF).astype("<u2")
        return self._accessor(
            {
                "componentType": UNSIGNED_SHORT,
                "normalized": True,
                "count": len(array),
                "type": "VEC4",
            },
            array.tobytes(),
            VERTICES,
        )

    def _indices(self, faces: Ints) -> int:
        kind, code = ("<u2", UNSIGNED_SHORT) if faces.max() < 0xFFFF else ("<u4", UNSIGNED_INT)  # noqa: PLR2004
        array = faces.ravel().astype(kind)
        return self._accessor(
            {"componentType": code, "count": len(array), "type": "SCALAR"},
            array.tobytes(),
            INDICES,
        )

    def _accessor(self, accessor: Document, data: bytes, target: int) -> int:
        """Add an accessor with a view of its own."""
        self.binary += b"\0" * (-len(self.binary) % 4)
        view = {
            "buffer": 0,
            "byteOffset": len(self.binary),
            "byteLength": len(data),
            "target": target,
        }
        self.binary += data
        return self.add("accessors", {"bufferView": self.add("bufferViews", view), **accessor})
