"""Cumulative curves, as in the paper's figures: what share of answers is this near the truth?"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from scenegen_core.evaluation.bench import Task
from scenegen_core.evaluation.drawing import COLORS, DASHES, figure, svg
from scenegen_core.evaluation.names import (
    MEASURES,
    ORIENTATION_SYSTEMS,
    POSITION_SYSTEMS,
    TASKS,
    UNITS,
    title,
)
from scenegen_core.evaluation.records import Record

SIZE = (5.2, 4.4)  # inches
FAR = 5.0  # metres; few rooms are larger than that to either side

JOINT_SYSTEMS = {
    name: title(name)
    for name in ("paper", "scenegen", "category_prior", "nearest_room", "rules", "random_open",
                 "oracle")
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class Curves:
    """One plot: a line a system."""

    task: Task
    measure: str
    systems: Mapping[str, str]
    """Name -> words of the legend, in the order of the lines."""

    @property
    def id(self) -> str:
        """Names its file."""
        return f"curve_{self.task}_{self.measure}"


PLOTS: tuple[Curves, ...] = (
    Curves("joint", "top1", JOINT_SYSTEMS),
    Curves("joint", "spread5", JOINT_SYSTEMS),
    Curves("joint", "angle", JOINT_SYSTEMS),
    Curves("position", "top1", POSITION_SYSTEMS),
    Curves("position", "top5", POSITION_SYSTEMS),
    Curves("position", "spread5", POSITION_SYSTEMS),
    Curves("orientation", "angle", ORIENTATION_SYSTEMS),
)


def errors_of(records: Sequence[Record], system: str, task: Task, measure: str) -> list[float]:
    """The errors of a system, sorted."""
    found = [record.errors.get(system, {}).get(task, {}).get(measure) for record in records]
    return sorted(error for error in found if error is not None)


def draw(curves: Curves, records: Sequence[Record]) -> str | None:
    """The plot as SVG; None if no system of it was asked."""
    lines = {
        words: errors_of(records, name, curves.task, curves.measure)
        for name, words in curves.systems.items()
    }
    lines = {words: errors for words, errors in lines.items() if errors}
    if not lines:
        return None
    radians = UNITS[curves.measure] == "rad"
    with figure(*SIZE) as drawn:
        axes = drawn.add_subplot()
        styles = zip(COLORS, DASHES, strict=True)
        for (words, errors), (color, dashes) in zip(lines.items(), styles, strict=False):
            share = np.arange(len(errors) + 1) / len(errors)
            axes.step([0, *errors], share, where="post", color=color, linestyle=dashes, label=words)
        axes.set(
            xlim=(0, np.pi if radians else FAR),
            ylim=(0, 1),
            xlabel="angle to the true heading, radians" if radians else "distance, metres",
            ylabel="share of objects",
            title=f"{MEASURES[curves.measure].capitalize()} ({TASKS[curves.task]})",
        )
        axes.grid(alpha=0.25)
        drawn.legend(loc="outside lower center", ncols=2, frameon=False)
        return svg(drawn)
