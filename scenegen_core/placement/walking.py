"""Can people still walk? A grid of the places where a walker 0.6 m wide can be.

With an object at a pose, every door, seat, bed and storage front must still be reached from each
door that it was reached from before, and the object itself from one of them.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy import ndimage

from scenegen_core.graph.surroundings import Surroundings
from scenegen_core.graph.wording import spoken
from scenegen_core.placement.mounts import RUG_HEIGHT
from scenegen_core.placement.proposals import CELL, floor_points
from scenegen_core.scene.geometry import (
    TIE,
    Bools,
    Floats,
    Ints,
    Rectangles,
    directions,
    distances_to_rectangles,
    distances_to_segments,
    footprints,
)
from scenegen_core.scene.model import Box

WALKER = 0.6  # metres wide, the usual clear width of a passage at home
HEAD = 1.8  # metres; what hangs higher is walked under
REACH = 0.35  # metres from the walker's side to what it reaches
FRONT = 0.6  # metres before a storage that one stands on to open it
REACHED_CATEGORIES = ("Bed", "Chair", "Sofa", "Storage")


@dataclass(frozen=True, slots=True)
class Target:
    """Something that people go to: it is reached if one of its cells is."""

    name: str
    cells: Ints


class Walking:
    """The walkable floor of a scene, cells of ``CELL`` metres."""

    def __init__(self, around: Surroundings, *, counts: bool = True) -> None:
        """Prepare the floor; where ways do not count, nothing blocks them."""
        self.around = around
        self._counts = counts
        walls = around.walls
        self._origin: Floats = walls[:, 0].min(axis=0)
        self._points = floor_points(around)
        place = np.floor((self._points - self._origin) / CELL).astype(np.int64)
        self._column, self._row = place[:, 0], place[:, 1]
        self._shape = (int(self._row.max(initial=0)) + 1, int(self._column.max(initial=0)) + 1)

    @cached_property
    def _free(self) -> Bools:
        """Cells where the walker touches neither wall nor box: (cells,)."""
        off_walls = distances_to_segments(self._points, self.around.walls).min(axis=1)
        doorway = self._in_doorways(WALKER / 2)
        free = (off_walls >= WALKER / 2 - CELL / 2 - TIE) | doorway
        boxes = self.around.scene.boxes
        solid = np.array([_is_obstacle(box) for box in boxes], dtype=bool)
        taken = self._near(self.around.footprints[solid], WALKER / 2 - CELL / 2)
        return np.asarray(free & ~taken, dtype=np.bool_)

    @cached_property
    def _before(self) -> Bools:
        return self._reached(self._free)

    @cached_property
    def targets(self) -> tuple[Target, ...]:
        """What is reached as the room is: doors, seats, beds, storage fronts."""
        doors = [Target("the door", self._door_cells(index)) for index in range(self._doors)]
        furniture = [
            Target(f"the {spoken(box)}", self._cells_at(box))
            for box in self.around.scene.boxes
            if box.category in REACHED_CATEGORIES and _is_obstacle(box)
        ]
        found = (*doors, *furniture)
        return tuple(target for target in found if self._before[:, target.cells].any())

    def blocked_by(self, box: Box) -> str | None:
        """What could no longer be reached with the box there; None if all still can."""
        if not self._counts or not _is_obstacle(box):
            return None
        shape = footprints([box])
        after = self._reached(self._free & ~self._near(shape, WALKER / 2 - CELL / 2))
        for target in self.targets:
            lost = self._before[:, target.cells].any(axis=1) & ~after[:, target.cells].any(axis=1)
            if lost.any():
                return target.name
        if not after[:, self._cells_at(box)].any():
            return f"the {spoken(box)} itself"
        return None

    @property
    def _doors(self) -> int:
        return len(self.around.scene.room.doors)

    def _reached(self, free: Bools) -> Bools:
        """Cells that can be walked to from each door: (doors, cells).

        Where no door can be used as the room is, the largest connected floor: (1, cells).
        """
        raster = np.zeros(self._shape, dtype=bool)
        raster[self._row, self._column] = free
        areas, _ = ndimage.label(raster)
        area = areas[self._row, self._column]
        homes = [area[cells][free[cells]] for cells in self._starts]
        if not homes:
            largest = [np.bincount(area[free]).argmax()] if free.any() else []
            homes = [np.array(largest, dtype=area.dtype)]
        return np.stack([free & np.isin(area, home) for home in homes])

    @cached_property
    def _starts(self) -> list[Ints]:
        """The cells of each door; none if no door has a free one."""
        starts = [self._door_cells(index) for index in range(self._doors)]
        return starts if any(self._free[cells].any() for cells in starts) else []

    def _door_cells(self, index: int) -> Ints:
        door = self.around.scene.room.doors[index]
        segment = np.array([[door.start, door.end]], dtype=float)
        near = distances_to_segments(self._points, segment)[:, 0] <= WALKER + TIE
        return np.flatnonzero(near)

    def _in_doorways(self, reach: float) -> Bools:
        doors = self.around.scene.room.doors
        if not doors:
            return np.zeros(len(self._points), dtype=np.bool_)
        middles = np.array([np.mean([door.start, door.end], axis=0) for door in doors])
        offset = np.hypot(*(self._points[:, None] - middles[None]).transpose(2, 0, 1))
        return np.asarray((offset <= reach + TIE).any(axis=1), dtype=np.bool_)

    def _near(self, shapes: Rectangles, reach: float) -> Bools:
        """Cells nearer than ``reach`` to one of the shapes, ties left out: (cells,)."""
        if not len(shapes):
            return np.zeros(len(self._points), dtype=np.bool_)
        distances = distances_to_rectangles(self._points, shapes)
        return np.asarray((distances < reach).any(axis=1), dtype=np.bool_)

    def _cells_at(self, box: Box) -> Ints:
        """Cells from which a box is reached: beside it, or before its front if it has doors."""
        shape = footprints([box])
        if box.category == "Storage" and box.front_known:
            ahead = directions(shape.headings) * (shape.halves[0, 0] + FRONT / 2)
            half = np.array([[FRONT / 2, shape.halves[0, 1]]])
            front = Rectangles(shape.centers + ahead, half, shape.headings)
            return np.flatnonzero(self._near(front, CELL))
        return np.flatnonzero(self._near(shape, WALKER / 2 + REACH))


def _is_obstacle(box: Box) -> bool:
    """Does it stand in a walker's way? Rugs and what hangs high or lies on furniture do not."""
    return box.bottom < HEAD and box.size[2] > RUG_HEIGHT and box.bottom < FRONT
