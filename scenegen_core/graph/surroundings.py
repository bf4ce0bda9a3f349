"""Surroundings: what candidates are measured against, as arrays."""

from __future__ import annotations

from functools import cached_property

import numpy as np

from scenegen_core.scene.geometry import (
    Bools,
    Floats,
    Ints,
    Rectangles,
    footprints,
    left_of,
    walls_as_rectangles,
)
from scenegen_core.scene.model import OTHER, Category, Opening, Scene, Symmetry


class Surroundings:
    """A scene as arrays, its m boxes sorted into ``groups``; of a group unknown: Other.

    Read-only; made once for a scene and shared by all that measure in it.
    """

    def __init__(self, scene: Scene, groups: tuple[Category, ...]) -> None:
        self.scene = scene
        self.groups = groups
        boxes = scene.boxes
        self.ids = tuple(box.id for box in boxes)
        self.parents = tuple(box.parent for box in boxes)
        self.centers: Floats = np.array([box.center for box in boxes], dtype=float).reshape(-1, 3)
        self.footprints = footprints(boxes)
        self.bottoms: Floats = np.array([box.bottom for box in boxes], dtype=float)
        self.tops: Floats = np.array([box.top for box in boxes], dtype=float)
        self.fronts_known: Bools = np.array([box.front_known for box in boxes], dtype=bool)
        self.walls: Floats = np.array(scene.room.walls, dtype=float)

    def __len__(self) -> int:
        return len(self.ids)

    @cached_property
    def categories(self) -> tuple[str, ...]:
        """The category of each box: (m,)."""
        return tuple(box.category for box in self.scene.boxes)

    @cached_property
    def sizes(self) -> Floats:
        """Depth, width, height of each box, metres: (m, 3)."""
        return np.array([box.size for box in self.scene.boxes], dtype=float).reshape(-1, 3)

    @cached_property
    def frontless(self) -> frozenset[str]:
        """The groups without a front, by name."""
        return frozenset(g.name for g in self.groups if g.symmetry is Symmetry.SYMMETRIC)

    @cached_property
    def group_of(self) -> Ints:
        """The index of each box's group: (m,)."""
        index = {group.name: i for i, group in enumerate(self.groups)}
        other = index.get(OTHER, -1)
        return np.array(
            [index.get(box.category, other) for box in self.scene.boxes], dtype=np.int64
        )

    @cached_property
    def membership(self) -> Floats:
        """1 where a box belongs to a group: (m, groups); sums over groups are products with it."""
        belongs = self.group_of[:, None] == np.arange(len(self.groups))
        return np.asarray(belongs, dtype=np.float64)

    @cached_property
    def fronted(self) -> Bools:
        """Which boxes have a front that is known: (m,)."""
        has_front = np.array([name not in self.frontless for name in self.categories], dtype=bool)
        return np.asarray(self.fronts_known & has_front, dtype=np.bool_)

    @cached_property
    def wall_shapes(self) -> Rectangles:
        """The walls as rectangles without width."""
        return walls_as_rectangles(self.walls)

    @cached_property
    def inward(self) -> Floats:
        """Headings that look from each wall into the room: (l,). Outlines run anticlockwise."""
        normal = left_of(self.walls[:, 1] - self.walls[:, 0])
        return np.arctan2(normal[:, 1], normal[:, 0])

    @cached_property
    def doors(self) -> Rectangles:
        """The doors as rectangles without width."""
        return _as_rectangles(self.scene.room.doors)

    @cached_property
    def windows(self) -> Rectangles:
        """The windows as rectangles without width."""
        return _as_rectangles(self.scene.room.windows)

    @cached_property
    def area(self) -> float:
        """Of the room, m²."""
        return float(abs(self._crosses.sum()) / 2)

    @cached_property
    def middle(self) -> Floats:
        """The centroid of the room: (2,)."""
        start, end = self.walls[:, 0], self.walls[:, 1]
        third = ((start + end) * self._crosses[:, None]).sum(axis=0) / 3
        return np.asarray(third / self._crosses.sum(), dtype=np.float64)

    @property
    def _crosses(self) -> Floats:
        """Twice the area between each wall and the origin: (l,)."""
        (x0, y0), (x1, y1) = self.walls[:, 0].T, self.walls[:, 1].T
        return np.asarray(x0 * y1 - x1 * y0, dtype=np.float64)


def _as_rectangles(openings: tuple[Opening, ...]) -> Rectangles:
    segments = [(opening.start, opening.end) for opening in openings]
    return walls_as_rectangles(np.array(segments, dtype=float).reshape(-1, 2, 2))
