"""Summaries: means by task and category with bootstrap intervals by room."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from scenegen_core.evaluation.bench import Task
from scenegen_core.evaluation.physical import PHYSICAL
from scenegen_core.evaluation.records import Record
from scenegen_core.scene.geometry import Floats

MEASURES = ("top1", "top5", "spread5", "angle")
"""Metres, metres, metres, radians."""
RESAMPLES = 1000
LEVEL = 0.95

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
    tasks = dict.fromkeys(task for record in records for task in record.errors.get(name, {}))
    tables: dict[str, Any] = {task: _table(records, name, task, rng) for task in tasks}
    facts = [e["joint"] for r in records if "joint" in (e := r.errors.get(name, {}))]
    if facts:
        tables["physical"] = {
            fact: float(np.mean([errors[fact] for errors in facts])) for fact in PHYSICAL
        }
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


def interval(
    values: Sequence[tuple[str, float]], *, rng: np.random.Generator
) -> tuple[float, float]:
    """The 95 % bootstrap interval of a mean, rooms drawn with replacement.

    Queries of one room hang together, so rooms are drawn, not queries.
    """
    sums, counts = _drawn([(room, (value,)) for room, value in values], rng)
    return _middle(sums[:, 0] / counts)


def relative(
    values: Sequence[tuple[str, tuple[float, float]]], *, rng: np.random.Generator
) -> tuple[float, float, float]:
    """mean(one) / mean(other) − 1 of (room, (one, other)) pairs, with its interval by rooms."""
    one, other = np.array([pair for _, pair in values]).mean(axis=0)
    totals, _ = _drawn(values, rng)
    safe = totals[totals[:, 1] > 0]
    return float(one / other - 1), *_middle(safe[:, 0] / safe[:, 1] - 1)


def _drawn(
    values: Sequence[tuple[str, tuple[float, ...]]], rng: np.random.Generator
) -> tuple[Floats, Floats]:
    """Rooms drawn with replacement: sums (draws, values), and how many values (draws,)."""
    rooms, index = np.unique([room for room, _ in values], return_inverse=True)
    numbers = np.array([number for _, number in values])
    sums = np.zeros((len(rooms), numbers.shape[1]))
    np.add.at(sums, index, numbers)
    drawn = rng.integers(len(rooms), size=(RESAMPLES, len(rooms)))
    counts = np.bincount(index).astype(float)
    return sums[drawn].sum(axis=1), counts[drawn].sum(axis=1)


def _middle(resampled: Floats) -> tuple[float, float]:
    low, high = np.quantile(resampled, ((1 - LEVEL) / 2, (1 + LEVEL) / 2))
    return float(low), float(high)


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
