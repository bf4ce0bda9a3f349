"""Comparisons: skill, what each relation is worth, paired differences; and the paper's numbers."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from scenegen_core.evaluation.bench import Task
from scenegen_core.evaluation.bootstrap import relative
from scenegen_core.evaluation.names import (
    BOUND,
    MEASURES,
    ORIENTATION_SYSTEMS,
    POSITION_SYSTEMS,
    REFERENCE,
    TASKS,
    UNITS,
    title,
    with_unit,
)
from scenegen_core.evaluation.published import ORIENTATION, POSITION
from scenegen_core.evaluation.report_tables import Judged
from scenegen_core.evaluation.summary import both, paired
from scenegen_core.evaluation.tables import Cell, Column, Row, Table, best_of_column, best_of_row

ASKED: tuple[tuple[Task, str], ...] = (
    ("joint", "top1"), ("joint", "spread5"), ("joint", "angle"),
    ("position", "top1"), ("position", "top5"), ("position", "spread5"),
    ("orientation", "angle"),
)  # fmt: skip
"""The measures that comparisons are made of."""

STEPS: tuple[tuple[str, str, Task, str], ...] = (
    ("RP", "paper", "position", "top1"),
    ("RP", "paper", "position", "top5"),
    ("AD+RP", "paper", "position", "top1"),
    ("S+RP", "paper", "position", "top1"),
    ("F", "F+C", "orientation", "angle"),
    ("F+C", "paper", "orientation", "angle"),
    ("F", "paper", "orientation", "angle"),
)
"""From a reduced system to a fuller one, and the measure that should fall."""


def skill(judged: Judged) -> Table:
    """1 − error / error of a random possible pose in the same rooms."""
    rows = []
    for name in judged.results["models"]:
        cells = []
        for task, measure in ASKED:
            pairs = both(judged.records, name, REFERENCE, task, measure)
            change = relative(pairs, rng=_rng(judged)) if pairs and name != REFERENCE else None
            cells.append(Cell() if change is None else Cell(-change[0], -change[2], -change[1]))
        if any(one.value is not None for one in cells):
            rows.append(Row(title(name), tuple(cells)))
    columns = tuple(
        Column(MEASURES[measure], "change", TASKS[task], better="high") for task, measure in ASKED
    )
    table = Table(
        "skill",
        "Skill: how much of a random possible pose's error is gone",
        "1 − error / error of a random possible pose in the same rooms; 0 % is no better than "
        "chance, 100 % is perfect. Unlike metres it does not grow with rooms.",
        "system",
        columns,
        tuple(rows),
    )
    return best_of_column(table, [title(BOUND)])


def steps(judged: Judged) -> Table:
    """What the relations are worth: the change of the error from a reduced system to a fuller."""
    rows = []
    for reduced, full, task, measure in STEPS:
        pairs = both(judged.records, full, reduced, task, measure)
        if pairs:
            rows.append(
                Row(
                    _step(reduced, full, task, measure), (Cell(*relative(pairs, rng=_rng(judged))),)
                )
            )
    return _steps_table("steps", "Here", tuple(rows))


def published_steps() -> Table:
    """The same changes from the paper's tables."""
    rows = []
    for reduced, full, task, measure in STEPS:
        before, after = (_published(name, task, measure) for name in (reduced, full))
        rows.append(Row(_step(reduced, full, task, measure), (Cell(after / before - 1),)))
    return _steps_table("published_steps", "In the paper", tuple(rows))


def _steps_table(table_id: str, where: str, rows: tuple[Row, ...]) -> Table:
    columns = (Column("change of the error", "change", better=""),)
    return Table(table_id, where, "", "from → to", columns, rows)


def _step(reduced: str, full: str, task: Task, measure: str) -> str:
    words = _systems(task)
    return f"{words[reduced]} → {words[full]}, {MEASURES[measure]}"


def _systems(task: Task) -> Mapping[str, str]:
    return POSITION_SYSTEMS if task == "position" else ORIENTATION_SYSTEMS


def _published(name: str, task: Task, measure: str) -> float:
    if task == "position":
        return POSITION[POSITION_SYSTEMS[name]]["overall"][("top1", "top5").index(measure)]
    return ORIENTATION[ORIENTATION_SYSTEMS[name]]["overall"]


def differences(judged: Judged, one: str = "paper") -> Table:
    """Paired differences of one system and every other, on the cases both answer."""
    rows = []
    for name in judged.results["models"]:
        if name == one:
            continue
        found = {
            task: paired(judged.records, one, name, task, rng=_rng(judged))
            for task in dict.fromkeys(task for task, _ in ASKED)
        }
        cells = tuple(Cell(*found[task].get(measure, ())) for task, measure in ASKED)
        if any(c.value is not None for c in cells):
            rows.append(Row(title(name), cells))
    columns = tuple(Column(with_unit(m), UNITS[m], TASKS[task], better="") for task, m in ASKED)
    note = "Below 0: nearer to the truth than the system of the row, on the same objects."
    heading = f"Paired differences: “{title(one)}” minus each other system"
    return Table("differences", heading, note, "minus", columns, tuple(rows))


def published_position() -> Table:
    """The paper's Table 1."""
    columns = tuple(
        Column(system, "m", MEASURES[measure])
        for measure in ("top1", "top5")
        for system in POSITION
    )
    rows = tuple(
        Row(
            category,
            tuple(Cell(table[category][rank]) for rank in (0, 1) for table in POSITION.values()),
        )
        for category in POSITION["RP"]
    )
    return best_of_row(
        Table(
            "published_position",
            "Published: the paper's Table 1, metres (Matterport3D)",
            "",
            "category",
            columns,
            rows,
        )
    )


def published_orientation() -> Table:
    """The paper's Table 2."""
    columns = tuple(Column(system, "rad", MEASURES["angle"]) for system in ORIENTATION)
    rows = tuple(
        Row(category, tuple(Cell(table[category]) for table in ORIENTATION.values()))
        for category in ORIENTATION["F"]
    )
    return best_of_row(
        Table(
            "published_orientation",
            "Published: the paper's Table 2, radians (Matterport3D)",
            "",
            "category",
            columns,
            rows,
        )
    )


def _rng(judged: Judged) -> np.random.Generator:
    return np.random.default_rng(judged.settings.seed)
