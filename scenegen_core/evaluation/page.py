"""HTML of reports: one page that needs no other file, for phones and desks, light and dark."""

from __future__ import annotations

from collections.abc import Iterable
from html import escape

from scenegen_core.evaluation.exports import spans
from scenegen_core.evaluation.tables import Cell, Column, Row, Table, interval_text, text

CSS = """
:root { color-scheme: light dark; --ink: #1d1d1f; --soft: #5d5f66; --line: #d9dadf;
  --paper: #fff; --band: #f4f5f8; --link: #0a58ca; }
@media (prefers-color-scheme: dark) { :root { --ink: #ececf1; --soft: #a5a7b0; --line: #3a3c44;
  --paper: #17181c; --band: #202228; --link: #8ab4f8; } }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 1.5rem clamp(1rem, 4vw, 3rem) 4rem; max-width: 84rem;
  background: var(--paper); color: var(--ink); font: 1rem/1.5 system-ui, sans-serif; }
h1 { font-size: 1.75rem; line-height: 1.2; margin: 0 0 .5rem; }
h2 { font-size: 1.3rem; margin: 2.5rem 0 .5rem; padding-top: .75rem;
  border-top: 1px solid var(--line); }
h3 { font-size: 1rem; margin: 1.5rem 0 .25rem; }
p, ul { max-width: 46rem; margin: .5rem 0; }
a { color: var(--link); }
nav ul { display: flex; flex-wrap: wrap; gap: .25rem 1rem; padding: 0; list-style: none; }
.note, .files { color: var(--soft); font-size: .85rem; }
.headline { font-size: 1.15rem; }
.scroll { overflow-x: auto; max-width: 100%; }
table { border-collapse: collapse; font-size: .875rem; font-variant-numeric: tabular-nums; }
th, td { padding: .3rem .4rem; text-align: right; white-space: nowrap; vertical-align: top; }
thead th { color: var(--soft); font-weight: 600; vertical-align: bottom;
  white-space: normal; border-bottom: 1px solid var(--line); }
thead th:not([scope=row], .group) { max-width: 7.5rem; }
thead th.group { text-align: center; }
th[scope=row] { position: sticky; left: 0; background: var(--paper); text-align: left;
  font-weight: 500; white-space: normal; min-width: 6.5rem; max-width: 14rem; }
tbody tr + tr > * { border-top: 1px solid var(--line); }
tbody tr.overall > * { background: var(--band); }
.first { border-left: 1px solid var(--line); }
td small { display: block; color: var(--soft); font-size: .7rem; font-weight: 400; }
td.best { font-weight: 700; }
.beside { display: flex; flex-wrap: wrap; gap: 0 2.5rem; }
.beside > * { max-width: 100%; min-width: 0; }
.plots { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 22rem), 1fr));
  gap: 1rem; }
.plots figure { margin: 0; background: #fff; border: 1px solid var(--line); border-radius: .5rem;
  padding: .5rem; }
.plots svg { display: block; width: 100%; height: auto; }
.large { grid-template-columns: repeat(auto-fill, minmax(min(100%, 34rem), 1fr)); }
.wide { display: block; max-width: 46rem; }
.wide + details { margin-top: .5rem; }
"""


def document(title: str, body: str) -> str:
    """A whole page."""
    return (
        '<!doctype html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>{escape(title)}</title>\n<style>{CSS}</style>\n</head>\n"
        f"<body>\n{body}\n</body>\n</html>\n"
    )


def section(section_id: str, title: str, *parts: str) -> str:
    """A part of the page with its heading."""
    return f'<section id="{section_id}">\n<h2>{escape(title)}</h2>\n{"".join(parts)}</section>\n'


def paragraph(words: str, kind: str = "") -> str:
    """A paragraph of plain words."""
    return f'<p class="{kind}">{escape(words)}</p>\n' if kind else f"<p>{escape(words)}</p>\n"


def listed(sentences: Iterable[str]) -> str:
    """Sentences as a list."""
    return "<ul>" + "".join(f"<li>{escape(one)}</li>" for one in sentences) + "</ul>\n"


def contents(sections: list[tuple[str, str]]) -> str:
    """Links to the sections."""
    links = "".join(f'<li><a href="#{i}">{escape(title)}</a></li>' for i, title in sections)
    return f'<nav aria-label="Contents"><ul>{links}</ul></nav>\n'


def plot(drawn: str, caption: str) -> str:
    """An SVG with what it shows, for those who cannot see it."""
    shown = drawn.replace("<svg", f'<svg role="img" aria-label="{escape(caption)}"', 1)
    return f"<figure>{shown}</figure>\n"


def table_html(table: Table) -> str:
    """A table that scrolls sideways where it is too wide, its files below."""
    note = paragraph(table.note, "note") if table.note else ""
    files = " · ".join(
        f'<a href="tables/{table.id}.{end}">{end.upper() if end != "tex" else "LaTeX"}</a>'
        for end in ("json", "csv", "tex")
    )
    rows = "".join(_row(table, row) for row in table.rows)
    return (
        f"<div><h3>{escape(table.title)}</h3>\n"
        f'<div class="scroll" tabindex="0" role="region" aria-label="{escape(table.title)}">'
        f"<table><thead>{_head(table)}</thead><tbody>{rows}</tbody></table></div>\n"
        f'{note}<p class="files">{files}</p></div>\n'
    )


def _head(table: Table) -> str:
    names = "".join(
        f'<th scope="col"{_first(table.columns, i)}>{escape(column.name)}</th>'
        for i, column in enumerate(table.columns)
    )
    head = f'<th scope="row">{escape(table.head)}</th>'
    if not any(column.group for column in table.columns):
        return f"<tr>{head}{names}</tr>"
    groups = "".join(
        f'<th scope="colgroup" class="group first" colspan="{span}">{escape(name)}</th>'
        for name, span in spans(table.columns)
    )
    return f'<tr><th scope="row"></th>{groups}</tr><tr>{head}{names}</tr>'


def _row(table: Table, row: Row) -> str:
    kind = ' class="overall"' if row.name in {"overall", "all"} else ""
    cells = "".join(
        _cell(one, column, _first(table.columns, i, best=one.best))
        for i, (one, column) in enumerate(zip(row.cells, table.columns, strict=True))
    )
    return f'<tr{kind}><th scope="row">{escape(row.name)}</th>{cells}</tr>\n'


def _cell(one: Cell, column: Column, kind: str) -> str:
    within = interval_text(one, column.unit)
    small = f'<small title="95 % interval">{within}</small>' if within else ""
    return f"<td{kind}>{text(one, column.unit) or '–'}{small}</td>"


def _first(columns: tuple[Column, ...], index: int, *, best: bool = False) -> str:
    """The class of a cell: the first of its group has a line before it."""
    group = columns[index].group
    first = bool(group) and (index == 0 or columns[index - 1].group != group)
    kinds = " ".join(["first"] * first + ["best"] * best)
    return f' class="{kinds}"' if kinds else ""
