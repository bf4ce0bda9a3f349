"""How much the constants that the paper gives no number for matter: cross-validated errors.

    python benchmarks/constants.py ROOMS… [--every 4] > benchmarks/results/constants.md

Learns and judges the paper's model in four folds by home, once for each value of ϱ (NEAR_WALL),
ε (NEARBY) and φ (SAME_DIRECTION), the others as they ship, and prints a table. ``--every`` takes
only every n-th case, the same ones for all values.
"""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np

from scenegen_core.datasets.cleaning import clean
from scenegen_core.datasets.formats import read_all
from scenegen_core.evaluation.bench import Bench
from scenegen_core.evaluation.bootstrap import interval
from scenegen_core.evaluation.cases import Case
from scenegen_core.evaluation.jobs import cross_validated
from scenegen_core.evaluation.measure import answer, errors
from scenegen_core.evaluation.systems import PAPER, System
from scenegen_core.graph import relations
from scenegen_core.scene.model import PAPER_CATEGORIES, Scene, Symmetry

VALUES: dict[str, tuple[float, ...]] = {
    "NEAR_WALL": (0.5, 0.75, 1.0, 1.5),
    "NEARBY": (0.5, 1.0, 1.5, 2.0),
    "SAME_DIRECTION": (np.pi / 24, np.pi / 12, np.pi / 6),
}
SEED = 1


def judged(scenes: tuple[Scene, ...], every: int) -> dict[str, list[tuple[str, float]]]:
    """(room, error) of each case: position top-1 in metres, orientation in radians."""
    found: dict[str, list[tuple[str, float]]] = {"position": [], "orientation": []}
    system = System("paper", {task: PAPER.scores[task] for task in ("position", "orientation")})
    for job in cross_validated(scenes, PAPER_CATEGORIES, 4, seed=SEED, choices=False):
        rng = np.random.default_rng(SEED)
        for case in job.cases[::every]:
            bench = Bench(case, job.knowledge.groups)
            one = errors(answer(system, "position", bench, job.knowledge, rng))
            found["position"].append((case.scene.id, one["top1"]))
            if _faces(case, bench):
                other = errors(answer(system, "orientation", bench, job.knowledge, rng))
                found["orientation"].append((case.scene.id, other["angle"]))
    return found


def _faces(case: Case, bench: Bench) -> bool:
    known = case.box.front_known and not case.box.front_from_wall
    return known and bench.category.symmetry is Symmetry.ASYMMETRIC


def main() -> None:
    """Judge every value, print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("rooms", nargs="+", type=Path)
    parser.add_argument("--every", type=int, default=4)
    arguments = parser.parse_args()
    scenes, _ = clean(read_all(arguments.rooms))
    print("| constant | value | position, top 1 m | orientation rad |\n| --- | --- | --- | --- |")
    for name, values in VALUES.items():
        shipped = getattr(relations, name)
        for value in values:
            setattr(relations, name, value)
            cells = [_cell(rows) for rows in judged(scenes, arguments.every).values()]
            mark = " (ships)" if value == shipped else ""
            print(f"| {name} | {value:.2f}{mark} | {' | '.join(cells)} |", flush=True)
        setattr(relations, name, shipped)


def _cell(rows: list[tuple[str, float]]) -> str:
    mean = np.mean([value for _, value in rows])
    low, high = interval(rows, rng=np.random.default_rng(SEED))
    return f"{mean:.2f} ({low:.2f} to {high:.2f}; n = {len(rows)})"


if __name__ == "__main__":
    main()
