"""A situation: candidates in surroundings, with what several relations need measured once."""

from __future__ import annotations

from functools import cached_property

import numpy as np

from scenegen_core.graph.candidates import Candidates
from scenegen_core.graph.scan_walls import rays_to_walls
from scenegen_core.graph.surroundings import Surroundings
from scenegen_core.scene.geometry import (
    Bools,
    Floats,
    Ints,
    Rectangles,
    distances_to_segments,
    gaps,
    left_of,
    rays_hit,
    separations,
)

TOUCH = 1e-9  # metres; footprints that only share an edge do not overlap (rounding)


class Situation:
    """n candidates among m boxes and l walls; every measure is made when first asked for."""

    def __init__(self, candidates: Candidates, surroundings: Surroundings) -> None:
        self.candidates = candidates
        self.surroundings = surroundings

    def __getitem__(self, index: slice | Ints | Bools) -> Situation:
        """Some of the candidates, among the same surroundings."""
        some = Situation(self.candidates[index], self.surroundings)
        if "shapes" in self.__dict__:
            some.__dict__["shapes"] = self.shapes[index]
        return some

    @cached_property
    def shapes(self) -> Rectangles:
        """The footprints B(O_k): n."""
        return self.candidates.footprints

    @cached_property
    def gaps(self) -> Floats:
        """δ(B(O_k), B(O_j)), metres, negative where they overlap: (n, m)."""
        return gaps(self.shapes, self.surroundings.footprints)

    @cached_property
    def wall_distances(self) -> Floats:
        """δ(Ȯ_k, W_i) from the centers, metres: (n, l)."""
        return distances_to_segments(self.candidates.centers[:, :2], self.surroundings.walls)

    @cached_property
    def wall_gaps(self) -> Floats:
        """δ(B(O_k), W_i) from the footprints, metres: (n, l)."""
        return gaps(self.shapes, self.surroundings.wall_shapes)

    @cached_property
    def wall_overlaps(self) -> Floats:
        """Like ``wall_gaps`` where a footprint passes a wall; elsewhere positive: (n, l)."""
        return separations(self.shapes, self.surroundings.wall_shapes)

    @cached_property
    def wall_reach(self) -> Floats:
        """How far the rays ahead, behind, left and right run to the first wall, metres: (4, n)."""
        reach = np.empty((4, len(self.candidates)))
        rays_to_walls(self.shapes.columns, self.surroundings.walls, reach)
        return reach

    @cached_property
    def fronts(self) -> Floats:
        """The primary axes a_k: (n, 2)."""
        return self.shapes.columns[2:4].T

    @cached_property
    def faces(self) -> Bools:
        """h(Ȯ_k, a_k, B(O_j)): (n, m)."""
        return self._rays_hit(self.fronts)

    @cached_property
    def flanks(self) -> Bools:
        """h(Ȯ_k, ±b_k, B(O_j)): (n, m)."""
        side = left_of(self.fronts)
        return self._rays_hit(side) | self._rays_hit(-side)

    @cached_property
    def meets(self) -> Bools:
        """Do the footprints overlap by more than a touch?: (n, m)."""
        return self.gaps < -TOUCH

    def _rays_hit(self, toward: Floats) -> Bools:
        centers = self.candidates.centers[:, :2]
        return rays_hit(centers, toward, self.surroundings.footprints)
