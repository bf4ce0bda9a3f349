"""The relations of the paper ("Scene Representation"), each a value that measures many poses.

A relation returns an array (poses, columns): one column, its ``parts``, or one for each group.
Training is the same call with the one pose that a box already has, in its scene without it.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import numpy as np

from scenegen_core.graph.situation import Situation
from scenegen_core.scene.geometry import TIE, Bools, Floats, ray_lengths, wrapped
from scenegen_core.scene.model import Category
from scenegen_core.scene.resting import RESTS

NEAR_WALL = 1.0  # metres; the paper's ϱ, which it gives no number for
NEARBY = 1.0  # metres; the paper's ε, which it gives no number for
SAME_DIRECTION = np.pi / 12  # radians (15°); the paper's φ, which it gives no number for
ABSENT = 1000.0  # metres; AverageDistance to a group that is not in the room (the paper's constant)

Values = Literal["continuous", "ordered"]


@dataclass(frozen=True, slots=True)
class Relation:
    """A named way to measure poses; a user's own relation is a value of this type too."""

    name: str
    short: str
    """The paper's abbreviation."""
    values: Values
    measure: Callable[[Situation], Floats]
    """Situation -> (poses, columns)."""
    per_group: bool = False
    parts: tuple[str, ...] = ("",)
    """Names of its columns, for each group or for the whole."""


@dataclass(frozen=True, slots=True)
class Column:
    """One number of a feature vector: a relation, and the group or part that it is about."""

    relation: str
    """The relation's abbreviation."""
    group: str
    """The group's name; empty where the relation is not per group."""
    values: Values
    part: str = ""
    """Which of the relation's columns, where it has several."""

    @property
    def about(self) -> str:
        """The group or part that it is about, or empty."""
        return self.group or self.part


def columns(relations: tuple[Relation, ...], groups: tuple[Category, ...]) -> tuple[Column, ...]:
    """What each column of :func:`measure` is."""
    names = tuple(group.name for group in groups)
    return tuple(
        Column(relation.short, group, relation.values, part)
        for relation in relations
        for group in (names if relation.per_group else ("",))
        for part in relation.parts
    )


def measure(relations: tuple[Relation, ...], situation: Situation) -> Floats:
    """The feature vectors of all poses, the paper's d_p and d_o: (poses, columns)."""
    parts = [relation.measure(situation) for relation in relations]
    features: Floats = np.concatenate(parts, axis=1)
    return features


def _room_position(situation: Situation) -> Floats:
    """RoomPosition: how many walls are nearer than ϱ to the center (eq. room_position)."""
    near = situation.wall_distances < NEAR_WALL
    return np.asarray(near.sum(axis=1, keepdims=True), dtype=np.float64)


def _average_distance(situation: Situation) -> Floats:
    """AverageDistance: mean gap to the members of each group, ABSENT without members."""
    members = situation.surroundings.membership
    counts = members.sum(axis=0)
    total = np.maximum(situation.gaps, 0) @ members
    return np.where(counts > 0, total / np.maximum(counts, 1), ABSENT)


def _surrounded_by(situation: Situation) -> Floats:
    """SurroundedBy: how many members of each group are nearer than ε."""
    return (situation.gaps < NEARBY) @ situation.surroundings.membership


def _support(situation: Situation) -> Floats:
    """Support: 1 on top of a member of the group, −1 under one, 0 otherwise."""
    candidates, around = situation.candidates, situation.surroundings
    meets = situation.meets
    on_top = meets & (np.abs(candidates.bottoms[:, None] - around.tops) <= RESTS)
    under = meets & (np.abs(around.bottoms - candidates.tops[:, None]) <= RESTS)
    if candidates.id:
        on_top = on_top | np.array([candidates.parent == i for i in around.ids], dtype=bool)
        under = under | np.array([candidates.id == p for p in around.parents], dtype=bool)
    members = around.membership
    return np.where(on_top @ members > 0, 1.0, np.where(under @ members > 0, -1.0, 0.0))


def _towards_center(situation: Situation) -> Floats:
    """TowardsCenter: the ray ahead first meets one of the furthest ⌈l/2⌉ walls.

    The text says l/2 walls, its formula stops at l/2 − 1: we follow the text, round odd l up, and
    count the first wall that the ray meets, since rooms are not convex (docs/decisions.md).
    Walls that tie with the last of them count too: two that share an inner corner often do.
    """
    walls = situation.surroundings.walls
    centers = situation.candidates.centers[:, :2]
    ahead = ray_lengths(centers, situation.fronts, walls)
    last = np.sort(situation.wall_distances, axis=1)[:, len(walls) // 2, None]
    far = situation.wall_distances >= last - TIE
    first = ahead.argmin(axis=1)[:, None]
    hit = np.isfinite(np.take_along_axis(ahead, first, axis=1))
    return np.asarray(hit & np.take_along_axis(far, first, axis=1), dtype=np.float64)


def _away_from_wall(situation: Situation) -> Floats:
    """AwayFromWall: the ray behind meets the nearest wall, and the axis is normal to it (± φ).

    Of walls that tie, as all do that the footprint touches, any will do.
    """
    around = situation.surroundings
    distances = np.maximum(situation.wall_gaps, 0)
    nearest = distances <= distances.min(axis=1, keepdims=True) + TIE
    centers = situation.candidates.centers[:, :2]
    behind = np.isfinite(ray_lengths(centers, -situation.fronts, around.walls))
    turns = wrapped(situation.candidates.headings[:, None] - around.wall_shapes.headings)
    normal = np.abs(np.abs(turns) - np.pi / 2) <= SAME_DIRECTION
    away = (nearest & behind & normal).any(axis=1, keepdims=True)
    return np.asarray(away, dtype=np.float64)


def _direction_similarity(situation: Situation) -> Floats:
    """DirectionSimilarity: [Same, Opp], neighbors within ε that face alike or the other way."""
    around = situation.surroundings
    turn = np.abs(
        wrapped(situation.candidates.headings[:, None] - around.footprints.headings[None, :])
    )
    counts = (situation.gaps <= NEARBY) & around.fronts_known
    same = counts & (turn <= SAME_DIRECTION)
    opposite = counts & (np.pi - turn <= SAME_DIRECTION)
    return np.stack([same.sum(axis=1), opposite.sum(axis=1)], axis=1).astype(float)


def _facing(situation: Situation) -> Floats:
    """Facing: members within ε that the ray ahead meets."""
    return _count(situation, situation.faces)


def _next_to(situation: Situation) -> Floats:
    """NextTo: members within ε that a ray to either side meets."""
    return _count(situation, situation.flanks)


def _count(situation: Situation, related: Bools) -> Floats:
    return (related & (situation.gaps <= NEARBY)) @ situation.surroundings.membership


ROOM_POSITION = Relation("RoomPosition", "RP", "ordered", _room_position)
AVERAGE_DISTANCE = Relation(
    "AverageDistance", "AD", "continuous", _average_distance, per_group=True
)
SURROUNDED_BY = Relation("SurroundedBy", "S", "ordered", _surrounded_by, per_group=True)
SUPPORT = Relation("Support", "SP", "ordered", _support, per_group=True)
TOWARDS_CENTER = Relation("TowardsCenter", "TC", "ordered", _towards_center)
AWAY_FROM_WALL = Relation("AwayFromWall", "AW", "ordered", _away_from_wall)
DIRECTION_SIMILARITY = Relation(
    "DirectionSimilarity", "DS", "ordered", _direction_similarity, parts=("same", "opposite")
)
FACING = Relation("Facing", "F", "ordered", _facing, per_group=True)
NEXT_TO = Relation("NextTo", "NT", "ordered", _next_to, per_group=True)

RELATIONS: tuple[Relation, ...] = (
    ROOM_POSITION,
    AVERAGE_DISTANCE,
    SURROUNDED_BY,
    SUPPORT,
    TOWARDS_CENTER,
    AWAY_FROM_WALL,
    DIRECTION_SIMILARITY,
    FACING,
    NEXT_TO,
)
"""All relations of the paper; RP belongs to both feature vectors."""

BY_SHORT = {relation.short: relation for relation in RELATIONS}
