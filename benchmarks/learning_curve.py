"""How good the model gets with how many rooms.

    python benchmarks/learning_curve.py judged ROOMS… [--every 4]
    python benchmarks/learning_curve.py new ROOMS… --category Sofa [--every 4]

``judged``: one of four folds by home is asked, and 5, 10, 20 … rooms of the others teach.
``new``: a category is taken out of what ships, as if nobody had thought of it, and is taught again
on top of that with 5, 10, 20 … rooms that have one; other rooms of the same files are asked.
Errors beside those of random possible poses in the same rooms, in brackets 95 % intervals by rooms.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from scenegen_core.datasets.cleaning import clean
from scenegen_core.datasets.formats import read_all
from scenegen_core.evaluation.bootstrap import interval
from scenegen_core.evaluation.cases import Case, cases, folds
from scenegen_core.evaluation.records import Record
from scenegen_core.evaluation.run import ask
from scenegen_core.evaluation.systems import SYSTEMS, System
from scenegen_core.knowledge import Knowledge, default_knowledge, learn
from scenegen_core.knowledge.growing import together
from scenegen_core.placement.choice_learning import gather, with_choices
from scenegen_core.scene.model import PAPER_CATEGORIES, Scene

ROOMS = (5, 10, 20, 50, 100, 200, 500, 1000)
SEED = 1
MEASURES = {"top1": "best pose, m", "spread5": "nearest of five, m", "angle": "angle, rad"}
ASKED = {
    system.name: replace(system, scores={"joint": system.scores["joint"]})
    for system in SYSTEMS
    if system.name in ("scenegen", "paper", "random_open")
}


def main() -> None:
    """Print one table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("kind", choices=("judged", "new"))
    parser.add_argument("rooms", nargs="+", type=Path)
    parser.add_argument("--category", default="Sofa")
    parser.add_argument("--every", type=int, default=4)
    arguments = parser.parse_args()
    scenes, _ = clean(read_all(arguments.rooms))
    print(
        f"| rooms | choices | {' | '.join(f'{n}: {m}' for n in ASKED for m in MEASURES.values())} |"
    )
    print("| ---: " * (2 + len(ASKED) * len(MEASURES)) + "|")
    steps = _judged(scenes) if arguments.kind == "judged" else _new(scenes, arguments.category)
    for rooms, knowledge, asked in steps:
        records = [
            ask(case, knowledge, tuple(ASKED.values()), seed=SEED)
            for case in asked[:: arguments.every]
            if case.box.category in knowledge.choices
        ]
        taught = sum(len(choice.examples) for choice in knowledge.choices.values())
        cells = [
            _cell(records, system, measure) for system in ASKED.values() for measure in MEASURES
        ]
        print(f"| {rooms} | {taught} | {' | '.join(cells)} |", flush=True)


def _judged(scenes: Sequence[Scene]) -> Iterator[tuple[int, Knowledge, tuple[Case, ...]]]:
    rng = np.random.default_rng(SEED)
    asked, *others = folds(scenes, 4, rng=rng)
    pool = [scene for part in others for scene in part]
    pool = [pool[i] for i in rng.permutation(len(pool))]
    names = [group.name for group in PAPER_CATEGORIES]
    for count in [n for n in ROOMS if n < len(pool)] + [len(pool)]:
        some = pool[:count]
        known = with_choices(learn(some, PAPER_CATEGORIES), gather(some, PAPER_CATEGORIES))
        yield count, known, cases(asked, names)


def _new(
    scenes: Sequence[Scene], category: str
) -> Iterator[tuple[int, Knowledge, tuple[Case, ...]]]:
    rng = np.random.default_rng(SEED)
    shipped = default_knowledge()
    before = replace(
        shipped,
        categories={n: part for n, part in shipped.categories.items() if n != category},
        choices={n: choice for n, choice in shipped.choices.items() if n != category},
    )
    have = [s for s in scenes if any(box.category == category for box in s.boxes)]
    have = [have[i] for i in rng.permutation(len(have))]
    asked, pool = have[: len(have) // 4], have[len(have) // 4 :]
    for count in [n for n in ROOMS if n <= len(pool)]:
        some = pool[:count]
        learned = learn(some, shipped.groups)
        chosen = [one for one in gather(some, shipped.groups) if one.category == category]
        only = replace(learned, categories={category: learned.categories[category]})
        known = with_choices(together(before, only), chosen, before=before)
        yield count, known, cases(asked, [category])


def _cell(records: Sequence[Record], system: System, measure: str) -> str:
    rows = [
        (record.room, errors[measure])
        for record in records
        if measure in (errors := record.errors.get(system.name, {}).get("joint", {}))
    ]
    if not rows:
        return "–"
    low, high = interval(rows, rng=np.random.default_rng(SEED))
    return f"{np.mean([value for _, value in rows]):.2f} ({low:.2f} to {high:.2f})"


if __name__ == "__main__":
    main()
