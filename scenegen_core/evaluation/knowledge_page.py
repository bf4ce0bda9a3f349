"""Knowledge to look at: the paper's figure of every category, and the curves that we add to it."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from html import escape
from pathlib import Path

import msgspec
import numpy as np

from scenegen_core.evaluation.choice_pictures import Drawn, draw_curves, draw_surfaces
from scenegen_core.evaluation.choice_strength import shares
from scenegen_core.evaluation.knowledge_bars import draw, panels
from scenegen_core.evaluation.page import contents, document, paragraph, plot, section
from scenegen_core.knowledge.choice import choice_columns
from scenegen_core.knowledge.knowledge import Knowledge
from scenegen_core.knowledge.marginals import Bar, CategoryMarginals, KnowledgeMarginals, marginals
from scenegen_core.knowledge.writing_tables import CURVES, SURFACES, file_stem, write_tables

TITLE = "What does it know?"
INTRODUCTION = (
    "SceneGen learned from rooms how each kind of furniture stands in them. Each bar is the share "
    "of its examples that it holds for, with their count. What is near is less than 1 m away. A "
    "thing is at an edge if one wall is that near to its middle, in a corner if two are: large "
    "things seldom are."
)
CHOICES = (
    "Where something goes is decided by curves and surfaces. A curve says how much likelier, or "
    "less likely, a place is for one thing that can be measured there, a surface for two at once; "
    "the factors of a place are multiplied. ×1 makes no difference. Shown are those that tell the "
    "examples apart most; grey bars and dots say how often examples are there, and little is known "
    "where there are none. Bins are as wide as each other in the pictures, and finest where "
    "furniture touches."
)
SHARED = (
    "What all furniture has in common is learned first, and then how each kind differs: so a few "
    "examples are enough. These are its strongest curves; the bars are the average of all kinds."
)
TOO_FEW = "There were too few examples to learn curves from."
ALL = "All furniture"
TABLES = "tables"


@dataclass(frozen=True, slots=True)
class Pictures:
    """What is drawn of one category."""

    bars: Drawn
    """The paper's figure."""
    curves: Drawn | None
    surfaces: Drawn | None

    @property
    def named(self) -> dict[str, Drawn]:
        """Those that there are, by what their files are called after the category."""
        everything = {"": self.bars, "-curves": self.curves, "-surfaces": self.surfaces}
        return {end: drawn for end, drawn in everything.items() if drawn}


def write_knowledge(out: Path, knowledge: Knowledge, *, tables: bool = False) -> None:
    """Write index.html, knowledge.json and the pictures; OSError if that fails.

    With ``tables`` also the curves and surfaces of every category as files to edit.
    """
    known = marginals(knowledge)
    out.mkdir(parents=True, exist_ok=True)
    pictures = {part.category: _pictures(part, knowledge) for part in known.categories}
    shared = _draw_shared(knowledge)
    files = {
        f"{file_stem(name)}{end}": drawn
        for name, of_category in pictures.items()
        for end, drawn in of_category.named.items()
    } | ({"all-furniture": shared} if shared else {})
    for name, drawn in files.items():
        (out / f"{name}.svg").write_text(drawn.picture, encoding="utf-8")
    if tables:
        write_tables(knowledge, out / TABLES)
    (out / "knowledge.json").write_bytes(msgspec.json.format(msgspec.json.encode(known)))
    page = _page(known, pictures, shared, with_tables=set(knowledge.choices) if tables else set())
    (out / "index.html").write_text(page, encoding="utf-8")


def _pictures(part: CategoryMarginals, knowledge: Knowledge) -> Pictures:
    bars = Drawn(draw(part), f"What is known of {part.category}")
    choice = knowledge.choices.get(part.category)
    if choice is None:
        return Pictures(bars, None, None)
    often = shares(choice.examples)
    curves = draw_curves(choice.columns, choice.curves, often, knowledge.shared)
    return Pictures(bars, curves, draw_surfaces(choice))


def _draw_shared(knowledge: Knowledge) -> Drawn | None:
    """What all categories share, over the examples of all, each category counting alike."""
    if knowledge.shared is None or not knowledge.choices:
        return None
    often = np.mean([shares(choice.examples) for choice in knowledge.choices.values()], axis=0)
    return draw_curves(choice_columns(knowledge.groups), knowledge.shared, often)


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


def _page(
    known: KnowledgeMarginals,
    pictures: dict[str, Pictures],
    shared: Drawn | None,
    with_tables: set[str],
) -> str:
    sources = "; ".join(
        f"{source.name}, {source.rooms} rooms ({source.license}, {source.copyright})"
        for source in known.sources
    )
    chosen = any(of_category.curves for of_category in pictures.values())
    sections = [
        section(
            part.category,
            part.category,
            paragraph(sentence(part)),
            _drawn(pictures[part.category].named.values()),
            "" if pictures[part.category].curves or not chosen else paragraph(TOO_FEW, "note"),
            _counts(part),
            _files(part.category) if part.category in with_tables else "",
        )
        for part in known.categories
    ]
    named = [(part.category, part.category) for part in known.categories]
    if shared:
        sections.insert(0, section("all", ALL, paragraph(SHARED), _drawn([shared])))
        named.insert(0, ("all", ALL))
    return document(
        f"{TITLE} SceneGen",
        f"<header><h1>{TITLE}</h1>\n{paragraph(INTRODUCTION)}"
        f"{paragraph(CHOICES) if chosen else ''}"
        f"{paragraph(f'Learned from {sources}.', 'note')}"
        f"{contents(named)}</header>\n" + "".join(sections),
    )


def _drawn(pictures: Iterable[Drawn]) -> str:
    figures = "".join(plot(drawn.picture, drawn.caption) for drawn in pictures)
    return f'<div class="plots large">{figures}</div>\n'


def _files(category: str) -> str:
    """Links to the tables of a category."""
    links = " · ".join(
        f'<a href="{TABLES}/{file_stem(category)}-{kind}.csv">{kind} as CSV</a>'
        for kind in (CURVES, SURFACES)
    )
    return f'<p class="files">{links}</p>\n'


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
