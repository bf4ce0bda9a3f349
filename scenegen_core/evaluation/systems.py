"""Systems: ways to score the poses of a case; the paper's, its ablations, and yardsticks."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import get_args

import numpy as np

from scenegen_core.evaluation.bench import Bench, Form, Table
from scenegen_core.evaluation.trees import trees
from scenegen_core.evaluation.yardsticks import (
    along_walls,
    anywhere,
    away_from_wall,
    cover_floor,
    nearest_room,
    oracle,
    rules,
)
from scenegen_core.knowledge.knowledge import Knowledge
from scenegen_core.placement.choice_model import ChoiceModel
from scenegen_core.placement.paper_model import PaperModel
from scenegen_core.scene.geometry import Floats

Score = Callable[[Bench, Table, Knowledge, np.random.Generator], Floats]
"""(bench, table, knowledge, rng) -> a score for each scored pose of the table."""


@dataclass(frozen=True, slots=True)
class System:
    """A named way to answer some of the tasks."""

    name: str
    scores: Mapping[Form, Score]
    feasible: bool = True
    """Does it look at what is possible? Only the random pose does not."""
    needs_lessons: bool = False
    """Does it look into the rooms that taught?"""
    probabilities: bool = False
    """Are its joint scores, all finite, logarithms of probabilities but for a constant of the room?

    Then the report shows how right they are.
    """
    needs_forest: bool = False
    """Does it ask trees that were grown for the purpose?"""
    needs_choices: bool = False
    """Does it ask what is chosen? Of categories with too few examples nothing is known of that."""
    expects: bool = False
    """Does it offer by expected distance? Then its scores are probabilities too."""


def _paper(position: tuple[str, ...], orientation: tuple[str, ...], part: str) -> Score:
    @lru_cache(maxsize=64)
    def model(knowledge: Knowledge, category: str) -> PaperModel:
        return PaperModel(knowledge, category, position=position, orientation=orientation)

    def score(bench: Bench, table: Table, knowledge: Knowledge, _: np.random.Generator) -> Floats:
        scores = model(knowledge, bench.category.name).score(table.situation)
        found: Floats = getattr(scores, part)
        return found

    return score


def _choice(*, pairs: bool) -> Score:
    @lru_cache(maxsize=64)
    def model(knowledge: Knowledge, category: str) -> ChoiceModel:
        return ChoiceModel(knowledge, category, pairs=pairs)

    def score(bench: Bench, table: Table, knowledge: Knowledge, _: np.random.Generator) -> Floats:
        return model(knowledge, bench.category.name).total(table.situation)

    return score


def _of_choices(name: str, *, pairs: bool) -> System:
    return System(
        name,
        dict.fromkeys(get_args(Form), _choice(pairs=pairs)),
        probabilities=True,
        needs_choices=True,
        expects=True,
    )


def _position(*relations: str) -> Mapping[Form, Score]:
    return {"position": _paper(relations, ("F", "TC", "RP"), "position")}


def _orientation(*relations: str) -> Mapping[Form, Score]:
    return {"orientation": _paper(("RP",), relations, "orientation")}


SCENEGEN = _of_choices("scenegen", pairs=True)
"""Our model: one score for position and heading together, whatever is asked."""

CURVES = _of_choices("curves", pairs=False)
"""Our model without surfaces: its curves are learned first, so this is what curves alone can do."""

PAPER = System(
    "paper",
    {
        "position": _paper(("AD", "S", "RP"), ("F", "TC", "RP"), "position"),
        "orientation": _paper(("RP",), ("F", "TC", "RP"), "orientation"),
        "joint": _paper(("AD", "S", "RP"), ("F", "TC", "RP"), "total"),
    },
    probabilities=True,
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

YARDSTICKS: tuple[System, ...] = (
    System("random", dict.fromkeys(get_args(Form), anywhere), feasible=False),
    System("random_open", dict.fromkeys(get_args(Form), anywhere)),
    System("cover_floor", {"position": cover_floor, "joint": cover_floor}),
    System("along_walls", {"position": along_walls, "joint": along_walls}),
    System("away_from_wall", {"orientation": away_from_wall}),
    System("category_prior", {"position": _paper(("RP",), ("TC", "RP"), "position"),
                              "orientation": _paper(("RP",), ("TC", "RP"), "orientation"),
                              "joint": _paper(("RP",), ("TC", "RP"), "total")}),
    System("nearest_room", dict.fromkeys(get_args(Form), nearest_room), needs_lessons=True),
    System("trees", dict.fromkeys(get_args(Form), trees), probabilities=True, needs_forest=True,
           expects=True),
    System("rules", dict.fromkeys(get_args(Form), rules)),
    System("oracle", dict.fromkeys(get_args(Form), oracle)),
)  # fmt: skip

SYSTEMS: tuple[System, ...] = (SCENEGEN, PAPER, CURVES, *ABLATIONS, *YARDSTICKS)
