"""Breakdowns: every system by category and by source, and the hard facts."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from scenegen_core.evaluation.bench import Task
from scenegen_core.evaluation.names import (
    BOUND,
    FACTS,
    MEASURES,
    ORIENTATION_SYSTEMS,
    POSITION_SYSTEMS,
    TAKEN_OUT,
    TASKS,
    UNITS,
    title,
    with_unit,
)
from scenegen_core.evaluation.physical import DECLINED, PHYSICAL
from scenegen_core.evaluation.records import Record
from scenegen_core.evaluation.report_tables import Judged
from scenegen_core.evaluation.summary import means
from scenegen_core.evaluation.tables import Cell, Column, Row, Table, best_of_column, cell

REACH = 0.2  # metres; a possible pose nearer to the truth than that could have been offered


def joint_by_category(judged: Judged) -> tuple[Table, ...]:
    """The joint task by category: one table a measure."""
    return tuple(
        _by_system(judged, "joint", measure, f"By category, {MEASURES[measure]}")
        for measure in ("top1", "spread5", "angle")
    )


def emptier_by_category(judged: Judged) -> tuple[Table, ...]:
    """The joint task in emptier rooms by category: a table for each."""
    emptier = [(task, words) for task, words in TAKEN_OUT.items() if task != "joint"]
    return tuple(
        _by_system(judged, task, "top1", f"By category, {words}, {MEASURES['top1']}")
        for task, words in emptier
    )


def yardsticks(judged: Judged) -> tuple[Table, ...]:
    """All systems where the heading, or the place, is given."""
    return (
        _by_system(judged, "position", "top1", "Heading given, best place"),
        _by_system(judged, "position", "spread5", "Heading given, nearest of 5 that differ"),
        _by_system(judged, "orientation", "angle", "Place given, angle"),
    )


def _by_system(judged: Judged, task: Task, measure: str, heading: str) -> Table:
    systems = [s for s in judged.systems(task) if measure in judged.means(s, task)]
    names = [
        n for n in judged.categories if any(measure in judged.means(s, task, n) for s in systems)
    ]
    unit = UNITS[measure]
    rows = [
        Row(title(s), tuple(cell(judged.means(s, task, n), measure) for n in names))
        for s in systems
    ]
    unit_word = {"m": "metres", "rad": "radians"}[unit]
    table = Table(
        f"{task}_{measure}_by_category",
        f"{heading}, {unit_word}",
        "",
        "system",
        tuple(Column(name, unit) for name in names),
        tuple(rows),
    )
    return best_of_column(table, [title(BOUND)])


def by_source(judged: Judged) -> tuple[Table, ...]:
    """Each task by source of the rooms, all categories."""
    parts = {
        source or "unnamed": [one for one in judged.records if one.source == source]
        for source in judged.sources
    }
    titles = {name: title(name) for name in judged.systems("joint")}
    asked: tuple[tuple[Task, tuple[str, ...], Mapping[str, str]], ...] = (
        ("joint", ("top1", "spread5", "angle"), titles),
        ("position", ("top1", "top5", "spread5"), POSITION_SYSTEMS),
        ("orientation", ("angle",), ORIENTATION_SYSTEMS),
    )
    return tuple(
        _by_part(judged, task, measures, words, parts, f"{task}_by_source", "By source")
        for task, measures, words in asked
    )


def by_reach(judged: Judged) -> Table:
    """The joint task where a possible pose was tried near the truth, and where none was."""
    near: list[Record] = []
    far: list[Record] = []
    for record in judged.records:
        away = record.errors.get(BOUND, {}).get("joint", {}).get("top1")
        if away is not None:
            (near if away <= REACH else far).append(record)
    parts = {f"within {REACH:g} m ({len(near)})": near, f"further away ({len(far)})": far}
    parts = {label: part for label, part in parts.items() if part}
    words = {name: title(name) for name in judged.systems("joint")}
    measures = ("top1", "spread5", "angle")
    return _by_part(
        judged, "joint", measures, words, parts, "joint_by_reach", "By the nearest pose tried"
    )


def _by_part(
    judged: Judged,
    task: Task,
    measures: Sequence[str],
    words: Mapping[str, str],
    parts: Mapping[str, Sequence[Record]],
    name: str,
    heading: str,
) -> Table:
    """A task, each part of the records beside the others."""
    asked = [system for system in words if system in judged.systems(task)]
    columns, cells = [], dict[str, list[Cell]]({system: [] for system in asked})
    for label, part in parts.items():
        rng = np.random.default_rng(judged.settings.seed)
        columns += [Column(with_unit(m), UNITS[m], label) for m in measures]
        for system in asked:
            rows = [(r.room, e[task]) for r in part if task in (e := r.errors.get(system, {}))]
            found = means(rows, rng=rng) if rows else {}
            cells[system] += [cell(found, measure) for measure in measures]
    table = Table(
        name,
        f"{heading}: {TASKS[task]}",
        "",
        "system",
        tuple(columns),
        tuple(Row(words[system], tuple(row)) for system, row in cells.items()),
    )
    return best_of_column(table, [title(BOUND)])


def physical(judged: Judged) -> Table:
    """Shares of answers that break a hard fact; and of the true places."""
    rows = [
        Row(title(name), tuple(map(Cell, [*tables["physical"].values(), tables[DECLINED]])))
        for name, tables in judged.results["models"].items()
        if "physical" in tables
    ]
    truth = [Cell(float(np.mean([r.truth[fact] for r in judged.records]))) for fact in PHYSICAL]
    rows.append(Row("Where it really stood", (*truth, Cell(0.0))))
    facts = (*PHYSICAL, DECLINED)
    columns = tuple(Column(FACTS[fact], "share", better="") for fact in facts)
    note = (
        "Runs into something: footprints share more than 2 % of the smaller, and more than 1 cm of "
        "height; chairs at tables and rugs excepted. Leaves the room: more than 1 % of the "
        "footprint. Stands before a door: on the square inside it. Bars a way: a door, seat, bed "
        "or storage that a walker 0.6 m wide reached is no longer reached. Where nothing is "
        "possible the program says so and puts the object nowhere; distances are then to its best "
        "guess."
    )
    return Table("physical", "Hard facts, share of answers", note, "system", columns, tuple(rows))
