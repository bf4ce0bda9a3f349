"""The plan of a room that was learned from, as an SVG picture with its source beneath."""

from __future__ import annotations

from collections.abc import Iterator
from xml.sax.saxutils import escape

from scenegen_core.knowledge.plans import Plan, PlanBox, Segment
from scenegen_core.knowledge.sources import Source

MARGIN = 20  # centimetres about the walls
WALL = 12  # centimetres thick as drawn
CAPTION = 0.04  # of the width of the picture: the height of the letters beneath
LINE = 1.35  # of the height of the letters
LETTER = 0.56  # of their height: how wide letters are, about
FRONT = 0.16  # of the depth: the mark on the side that is the front
THIN = 4  # centimetres that thin things are drawn with at least
FLAT = 5  # centimetres; what is no higher lies under everything: rugs
FRONTLESS = ("Table", "Decor", "Other")
PAPER, FLOOR, WALLS, EDGE = "#fdfbf7", "#f3eadb", "#7d705b", "#9a8c74"
THING, RUG, GLASS, INK = "#ddd0ba", "#e9dfcc", "#6fb1e6", "#5a554c"
ACCENT, ACCENT_EDGE = "#2f6fed", "#1546a8"


def room_plan(plan: Plan, category: str, name: str, source: Source | None) -> str:
    """The picture: y is up, what is of the category stands out, the source is named beneath."""
    xs, ys = zip(*plan.corners, strict=True)
    left, top = min(xs) - MARGIN, -max(ys) - MARGIN
    width, height = max(xs) - left + MARGIN, -min(ys) + MARGIN - top
    credit = list(_lines(credits_of(name, source), width))
    letters = width * CAPTION
    beneath = letters * LINE * (len(credit) + 0.5)
    text = "".join(
        f'<text x="{left + MARGIN}" y="{top + height + letters * LINE * (i + 0.6):.1f}" '
        f'font-size="{letters:.1f}" font-family="system-ui, sans-serif" fill="{INK}">'
        f"{escape(line)}</text>"
        for i, line in enumerate(credit)
    )
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" '
        f'viewBox="{left} {top} {width} {height + beneath:.1f}" role="img">'
        f"<title>{escape(name)}</title>"
        f'<rect x="{left}" y="{top}" width="100%" height="100%" fill="{PAPER}"/>'
        f"{''.join(_drawn(plan, category))}{text}</svg>"
    )


def credits_of(name: str, source: Source | None) -> str:
    """Whose room it is: name, corpus, owner, license."""
    parts = (name,) if source is None else (name, source.name, source.copyright, source.license)
    return " · ".join(parts)


def _lines(text: str, width: float) -> Iterator[str]:
    """The text broken to the width of the picture."""
    fits = max(1, round((width - 2 * MARGIN) / (width * CAPTION * LETTER)))
    line = ""
    for word in text.split(" "):
        if line and len(line) + 1 + len(word) > fits:
            yield line
            line = word
        else:
            line = f"{line} {word}".strip()
    yield line


def _drawn(plan: Plan, category: str) -> Iterator[str]:
    outline = " ".join(f"{x},{-y}" for x, y in plan.corners)
    yield f'<polygon points="{outline}" fill="{FLOOR}"/>'
    for box in sorted(plan.boxes, key=lambda box: (box.category == category, box.top)):
        yield _box(box, chosen=box.category == category)
    yield (
        f'<polygon points="{outline}" fill="none" stroke="{WALLS}" stroke-width="{WALL}" '
        'stroke-linejoin="round"/>'
    )
    for window in plan.windows:
        yield _opening(window, GLASS)
    for door in plan.doors:
        yield _opening(door, PAPER)


def _box(box: PlanBox, *, chosen: bool) -> str:
    depth, width = max(box.depth, THIN), max(box.width, THIN)
    fill, edge = (RUG if box.top <= FLAT else THING), EDGE
    if chosen:
        fill, edge = ACCENT, ACCENT_EDGE
    shape = (
        f'<rect x="{-depth / 2}" y="{-width / 2}" width="{depth}" height="{width}" rx="4" '
        f'fill="{fill}" stroke="{edge}" stroke-width="3"/>'
    )
    mark = depth * FRONT
    front = (
        f'<rect x="{depth / 2 - mark:.1f}" y="{-width * 0.35:.1f}" width="{mark / 2:.1f}" '
        f'height="{width * 0.7:.1f}" fill="{PAPER if chosen else edge}"/>'
    )
    turn = f"translate({box.x} {-box.y}) rotate({-box.heading})"
    return f'<g transform="{turn}">{shape}{"" if box.category in FRONTLESS else front}</g>'


def _opening(segment: Segment, color: str) -> str:
    x, y, end_x, end_y = segment
    return (
        f'<line x1="{x}" y1="{-y}" x2="{end_x}" y2="{-end_y}" stroke="{color}" '
        f'stroke-width="{WALL * 0.7:.1f}"/>'
    )
