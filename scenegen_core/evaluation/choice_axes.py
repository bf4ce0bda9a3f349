"""The axes of curves and surfaces: bins along them, factors as their scale."""

from __future__ import annotations

from math import ceil, exp, log
from textwrap import fill
from typing import Any

import numpy as np

from scenegen_core.evaluation.column_words import bin_words, edge_words, is_counted, words
from scenegen_core.graph.relations import Column
from scenegen_core.knowledge.choice import Table, edges_of
from scenegen_core.scene.geometry import Floats

TITLE = 40  # letters a line
TICKS = 7  # edges written below a picture, at most
LEAST, MOST = log(1.5), log(32)  # nats that scales reach at least, and at most
WIDE = log(8)  # nats; scales that reach further have a tick every two doublings


def bins_shown(column: Column, curve: Table | None, often: Floats) -> slice:
    """The bins worth drawing: where examples are, and where the curve changes."""
    bins = len(edges_of(column)) + 1
    seen = np.flatnonzero(often[:bins])
    low, high = (int(seen[0]), int(seen[-1])) if len(seen) else (0, bins - 1)
    if curve is not None:
        changes = np.flatnonzero(np.diff(curve[:bins]))
        low = min([low, *changes[:1].tolist()])
        high = max([high, *(changes[-1:] + 1).tolist()])
    return slice(low, high + 1)


def reach_of(values: Floats) -> float:
    """How far a scale goes to either side of "makes no difference", nats."""
    return float(np.clip(np.abs(values).max() * 1.1, LEAST, MOST))


def factor_axis(axis: Any, reach: float) -> None:
    """Ticks of a scale in nats, written as factors: ×2, ×1/2."""
    step = log(2) if reach <= WIDE else log(4)
    count = int(reach / step)
    places = [k * step for k in range(-count, count + 1)]
    named = [f"×{exp(nats):.0f}" if nats >= 0 else f"×1/{exp(-nats):.0f}" for nats in places]
    axis.set_ticks(places, labels=named)


def title(column: Column, letters: int = TITLE) -> str:
    """What a column measures, on several lines, the unit never alone on one."""
    told, comma, unit = words(column).rpartition(", ")
    return fill(f"{told},\u00a0{unit}" if comma else unit, letters)


def bin_axis(axis: Any, column: Column, window: slice) -> None:
    """Ticks where bins meet, or in the middle of bins that are whole numbers."""
    if is_counted(column):
        named = bin_words(column)
        places = [i + 0.5 for i in range(window.start, window.stop)]
        labels = [named[i] for i in range(window.start, window.stop)]
    else:
        named = edge_words(column)
        inner = list(range(window.start, window.stop - 1))
        inner = inner[:: max(1, ceil(len(inner) / TICKS))]
        places, labels = [i + 1.0 for i in inner], [named[i] for i in inner]
    axis.set_ticks(places, labels=labels)


def leave_out(rest: Any) -> None:
    """Show nothing where there is no picture left."""
    for axes in rest:
        axes.set_visible(False)
