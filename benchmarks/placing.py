"""How fast placements are found: whole maps, single poses, and how time grows.

    python benchmarks/placing.py [--runs 40]

Prints a table; writes ``placing.json`` and ``placing.png`` into benchmarks/results. Every figure is
a median with its quartiles; a reference that never changes is timed between the runs, so that a
busy machine shows (docs/performance.md).
"""

from __future__ import annotations

import argparse
import json
import os
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from time import perf_counter

import literal
import matplotlib as mpl
import matplotlib.pyplot as plt
import numpy as np
import rooms

from scenegen_core.graph.candidates import Candidates
from scenegen_core.graph.situation import Situation
from scenegen_core.graph.surroundings import Surroundings
from scenegen_core.knowledge import Knowledge, default_knowledge
from scenegen_core.knowledge.density import Density
from scenegen_core.placement.answer import MODELS, Model, Query
from scenegen_core.placement.feasible import ALLOWED, Space, verdicts
from scenegen_core.placement.models import model_of
from scenegen_core.placement.proposals import propose
from scenegen_core.placement.solve import draw, solve
from scenegen_core.scene.model import Scene

RESULTS = Path(__file__).parent / "results"
CATEGORIES = ("Chair", "Sofa", "Bed", "TV", "Table", "Storage", "Decor", "Picture")
FEW = 250  # poses, as many as the paper tries
LITERAL = 60  # poses that the literal programs are asked of
BOXES = (1, 12, 25, 50, 100, 200)
CORNERS = (4, 8, 16, 24, 40)
SIDES = (4.0, 6.0, 9.0, 12.0)  # metres of a square room
ROWS = (1, 2, 4, 8)  # times the examples of the shipped knowledge
Step = Callable[[int], object]


@dataclass(frozen=True)
class Timed:
    """Milliseconds of something: quartiles, of how many runs, and of the reference meanwhile."""

    quarter: float
    median: float
    three_quarters: float
    runs: int
    reference: float


def timed(work: Step, runs: int) -> Timed:
    """Time work(0), work(1) … after warming up, the reference in between."""
    found, other = [], []
    for run in range(-3, runs):
        begin = perf_counter()
        work(run)
        middle = perf_counter()
        reference()
        if run >= 0:
            found.append(1000 * (middle - begin))
            other.append(1000 * (perf_counter() - middle))
    low, mid, high = np.percentile(found, (25, 50, 75)).tolist()
    return Timed(low, mid, high, runs, float(np.median(other)))


def reference() -> float:
    """Work that never changes: sines of 100,000 numbers on one core."""
    return float(np.sin(np.arange(100_000.0)).sum())


def few(category: str, model: Model, knowledge: Knowledge) -> tuple[Step, Candidates]:
    """The paper's number of possible poses, scored in a changed scene."""
    around = Surroundings(rooms.living_room(), knowledge.groups)
    learnt = knowledge[category]
    proposed = propose(around, learnt.category, learnt.usual_size).candidates
    possible = verdicts(Situation(proposed, around), Space.of(around)) == ALLOWED
    which = np.random.default_rng(1).choice(np.flatnonzero(possible), FEW, replace=False)
    poses = proposed[np.sort(which)]

    def step(run: int) -> None:
        scene = Surroundings(rooms.changed(rooms.living_room(), run), knowledge.groups)
        situation = Situation(poses, scene)
        verdicts(situation, Space.of(scene))
        model_of(model, knowledge, category).total(situation)

    return step, poses


def maps(runs: int, knowledge: Knowledge) -> Iterator[tuple[str, Timed]]:
    """Whole maps from a changed scene, and answers with their offers and reasons."""
    scene = rooms.living_room()
    for category in CATEGORIES:
        query = Query(category)
        yield (
            f"map, {category}",
            timed(lambda i, q=query: draw(rooms.changed(scene, i), q, knowledge), runs),
        )
    for category in ("Chair", "Sofa"):
        query = Query(category)
        yield (
            f"answer, {category}",
            timed(lambda i, q=query: solve(rooms.changed(scene, i), q, knowledge), runs // 4),
        )
    paper = Query("Sofa", model="paper")
    yield (
        "map, Sofa, paper's model",
        timed(lambda i: draw(rooms.changed(scene, i), paper, knowledge), runs // 4),
    )


def poses(runs: int, knowledge: Knowledge) -> Iterator[tuple[str, Timed]]:
    """The paper's number of poses, and the same by the book."""
    scene = rooms.living_room()
    models: tuple[tuple[Model, literal.Score], ...] = (
        ("scenegen", literal.scenegen(knowledge, "Chair")),
        ("paper", literal.paper(knowledge, "Chair")),
    )
    for model, score in models:
        step, candidates = few("Chair", model, knowledge)
        yield f"{FEW} poses, {model}", timed(step, runs)
        some = literal.boxes(candidates[:: FEW // LITERAL])
        count = len(some)
        yield (
            f"one pose by the book, {model}",
            timed(lambda i, s=score, b=some, n=count: s(b[i % n], scene), count),
        )
        around = Surroundings(scene, knowledge.groups)
        many = propose(around, knowledge["Chair"].category, knowledge["Chair"].usual_size)
        allowed = verdicts(Situation(many.candidates, around), Space.of(around)) == ALLOWED
        all_poses = many.candidates[np.flatnonzero(allowed)]
        scorer = model_of(model, knowledge, "Chair")
        yield (
            f"{len(all_poses)} poses scored, {model}",
            timed(lambda _, c=all_poses, s=scorer, a=around: s.total(Situation(c, a)), runs // 4),
        )


def growth(runs: int, knowledge: Knowledge) -> Iterator[tuple[str, float, Timed]]:
    """Time against poses, boxes, walls and training rows: (what grows, how many, time)."""
    query, learnt = Query("Chair"), knowledge["Chair"]

    def map_of(scene: Scene) -> Timed:
        return timed(lambda i: draw(rooms.changed(scene, i), query, knowledge), runs)

    for side in SIDES:
        scene = rooms.hall(side, 12)
        around = Surroundings(scene, knowledge.groups)
        poses = propose(around, learnt.category, learnt.usual_size).candidates
        yield "poses", len(poses), map_of(scene)
    for count in BOXES:
        yield "boxes", count, map_of(rooms.hall(12.0, count))
    for corners in CORNERS:
        yield "walls", corners, map_of(rooms.hall(6.0, 12, corners=corners))
    yield "boxes and 40 walls", 200, map_of(rooms.hall(12.0, 200, corners=40))
    for examples, one in training_rows(runs, knowledge):
        yield "training rows", examples, one


def training_rows(runs: int, knowledge: Knowledge) -> Iterator[tuple[float, Timed]]:
    """The paper's density under more and more examples; ``scenegen`` reads tables only."""
    density = knowledge["Chair"].position().density
    queries = np.repeat(density.rows, 4, axis=0)[:1000]
    kinds = ["ordered" if ordered else "continuous" for ordered in density.ordered]
    for times in ROWS:
        rows = np.tile(density.rows, (times, 1))
        fixed = {i: float(width) for i, width in enumerate(density.bandwidths)}
        more = replace(Density.fit(rows, kinds, fixed=fixed), can_be_absent=density.can_be_absent)
        yield len(rows), timed(lambda _, d=more: d.log_density(queries), runs)


def plot(grown: list[tuple[str, float, Timed]], path: Path) -> None:
    """A panel for each thing that grows."""
    names = ("poses", "boxes", "walls", "training rows")
    figure, axes = plt.subplots(1, len(names), figsize=(4 * len(names), 3.4), layout="tight")
    for axis, name in zip(axes, names, strict=True):
        rows = [(count, one) for what, count, one in grown if what == name]
        x = [count for count, _ in rows]
        axis.plot(x, [one.median for _, one in rows], "o-", color="#0072b2")
        low, high = [one.quarter for _, one in rows], [one.three_quarters for _, one in rows]
        axis.fill_between(x, low, high, alpha=0.25, color="#0072b2", linewidth=0)
        axis.set(xlabel=name, ylim=(0, None), xlim=(0, None))
    axes[0].set_ylabel("milliseconds")
    figure.savefig(path, dpi=120)


def told(rows: Iterator[tuple[str, Timed]]) -> dict[str, Timed]:
    """Print each row as soon as it is there."""
    found = {}
    for name, one in rows:
        spread = f"{one.quarter:.1f} to {one.three_quarters:.1f}"
        ratio = one.median / one.reference
        print(f"| {name} | {one.median:.1f} | {spread} | {ratio:.1f} |", flush=True)
        found[name] = one
    return found


def main() -> None:
    """Measure all, print a table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, default=40)
    runs = parser.parse_args().runs
    mpl.use("agg")
    knowledge = default_knowledge()
    before = os.getloadavg()[0]
    print("| measured | median ms | quartiles | of reference |\n| --- | ---: | ---: | ---: |")
    rows = told(maps(runs, knowledge)) | told(poses(runs, knowledge))
    grown = []
    for name, count, one in growth(max(5, runs // 4), knowledge):
        rows |= told(iter([(f"{count:g} {name}", one)]))
        grown.append((name, count, one))
    for model in MODELS:
        name = next(n for n in rows if n.endswith(f"poses scored, {model}"))
        each = rows[name].median / int(name.split()[0])
        ratio = rows[f"one pose by the book, {model}"].median / each
        print(f"\n{model}: {1000 * each:.2f} µs a pose, {ratio:.0f} times faster than by the book.")
    print(f"\nLoad {before:.1f} before, {os.getloadavg()[0]:.1f} after; {os.cpu_count()} cores.")
    RESULTS.mkdir(exist_ok=True)
    (RESULTS / "placing.json").write_text(
        json.dumps({"load": before, "rows": {n: vars(one) for n, one in rows.items()}}, indent=1)
        + "\n"
    )
    plot(grown, RESULTS / "placing.png")


if __name__ == "__main__":
    main()
