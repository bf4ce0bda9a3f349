"""The sections of the report: which words, tables and plots stand where."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from scenegen_core.evaluation import breakdown_tables as breakdowns
from scenegen_core.evaluation import calibration_tables as calibrations
from scenegen_core.evaluation import comparison_tables as comparisons
from scenegen_core.evaluation import report_tables as tables
from scenegen_core.evaluation.emptier_tables import emptier
from scenegen_core.evaluation.report_tables import Judged
from scenegen_core.evaluation.report_words import (
    COMPARABLE,
    DENSITIES,
    FIVES,
    TASK_WORDS,
    ordering,
    what_was_judged,
)
from scenegen_core.evaluation.tables import Table


@dataclass(frozen=True, slots=True)
class Part:
    """A section: words and notes, tables row by row, plots by their ids."""

    id: str
    title: str
    words: str
    notes: tuple[str, ...]
    tables: tuple[tuple[Table, ...], ...]
    plots: tuple[str, ...] = ()


def parts_of(judged: Judged, plots: Mapping[str, str]) -> list[Part]:
    """The sections that have something to show, in order."""

    def drawn(task: str) -> tuple[str, ...]:
        return tuple(name for name in plots if name.startswith(f"curve_{task}"))

    parts = [
        Part(
            "judged", "What was judged", "", what_was_judged(judged), _kept(tables.counts(judged))
        ),
        Part(
            "joint",
            "Place and heading",
            TASK_WORDS["joint"],
            (FIVES,),
            _kept(tables.joint(judged), *breakdowns.joint_by_category(judged)),
            drawn("joint"),
        ),
        Part(
            "emptier",
            "Emptier rooms",
            TASK_WORDS["emptier"],
            (),
            _kept(emptier(judged), *breakdowns.emptier_by_category(judged)),
        ),
        Part(
            "position",
            "Place, the heading given",
            TASK_WORDS["position"],
            (),
            _kept(tables.position(judged)),
            drawn("position"),
        ),
        Part(
            "orientation",
            "Heading, the place given",
            TASK_WORDS["orientation"],
            (),
            _kept(tables.orientation(judged)),
            drawn("orientation"),
        ),
        Part(
            "paper",
            "Beside the paper",
            ordering(judged),
            COMPARABLE,
            (
                *_beside(comparisons.steps(judged), comparisons.published_steps()),
                (comparisons.published_position(),),
                (comparisons.published_orientation(),),
            ),
        ),
        Part("skill", "Skill", "", (), _kept(comparisons.skill(judged))),
        Part(
            "yardsticks",
            "Yardsticks",
            TASK_WORDS["yardsticks"],
            (),
            _kept(*breakdowns.yardsticks(judged)),
        ),
        Part("differences", "Differences", "", (), _kept(comparisons.differences(judged))),
        Part(
            "sources", "By source", TASK_WORDS["sources"], (), _kept(*breakdowns.by_source(judged))
        ),
        Part("reach", "Within reach", TASK_WORDS["reach"], (), _kept(breakdowns.by_reach(judged))),
        Part(
            "calibration",
            "Probabilities",
            TASK_WORDS["calibration"],
            (DENSITIES,) if "paper" in calibrations.calibrated(judged) else (),
            _kept(
                calibrations.calibration(judged),
                calibrations.reliability(judged),
                calibrations.by_category(judged),
            ),
            tuple(name for name in plots if name == "reliability"),
        ),
        Part("facts", "Hard facts", TASK_WORDS["facts"], (), _kept(breakdowns.physical(judged))),
    ]
    return [part for part in parts if part.tables or part.plots]


def _kept(*found: Table) -> tuple[tuple[Table, ...], ...]:
    """The tables that say something, each in a row of its own."""
    return tuple((table,) for table in found if table.rows and table.columns)


def _beside(one: Table, other: Table) -> tuple[tuple[Table, ...], ...]:
    return ((one, other),) if one.rows else ((other,),)
