"""One GLB inside another: its parts renumbered to follow those that are there."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, NamedTuple

from server.furniture.glb import Document

SHARED = ("accessors", "bufferViews", "images", "materials", "meshes", "samplers", "textures")
OWN = ("nodes", "skins")
"""Lists whose entries have one place in the room, so that every copy needs its own."""
REFERENCES = {
    "bufferView": "bufferViews", "children": "nodes", "index": "textures", "indices": "accessors",
    "inverseBindMatrices": "accessors", "joints": "nodes", "material": "materials",
    "mesh": "meshes", "sampler": "samplers", "skeleton": "nodes", "skin": "skins",
    "source": "images",
}  # fmt: skip
"""Which list a number under that name points into (glTF 2.0, chapter 5)."""
DROPPED = ("extras", "camera")
PLAIN = ("nodes", "meshes")
"""Lists whose extensions are dropped: lights and variants point into lists that are not copied."""
STILL_LISTED = ("KHR_mesh_quantization",)
"""Extensions without an object of their own, known by their name alone."""


class Range(NamedTuple):
    """Where the entries of one list go: the number of the first, and their number."""

    first: int
    length: int


class Guest:
    """A document copied into another once, whose nodes can then stand there many times."""

    def __init__(self, target: Document, binary: bytearray, source: Document, data: bytes) -> None:
        """Copy all but the nodes; animations, cameras and lights stay behind.

        Args:
            target: Grows by the lists of the source.
            binary: Grows by ``data``, at a multiple of four bytes.
            source: A document of one buffer.
            data: Its binary.

        Raises:
            ValueError: A reference points nowhere.
        """
        self._target, self._source = target, source
        binary += b"\0" * (-len(binary) % 4)
        start = len(binary)
        binary += data
        self._ranges = self._next(SHARED) | self._next(OWN)
        for kind in SHARED:
            self._copy(kind)
        for view in target.get("bufferViews", ())[self._ranges["bufferViews"].first :]:
            view["byteOffset"] = view.get("byteOffset", 0) + start
        self._list_extensions()

    def stand(self, roots: Iterable[int]) -> list[int]:
        """Copy the nodes; the numbers in the target of those that were ``roots``."""
        self._ranges |= self._next(OWN)
        for kind in OWN:
            self._copy(kind)
        return [root + self._ranges["nodes"].first for root in roots]

    def _next(self, kinds: tuple[str, ...]) -> dict[str, Range]:
        """Where the source's entries go when they are appended now."""
        return {
            kind: Range(len(self._target.get(kind, ())), len(self._source.get(kind, ())))
            for kind in kinds
        }

    def _copy(self, kind: str) -> None:
        for value in self._source.get(kind, ()):
            copy = _renumbered(value, self._ranges)
            if kind in PLAIN:
                copy = _without_extensions(copy)
            self._target.setdefault(kind, []).append(copy)

    def _list_extensions(self) -> None:
        """Name in the target the extensions that the copied parts use."""
        copied = [self._target.get(kind, [])[self._ranges[kind].first :] for kind in SHARED]
        used = set(STILL_LISTED) | _extensions(copied)
        for kind in ("extensionsUsed", "extensionsRequired"):
            names = used & set(self._source.get(kind, ())) | set(self._target.get(kind, ()))
            if names:
                self._target[kind] = sorted(names)


def _renumbered(value: Any, ranges: dict[str, Range]) -> Any:
    """A copy of part of a document with its references renumbered."""
    if isinstance(value, list):
        return [_renumbered(item, ranges) for item in value]
    if not isinstance(value, dict):
        return value
    copy = {}
    for name, inner in value.items():
        if name in DROPPED:
            continue
        if name in ("attributes", "targets"):
            copy[name] = _shifted(inner, ranges["accessors"])
        elif name in REFERENCES and not isinstance(inner, dict):
            copy[name] = _shifted(inner, ranges[REFERENCES[name]])
        else:
            copy[name] = _renumbered(inner, ranges)
    return copy


def _shifted(value: Any, numbers: Range) -> Any:
    """The numbers inside, renumbered; ValueError if one points nowhere."""
    if isinstance(value, dict):
        return {name: _shifted(inner, numbers) for name, inner in value.items()}
    if isinstance(value, list):
        return [_shifted(inner, numbers) for inner in value]
    if type(value) is not int or not 0 <= value < numbers.length:
        raise ValueError("it points to parts that are not there")
    return value + numbers.first


def _without_extensions(value: Any) -> Any:
    if isinstance(value, list):
        return [_without_extensions(item) for item in value]
    if isinstance(value, dict):
        return {name: _without_extensions(v) for name, v in value.items() if name != "extensions"}
    return value


def _extensions(value: Any) -> set[str]:
    """Names of all extensions with an object inside."""
    if isinstance(value, list):
        return set().union(*map(_extensions, value))
    if isinstance(value, dict):
        own = set(value.get("extensions", ()))
        return own.union(*map(_extensions, value.values()))
    return set()
