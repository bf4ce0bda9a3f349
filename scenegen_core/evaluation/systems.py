"""Systems: ways to score the poses of a case; the paper's, its ablations, and yardsticks."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from scenegen_core.evaluation.bench import Bench, Table, Task
from scenegen_core.evaluation.retrieval import recall
from scenegen_core.knowledge.knowledge import Knowledge
from scenegen_core.placement.paper_model import PaperModel
from scenegen_core.placement.proposals import inward
from scenegen_core.scene.geometry import Floats, directions, wrapped

TURN = 0.1  # metres that a radian counts for, where poses are compared as a whole
NOT_REMEMBERED = 100.0  # ranks below every pose that a room is remembered for

Score = Callable[[Bench, Table, Knowledge, np.random.Generator], Floats]
"""(bench, table, knowledge, rng) -> a score for each scored pose of the table."""


@dataclass(frozen=True, slots=True)
class System:
    """A named way to answer some of the tasks."""

    name: str
    scores: Mapping[Task, Score]
    feasible: bool = True
    """Does it look at what is possible? Only the random pose does not."""
    needs_lessons: bool = False
    """Does it look into the rooms that taught?"""


def _paper(position: tuple[str, ...], orientation: tuple[str, ...], part: str) -> Score:
    @lru_cache(maxsize=64)
    def model(knowledge: Knowledge, category: str) -> PaperModel:
        return PaperModel(knowledge, category, position=position, orientation=orientation)

    def score(bench: Bench, table: Table, knowledge: Knowledge, _: np.random.Generator) -> Floats:
        scores = model(knowledge, bench.category.name).score(table.situation)
        found: Floats = getattr(scores, part)
        return found

    return score


def _position(*relations: str) -> Mapping[Task, Score]:
    return {"position": _paper(relations, ("F", "TC", "RP"), "position")}


def _orientation(*relations: str) -> Mapping[Task, Score]:
    return {"orientation": _paper(("RP",), relations, "orientation")}


def _any(_: Bench, table: Table, __: Knowledge, rng: np.random.Generator) -> Floats:
    return rng.random(len(table.scored))


def _along_walls(_: Bench, table: Table, __: Knowledge, rng: np.random.Generator) -> Floats:
    return table.flush[table.scored] + rng.random(len(table.scored))


def _away_from_wall(bench: Bench, table: Table, _: Knowledge, rng: np.random.Generator) -> Floats:
    """Face away from a wall, the nearer the better; into a wall is as bad as away from it.

    A footprint reaches other walls as it turns, so each heading is held against every wall.
    """
    situation = table.situation
    turns = np.abs(wrapped(situation.candidates.headings[:, None] - inward(bench.around.walls)))
    worst = turns + np.abs(situation.wall_gaps)  # a radian counts like a metre
    return np.asarray(-worst.min(axis=1) + 1e-6 * rng.random(len(worst)), dtype=np.float64)


def _cover(_: Bench, table: Table, __: Knowledge, rng: np.random.Generator) -> Floats:
    """Greedy k-center over the possible floor: each next pose is the furthest from those before."""
    points = table.situation.candidates.centers[:, :2]
    scores = np.full(len(points), -np.inf)
    middle = np.hypot(*(points - points.mean(axis=0)).T)
    nearest = np.full(len(points), np.inf)
    pose = int(middle.argmin())
    for rank in range(5):
        scores[pose] = -rank
        nearest = np.minimum(nearest, np.hypot(*(points - points[pose]).T))
        pose = int((nearest + 1e-6 * rng.random(len(points))).argmax())
    return np.where(np.isfinite(scores), scores, -10 - rng.random(len(points)))


def _oracle(bench: Bench, table: Table, _: Knowledge, __: np.random.Generator) -> Floats:
    """The nearest of the possible poses to the truth: what the sampling allows at best."""
    truth = bench.case.box
    poses = table.situation.candidates
    distance = np.hypot(*(poses.centers[:, :2] - np.array(truth.center[:2])).T)
    turn = np.abs(wrapped(poses.headings - truth.heading))
    return np.asarray(-distance - TURN * turn, dtype=np.float64)


def _rules(bench: Bench, table: Table, _: Knowledge, rng: np.random.Generator) -> Floats:
    """Hand-written rules in the manner of Holodeck: edge or middle, near its partner, facing it."""
    edge, partner = RULES.get(bench.category.name, NO_RULE)
    situation, around = table.situation, bench.around
    against = situation.wall_gaps.min(axis=1) < 0.2  # noqa: PLR2004 (metres)
    scores = np.where(against == edge, 1.0, 0.0) + 1e-3 * rng.random(len(against))
    turn = wrapped(
        situation.candidates.headings - inward(around.walls)[situation.wall_gaps.argmin(axis=1)]
    )
    scores += np.where(edge & (np.abs(turn) < 0.1), 0.5, 0.0)  # noqa: PLR2004 (radians)
    members = np.array([box.category == partner for box in around.scene.boxes], dtype=bool)
    if members.any():
        gap = situation.gaps[:, members].min(axis=1)
        scores += np.exp(-np.maximum(gap, 0))
        toward = around.centers[members, :2][situation.gaps[:, members].argmin(axis=1)]
        offset = toward - situation.candidates.centers[:, :2]
        reach = np.maximum(np.hypot(offset[:, 0], offset[:, 1]), 1e-9)
        ahead = (offset * directions(situation.candidates.headings)).sum(axis=1) / reach
        scores += 0.5 * ahead
    return np.asarray(scores, dtype=np.float64)


def _nearest_room(bench: Bench, table: Table, _: Knowledge, __: np.random.Generator) -> Floats:
    """The poses nearest to where such things stood in the rooms most like this one."""
    poses = table.situation.candidates
    scores = np.full(len(poses), -np.inf)
    for rank, remembered in enumerate(recall(bench.case, bench.lessons)):
        away = np.hypot(*(poses.centers[:, :2] - np.array(remembered.center)).T)
        far = away + TURN * np.abs(wrapped(poses.headings - remembered.heading))
        if rank == 0:
            scores = -NOT_REMEMBERED - far
        nearest = far.argmin()
        scores[nearest] = max(scores[nearest], -rank)
    return scores


RULES: dict[str, tuple[bool, str]] = {
    "Bed": (True, "Storage"),
    "Chair": (False, "Table"),
    "Decor": (True, "Storage"),
    "Picture": (True, "Sofa"),
    "Sofa": (True, "TV"),
    "Storage": (True, "Bed"),
    "Table": (False, "Sofa"),
    "TV": (True, "Sofa"),
}
"""At the edge or in the middle, and near (and facing) what: a designer's first guess."""
NO_RULE = (True, "")  # for categories that knowledge has added

PAPER = System(
    "paper",
    {
        "position": _paper(("AD", "S", "RP"), ("F", "TC", "RP"), "position"),
        "orientation": _paper(("RP",), ("F", "TC", "RP"), "orientation"),
        "joint": _paper(("AD", "S", "RP"), ("F", "TC", "RP"), "total"),
    },
)

ABLATIONS: tuple[System, ...] = (
    System("AD+RP", _position("AD", "RP")),
    System("S+RP", _position("S", "RP")),
    System("RP", _position("RP")),
    System("F", _orientation("F")),
    System("F+C", _orientation("F", "TC")),
    System("F+C+NT", _orientation("F", "TC", "NT")),
    System("F+C+DS", _orientation("F", "TC", "DS")),
    System("F+C+DS+NT", _orientation("F", "TC", "DS", "NT")),
)
"""The paper's reduced systems; its full ones, AD+S+RP and F+C+RP, are "paper"."""

ALL_TASKS: tuple[Task, ...] = ("position", "orientation", "joint")

YARDSTICKS: tuple[System, ...] = (
    System("random", dict.fromkeys(ALL_TASKS, _any), feasible=False),
    System("random_open", dict.fromkeys(ALL_TASKS, _any)),
    System("cover_floor", {"position": _cover, "joint": _cover}),
    System("along_walls", {"position": _along_walls, "joint": _along_walls}),
    System("away_from_wall", {"orientation": _away_from_wall}),
    System("category_prior", {"position": _paper(("RP",), ("TC", "RP"), "position"),
                              "orientation": _paper(("RP",), ("TC", "RP"), "orientation"),
                              "joint": _paper(("RP",), ("TC", "RP"), "total")}),
    System("nearest_room", dict.fromkeys(ALL_TASKS, _nearest_room), needs_lessons=True),
    System("rules", dict.fromkeys(ALL_TASKS, _rules)),
    System("oracle", dict.fromkeys(ALL_TASKS, _oracle)),
)  # fmt: skip

SYSTEMS: tuple[System, ...] = (PAPER, *ABLATIONS, *YARDSTICKS)
