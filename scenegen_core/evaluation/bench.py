"""The bench of one case: the poses that every system chooses from, measured once for all."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np

from scenegen_core.evaluation.cases import Case
from scenegen_core.evaluation.retrieval import Lesson
from scenegen_core.graph.candidates import Candidates
from scenegen_core.graph.situation import Situation
from scenegen_core.graph.surroundings import Surroundings
from scenegen_core.placement.feasible import ALLOWED, Space, verdicts
from scenegen_core.placement.proposals import Proposals, main_direction, propose
from scenegen_core.placement.walking import Walking
from scenegen_core.scene.geometry import Bools, Floats, Ints
from scenegen_core.scene.model import Category

Form = Literal["position", "orientation", "joint"]
"""What is unknown: the position, the heading, or both."""
Task = Literal["position", "orientation", "joint", "joint2", "joint3"]
"""A form in the room that lacks the object, or two or three with it."""
FORMS: dict[Task, Form] = {
    "position": "position",
    "orientation": "orientation",
    "joint": "joint",
    "joint2": "joint",
    "joint3": "joint",
}

HEADINGS = 72  # tried at the true position, every 5°


@dataclass(frozen=True, eq=False)
class Table:
    """The n poses of one task, and which of them are possible."""

    candidates: Candidates
    cells: Ints
    """Poses of one cell are one position: (n,)."""
    possible: Bools
    flush: Bools
    situation: Situation
    """Of the poses that are scored: the possible ones, or all where none is."""
    scored: Ints
    proposals: Proposals | None = None


class Bench:
    """One case, ready for every system and task."""

    def __init__(
        self,
        case: Case,
        groups: tuple[Category, ...],
        lessons: tuple[Lesson, ...] = (),
        forest: Mapping[str, str] | None = None,
    ) -> None:
        self.case = case
        self.lessons = lessons
        self.forest = forest or {}
        self.category = next(group for group in groups if group.name == case.box.category)
        self.around = Surroundings(case.scene, groups)
        self.space = Space.of(self.around)

    @cached_property
    def walking(self) -> Walking:
        """The walkable floor of the scene."""
        return Walking(self.around)

    @cached_property
    def _proposals(self) -> Proposals:
        return propose(self.around, self.category, self.case.box.size)

    def table(self, form: Form) -> Table:
        """The poses of a form."""
        match form:
            case "position":
                return self.position
            case "orientation":
                return self.orientation
            case "joint":
                return self.joint

    @cached_property
    def joint(self) -> Table:
        """Position and heading both unknown: what the program proposes."""
        found = self._proposals
        return self._table(found.candidates, found.places, found.flush, found)

    @cached_property
    def position(self) -> Table:
        """The true heading given, as in the paper's Table 1: the cells of the proposals."""
        found = self._proposals
        each = np.stack([found.places, found.flush], axis=1)
        _, first = np.unique(each, axis=0, return_index=True)
        candidates = found.candidates[first]
        turned = Candidates(
            candidates.category,
            candidates.size,
            candidates.centers,
            np.full(len(first), self.case.box.heading),
        )
        as_found = Proposals(
            turned, found.mounts[first], found.cells[first], found.flush[first], found.grids
        )
        return self._table(turned, found.places[first], found.flush[first], as_found)

    @cached_property
    def orientation(self) -> Table:
        """The true position given, as in the paper's Table 2: all headings count as possible."""
        turns = np.arange(HEADINGS) * (2 * np.pi / HEADINGS)
        candidates = Candidates(
            self.case.box.category,
            self.case.box.size,
            np.tile(np.array(self.case.box.center, dtype=float), (HEADINGS, 1)),
            np.asarray(main_direction(self.around.walls) + turns, dtype=np.float64),
        )
        everything = np.ones(HEADINGS, dtype=np.bool_)
        situation = Situation(candidates, self.around)
        cells = np.arange(HEADINGS, dtype=np.int64)
        return Table(candidates, cells, everything, ~everything, situation, cells)

    def _table(
        self,
        candidates: Candidates,
        cells: Ints,
        flush: Bools,
        proposals: Proposals | None = None,
    ) -> Table:
        situation = Situation(candidates, self.around)
        possible = np.asarray(verdicts(situation, self.space) == ALLOWED, dtype=np.bool_)
        scored = np.flatnonzero(possible if possible.any() else np.ones_like(possible))
        return Table(
            candidates,
            cells,
            possible,
            flush,
            Situation(candidates[scored], self.around),
            scored,
            proposals,
        )


def spread(table: Table, scores: Floats, count: int, apart: float) -> Ints:
    """The best poses at least ``apart`` metres from each other."""
    order = np.argsort(-scores, kind="stable")
    _, first = np.unique(table.cells[order], return_index=True)
    chosen: list[int] = []
    for pose in order[np.sort(first)]:
        offset = table.candidates.centers[chosen] - table.candidates.centers[pose]
        if (np.hypot(offset[:, 0], offset[:, 1]) >= apart).all() and np.isfinite(scores[pose]):
            chosen.append(int(pose))
        if len(chosen) == count:
            break
    return np.array(chosen, dtype=np.int64)
