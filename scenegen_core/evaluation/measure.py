"""What one system's answer to one case is worth, in metres, radians and hard facts."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from scenegen_core.evaluation.bench import FORMS, Bench, Table, Task, spread
from scenegen_core.evaluation.physical import DECLINED, PHYSICAL, physical
from scenegen_core.evaluation.systems import System
from scenegen_core.knowledge.knowledge import Knowledge
from scenegen_core.placement.alternatives import APART, TIE, choose
from scenegen_core.scene.geometry import Floats, Ints, wrapped
from scenegen_core.scene.model import Symmetry

OFFERED = 5

Errors = dict[str, float]
"""Measure -> error: top1, top5, spread5 (metres), angle (radians), or the physical facts (0, 1)."""


@dataclass(frozen=True, slots=True)
class Picks:
    """The poses that an answer is judged by, as indices of its table."""

    best: int
    five: Ints
    spread: Ints
    offered: bool
    """Would the program offer the best? Where it offers none, distances are to its best guess."""


@dataclass(frozen=True, slots=True, eq=False)
class Answer:
    """What a system says in a task of a case."""

    task: Task
    bench: Bench
    table: Table
    scores: Floats
    """Of all n poses of the table, −∞ for those that were not scored: (n,)."""
    picks: Picks


def answer(
    system: System, task: Task, bench: Bench, knowledge: Knowledge, rng: np.random.Generator
) -> Answer:
    """Ask a system."""
    form = FORMS[task]
    table = bench.table(form)
    scores = np.full(len(table.candidates), -np.inf)
    if system.feasible:
        found = system.scores[form](bench, table, knowledge, rng)
        scores[table.scored] = found + TIE * rng.random(len(found))
    else:
        scores = rng.random(len(table.candidates))
    picks = _picks(system, bench, table, scores, rng, as_offered=form == "joint" or system.expects)
    return Answer(task, bench, table, scores, picks)


def errors(found: Answer) -> Errors:
    """How far an answer is from the truth; in the joint task also the facts that it breaks."""
    bench, table, picks, form = found.bench, found.table, found.picks, FORMS[found.task]
    facts: Errors = {}
    truth = bench.case.box
    away = np.hypot(*(table.candidates.centers[:, :2] - np.array(truth.center[:2])).T)
    if form != "orientation":
        facts["top1"] = float(away[picks.best])
        facts["top5"] = float(away[picks.five].min())
        facts["spread5"] = float(away[picks.spread].min())
    if form != "position" and has_front(bench):
        facts["angle"] = float(abs(wrapped(table.candidates.headings[picks.best] - truth.heading)))
    if found.task == "joint":
        facts[DECLINED] = float(not picks.offered)
        if picks.offered:
            facts |= physical(bench, table.candidates.box(picks.best, "new"))
        else:
            facts |= dict.fromkeys(PHYSICAL, 0.0)
    return facts


def _picks(
    system: System,
    bench: Bench,
    table: Table,
    scores: Floats,
    rng: np.random.Generator,
    *,
    as_offered: bool,
) -> Picks:
    """Best, best five, and five that differ; of proposals as the program would offer them."""
    order = np.argsort(-scores, kind="stable")
    _, first = np.unique(table.cells[order], return_index=True)
    five = order[np.sort(first)[:OFFERED]]
    differing = np.empty(0, dtype=np.int64)
    if as_offered and system.feasible and table.proposals and table.possible.any():
        differing = choose(
            table.proposals,
            scores,
            bench.walking,
            count=OFFERED,
            rng=rng,
            keep_going=lambda: None,
            expects=system.expects,
        ).poses
    offered = len(differing) > 0 or not system.feasible
    if not len(differing):
        differing = spread(table, scores, OFFERED, APART)
    return Picks(int(differing[0]), five, differing, offered)


def has_front(bench: Bench) -> bool:
    """Is the true heading evidence about orientation?"""
    box = bench.case.box
    asymmetric = bench.category.symmetry is Symmetry.ASYMMETRIC
    return asymmetric and box.front_known and not box.front_from_wall
