"""Candidates: poses that one object could take, or the one that it has."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from scenegen_core.scene.geometry import Bools, Floats, Ints, Rectangles
from scenegen_core.scene.model import Box, Vector3


@dataclass(frozen=True, slots=True)
class Candidates:
    """n poses of one object: ``centers`` (n, 3) of the box, metres; ``headings`` (n,) radians."""

    category: str
    size: Vector3
    centers: Floats
    headings: Floats
    id: str = ""
    """The id of the box whose pose this is; empty for a new object."""
    parent: str | None = None
    """What that box stands on, where its source says so."""

    @classmethod
    def of(cls, box: Box) -> Candidates:
        """The one pose that a box already has."""
        return cls(
            category=box.category,
            size=box.size,
            centers=np.array([box.center], dtype=float),
            headings=np.array([box.heading], dtype=float),
            id=box.id,
            parent=box.parent,
        )

    def __len__(self) -> int:
        return len(self.centers)

    def __getitem__(self, index: slice | Ints | Bools) -> Candidates:
        return replace(self, centers=self.centers[index], headings=self.headings[index])

    @property
    def footprints(self) -> Rectangles:
        """The footprints of the poses."""
        half = np.array([self.size[0] / 2, self.size[1] / 2])
        halves = np.broadcast_to(half, (len(self), 2))
        return Rectangles(self.centers[:, :2], halves, self.headings)

    @property
    def bottoms(self) -> Floats:
        """Heights of the undersides, metres: (n,)."""
        return self.centers[:, 2] - self.size[2] / 2

    @property
    def tops(self) -> Floats:
        """Heights of the upper sides, metres: (n,)."""
        return self.centers[:, 2] + self.size[2] / 2

    def box(self, index: int, box_id: str) -> Box:
        """The box that stands at one of the poses."""
        x, y, z = self.centers[index].tolist()
        return Box(
            id=box_id,
            category=self.category,
            center=(x, y, z),
            size=self.size,
            heading=float(self.headings[index]),
        )
