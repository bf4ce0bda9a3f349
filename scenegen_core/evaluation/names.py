"""What systems and measures are called in a report, and which of them belong together."""

from __future__ import annotations

from typing import Literal

from scenegen_core.evaluation.bench import Task

POSITION_SYSTEMS = {"paper": "AD+S+RP", "AD+RP": "AD+RP", "S+RP": "S+RP", "RP": "RP"}
"""The systems of the paper's Table 1: our name -> the paper's."""

ORIENTATION_SYSTEMS = {
    "paper": "F+C+RP", "F": "F", "F+C": "F+C", "F+C+NT": "F+C+NT", "F+C+DS": "F+C+DS",
    "F+C+DS+NT": "F+C+DS+NT",
}  # fmt: skip
"""The systems of the paper's Table 2: our name -> the paper's."""

TITLES = {
    "scenegen": "SceneGen, choices",
    "paper": "SceneGen as published, made sound",
    "random": "Random pose",
    "random_open": "Random possible pose",
    "cover_floor": "Poses that cover the free floor",
    "along_walls": "Along the walls",
    "away_from_wall": "Away from the nearest wall",
    "category_prior": "Relations to the room only",
    "curves": "SceneGen, curves alone",
    "trees": "Gradient-boosted trees, same columns",
    "nearest_room": "As in the most similar room",
    "rules": "Hand-written rules",
    "oracle": "Best of the poses tried",
}
"""The systems that are no ablations, in words."""

BOUND = "oracle"  # knows the truth: a bound, not a rival
REFERENCE = "random_open"  # what skill is counted from

MEASURES = {
    "top1": "best pose",
    "top5": "nearest of the best 5",
    "spread5": "nearest of 5 that differ",
    "angle": "angle",
}
UNITS: dict[str, Literal["m", "rad"]] = {"top1": "m", "top5": "m", "spread5": "m", "angle": "rad"}

TASKS: dict[Task, str] = {
    "joint": "place and heading both unknown",
    "position": "heading given",
    "orientation": "place given",
    "joint2": "two taken out",
    "joint3": "three taken out",
}
TAKEN_OUT: dict[Task, str] = {
    "joint": "one taken out", "joint2": TASKS["joint2"], "joint3": TASKS["joint3"],
}  # fmt: skip
"""The joint task by how much of the room is gone."""

FACTS = {
    "collides": "runs into something",
    "outside": "leaves the room",
    "blocks_door": "stands before a door",
    "breaks_path": "bars a way",
    "declined": "says: no good place",
}


def with_unit(measure: str) -> str:
    """A measure in words with its unit, for tables that mix units."""
    return f"{MEASURES[measure]},\N{NO-BREAK SPACE}{UNITS[measure]}"


def title(system: str) -> str:
    """A system in words; ablations keep the paper's abbreviations."""
    return TITLES.get(system, system)
