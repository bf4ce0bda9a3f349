"""The soft shape: cushions, mattresses, upholstered arms."""

from __future__ import annotations

from functools import lru_cache
from itertools import product
from math import cos, pi, sin

import numpy as np

from server.furniture.mesh import Floats, Ints, Mesh
from server.furniture.parts import Span

ARC_STEPS = 2  # pieces of a rounded corner


def cushion(x: Span, y: Span, z: Span, radius: float, crown: float = 0.0, axis: int = 1) -> Mesh:
    """A box with round edges whose side at the high end of ``axis`` bulges by ``crown``."""
    low, high = np.array([x, y, z]).T
    order = {0: [1, 0, 2], 1: [0, 1, 2], 2: [0, 2, 1]}[axis]
    half = ((high - low) / 2)[order]
    crown = min(crown, 0.6 * float(half[1]))
    round_ = min(radius, 0.6 * float(half[[0, 2]].min()), float(half[1]) - crown / 2)
    signs, bends = _outline()
    positions, normals = [], []
    for inset, height, rise in _cushion_profile(half, round_, crown):
        arc = max(round_ - inset, 0.3 * round_)
        ring = signs * (half[[0, 2]] - inset - arc) + bends * arc
        positions.append(np.insert(ring, 1, height, axis=1))
        normals.append(np.insert(bends * cos(rise), 1, sin(rise), axis=1))
    faces = _loft_faces(len(positions), len(signs))
    if axis != 1:  # two axes are swapped, which turns the faces over
        faces = faces[:, ::-1]
    middle = (low + high) / 2
    return Mesh(
        np.concatenate(positions)[:, order] + middle, np.concatenate(normals)[:, order], faces
    )


def _cushion_profile(half: Floats, radius: float, crown: float) -> list[tuple[float, float, float]]:
    """From the bottom up: inset from the outline, height, and how far the normal looks up."""
    low, top = -half[1], half[1] - crown
    rows = [(0.6 * radius, low, -pi / 3), (0.0, low + 0.6 * radius, 0.0)]
    rows += [(0.0, top - radius, 0.0), (0.29 * radius, top - 0.29 * radius, pi / 4)]
    if crown == 0:
        return [*rows, (radius, top, pi / 2)]
    run = min(5 * crown, 0.5 * (float(half[[0, 2]].min()) - radius))
    rows += [(radius, top, 0.38 * pi), (radius + 0.35 * run, top + 0.6 * crown, 0.44 * pi)]
    return [*rows, (radius + run, half[1], pi / 2)]


@lru_cache
def _outline() -> tuple[Floats, Floats]:
    """Round a cushion: the sign of the corner and the way out (points, 2) at each point (x, z)."""
    corners = (np.repeat(np.arange(4), ARC_STEPS + 1) + 0.5) * pi / 2
    turns = (
        np.repeat(np.arange(4), ARC_STEPS + 1) * pi + np.tile(np.linspace(0, pi, ARC_STEPS + 1), 4)
    ) / 2
    signs, bends = (np.stack([np.sin(turn), np.cos(turn)], axis=1) for turn in (corners, turns))
    return np.sign(signs), bends


@lru_cache
def _loft_faces(rings: int, sides: int) -> Ints:
    """Faces between rings one above the other, turning anticlockwise seen from above, and ends."""
    last = (rings - 1) * sides
    faces = [(0, i + 1, i) for i in range(1, sides - 1)]
    faces += [(last, last + i, last + i + 1) for i in range(1, sides - 1)]
    for ring, corner in product(range(rings - 1), range(sides)):
        a, b = ring * sides + corner, ring * sides + (corner + 1) % sides
        faces += [(a, b, b + sides), (a, b + sides, a + sides)]
    return np.array(faces)
