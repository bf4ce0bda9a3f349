"""GLB files seen through other people's eyes: Khronos' validator, pygltflib and trimesh."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Mapping
from dataclasses import dataclass
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np
import pygltflib
import trimesh
from numpy.typing import NDArray

SCRIPT = Path(__file__).with_name("validate_glb.mjs")
TYPES = {5123: "<u2", 5125: "<u4", 5126: "<f4"}
WIDTHS = {"SCALAR": 1, "VEC3": 3}


@dataclass(frozen=True)
class Primitive:
    material: str
    positions: NDArray[np.float64]
    normals: NDArray[np.float64]
    faces: NDArray[np.int64]


def complaints(files: Mapping[str, bytes], directory: Path) -> dict[str, list[str]]:
    """The validator's errors and warnings of each file that has some."""
    paths = {name: directory / f"{number}.glb" for number, name in enumerate(files)}
    for name, path in paths.items():
        path.write_bytes(files[name])
    run = subprocess.run(
        ["node", str(SCRIPT), *map(str, paths.values())],
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode == 0, f"the glTF validator does not run; `npm ci` first?\n{run.stderr}"
    found = json.loads(run.stdout)
    assert len(found) == len(files)
    return {name: found[str(path)] for name, path in paths.items() if found[str(path)]}


def exported(mesh: Any) -> bytes:
    """The GLB that trimesh makes of a mesh or scene."""
    return bytes(mesh.export(file_type="glb"))


def bounds(data: bytes) -> NDArray[np.float64]:
    """Lowest and highest coordinates (2, 3) of all that is in a file, through its nodes."""
    scene = trimesh.load_scene(BytesIO(data), file_type="glb")
    return np.asarray(scene.bounds, dtype=np.float64)


def document(data: bytes) -> pygltflib.GLTF2:
    return pygltflib.GLTF2.load_from_bytes(data)


def primitives(data: bytes) -> list[Primitive]:
    """The primitives of all meshes, each in its own frame."""
    gltf = document(data)
    blob = gltf.binary_blob()

    def array(number: int) -> NDArray[np.float64]:
        accessor = gltf.accessors[number]
        view = gltf.bufferViews[accessor.bufferView]
        start = (view.byteOffset or 0) + (accessor.byteOffset or 0)
        width = WIDTHS[accessor.type]
        flat = np.frombuffer(blob, TYPES[accessor.componentType], accessor.count * width, start)
        return flat.reshape(-1, width).astype(np.float64)

    return [
        Primitive(
            material=gltf.materials[part.material].name,
            positions=array(part.attributes.POSITION),
            normals=array(part.attributes.NORMAL),
            faces=array(part.indices).astype(np.int64).reshape(-1, 3),
        )
        for mesh in gltf.meshes
        for part in mesh.primitives
    ]
