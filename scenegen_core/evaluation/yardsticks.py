"""Yardsticks: scores by means that know less than the paper's model, and the one that knows all.

Each takes (bench, table, knowledge, rng) and gives a score for each scored pose of the table.
"""

from __future__ import annotations

import numpy as np

from scenegen_core.evaluation.bench import Bench, Table
from scenegen_core.evaluation.retrieval import recall
from scenegen_core.knowledge.knowledge import Knowledge
from scenegen_core.scene.geometry import Floats, directions, wrapped

TURN = 0.1  # metres that a radian counts for, where poses are compared as a whole
NOT_REMEMBERED = 100.0  # ranks below every pose that a room is remembered for
SAME_PLACE = 1e-9  # metres; nearer things have no direction to each other
TIE = 1e-6  # metres; so near to each other is drawn by chance

SPREAD = 5  # poses that cover the floor
UNSPREAD = -10.0  # ranks below all of them

AGAINST = 0.2  # metres from a wall that still count as at the edge
SQUARE = 0.1  # radians off the normal of a wall that still count as the back to it
BACK_TO_WALL = 0.5  # what that is worth, where being in the right zone is worth 1
AHEAD = 0.5  # what it is worth to face the partner
RULES_TIE = 1e-3  # too little to outweigh a rule

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


def anywhere(_: Bench, table: Table, __: Knowledge, rng: np.random.Generator) -> Floats:
    """By chance."""
    return rng.random(len(table.scored))


def along_walls(_: Bench, table: Table, __: Knowledge, rng: np.random.Generator) -> Floats:
    """Flush against any wall."""
    return table.flush[table.scored] + rng.random(len(table.scored))


def away_from_wall(bench: Bench, table: Table, _: Knowledge, rng: np.random.Generator) -> Floats:
    """Face away from a wall, the nearer the better; into a wall is as bad as away from it.

    A footprint reaches other walls as it turns, so each heading is held against every wall.
    """
    situation = table.situation
    turns = np.abs(wrapped(situation.candidates.headings[:, None] - bench.around.inward))
    worst = turns + np.abs(situation.wall_gaps)  # a radian counts like a metre
    return np.asarray(-worst.min(axis=1) + TIE * rng.random(len(worst)), dtype=np.float64)


def cover_floor(_: Bench, table: Table, __: Knowledge, rng: np.random.Generator) -> Floats:
    """Greedy k-center over the possible floor: each next pose is the furthest from those before."""
    points = table.situation.candidates.centers[:, :2]
    scores = np.full(len(points), -np.inf)
    middle = np.hypot(*(points - points.mean(axis=0)).T)
    nearest = np.full(len(points), np.inf)
    pose = int(middle.argmin())
    for rank in range(SPREAD):
        scores[pose] = -rank
        nearest = np.minimum(nearest, np.hypot(*(points - points[pose]).T))
        pose = int((nearest + TIE * rng.random(len(points))).argmax())
    return np.where(np.isfinite(scores), scores, UNSPREAD - rng.random(len(points)))


def oracle(bench: Bench, table: Table, _: Knowledge, __: np.random.Generator) -> Floats:
    """The nearest of the possible poses to the truth: what the sampling allows at best."""
    truth = bench.case.box
    poses = table.situation.candidates
    distance = np.hypot(*(poses.centers[:, :2] - np.array(truth.center[:2])).T)
    turn = np.abs(wrapped(poses.headings - truth.heading))
    return np.asarray(-distance - TURN * turn, dtype=np.float64)


def rules(bench: Bench, table: Table, _: Knowledge, rng: np.random.Generator) -> Floats:
    """Hand-written rules in the manner of Holodeck: edge or middle, near its partner, facing it."""
    edge, partner = RULES.get(bench.category.name, NO_RULE)
    situation, around = table.situation, bench.around
    against = situation.wall_gaps.min(axis=1) < AGAINST
    scores = np.where(against == edge, 1.0, 0.0) + RULES_TIE * rng.random(len(against))
    turn = wrapped(
        situation.candidates.headings - around.inward[situation.wall_gaps.argmin(axis=1)]
    )
    scores += np.where(edge & (np.abs(turn) < SQUARE), BACK_TO_WALL, 0.0)
    members = np.array([box.category == partner for box in around.scene.boxes], dtype=bool)
    if members.any():
        gap = situation.gaps[:, members].min(axis=1)
        scores += np.exp(-np.maximum(gap, 0))  # a metre further is worth 1/e
        toward = around.centers[members, :2][situation.gaps[:, members].argmin(axis=1)]
        offset = toward - situation.candidates.centers[:, :2]
        reach = np.maximum(np.hypot(offset[:, 0], offset[:, 1]), SAME_PLACE)
        ahead = (offset * directions(situation.candidates.headings)).sum(axis=1) / reach
        scores += AHEAD * ahead
    return np.asarray(scores, dtype=np.float64)


def nearest_room(bench: Bench, table: Table, _: Knowledge, __: np.random.Generator) -> Floats:
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
