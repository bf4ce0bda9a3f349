"""Our own relations, beside the paper's: the footprint to walls, openings, neighbors and twins.

They measure from the footprint, not from the center, and look at the nearest member of each group
in that member's own frame (docs/model.md). NaN says that there is nothing to measure to. What has
no front is measured up to a half turn: "behind" is then the nearer end.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from scenegen_core.graph import scan, scan_boxes, scan_walls
from scenegen_core.graph.relations import Relation
from scenegen_core.graph.situation import Situation
from scenegen_core.graph.surroundings import Surroundings
from scenegen_core.scene.geometry import (
    TIE,
    Bools,
    Floats,
    Ints,
    Rectangles,
    gaps,
    left_of,
)

SAME_SIZE = 0.1  # share by which twins may differ in each dimension
SAME_LENGTH = 0.03  # metres by which they may always
PARTNER = 0.8  # metres; what stands nearer to a box can mirror it
OFF_AXIS = 0.1  # metres; a box nearer to an axis is its own mirror image
TAKEN = 0.25  # metres; a mirror place this near to a box of the kind is taken


def _walls(situation: Situation) -> Floats:
    """The walls behind, ahead and beside, the nearest, how parallel it is to them."""
    out = np.empty((len(scan.WALL_PARTS), len(situation.candidates)))
    scan_walls.look_at_walls(
        situation.shapes.columns, situation.candidates.headings, _symmetric(situation),
        situation.wall_reach, situation.wall_gaps.T, situation.surroundings.inward, out,
    )  # fmt: skip
    return out.T


def _free_space(situation: Situation) -> Floats:
    """The free floor behind, ahead and beside, and what is near."""
    candidates, around = situation.candidates, situation.surroundings
    out = np.empty((len(scan.FREE_PARTS), len(candidates)))
    scan_boxes.look_round(
        situation.shapes.columns, candidates.bottoms, candidates.tops, _symmetric(situation),
        situation.wall_reach, around.footprints.rows, around.bottoms, around.tops,
        situation.gaps.T, out,
    )  # fmt: skip
    return out.T


def _middle(situation: Situation) -> Floats:
    """Distance to the middle of the room, in units of its size, and where it lies."""
    around = situation.surroundings
    to = around.middle - situation.candidates.centers[:, :2]
    fronts = situation.fronts
    away = np.hypot(*to.T)
    aside, ahead = (to * left_of(fronts)).sum(axis=1), (to * fronts).sum(axis=1)
    return np.stack([away / np.sqrt(around.area), _bearings(situation, aside, ahead)]).T


def _doors(situation: Situation) -> Floats:
    """The nearest door: gap, where it lies, how far aside."""
    return _openings(situation, situation.surroundings.doors)


def _windows(situation: Situation) -> Floats:
    """The nearest window: gap, where it lies, how far aside."""
    return _openings(situation, situation.surroundings.windows)


def _openings(situation: Situation, shapes: Rectangles) -> Floats:
    if not len(shapes):
        return np.full((len(scan.OPENING_PARTS), len(situation.candidates)), np.nan).T
    away = gaps(situation.shapes, shapes)
    out = np.empty((len(scan.OPENING_PARTS), len(situation.candidates)))
    beyond = np.empty(len(situation.candidates))
    scan_walls.look_at_openings(situation.shapes.columns, shapes.rows, away.T, out, beyond)
    out[1] = _bearings(situation, out[1], beyond)
    return out.T


def _height(situation: Situation) -> Floats:
    """The height of the underside."""
    return situation.candidates.bottoms[:, None]


def _neighbors(situation: Situation) -> Floats:
    """The nearest member of each group, in its own frame."""
    around = situation.surroundings
    return _look_at(situation, around.group_of, len(around.groups))


def _twins(situation: Situation) -> Floats:
    """The nearest box of the same category and size, in its own frame."""
    around, size = situation.surroundings, np.array(situation.candidates.size)
    alike = (np.abs(around.sizes - size) <= np.maximum(SAME_SIZE * size, SAME_LENGTH)).all(axis=1)
    kind = _of_the_kind(around, situation.candidates.category)
    return _look_at(situation, np.where(alike & kind, 0, -1).astype(np.int64), 1)


def _mirror(situation: Situation) -> Floats:
    """Distance and turn to the nearest free place that mirrors one of the kind."""
    places = mirror_places(situation.surroundings, situation.candidates.category)
    out = np.empty((2, len(situation.candidates)))
    scan_boxes.look_at_twins_places(
        situation.shapes.columns, situation.candidates.headings, _symmetric(situation), places, out
    )
    return out.T


def _size(situation: Situation) -> Floats:
    """The object's own depth, width and height, and the area of the room; the same everywhere."""
    column = np.array([[*situation.candidates.size, situation.surroundings.area]]).T
    return np.repeat(column, len(situation.candidates), axis=1).T


@lru_cache(maxsize=64)
def mirror_places(around: Surroundings, category: str) -> Floats:
    """Where a box of a category would mirror another about what stands beside it: (k, 3).

    Rows are x, y, heading. About each axis of a partner, and about its center; places that are
    taken are left out.
    """
    shapes, kind = around.footprints, _of_the_kind(around, category)
    which = np.flatnonzero(kind)
    solid = (around.tops - around.bottoms > scan.FLAT) & ~kind
    close = gaps(shapes[which], shapes) <= PARTNER
    places = []
    for row, one in enumerate(which):
        for partner in np.flatnonzero(close[row] & solid):
            offset = shapes.centers[one] - shapes.centers[partner]
            for axis in shapes.axes[partner]:
                away = offset @ axis
                if abs(away) >= OFF_AXIS:
                    about = np.pi + 2 * np.arctan2(axis[1], axis[0])
                    place = shapes.centers[one] - 2 * away * axis
                    places.append((*place, about - shapes.headings[one]))
            opposite = shapes.centers[partner] - offset
            places.append((*opposite, shapes.headings[one] + np.pi))
    found = np.array(places, dtype=np.float64).reshape(-1, 3)
    apart = np.hypot(*(found[:, None, :2] - shapes.centers[which][None]).transpose(2, 0, 1))
    return np.asarray(found[(apart > TAKEN).all(axis=1)], dtype=np.float64)


def _look_at(situation: Situation, group_of: Ints, groups: int) -> Floats:
    candidates, around = situation.candidates, situation.surroundings
    parts = len(scan.NEIGHBOR_PARTS)
    out, beyond = np.empty((groups * parts, len(candidates))), np.empty((groups, len(candidates)))
    scan_boxes.look_at_neighbors(
        situation.shapes.columns, candidates.headings, candidates.bottoms, _symmetric(situation),
        around.footprints.rows, situation.gaps.T, around.footprints.headings, around.tops,
        around.fronted, group_of, groups, out, beyond,
    )  # fmt: skip
    bearings = out[scan.NEIGHBOR_PARTS.index("bearing") :: parts]
    bearings[:] = _bearings(situation, bearings, beyond)
    return out.T


def _bearings(situation: Situation, aside: Floats, ahead: Floats) -> Floats:
    """How far from straight ahead offsets point: 0 to π, and 0 where there is no offset."""
    bearing = np.abs(np.arctan2(aside, ahead))
    bearing[(np.abs(aside) < TIE) & (np.abs(ahead) < TIE)] = 0.0
    return np.minimum(bearing, np.pi - bearing) if _symmetric(situation) else bearing


def _of_the_kind(around: Surroundings, category: str) -> Bools:
    return np.array([name == category for name in around.categories], dtype=bool)


def _symmetric(situation: Situation) -> bool:
    """Has the object no front?"""
    return situation.candidates.category in situation.surroundings.frontless


WALLS = Relation("Walls", "W", "continuous", _walls, parts=scan.WALL_PARTS)
FREE_SPACE = Relation("FreeSpace", "FS", "continuous", _free_space, parts=scan.FREE_PARTS)
MIDDLE = Relation("Middle", "M", "continuous", _middle, parts=("distance", "bearing"))
DOORS = Relation("Doors", "DR", "continuous", _doors, parts=scan.OPENING_PARTS)
WINDOWS = Relation("Windows", "WN", "continuous", _windows, parts=scan.OPENING_PARTS)
HEIGHT = Relation("Height", "H", "continuous", _height)
NEIGHBOR = Relation(
    "Neighbor", "N", "continuous", _neighbors, per_group=True, parts=scan.NEIGHBOR_PARTS
)
TWIN = Relation("Twin", "TW", "continuous", _twins, parts=scan.NEIGHBOR_PARTS)
MIRROR = Relation("Mirror", "MI", "continuous", _mirror, parts=("distance", "turn"))
SIZE = Relation("Size", "SZ", "continuous", _size, parts=("depth", "width", "height", "room"))

OWN_RELATIONS: tuple[Relation, ...] = (
    WALLS, FREE_SPACE, MIDDLE, DOORS, WINDOWS, HEIGHT, NEIGHBOR, TWIN, MIRROR, SIZE,
)  # fmt: skip
