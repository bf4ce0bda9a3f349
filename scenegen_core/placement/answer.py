"""What is asked and what is answered, as plain values."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from scenegen_core.scene.model import Point, Vector3

Surface = Literal["floor", "walls", "tops"]
Model = Literal["scenegen", "paper"]
MODELS: tuple[Model, ...] = ("scenegen", "paper")
"""The default first."""
Comfort = Literal["window", "path"]
COMFORTS: tuple[Comfort, ...] = ("window", "path")
"""The rules that somebody may choose to live without."""


@dataclass(frozen=True, slots=True)
class Query:
    """What is to be placed."""

    category: str
    size: Vector3 | None = None
    """Depth, width, height, metres; None for the usual size."""
    count: int = 5
    """How many placements to offer."""
    model: Model = MODELS[0]
    seed: int = 0
    """Decides between poses of exactly the same score."""
    relaxed: tuple[Comfort, ...] = ()
    """Rules that do not count this time."""


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
    name: str
    """A few words that tell it from the others on offer."""
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
class Remedy:
    """The nearest thing that gives a place: a smaller size, one box less, or one rule less."""

    kind: Literal["size", "box", "rule"]
    text: str
    center: Vector3
    """Where the object would then go."""
    heading: float
    size: Vector3 | None = None
    box: str | None = None
    """The id of the box to take away."""
    rule: Comfort | None = None


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
class Elsewhere:
    """Another pose, and how to get there."""

    center: Vector3
    heading: float
    distance: float
    """From the pose that was looked at, metres."""
    text: str
    """The way in words: "30 cm further from the door"."""
    sentence: str
    """How it stands there."""


@dataclass(frozen=True, slots=True)
class Cost:
    """What a pose loses to the best one on offer through one relation to a group."""

    relation: str
    group: str
    difference: float
    """Nats, negative."""
    here: str
    best: str


@dataclass(frozen=True, slots=True)
class Inspection:
    """What the model says of one pose; ``rule`` is empty where the pose is possible."""

    allowed: bool
    rule: str
    score: float | None
    likelihood: float | None
    sentence: str
    reasons: tuple[Reason, ...]
    costs: tuple[Cost, ...] = ()
    """What costs most, the dearest first."""
    elsewhere: Elsewhere | None = None
    """Where it would be possible, or better; None if nowhere."""


@dataclass(frozen=True, slots=True)
class Counterfactual:
    """The box whose removal changes the answer most, and the answer without it."""

    box: str
    center: Vector3 | None
    """Where the object would go without the box; None if nowhere."""
    heading: float | None
    text: str
    moved: float = 0.0
    """Metres between the best poses with and without it."""
    turned: float = 0.0
    """Radians between them, 0 to π."""
    score_change: float = 0.0
    """Nats of the best pose above the average one, without the box less with it."""


class Cancelled(Exception):  # noqa: N818 (not an error: somebody asked for something newer)
    """The work was superseded and abandoned."""
