"""Draws curves and surfaces of a model of choices: how much likelier, and how often it is seen.

Bins are drawn equally wide, with their edges written below: they are narrow where furniture
touches. What each adds is told as a factor, on a scale that all pictures of a category share.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import ceil
from typing import Any

import numpy as np

from scenegen_core.evaluation.choice_axes import (
    MOST,
    bin_axis,
    bins_shown,
    factor_axis,
    leave_out,
    reach_of,
    title,
)
from scenegen_core.evaluation.choice_strength import (
    curve_spreads,
    joint_shares,
    strongest,
    surface_spreads,
)
from scenegen_core.evaluation.column_words import words
from scenegen_core.evaluation.drawing import COLORS, figure, svg
from scenegen_core.graph.relations import Column
from scenegen_core.knowledge.choice import Choice, Table
from scenegen_core.scene.geometry import Floats

CURVES, SURFACES = 6, 4  # drawn of each category
ACROSS = 2  # pictures side by side
WIDTH, CURVE_HEIGHT, SURFACE_HEIGHT = 7.2, 2.0, 2.9  # inches
SIDEWAYS = 32  # letters a line, beside a picture

OWN, SHARED, SEEN = COLORS[2], COLORS[1], "#d5d9e2"
UNLIKELY, EVEN, LIKELY = COLORS[2], "#ffffff", COLORS[1]


@dataclass(frozen=True, slots=True)
class Drawn:
    """A figure of a category, with what it shows for those who cannot see it."""

    picture: str
    caption: str


def draw_curves(
    columns: tuple[Column, ...], curves: Table, often: Floats, beside: Table | None = None
) -> Drawn | None:
    """The strongest curves; dashed what all categories share; None if none matters."""
    which = strongest(curve_spreads(columns, curves, often), CURVES)
    if not len(which):
        return None
    shown = [bins_shown(columns[i], curves[i], often[i]) for i in which]
    values = [curves[i, window] for i, window in zip(which, shown, strict=True)]
    reach = reach_of(np.concatenate(values))
    rows = ceil(len(which) / ACROSS)
    shared = [beside] if beside is not None and beside.any() else []
    with figure(WIDTH, CURVE_HEIGHT * rows + 0.3) as drawn:
        grid = drawn.subplots(rows, ACROSS, squeeze=False).flat
        for axes, i, window in zip(grid, which, shown, strict=False):
            _behind(axes, often[i], window)
            _line(axes, curves[i], window, OWN, "-")
            for table in shared:
                _line(axes, table[i], window, SHARED, (0, (4, 2)))
            factor_axis(axes.yaxis, reach)
            axes.set(title=title(columns[i]), ylim=(-reach, reach))
            bin_axis(axes.xaxis, columns[i], window)
            axes.set_xlim(window.start, window.stop)
        leave_out(grid[len(which) :])
        dashed = "; dashed: what all furniture shares" if shared else ""
        drawn.supxlabel(f"line: how much likelier{dashed}; bars: share of examples", fontsize=9)
        return Drawn(svg(drawn), _caption("Curves", [words(columns[i]) for i in which]))


def draw_surfaces(choice: Choice) -> Drawn | None:
    """The strongest surfaces; dots are examples; None if none matters."""
    often = joint_shares(choice)
    which = strongest(surface_spreads(choice, often), SURFACES)
    if not len(which):
        return None
    named = [[choice.columns[c] for c in choice.pairs[i]] for i in which]
    windows = [
        [bins_shown(column, None, often[i].sum(axis=1 - axis)) for axis, column in enumerate(pair)]
        for i, pair in zip(which, named, strict=True)
    ]
    values = [choice.surfaces[i][w[0], w[1]] for i, w in zip(which, windows, strict=True)]
    reach = reach_of(np.concatenate([value.ravel() for value in values]))
    rows = ceil(len(which) / ACROSS)
    with figure(WIDTH, SURFACE_HEIGHT * rows) as drawn:
        grid = drawn.subplots(rows, ACROSS, squeeze=False).flat
        images: list[Any] = []
        for axes, i, pair, window, value in zip(grid, which, named, windows, values, strict=False):
            images.append(_image(axes, value, window, reach))
            _dots(axes, often[i], window)
            bin_axis(axes.xaxis, pair[1], window[1])
            bin_axis(axes.yaxis, pair[0], window[0])
            axes.set_xlabel(title(pair[1]))
            axes.set_ylabel(title(pair[0], SIDEWAYS))
        leave_out(grid[len(which) :])
        bar = drawn.colorbar(
            images[0], ax=list(grid[: len(which)]), shrink=0.6, label="how much likelier"
        )
        factor_axis(bar.ax.yaxis, reach)
        drawn.supxlabel("dots: examples, the larger the more", fontsize=9)
        told = [f"{words(one)} with {words(two)}" for one, two in named]
        return Drawn(svg(drawn), _caption("Surfaces", told))


def _caption(kind: str, told: Sequence[str]) -> str:
    return f"{kind}, the strongest first: {'; '.join(told)}"


def _line(axes: Any, curve: Floats, window: slice, color: str, dash: Any) -> None:
    edges = np.arange(window.start, window.stop + 1)
    axes.stairs(
        curve[window].clip(-MOST, MOST), edges, baseline=None, color=color, linestyle=dash, lw=1.8
    )


def _behind(axes: Any, often: Floats, window: slice) -> None:
    """How often the examples are in each bin, on a scale of its own behind the curve."""
    bars = axes.twinx()
    middles = np.arange(window.start, window.stop) + 0.5
    bars.bar(middles, often[window], width=0.9, color=SEEN)
    bars.set(ylim=(0, max(often[window].max() * 1.1, 0.1)))
    most = float(often[window].max())
    bars.set_yticks([0, most], labels=["0%", f"{most:.0%}"])
    bars.tick_params(colors="#5d5f66", labelsize=7)
    bars.spines[["right", "left"]].set_visible(False)
    axes.set_zorder(bars.get_zorder() + 1)
    axes.patch.set_visible(False)
    axes.axhline(0, color="#8a8d96", lw=0.6)


def _image(axes: Any, values: Table, window: list[slice], reach: float) -> Any:
    from matplotlib.colors import LinearSegmentedColormap  # noqa: PLC0415 (optional)

    colors = LinearSegmentedColormap.from_list("likelier", [UNLIKELY, EVEN, LIKELY])
    extent = (window[1].start, window[1].stop, window[0].start, window[0].stop)
    return axes.imshow(
        values, cmap=colors, vmin=-reach, vmax=reach, origin="lower", extent=extent, aspect="auto",
        interpolation="nearest",
    )  # fmt: skip


def _dots(axes: Any, often: Floats, window: list[slice]) -> None:
    seen = often[window[0], window[1]]
    rows, columns = np.nonzero(seen)
    size = 2 + 60 * seen[rows, columns] / seen.max(initial=1e-9)
    x, y = columns + window[1].start + 0.5, rows + window[0].start + 0.5
    axes.scatter(x, y, s=size, color="black", alpha=0.45, linewidths=0)
