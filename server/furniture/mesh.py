"""Triangle meshes as arrays: the value that every piece of furniture is made of.

Frame of a model: metres, right-handed, y up, its front looks along +z, its width runs along x.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from trimesh import transform_points
from trimesh.transformations import rotation_matrix
from trimesh.triangles import cross
from trimesh.util import append_faces

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Triple = tuple[float, float, float]

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
    color: Triple = WHITE
    """Linear RGB, multiplied with the material's where that is a painted one."""

    def moved(self, x: float = 0.0, y: float = 0.0, z: float = 0.0) -> Mesh:
        """The mesh shifted, metres."""
        return Mesh(self.positions + np.array([x, y, z]), self.normals, self.faces, self.color)

    def leaning(self, angle: float, y: float, z: float) -> Mesh:
        """The mesh turned about the line along x through (y, z); positive tips its top to +z."""
        return self._turned(angle, (1, 0, 0), (0, y, z))

    def turned(self, angle: float, x: float = 0.0, z: float = 0.0) -> Mesh:
        """The mesh turned about the upright line through (x, z), anticlockwise from above."""
        return self._turned(angle, (0, 1, 0), (x, 0, z))

    def tilted(self, angle: float, x: float, y: float) -> Mesh:
        """The mesh turned about the line along z through (x, y), anticlockwise from the front."""
        return self._turned(angle, (0, 0, 1), (x, y, 0))

    def both_sides(self) -> Mesh:
        """The mesh with a second layer that looks the other way, for leaves and cloth."""
        return Mesh(
            np.concatenate([self.positions, self.positions]),
            np.concatenate([self.normals, -self.normals]),
            np.concatenate([self.faces, self.faces[:, ::-1] + len(self.positions)]),
            self.color,
        )

    def _turned(self, angle: float, axis: Triple, through: Triple) -> Mesh:
        matrix = rotation_matrix(angle, axis, through)
        positions = transform_points(self.positions, matrix)
        return Mesh(positions, self.normals @ matrix[:3, :3].T, self.faces, self.color)


def merged(meshes: Iterable[Mesh]) -> tuple[Floats, Floats, Floats, Ints]:
    """Positions, normals, colors (vertices, 3) and faces of several meshes as one."""
    parts = tuple(meshes)
    counts = [len(part.positions) for part in parts]
    positions, faces = append_faces([p.positions for p in parts], [p.faces for p in parts])
    normals = np.concatenate([part.normals for part in parts])
    colors = np.repeat([part.color for part in parts], counts, axis=0)
    return np.asarray(positions, float), normals, colors, np.asarray(faces, np.int64)


def facing(positions: Floats, normals: Floats, faces: Ints) -> Ints:
    """The faces, each turned so that it looks along the normal of its first corner."""
    away = np.einsum("ij,ij->i", cross(positions[faces]), normals[faces[:, 0]]) < 0
    return np.where(away[:, None], faces[:, ::-1], faces)
