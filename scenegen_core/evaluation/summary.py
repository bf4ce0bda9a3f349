"""Summaries: means by task and category with bootstrap intervals by room."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from scenegen_core.evaluation.bench import FORMS, Task
from scenegen_core.evaluation.bootstrap import interval
from scenegen_core.evaluation.calibration import calibration
from scenegen_core.evaluation.physical import DECLINED, PHYSICAL
from scenegen_core.evaluation.records import Record

MEASURES = ("top1", "top5", "spread5", "angle")
"""Metres, metres, metres, radians."""

Means = dict[str, Any]
"""{"n", measure: mean, "ci": {measure: [low, high]}}."""


def summarize(records: Sequence[Record], *, rng: np.random.Generator) -> dict[str, Any]:
    """The published form: rooms, queries, and a table a model."""
    names = names_of(records)
    return {
        "rooms": len({record.room for record in records}),
        "queries": len(records),
        "models": {name: _model(records, name, rng) for name in names},
    }


def names_of(records: Sequence[Record]) -> tuple[str, ...]:
    """The systems that were asked, in their order."""
    return tuple(dict.fromkeys(name for record in records for name in record.errors))


def _model(records: Sequence[Record], name: str, rng: np.random.Generator) -> dict[str, Any]:
    asked = {task for record in records for task in record.errors.get(name, {})}
    tables: dict[str, Any] = {
        task: _table(records, name, task, rng) for task in FORMS if task in asked
    }
    facts = [e["joint"] for r in records if "joint" in (e := r.errors.get(name, {}))]
    if facts:
        tables["physical"] = {
            fact: float(np.mean([errors[fact] for errors in facts])) for fact in PHYSICAL
        }
        tables[DECLINED] = float(np.mean([errors[DECLINED] for errors in facts]))
    said = [record for record in records if name in record.chances]
    if said:
        categories = sorted({record.category for record in said})
        tables["calibration"] = {
            "overall": calibration(said, name, rng=rng),
            **{c: calibration([r for r in said if r.category == c], name, rng=rng)
               for c in categories},
        }  # fmt: skip
    return tables


def _table(
    records: Sequence[Record], name: str, task: Task, rng: np.random.Generator
) -> dict[str, Means]:
    rows = [(r.room, r.category, e[task]) for r in records if task in (e := r.errors.get(name, {}))]
    categories = sorted({category for _, category, _ in rows})
    return {
        "overall": means([(room, errors) for room, _, errors in rows], rng=rng),
        **{
            category: means([(room, e) for room, c, e in rows if c == category], rng=rng)
            for category in categories
        },
    }


def means(rows: Iterable[tuple[str, dict[str, float]]], *, rng: np.random.Generator) -> Means:
    """The mean of each measure over (room, errors) rows, with its interval by rooms."""
    kept = list(rows)
    found: Means = {"n": len(kept)}
    intervals = {}
    for measure in MEASURES:
        values = [(room, errors[measure]) for room, errors in kept if measure in errors]
        if values:
            found[measure] = float(np.mean([value for _, value in values]))
            intervals[measure] = list(interval(values, rng=rng))
    found["ci"] = intervals
    return found


def both(
    records: Sequence[Record], one: str, other: str, task: Task, measure: str
) -> list[tuple[str, tuple[float, float]]]:
    """(room, (error of one, error of other)) of the cases that both answer."""
    return [
        (record.room, (a[measure], b[measure]))
        for record in records
        if measure in (a := record.errors.get(one, {}).get(task, {}))
        and measure in (b := record.errors.get(other, {}).get(task, {}))
    ]


def paired(
    records: Sequence[Record], one: str, other: str, task: Task, *, rng: np.random.Generator
) -> dict[str, tuple[float, float, float]]:
    """Mean difference one − other of each measure, with its interval, over cases both answer."""
    found = {}
    for measure in MEASURES:
        pairs = both(records, one, other, task, measure)
        values = [(room, a - b) for room, (a, b) in pairs]
        if values:
            mean = float(np.mean([value for _, value in values]))
            found[measure] = (mean, *interval(values, rng=rng))
    return found
