"""Knowledge to look at: the paper's knowledge figure for every category, with its counts."""

from __future__ import annotations

from html import escape
from pathlib import Path

import msgspec

from scenegen_core.evaluation.drawing import COLORS, figure, svg
from scenegen_core.evaluation.page import contents, document, paragraph, plot, section
from scenegen_core.knowledge.knowledge import Knowledge
from scenegen_core.knowledge.marginals import Bar, CategoryMarginals, KnowledgeMarginals, marginals

TITLE = "What does it know?"
INTRODUCTION = (
    "SceneGen learned from rooms how each kind of furniture stands in them. Each bar is the share "
    "of its examples that it holds for, with their count. What is near is less than 1 m away. A "
    "thing is at an edge if one wall is that near to its middle, in a corner if two are: large "
    "things seldom are."
)
WIDTH, ROW_HEIGHT = 5.4, 2.4  # inches
BAR, SEVERAL_BAR = COLORS[6], COLORS[2]


def write_knowledge(out: Path, knowledge: Knowledge) -> None:
    """Write index.html, knowledge.json and a picture a category; OSError if that fails."""
    known = marginals(knowledge)
    out.mkdir(parents=True, exist_ok=True)
    pictures = {part.category: draw(part) for part in known.categories}
    for name, picture in pictures.items():
        (out / f"{name.lower()}.svg").write_text(picture, encoding="utf-8")
    (out / "knowledge.json").write_bytes(msgspec.json.format(msgspec.json.encode(known)))
    (out / "index.html").write_text(_page(known, pictures), encoding="utf-8")


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


def sentence(part: CategoryMarginals) -> str:
    """The main points in words, such as "in a corner 63 %, along an edge 33 %"."""
    middle, edge, corner = (bar.share for bar in part.position)
    words = (
        f"{part.category}: in a corner {corner:.0%}, along an edge {edge:.0%}, "
        f"in the middle {middle:.0%} of {part.examples} examples"
    )
    if part.towards_center:
        words += (
            f"; faces the middle of the room {part.towards_center[0].share:.0%} of the "
            f"{part.fronts} whose front is known"
        )
    return words + "."


def _page(known: KnowledgeMarginals, pictures: dict[str, str]) -> str:
    sources = "; ".join(
        f"{source.name}, {source.rooms} rooms ({source.license}, {source.copyright})"
        for source in known.sources
    )
    sections = [
        section(
            part.category,
            part.category,
            paragraph(sentence(part)),
            '<div class="plots wide">',
            plot(pictures[part.category], f"What is known of {part.category}"),
            "</div>\n",
            _counts(part),
        )
        for part in known.categories
    ]
    return document(
        f"{TITLE} SceneGen",
        f"<header><h1>{TITLE}</h1>\n{paragraph(INTRODUCTION)}"
        f"{paragraph(f'Learned from {sources}.', 'note')}"
        f"{contents([(part.category, part.category) for part in known.categories])}</header>\n"
        + "".join(sections),
    )


def _counts(part: CategoryMarginals) -> str:
    """The counts behind the bars, folded away."""
    tables = "".join(_count_table(*panel) for panel in panels(part))
    return f'<details><summary>The counts</summary><div class="beside">{tables}</div></details>\n'


def _count_table(title: str, bars: tuple[Bar, ...], count: int) -> str:
    grouped = any(bar.possible for bar in bars)
    heads = ["", f"of {count}", *(["two or more", "rooms that have one"] * grouped)]
    rows = "".join(
        f'<tr><th scope="row">{escape(bar.label)}</th><td>{bar.count}</td>'
        + (f"<td>{bar.several}</td><td>{bar.possible}</td>" if grouped else "")
        + "</tr>"
        for bar in bars
    )
    head = "".join(f'<th scope="col">{one}</th>' for one in heads)
    return (
        f'<div class="scroll"><h3>{escape(title)}</h3><table><thead><tr>{head}</tr></thead>'
        f"<tbody>{rows}</tbody></table></div>"
    )
