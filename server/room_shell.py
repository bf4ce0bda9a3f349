"""The shell of a room as meshes of the page frame: floor, walls with openings, window panes."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from itertools import pairwise, product

import numpy as np
import shapely
from trimesh import unitize

from scenegen_core.scene.frames import to_page
from scenegen_core.scene.model import Opening, Point, Room
from server.furniture.mesh import Floats, Mesh, facing

THICKNESS = 0.1  # metres; how deep doors and windows lie in the walls
FAR = 0.3  # metres; an opening further than that from every wall is in none
SHARP = 0.2  # of two walls that nearly fold back on each other; their edge is cut off there

Hole = tuple[float, float, float, float]
"""From, to along a wall, and bottom, top: metres."""
UP = np.array([0.0, 0.0, 1.0])


@dataclass(frozen=True, slots=True, eq=False)
class Quad:
    """A flat rectangle in the core frame that looks along its normal."""

    corners: Floats
    """(4, 3), round its edge."""
    normal: Floats
    """(3,), unit."""


def floor_mesh(room: Room) -> Mesh:
    """The floor, looking up."""
    triangles = shapely.constrained_delaunay_triangles(shapely.Polygon(room.corners))
    rings = shapely.get_coordinates(triangles).reshape(-1, 4, 2)  # the last corner is the first
    points = rings[:, :3].reshape(-1, 2)
    positions = np.concatenate([points, np.zeros((len(points), 1))], axis=1)
    faces = np.arange(len(points)).reshape(-1, 3)
    normals = np.tile(UP, (len(points), 1))
    return Mesh(to_page(positions), to_page(normals), facing(positions, normals, faces))


def wall_mesh(room: Room) -> Mesh:
    """The inner sides of the walls, the reveals of their openings, and their upper edge."""
    quads: list[Quad] = []
    for wall, (start, end) in enumerate(room.walls):
        holes = holes_of(room, wall, (*room.doors, *room.windows))
        length = float(np.hypot(end[0] - start[0], end[1] - start[1]))
        for s0, s1, t0, t1 in solid_parts(length, room.height, holes):
            quads.append(_upright(start, end, (s0, s1, t0, t1), 0.0))
        for hole in holes:
            quads += _reveals(start, end, hole)
    return _merged([*quads, *_upper_edge(room)])


def glass_mesh(room: Room) -> Mesh | None:
    """The panes of the windows, in the middle of the walls; None without windows."""
    panes = [
        _upright(start, end, hole, THICKNESS / 2)
        for wall, (start, end) in enumerate(room.walls)
        for hole in holes_of(room, wall, room.windows)
    ]
    return _merged(panes) if panes else None


def holes_of(room: Room, wall: int, openings: Iterable[Opening]) -> list[Hole]:
    """The openings that lie in a wall, cut to it: from, to, bottom, top."""
    lines = [shapely.LineString(ends) for ends in room.walls]
    line = lines[wall]
    holes = []
    for opening in openings:
        middle = shapely.LineString([opening.start, opening.end]).centroid
        distances = [other.distance(middle) for other in lines]
        if min(distances) < distances[wall] or distances[wall] > FAR:
            continue
        ends = sorted(line.project(shapely.Point(p)) for p in (opening.start, opening.end))
        bottom, top = np.clip([opening.bottom, opening.top], 0.0, room.height)
        if ends[1] > ends[0] and top > bottom:
            holes.append((ends[0], ends[1], float(bottom), float(top)))
    return holes


def solid_parts(length: float, height: float, holes: list[Hole]) -> list[Hole]:
    """Rectangles that fill a wall but for its holes."""
    across = sorted({0.0, length, *(s for hole in holes for s in hole[:2])})
    up = sorted({0.0, height, *(t for hole in holes for t in hole[2:])})
    return [
        (s0, s1, t0, t1)
        for (s0, s1), (t0, t1) in product(pairwise(across), pairwise(up))
        if not any(
            a <= (s0 + s1) / 2 <= b and low <= (t0 + t1) / 2 <= high for a, b, low, high in holes
        )
    ]


def _axes(start: Point, end: Point) -> tuple[Floats, Floats, Floats]:
    """The start, the direction along the wall and the one into the room, each (3,)."""
    origin = np.array([*start, 0.0])
    along = unitize(np.array([*end, 0.0]) - origin)
    return origin, along, np.array([-along[1], along[0], 0.0])


def _upright(start: Point, end: Point, part: Hole, outward: float) -> Quad:
    """Part of a wall, ``outward`` metres behind its inner side."""
    origin, along, inward = _axes(start, end)
    s0, s1, t0, t1 = part
    corners = [
        origin + s * along + t * UP - outward * inward
        for s, t in ((s0, t0), (s1, t0), (s1, t1), (s0, t1))
    ]
    return Quad(np.array(corners), inward)


def _reveals(start: Point, end: Point, hole: Hole) -> list[Quad]:
    """The four sides of an opening, each looking into it."""
    origin, along, inward = _axes(start, end)
    s0, s1, t0, t1 = hole
    sides = (
        (s0, t0, s0, t1, along), (s1, t0, s1, t1, -along),
        (s0, t0, s1, t0, UP), (s0, t1, s1, t1, -UP),
    )  # fmt: skip
    quads = []
    for a, b, c, d, normal in sides:
        first, second = origin + a * along + b * UP, origin + c * along + d * UP
        back = THICKNESS * inward
        quads.append(Quad(np.array([first, second, second - back, first - back]), normal))
    return quads


def _upper_edge(room: Room) -> list[Quad]:
    """The tops of the walls, mitred at the corners."""
    inward = np.array([_axes(start, end)[2] for start, end in room.walls])
    before = np.roll(inward, 1, axis=0)
    opened = np.maximum(1 + np.sum(inward * before, axis=1, keepdims=True), SHARP)
    inner = np.array([[x, y, room.height] for x, y in room.corners])
    outer = inner - THICKNESS * (inward + before) / opened
    following = np.roll(np.arange(len(inner)), -1)
    return [
        Quad(np.array([inner[i], inner[j], outer[j], outer[i]]), UP)
        for i, j in enumerate(following)
    ]


def _merged(quads: list[Quad]) -> Mesh:
    """One mesh of the page frame."""
    positions = np.concatenate([quad.corners for quad in quads])
    normals = np.repeat([quad.normal for quad in quads], 4, axis=0)
    starts = 4 * np.arange(len(quads))
    faces = np.concatenate([starts[:, None] + (0, 1, 2), starts[:, None] + (0, 2, 3)])
    return Mesh(to_page(positions), to_page(normals), facing(positions, normals, faces))
