"""What is asked and what is answered, as plain values."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from scenegen_core.scene.model import Point, Vector3

Surface = Literal["floor", "walls", "tops"]
Model = Literal["paper"]
MODELS: tuple[Model, ...] = ("paper",)


@dataclass(frozen=True, slots=True)
class Query:
    """What is to be placed."""

    category: str
    size: Vector3 | None = None
    """Depth, width, height, metres; None for the usual size."""
    count: int = 5
    """How many placements to offer."""
    model: Model = "paper"
    seed: int = 0
    """Decides between poses of exactly the same score."""


@dataclass(frozen=True, slots=True)
class Reason:
    """One part of a score: what a relation to a group adds, in nats."""

    relation: str
    group: str
    contribution: float
    text: str


@dataclass(frozen=True, slots=True)
class Pose:
    """A placement on offer; the contributions of its reasons add up to its score."""

    rank: int
    center: Vector3
    """Of the box, metres."""
    heading: float
    """Radians anticlockwise from +x."""
    score: float
    """Log-likelihood above the average possible pose of this room (nats)."""
    likelihood: float
    """0 to 1, on the scale of the heat map."""
    sentence: str
    reasons: tuple[Reason, ...]
    rooms: tuple[str, ...]
    """The known rooms that speak loudest for it."""


@dataclass(frozen=True, slots=True)
class HeatMap:
    """A raster of uint8 (rows, columns): 0 nobody can stand there, 1 least to 255 most likely.

    ``floor`` and ``tops``: the plan, row 0 at the smallest y. ``walls``: the walls unrolled from
    corner 0 on, row 0 at the floor.
    """

    surface: Surface
    origin: Point
    """The outer corner of cell (0, 0), metres."""
    cell: float
    """Edge of a cell, metres."""
    values: NDArray[np.uint8]
    low: float
    """The score at value 1."""
    high: float
    """The score at value 255."""


@dataclass(frozen=True, slots=True)
class NoGoodPlace:
    """Why there is no place: the rule that forbids most of what fits, and a sentence on it."""

    rule: str
    text: str


@dataclass(frozen=True, slots=True)
class Answer:
    """Where the object would go."""

    category: str
    size: Vector3
    poses: tuple[Pose, ...]
    heat_maps: tuple[HeatMap, ...]
    no_good_place: NoGoodPlace | None


@dataclass(frozen=True, slots=True)
class Inspection:
    """What the model says of one pose; ``rule`` is empty where the pose is possible."""

    allowed: bool
    rule: str
    score: float | None
    likelihood: float | None
    sentence: str
    reasons: tuple[Reason, ...]


class Cancelled(Exception):  # noqa: N818 (not an error: somebody asked for something newer)
    """The work was superseded and abandoned."""
