"""The tables of the report: the paper's ablations, the joint task, yardsticks, sources."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from scenegen_core.evaluation.bench import Task
from scenegen_core.evaluation.names import (
    BOUND,
    MEASURES,
    ORIENTATION_SYSTEMS,
    POSITION_SYSTEMS,
    UNITS,
    title,
    with_unit,
)
from scenegen_core.evaluation.records import Record, Settings
from scenegen_core.evaluation.summary import Means, means
from scenegen_core.evaluation.tables import (
    Cell,
    Column,
    Row,
    Table,
    best_of_column,
    best_of_row,
    cell,
)

CLOSE = (0.5, np.pi / 12)  # metres and radians (15°) within which a pose counts as the true one
OVERALL = "overall"
DISTANCES = ("top1", "top5", "spread5")


@dataclass(frozen=True, slots=True, eq=False)
class Judged:
    """All that a report is made from."""

    settings: Settings
    records: Sequence[Record]
    results: Mapping[str, Any]
    """As :func:`summary.summarize` gives it."""

    def means(self, system: str, task: Task, category: str = OVERALL) -> Means:
        """The means of a system in a task; {} if it was not asked."""
        found: Means = self.results["models"].get(system, {}).get(task, {}).get(category, {})
        return found

    def systems(self, task: Task) -> list[str]:
        """The systems that did a task, in their order."""
        return [name for name, tables in self.results["models"].items() if task in tables]

    @property
    def categories(self) -> list[str]:
        """The categories that were asked about, then "overall"."""
        return [*sorted({record.category for record in self.records}), OVERALL]

    @property
    def sources(self) -> list[str]:
        """The sources of the rooms, by name."""
        return sorted({record.source for record in self.records})


def counts(judged: Judged) -> Table:
    """Rooms and objects by source and category."""
    names = [name for name in judged.categories if name != OVERALL]
    rows = []
    for source in [*judged.sources, "all"]:
        part = [record for record in judged.records if source in {record.source, "all"}]
        by_category = Counter(record.category for record in part)
        numbers = [len({r.room for r in part}), len(part), *(by_category[name] for name in names)]
        rows.append(Row(source or "unnamed", tuple(Cell(n) for n in numbers)))
    columns = [Column(name, "count", better="") for name in ("rooms", "objects", *names)]
    return Table("counts", "What was judged", "", "source", tuple(columns), tuple(rows))


def position(judged: Judged) -> Table:
    """The paper's Table 1: metres by category, four systems, three measures."""
    return best_of_row(
        _by_category(
            judged,
            "position",
            POSITION_SYSTEMS,
            DISTANCES,
            "Distance to the true place, the true heading given (the paper's Table 1), metres",
        )
    )


def orientation(judged: Judged) -> Table:
    """The paper's Table 2: radians by category, six systems."""
    return best_of_row(
        _by_category(
            judged,
            "orientation",
            ORIENTATION_SYSTEMS,
            ("angle",),
            "Angle to the true heading, the true place given (the paper's Table 2), radians",
        )
    )


def _by_category(
    judged: Judged, task: Task, systems: Mapping[str, str], measures: Sequence[str], heading: str
) -> Table:
    asked = [name for name in systems if judged.means(name, task)]
    names = [n for n in judged.categories if any(judged.means(s, task, n) for s in asked)]
    columns = [Column("n", "count", better="")]
    columns += [
        Column(systems[name], UNITS[measure], MEASURES[measure])
        for measure in measures
        for name in asked
    ]
    rows = []
    for category in names:
        found = [judged.means(name, task, category) for name in asked]
        cells = [cell(part, measure) for measure in measures for part in found]
        rows.append(Row(category, (Cell(found[0]["n"]), *cells)))
    return Table(task, heading, "", "category", tuple(columns), tuple(rows))


def joint(judged: Judged) -> Table:
    """The headline: every system, all categories, place and heading both unknown."""
    columns = [Column(with_unit(m), UNITS[m]) for m in ("top1", "spread5", "top5", "angle")]
    columns.append(Column("within 0.5 m and 15°", "share", better="high"))
    rows = []
    for name in judged.systems("joint"):
        found = judged.means(name, "joint")
        cells = [cell(found, measure) for measure in ("top1", "spread5", "top5", "angle")]
        rows.append(Row(title(name), (*cells, _close(judged, name))))
    heading = "Place and heading both unknown, all categories"
    note = (
        "Angles are of what has a front that is known. A pose is within reach if its place is, and "
        "its heading too where the front is known."
    )
    table = Table("joint", heading, note, "system", tuple(columns), tuple(rows))
    return best_of_column(table, [title(BOUND)])


def _close(judged: Judged, name: str) -> Cell:
    """Share of poses within reach of the truth, with its interval."""
    metres, radians = CLOSE
    found = [(r.room, e["joint"]) for r in judged.records if "joint" in (e := r.errors[name])]
    hits = [
        (room, {"top1": float(e["top1"] <= metres and e.get("angle", 0.0) <= radians)})
        for room, e in found
    ]
    return cell(means(hits, rng=np.random.default_rng(judged.settings.seed)), "top1")
