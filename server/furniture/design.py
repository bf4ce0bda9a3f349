"""What a kind of furniture is: a builder and the sizes for which its proportions hold."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass

import numpy as np

from scenegen_core.scene.model import Vector3
from server.furniture.materials import Material
from server.furniture.mesh import Floats, Mesh
from server.furniture.parts import tube

Parts = Iterable[tuple[Material, Mesh]]
Builder = Callable[[float, float, float], Parts]
"""Width, height, depth in metres to the parts: centered on x and z, standing on y = 0."""


@dataclass(frozen=True, slots=True)
class Design:
    """A kind of furniture."""

    name: str
    build: Builder
    smallest: Vector3
    """Depth, width, height, metres. Beyond these limits a piece is built at the limit and
    stretched, so that legs and cushions keep their order at any size."""
    largest: Vector3

    def parts(self, size: Vector3) -> list[tuple[Material, Mesh]]:
        """The parts at about the size (depth, width, height): the caller fits them to it."""
        depth, width, height = (
            float(np.clip(length, low, high))
            for length, low, high in zip(size, self.smallest, self.largest, strict=True)
        )
        return list(self.build(width, height, depth))


def named(label: str, *words: str) -> bool:
    """Whether the label has one of the words in it."""
    return any(word in label for word in words)


def legs(
    x: float, z: float, top: float, *, thickness: float, material: Material, splay: float = 0.0
) -> Parts:
    """Four tapered round legs at (±x, ±z) from the floor up to ``top``."""
    for side, end in ((-1, -1), (1, -1), (-1, 1), (1, 1)):
        foot = (side * (x + splay), 0.0, end * (z + splay))
        yield material, tube(foot, (side * x, top, end * z), 0.3 * thickness, thickness / 2)


def bounds(parts: list[tuple[Material, Mesh]]) -> tuple[Floats, Floats]:
    """The lowest and highest coordinates (3,) of the parts."""
    low = np.min([mesh.positions.min(axis=0) for _, mesh in parts], axis=0)
    return low, np.max([mesh.positions.max(axis=0) for _, mesh in parts], axis=0)
