"""Draws what knowledge says of a category, one relation at a time: the paper's knowledge figure."""

from __future__ import annotations

from scenegen_core.evaluation.drawing import COLORS, figure, svg
from scenegen_core.knowledge.marginals import Bar, CategoryMarginals

WIDTH, ROW_HEIGHT = 5.4, 2.4  # inches
BAR, SEVERAL_BAR = COLORS[6], COLORS[2]


def panels(part: CategoryMarginals) -> list[tuple[str, tuple[Bar, ...], int]]:
    """The four parts of the figure: title, bars, and how many examples they count."""
    everything = [
        ("Where in the room", part.position, part.examples),
        ("Near it", part.surrounded_by, part.examples),
        ("It faces", part.facing, part.fronts),
        ("Faces the middle", part.towards_center, part.fronts),
    ]
    return [(title, bars, count) for title, bars, count in everything if bars]


def draw(part: CategoryMarginals) -> str:
    """The figure of one category as SVG: two panels a row, each bar with its share and count."""
    shown = panels(part)
    rows = len(shown) // 2
    with figure(WIDTH, ROW_HEIGHT * rows + 0.3) as drawn:
        grid = drawn.subplots(rows, 2, squeeze=False).flat
        for axes, (title, bars, count) in zip(grid, shown, strict=True):
            labels = [bar.label for bar in bars]
            axes.barh(labels, [bar.share for bar in bars], color=BAR)
            axes.barh(labels, [bar.several / count for bar in bars], color=SEVERAL_BAR)
            for place, bar in enumerate(bars):
                axes.text(bar.share + 0.02, place, f"{bar.share:.0%} ({bar.count})", va="center")
            axes.set(title=f"{title}, of {count}", xlim=(0, 1.3), xticks=[])
            axes.invert_yaxis()
            axes.spines["bottom"].set_visible(False)
        drawn.supxlabel("dark: two or more of them", fontsize=9)
        return svg(drawn)
