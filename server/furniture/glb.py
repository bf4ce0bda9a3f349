"""Meshes and finishes packed into one GLB, the binary form of glTF 2.0, with pygltflib."""

from __future__ import annotations

from typing import Any

import numpy as np
import pygltflib
from numpy.typing import NDArray

from server.furniture.materials import Material
from server.furniture.mesh import Floats, Ints

COMPONENT_TYPES = {
    "float32": pygltflib.FLOAT,
    "uint16": pygltflib.UNSIGNED_SHORT,
    "uint32": pygltflib.UNSIGNED_INT,
}


class Packer:
    """Collects materials and meshes into one document and its binary."""

    def __init__(self) -> None:
        self.gltf = pygltflib.GLTF2(
            asset=pygltflib.Asset(generator="SceneGen"), buffers=[pygltflib.Buffer()], scene=0
        )
        self.binary = bytearray()

    def material(self, finish: Material) -> int:
        """Add a finish; its number."""
        return added(
            self.gltf.materials,
            pygltflib.Material(
                name=finish.name,
                pbrMetallicRoughness=pygltflib.PbrMetallicRoughness(
                    baseColorFactor=[*finish.color, finish.opacity],
                    metallicFactor=finish.metallic,
                    roughnessFactor=finish.roughness,
                ),
                emissiveFactor=list(finish.glow),
                alphaMode=pygltflib.BLEND if finish.opacity < 1 else pygltflib.OPAQUE,
                doubleSided=finish.thin,
            ),
        )

    def primitive(
        self, material: int, positions: Floats, normals: Floats, colors: Floats | None, faces: Ints
    ) -> pygltflib.Primitive:
        """Add the arrays of a mesh of one material; the primitive that draws them."""
        points = positions.astype("<f4")
        limits = {"min": points.min(axis=0).tolist(), "max": points.max(axis=0).tolist()}
        attributes = pygltflib.Attributes(
            POSITION=self._array(points, pygltflib.VEC3, **limits),
            NORMAL=self._array(normals.astype("<f4"), pygltflib.VEC3),
        )
        if colors is not None:
            rgba = np.concatenate([colors, np.ones((len(colors), 1))], axis=1)
            levels = np.rint(rgba * 0xFFFF).astype("<u2")
            attributes.COLOR_0 = self._array(levels, pygltflib.VEC4, normalized=True)
        numbers = faces.ravel().astype("<u2" if len(points) <= 0xFFFF else "<u4")  # noqa: PLR2004
        return pygltflib.Primitive(
            attributes=attributes,
            indices=self._array(numbers, pygltflib.SCALAR, pygltflib.ELEMENT_ARRAY_BUFFER),
            material=material,
        )

    def node(self, name: str, **more: Any) -> int:
        """Add a node; its number."""
        return added(self.gltf.nodes, pygltflib.Node(name=name, **more))

    def mesh_node(self, name: str, primitives: list[pygltflib.Primitive]) -> int:
        """Add a mesh and the node that shows it; the node's number."""
        mesh = added(self.gltf.meshes, pygltflib.Mesh(name=name, primitives=primitives))
        return self.node(name, mesh=mesh)

    def glb(self, roots: list[int]) -> bytes:
        """The finished file, whose scene has these root nodes."""
        self.gltf.scenes = [pygltflib.Scene(nodes=roots)]
        self.gltf.set_binary_blob(self.binary)
        return b"".join(self.gltf.save_to_bytes())

    def _array(
        self,
        values: NDArray[Any],
        kind: str,
        target: int = pygltflib.ARRAY_BUFFER,
        **more: Any,
    ) -> int:
        """Add an accessor with a view of its own, which pygltflib aligns when it writes."""
        view = pygltflib.BufferView(
            buffer=0, byteOffset=len(self.binary), byteLength=values.nbytes, target=target
        )
        self.binary += values.tobytes()
        return added(
            self.gltf.accessors,
            pygltflib.Accessor(
                bufferView=added(self.gltf.bufferViews, view),
                componentType=COMPONENT_TYPES[values.dtype.name],
                count=len(values),
                type=kind,
                **more,
            ),
        )


def added(values: list[Any], value: object) -> int:
    """Append to one of the lists of a document; the number of the value there."""
    values.append(value)
    return len(values) - 1
