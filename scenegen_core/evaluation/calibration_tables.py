"""Calibration in the report: scores of probabilities, what is called and what holds, the plot."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from scenegen_core.evaluation.calibration import BINS
from scenegen_core.evaluation.drawing import COLORS, DASHES, figure, svg
from scenegen_core.evaluation.names import title
from scenegen_core.evaluation.report_tables import OVERALL, Judged
from scenegen_core.evaluation.tables import Cell, Column, Row, Table, best_of_column, cell

SIZE = (4.6, 4.8)  # inches
DOT = 150.0  # square points; a dot that stands for all places, others by their share of them

SCORES: dict[str, Column] = {
    "n": Column("places", "count", better=""),
    "called": Column("called on average", "share", better=""),
    "holds": Column("hold the truth", "share", better=""),
    "ece": Column("calibration error", "share"),
    "brier": Column("Brier score", "score"),
    "brier_flat": Column("all called alike", "score", better=""),
    "log_score": Column("log score, nats", "nats", better="high"),
    "log_uniform": Column("all cells alike, nats", "nats", better=""),
}
NOTE = (
    "Calibration error: how far the share that holds is from what was called, the mean over all "
    "places by tenths. Brier score: the mean of (called − holds)², beside what it would be if all "
    "places were called by the share that holds. Log score: of the cell of the possible pose "
    "nearest to the truth, beside what it would be if all possible cells were equally likely."
)


def calibrated(judged: Judged) -> dict[str, Mapping[str, Any]]:
    """System -> its calibration, of those that give probabilities."""
    models = judged.results["models"]
    return {name: m["calibration"] for name, m in models.items() if "calibration" in m}


def calibration(judged: Judged) -> Table:
    """How right the probabilities are, all categories: a row a system."""
    rows = tuple(
        Row(title(name), tuple(cell(found[OVERALL], score) for score in SCORES))
        for name, found in calibrated(judged).items()
    )
    heading = "How right the probabilities are"
    return best_of_column(
        Table("calibration", heading, NOTE, "system", tuple(SCORES.values()), rows)
    )


def by_category(judged: Judged) -> Table:
    """The same by category: columns of each system."""
    systems = calibrated(judged)
    shown = ("called", "holds", "ece", "log_score", "log_uniform")
    names = [n for n in judged.categories if any(n in found for found in systems.values())]
    columns = tuple(
        Column(SCORES[s].name, SCORES[s].unit, title(system), SCORES[s].better)
        for system in systems
        for s in shown
    )
    rows = tuple(
        Row(name, tuple(cell(found.get(name, {}), s) for found in systems.values() for s in shown))
        for name in names
    )
    return Table("calibration_by_category", "By category", "", "category", columns, rows)


def reliability(judged: Judged) -> Table:
    """What was called and what held, by tenths: columns of each system."""
    systems = calibrated(judged)
    columns = tuple(
        Column(SCORES[s].name, SCORES[s].unit, title(system), better="")
        for system in systems
        for s in ("n", "called", "holds")
    )
    rows = []
    for index in range(BINS if systems else 0):
        cells = list[Cell]()
        for found in systems.values():
            part = next((b for b in found[OVERALL]["bins"] if b["from"] == index / BINS), {"n": 0})
            cells += [cell(part, score) for score in ("n", "called", "holds")]
        low, high = (100 * edge // BINS for edge in (index, index + 1))
        rows.append(Row(f"{low} to {high} %", tuple(cells)))
    heading = "Of the places called so, how many hold the truth"
    return Table("reliability", heading, "", "called", columns, tuple(rows))


def draw_reliability(judged: Judged) -> str | None:
    """The reliability plot as SVG; None if no system gives probabilities."""
    systems = calibrated(judged)
    if not systems:
        return None
    with figure(*SIZE) as drawn:
        axes = drawn.add_subplot()
        axes.plot([0, 1], [0, 1], color="#888888", linewidth=1, label="right probabilities")
        styles = zip(COLORS, DASHES, strict=True)
        for (name, found), (color, dashes) in zip(systems.items(), styles, strict=False):
            bins = found[OVERALL]["bins"]
            called, holds = ([b[score] for b in bins] for score in ("called", "holds"))
            low, high = zip(*(b["ci"]["holds"] for b in bins), strict=True)
            share = [b["n"] / found[OVERALL]["n"] for b in bins]
            axes.plot(called, holds, color=color, linestyle=dashes, label=title(name))
            axes.vlines(called, low, high, color=color, linewidth=1)
            axes.scatter(called, holds, [DOT * (0.1 + part) for part in share], color=color)
        axes.set(
            xlim=(0, 1),
            ylim=(0, 1),
            xlabel="probability that places are called with",
            ylabel="share of them that hold the truth",
            title="Reliability: dots by the number of places",
            aspect="equal",
        )
        axes.grid(alpha=0.25)
        drawn.legend(loc="outside lower center", ncols=2, frameon=False)
        return svg(drawn)
