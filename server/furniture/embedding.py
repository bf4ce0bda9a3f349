"""One GLB inside another: its parts renumbered to follow those that are there."""

from __future__ import annotations

from collections.abc import Iterable
from copy import deepcopy
from dataclasses import is_dataclass
from typing import Any

from pygltflib import GLTF2

from server.furniture.glb import Packer

SHARED = ("accessors", "bufferViews", "images", "materials", "meshes", "samplers", "textures")
OWN = ("nodes", "skins")
"""Lists whose entries have one place in the room, so that every copy needs its own."""
REFERENCES = {
    "attributes": "accessors", "bufferView": "bufferViews", "children": "nodes",
    "index": "textures", "indices": "accessors", "inverseBindMatrices": "accessors",
    "joints": "nodes", "material": "materials", "mesh": "meshes", "sampler": "samplers",
    "skeleton": "nodes", "skin": "skins", "source": "images", "targets": "accessors",
}  # fmt: skip
"""Which list a number under that name points into (glTF 2.0, chapter 5)."""
STILL_LISTED = ("KHR_mesh_quantization",)
"""Extensions without an object of their own, known by their name alone."""

Ranges = dict[str, range]
"""Where the entries of each list go."""


class Guest:
    """A document copied into another once, whose nodes can then stand there many times."""

    def __init__(self, packer: Packer, source: GLTF2) -> None:
        """Move in all but the nodes; animations, cameras and lights stay behind.

        Args:
            packer: Grows by the lists and the binary of the source.
            source: A document of one buffer that is used up.

        Raises:
            ValueError: A reference points nowhere.
        """
        self._target, self._source = packer.gltf, source
        primitives = [primitive for mesh in source.meshes for primitive in mesh.primitives]
        for part in (*source.nodes, *source.meshes, *primitives):
            part.extensions = {}  # lights and variants point into lists that are not copied
        for node in source.nodes:
            node.camera = None
        self._ranges = self._next(SHARED) | self._next(OWN)
        used = set(STILL_LISTED)
        for kind in SHARED:
            used |= _renumber(getattr(source, kind), self._ranges)
            getattr(self._target, kind).extend(getattr(source, kind))
        for view in source.bufferViews:
            view.byteOffset += len(packer.binary)
        packer.binary += source.binary_blob() or b""
        for kind in ("extensionsUsed", "extensionsRequired"):
            names = used & set(getattr(source, kind)) | set(getattr(self._target, kind))
            setattr(self._target, kind, sorted(names))

    def stand(self, roots: Iterable[int]) -> list[int]:
        """Copy the nodes; the numbers in the target of those that were ``roots``."""
        self._ranges |= self._next(OWN)
        for kind in OWN:
            copies = deepcopy(getattr(self._source, kind))
            _renumber(copies, self._ranges)
            getattr(self._target, kind).extend(copies)
        return [self._ranges["nodes"][root] for root in roots]

    def _next(self, kinds: tuple[str, ...]) -> Ranges:
        """Where the source's entries go when they are appended now."""
        ranges = {}
        for kind in kinds:
            first = len(getattr(self._target, kind))
            ranges[kind] = range(first, first + len(getattr(self._source, kind)))
        return ranges


def _renumber(value: Any, ranges: Ranges) -> set[str]:
    """Renumber all references inside, in place; the names of the extensions found there."""
    if isinstance(value, list):
        return set().union(*(_renumber(item, ranges) for item in value))
    fields = value if isinstance(value, dict) else getattr(value, "__dict__", {})
    found = set[str]()
    for name, inner in fields.items():
        if name == "extras" or inner is None:
            continue
        if name == "extensions" and isinstance(inner, dict):
            found |= inner.keys()
        if name in REFERENCES and not is_dataclass(inner):  # indices can be a record, too
            fields[name] = _shifted(inner, ranges[REFERENCES[name]])
        else:
            found |= _renumber(inner, ranges)
    return found


def _shifted(value: Any, numbers: range) -> Any:
    """The numbers inside, renumbered; ValueError if one points nowhere."""
    if isinstance(value, dict):
        return {name: _shifted(inner, numbers) for name, inner in value.items()}
    if isinstance(value, list):
        return [_shifted(inner, numbers) for inner in value]
    if type(value) is not int or not 0 <= value < len(numbers):
        raise ValueError("it points to parts that are not there")
    return numbers[value]
