"""The few shapes that all furniture is put together from.

``Span`` is a pair (low, high) along an axis, metres. Every shape is closed, convex or nearly so,
and has soft edges, because a bright edge is what makes a thing look real.
"""

from __future__ import annotations

from functools import lru_cache
from itertools import product
from math import pi

import numpy as np
from scipy.sparse import coo_matrix
from trimesh import transform_points, unitize
from trimesh.creation import revolve
from trimesh.geometry import align_vectors, index_sparse, mean_vertex_normals
from trimesh.triangles import cross

from server.furniture.mesh import Floats, Ints, Mesh, facing

Span = tuple[float, float]
Spot = tuple[float, float, float]

BEVEL = 0.006  # metres; the eased edge of joinery
SMOOTH = 0.7  # cosine; edges of a turned part that bend less than 45° are shaded round


def block(x: Span, y: Span, z: Span, bevel: float = BEVEL) -> Mesh:
    """A box with chamfered edges: 44 triangles, its flat sides shaded flat."""
    signs, insets, normals, faces = _block_template()
    low, high = np.array([x, y, z]).T
    half = (high - low) / 2
    cut = min(bevel, 0.45 * float(half.min()))
    return Mesh((low + high) / 2 + signs * (half - insets * cut), normals, faces)


def polygon(corners: list[tuple[float, float]], z: float) -> Mesh:
    """A flat convex polygon that looks along +z; corners (x, y) anticlockwise."""
    positions = np.array([(x, y, z) for x, y in corners])
    faces = np.array([(0, i, i + 1) for i in range(1, len(corners) - 1)])
    return Mesh(positions, np.tile([0.0, 0.0, 1.0], (len(corners), 1)), faces)


def lathe(
    profile: list[tuple[float, float]],
    x: float = 0.0,
    z: float = 0.0,
    *,
    sides: int = 20,
    squash: float = 1.0,
) -> Mesh:
    """A part turned about the upright line through (x, z).

    Args:
        profile: (radius, height) from the bottom of the outside upwards; a radius 0 closes it.
        x: Where the axis stands, metres.
        z: Where the axis stands, metres.
        sides: Corners of the circle.
        squash: Depth over width of the circle.
    """
    points = np.array(profile)
    steps = np.diff(points, axis=0)
    across = np.stack([steps[:, 1], -steps[:, 0]], axis=1)
    across /= np.maximum(np.linalg.norm(across, axis=1, keepdims=True), 1e-12)
    outward = np.array(
        [_edge_normal(across, step, end) for step in range(len(steps)) for end in (step, step + 1)]
    )
    ends = np.repeat(points, 2, axis=0)[1:-1]  # of every step its own, so that edges stay sharp
    turned = revolve(ends, sections=sides, process=False)  # has z up
    turn = np.repeat(np.arange(sides) * (2 * pi / sides), len(ends))
    out, up = np.tile(outward, (sides, 1)).T
    normals = np.stack([np.sin(turn) * out, up, np.cos(turn) * out / squash], axis=1)
    positions = np.asarray(turned.vertices)[:, [1, 2, 0]] * (1, 1, squash) + (x, 0, z)
    return Mesh(positions, unitize(normals), np.asarray(turned.faces))


def tube(start: Spot, end: Spot, radius: float, end_radius: float, sides: int = 8) -> Mesh:
    """A round bar between two spots, closed at both ends."""
    along = np.subtract(end, start)
    length = float(np.linalg.norm(along))
    bar = lathe([(0, 0), (radius, 0), (end_radius, length), (0, length)], sides=sides)
    matrix = align_vectors((0, 1, 0), along)
    positions = transform_points(bar.positions, matrix) + start
    return Mesh(positions, bar.normals @ matrix[:3, :3].T, bar.faces)


def leaf(base: Spot, tip: Spot, width: float, droop: float) -> Mesh:
    """A blade that rises from its base and bends down by ``droop`` metres towards the tip."""
    steps = np.linspace(0.0, 1.0, 5)
    spine = np.outer(1 - steps, base) + np.outer(steps, tip)
    spine[:, 1] += droop * 4 * steps * (1 - steps)
    across = unitize(np.cross((0.0, 1.0, 0.0), np.subtract(tip, base)))
    if abs(tip[0] - base[0]) + abs(tip[2] - base[2]) < 1e-9:  # noqa: PLR2004 (it stands upright)
        across = np.array([1.0, 0.0, 0.0])
    widths = width / 2 * np.array([0.25, 0.85, 1.0, 0.7, 0.06])
    sides = across[None, :] * widths[:, None]
    fold = np.array([0.0, 0.12 * width, 0.0])
    positions = np.stack([spine + sides + fold, spine, spine - sides + fold], axis=1).reshape(-1, 3)
    faces, around = _leaf_faces(len(steps))
    areas = cross(positions[faces])
    return Mesh(positions, mean_vertex_normals(len(positions), faces, areas, around), faces)


@lru_cache
def _block_template() -> tuple[Floats, Floats, Floats, Ints]:
    """Signs, insets and normals (24, 3) and faces of a chamfered box of half size 1."""
    rows = [(axis, signs) for axis in range(3) for signs in product((-1, 1), repeat=3)]
    number = {row: index for index, row in enumerate(rows)}
    signs = np.array([row[1] for row in rows], dtype=float)
    insets = np.array([[axis != other for other in range(3)] for axis, _ in rows], dtype=float)
    quads = [
        [number[axis, _signs(axis, side, a, b)] for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
        for axis, side in product(range(3), (-1, 1))
    ]
    for free, a, b in product(range(3), (-1, 1), (-1, 1)):
        first, second = (axis for axis in range(3) if axis != free)
        low, high = _signs(free, -1, a, b), _signs(free, 1, a, b)
        quads.append(
            [number[first, low], number[first, high], number[second, high], number[second, low]]
        )
    triangles = [(q[0], q[i], q[i + 1]) for q in quads for i in (1, 2)]
    triangles += [
        (number[0, corner], number[1, corner], number[2, corner])
        for corner in product((-1, 1), repeat=3)
    ]
    shape = signs * (1 - 0.2 * insets)
    return signs, insets, signs * (1 - insets), facing(shape, shape, np.array(triangles))


def _signs(axis: int, own: int, first: int, second: int) -> tuple[int, ...]:
    """Signs with ``own`` on the axis and the two others in order on the rest."""
    rest = iter((first, second))
    return tuple(own if other == axis else next(rest) for other in range(3))


@lru_cache
def _leaf_faces(rows: int) -> tuple[Ints, coo_matrix]:
    """The faces of a blade, and which of them are around each vertex: (vertices, faces)."""
    faces = np.array(
        [
            face
            for row, side in product(range(rows - 1), range(2))
            for a in [3 * row + side]
            for face in ((a, a + 1, a + 4), (a, a + 4, a + 3))
        ]
    )
    return faces, index_sparse(3 * rows, faces)


def _edge_normal(across: Floats, step: int, end: int) -> Floats:
    """The normal (out, up) of a step of a profile at one of its ends."""
    neighbor = step - 1 if end == step else step + 1
    own: Floats = across[step]
    if 0 <= neighbor < len(across) and float(own @ across[neighbor]) > SMOOTH:
        own = own + across[neighbor]
    return own
