"""One GLB inside another: its parts renumbered to follow those that are there."""

from __future__ import annotations

from typing import Any

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


class Guest:
    """A document copied into another once, whose nodes can then stand there many times."""

    def __init__(self, target: Document, binary: bytearray, source: Document, data: bytes) -> None:
        """Copy all but the nodes; animations, cameras and lights stay behind.

        Args:
            target: Grows by the lists of the source.
            binary: Grows by ``data``, at a multiple of four bytes.
            source: A valid document of one buffer.
            data: Its binary.
        """
        self._target, self._source = target, source
        binary += b"\0" * (-len(binary) % 4)
        start = len(binary)
        binary += data
        self._first = {kind: len(target.get(kind, ())) for kind in SHARED}
        for kind in SHARED:
            self._copy(kind, self._first)
        for view in target.get("bufferViews", ())[self._first["bufferViews"] :]:
            view["byteOffset"] = view.get("byteOffset", 0) + start
        _list_extensions(target, source, self._first)

    def stand(self) -> list[int]:
        """Copy the nodes of its scene; the numbers of the roots in the target."""
        first = self._first | {kind: len(self._target.get(kind, ())) for kind in OWN}
        for kind in OWN:
            self._copy(kind, first)
        scene = self._source["scenes"][self._source.get("scene", 0)]
        return [root + first["nodes"] for root in scene["nodes"]]

    def _copy(self, kind: str, first: dict[str, int]) -> None:
        for value in self._source.get(kind, ()):
            copy = _renumbered(value, first)
            if kind in PLAIN:
                copy = _without_extensions(copy)
            self._target.setdefault(kind, []).append(copy)


def _renumbered(value: Any, first: dict[str, int]) -> Any:
    """A copy of part of a document whose references count from ``first``."""
    if isinstance(value, list):
        return [_renumbered(item, first) for item in value]
    if not isinstance(value, dict):
        return value
    copy = {}
    for name, inner in value.items():
        if name in DROPPED:
            continue
        if name in ("attributes", "targets"):
            copy[name] = _shifted(inner, first["accessors"])
        elif name in REFERENCES and not isinstance(inner, dict):
            copy[name] = _shifted(inner, first[REFERENCES[name]])
        else:
            copy[name] = _renumbered(inner, first)
    return copy


def _shifted(value: Any, by: int) -> Any:
    """The numbers inside, each ``by`` higher."""
    if isinstance(value, dict):
        return {name: _shifted(inner, by) for name, inner in value.items()}
    if isinstance(value, list):
        return [_shifted(inner, by) for inner in value]
    return value + by


def _without_extensions(value: Any) -> Any:
    if isinstance(value, list):
        return [_without_extensions(item) for item in value]
    if isinstance(value, dict):
        return {name: _without_extensions(v) for name, v in value.items() if name != "extensions"}
    return value


def _list_extensions(target: Document, source: Document, first: dict[str, int]) -> None:
    """Name in the target the extensions that the copied parts use."""
    copied = [value for kind in SHARED for value in target.get(kind, ())[first[kind] :]]
    used = set(STILL_LISTED) | _extensions(copied)
    for kind in ("extensionsUsed", "extensionsRequired"):
        names = used & set(source.get(kind, ())) | set(target.get(kind, ()))
        if names:
            target[kind] = sorted(names)


def _extensions(value: Any) -> set[str]:
    """Names of all extensions with an object inside."""
    if isinstance(value, list):
        return set().union(*map(_extensions, value))
    if isinstance(value, dict):
        own = set(value.get("extensions", ()))
        return own.union(*map(_extensions, value.values()))
    return set()
