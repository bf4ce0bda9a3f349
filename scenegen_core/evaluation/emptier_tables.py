"""The joint task in emptier rooms, beside the same objects where nothing else was taken out."""

from __future__ import annotations

import numpy as np

from scenegen_core.evaluation.bench import Task
from scenegen_core.evaluation.names import BOUND, TAKEN_OUT, UNITS, title, with_unit
from scenegen_core.evaluation.report_tables import Judged
from scenegen_core.evaluation.summary import means
from scenegen_core.evaluation.tables import Cell, Column, Row, Table, best_of_column, cell

SHOWN = ("top1", "spread5", "angle")


def emptier(judged: Judged) -> Table:
    """One, two and three objects taken out: the same questions, all categories."""
    last: Task = "joint3"
    records = [r for r in judged.records if any(last in tasks for tasks in r.errors.values())]
    rows = []
    for name in judged.systems(last):
        rng = np.random.default_rng(judged.settings.seed)
        cells = list[Cell]()
        for task in TAKEN_OUT:
            asked = [(r.room, e[task]) for r in records if task in (e := r.errors.get(name, {}))]
            found = means(asked, rng=rng)
            cells += [cell(found, measure) for measure in SHOWN]
        rows.append(Row(title(name), tuple(cells)))
    columns = tuple(
        Column(with_unit(measure), UNITS[measure], words)
        for words in TAKEN_OUT.values()
        for measure in SHOWN
    )
    heading = f"Place and heading unknown in emptier rooms, the same {len(records)} objects"
    table = Table("emptier", heading, "", "system", columns, tuple(rows))
    return best_of_column(table, [title(BOUND)])
