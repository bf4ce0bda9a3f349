"""The report of an evaluation: a page, its tables as files, its plots, and a page for docs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import msgspec

from scenegen_core.evaluation.calibration_tables import draw_reliability
from scenegen_core.evaluation.curves import PLOTS, draw
from scenegen_core.evaluation.exports import as_csv, as_json, as_latex, as_markdown, provenance
from scenegen_core.evaluation.names import MEASURES, TASKS
from scenegen_core.evaluation.page import (
    contents,
    document,
    listed,
    paragraph,
    plot,
    section,
    table_html,
)
from scenegen_core.evaluation.parts import Part, parts_of
from scenegen_core.evaluation.records import Record, Settings
from scenegen_core.evaluation.report_tables import Judged
from scenegen_core.evaluation.report_words import headline
from scenegen_core.evaluation.tables import Table

TITLE = "How good is it?"
THE_PAPER = "Keshavarzi et al. 2020, tables 1 and 2, Matterport3D"


def write_report(
    out: Path, settings: Settings, records: Sequence[Record], results: Mapping[str, Any]
) -> None:
    """Write index.html, results.json, results.md, tables/ and plots/ into ``out``.

    OSError if that cannot be written.
    """
    judged = Judged(settings, records, results)
    plots = {curves.id: found for curves in PLOTS if (found := draw(curves, records))}
    if drawn := draw_reliability(judged):
        plots["reliability"] = drawn
    parts = parts_of(judged, plots)
    for folder in ("tables", "plots"):
        (out / folder).mkdir(parents=True, exist_ok=True)
    for part in parts:
        for row in part.tables:
            for table in row:
                _write_table(out / "tables", table, settings)
    for name, picture in plots.items():
        (out / "plots" / f"{name}.svg").write_text(picture, encoding="utf-8")
    everything = {"settings": msgspec.to_builtins(settings), **results}
    (out / "results.json").write_bytes(msgspec.json.format(msgspec.json.encode(everything)))
    (out / "results.md").write_text(_markdown(judged, parts), encoding="utf-8")
    (out / "index.html").write_text(_page(judged, parts, plots), encoding="utf-8")


def _write_table(folder: Path, table: Table, settings: Settings) -> None:
    """The paper's numbers and ours never share a file: each says whose it holds."""
    origin = THE_PAPER if table.id.startswith("published") else provenance(settings)
    for end, written in (
        ("json", as_json(table, origin)),
        ("csv", as_csv(table)),
        ("tex", as_latex(table, origin)),
    ):
        (folder / f"{table.id}.{end}").write_text(written, encoding="utf-8")


def _page(judged: Judged, parts: list[Part], plots: Mapping[str, str]) -> str:
    captions = {
        curves.id: f"{MEASURES[curves.measure]}, {TASKS[curves.task]}: share of objects by error"
        for curves in PLOTS
    } | {"reliability": "Reliability: share of places that hold the truth by what they are called"}
    body = [
        "<header>",
        f"<h1>{TITLE}</h1>\n",
        *(paragraph(sentence, "headline") for sentence in headline(judged)),
        paragraph(f"Made from {provenance(judged.settings)}.", "note"),
        contents([(part.id, part.title) for part in parts]),
        "</header>\n",
    ]
    for part in parts:
        words = paragraph(part.words) if part.words else ""
        words += listed(part.notes) if part.notes else ""
        rows = [
            f'<div class="beside">{"".join(map(table_html, row))}</div>\n' for row in part.tables
        ]
        drawn = "".join(plot(plots[name], captions[name]) for name in part.plots)
        figures = f'<div class="plots">{drawn}</div>\n' if drawn else ""
        body.append(section(part.id, part.title, words, *rows, figures))
    return document(f"{TITLE} SceneGen", "".join(body))


def _markdown(judged: Judged, parts: list[Part]) -> str:
    """Our tables for docs/results.md; the paper's are in published.py."""
    lines = [
        "# Results\n",
        f"Made by `scenegen evaluate` from {provenance(judged.settings)}. Do not edit: the command",
        "writes this page as `results.md` into the folder of its report. In brackets: 95 %",
        "intervals by rooms. The paper's numbers are in `scenegen_core/evaluation/published.py`.\n",
        *headline(judged),
    ]
    for part in parts:
        ours = [table for row in part.tables for table in row if table.id[:9] != "published"]
        if not ours:
            continue
        lines += ["", f"## {part.title}"]
        lines += ["", part.words] if part.words else []
        lines += ["", *(f"- {note}" for note in part.notes)] if part.notes else []
        for table in ours:
            lines += ["", f"**{table.title}**", "", as_markdown(table).rstrip()]
            lines += ["", table.note] if table.note else []
    return "\n".join(lines) + "\n"
