"""Triangle meshes as arrays: the value that every piece of furniture is made of.

Frame of a model: metres, right-handed, y up, its front looks along +z, its width runs along x.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from math import cos, sin

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

WHITE = (1.0, 1.0, 1.0)


@dataclass(frozen=True, slots=True, eq=False)
class Mesh:
    """Triangles over shared vertices, anticlockwise seen from outside."""

    positions: Floats
    """(vertices, 3), metres."""
    normals: Floats
    """(vertices, 3), of unit length."""
    faces: Ints
    """(triangles, 3), vertex numbers."""
    color: tuple[float, float, float] = WHITE
    """Linear RGB, multiplied with the material's where that is a painted one."""

    def moved(self, x: float = 0.0, y: float = 0.0, z: float = 0.0) -> Mesh:
        """The mesh shifted, metres."""
        return Mesh(self.positions + np.array([x, y, z]), self.normals, self.faces, self.color)

    def leaning(self, angle: float, y: float, z: float) -> Mesh:
        """The mesh turned about the line along x through (y, z); positive tips its top to +z."""
        return self._turned(_turn(1, 2, angle), np.array([0.0, y, z]))

    def turned(self, angle: float, x: float = 0.0, z: float = 0.0) -> Mesh:
        """The mesh turned about the upright line through (x, z), anticlockwise from above."""
        return self._turned(_turn(2, 0, angle), np.array([x, 0.0, z]))

    def tilted(self, angle: float, x: float, y: float) -> Mesh:
        """The mesh turned about the line along z through (x, y), anticlockwise from the front."""
        return self._turned(_turn(0, 1, angle), np.array([x, y, 0.0]))

    def both_sides(self) -> Mesh:
        """The mesh with a second layer that looks the other way, for leaves and cloth."""
        return Mesh(
            np.concatenate([self.positions, self.positions]),
            np.concatenate([self.normals, -self.normals]),
            np.concatenate([self.faces, self.faces[:, ::-1] + len(self.positions)]),
            self.color,
        )

    def _turned(self, matrix: Floats, pivot: Floats) -> Mesh:
        positions = (self.positions - pivot) @ matrix.T + pivot
        return Mesh(positions, self.normals @ matrix.T, self.faces, self.color)


def merged(meshes: Iterable[Mesh]) -> tuple[Floats, Floats, Floats, Ints]:
    """Positions, normals, colors (vertices, 3) and faces of several meshes as one."""
    parts = tuple(meshes)
    counts = [len(part.positions) for part in parts]
    starts = np.cumsum([0, *counts[:-1]])
    return (
        np.concatenate([part.positions for part in parts]),
        np.concatenate([part.normals for part in parts]),
        np.repeat([part.color for part in parts], counts, axis=0),
        np.concatenate([part.faces + start for part, start in zip(parts, starts, strict=True)]),
    )


def smooth_normals(positions: Floats, faces: Ints) -> Floats:
    """Unit normals (vertices, 3): the mean of the faces around, weighted by their area."""
    a, b, c = (positions[faces[:, corner]] for corner in range(3))
    areas = np.repeat(np.cross(b - a, c - a), 3, axis=0)
    normals = np.zeros_like(positions)
    np.add.at(normals, faces.ravel(), areas)
    return unit(normals)


def unit(vectors: Floats) -> Floats:
    """The vectors (…, 3) with length 1; one without a direction points up."""
    lengths = np.linalg.norm(vectors, axis=-1, keepdims=True)
    return np.where(lengths > 0, vectors / np.where(lengths > 0, lengths, 1.0), (0.0, 1.0, 0.0))


def _turn(first: int, second: int, angle: float) -> Floats:
    """The rotation that turns axis ``first`` towards axis ``second``: (3, 3)."""
    matrix = np.eye(3)
    matrix[[first, second], [first, second]] = cos(angle)
    matrix[second, first] = sin(angle)
    matrix[first, second] = -sin(angle)
    return matrix
