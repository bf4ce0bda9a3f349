"""Outlines of rooms from the walls that a scan found, and openings put on them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from math import dist

import numpy as np
from shapely import LineString, Polygon
from shapely import Point as ShapelyPoint

from scenegen_core.errors import DataError
from scenegen_core.scene.geometry import Floats
from scenegen_core.scene.model import Opening, Point, Vector3

NEAR_OUTLINE = 0.5  # metres; what lies further outside was seen through a door or a window
OUTSIDE = "lies outside of the room; it was seen through an opening"

Segment = tuple[Point, Point]


def point_of(position: Sequence[float] | Floats) -> Point:
    """The plan of a position (2 or 3,), to a tenth of a millimetre."""
    return round(float(position[0]), 4), round(float(position[1]), 4)


def rounded(values: Iterable[float]) -> Vector3:
    """A position or a size to a tenth of a millimetre."""
    x, y, z = (round(float(value), 4) for value in values)
    return x, y, z


def outline_of(walls: Sequence[Segment]) -> tuple[Point, ...]:
    """The corners where walls meet, anticlockwise: each wall goes on with the nearest end.

    DataError if there are fewer than three walls.
    """
    if len(walls) < 3:  # noqa: PLR2004 (a triangle)
        raise DataError("The scan has fewer than three walls; scan the room again.")
    chain, rest = [walls[0]], list(walls[1:])
    while rest:
        end = chain[-1][1]
        ends = [wall for pair in rest for wall in (pair, (pair[1], pair[0]))]
        following = min(ends, key=lambda wall: dist(wall[0], end))
        rest = [pair for pair in rest if set(pair) != set(following)]
        chain.append(following)
    meeting = zip(chain, (*chain[1:], chain[0]), strict=True)
    corners = tuple(point_of(np.mean([one[1], other[0]], axis=0)) for one, other in meeting)
    return corners if Polygon(corners).exterior.is_ccw else corners[::-1]


def on_outline(openings: Iterable[Opening], outline: Polygon) -> tuple[Opening, ...]:
    """The openings moved onto the outline, without those that are too far from it."""
    walls = outline.exterior

    def moved(point: Point) -> Point:
        on_wall = walls.interpolate(walls.project(ShapelyPoint(point)))
        return point_of((on_wall.x, on_wall.y))

    return tuple(
        replace(opening, start=moved(opening.start), end=moved(opening.end))
        for opening in openings
        if LineString([opening.start, opening.end]).centroid.distance(walls) <= NEAR_OUTLINE
    )
