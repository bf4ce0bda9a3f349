"""How far the map of a chair is from what this machine could do at best, step by step.

    python benchmarks/limits.py [--runs 20]

Each step runs on one core, in the blocks that it ships with. Its limit is the longer of two times:
its arithmetic (additions, multiplications, comparisons, counted in the loops by hand) at the rate
of a loop that does nothing but multiply and add, and the bytes that it has to read and write at the
rate at which large arrays are copied.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from time import perf_counter

import numpy as np
import rooms
from numba import njit

from scenegen_core.graph.candidates import Candidates
from scenegen_core.graph.own_relations import OWN_RELATIONS
from scenegen_core.graph.relations import measure
from scenegen_core.graph.situation import Situation
from scenegen_core.graph.surroundings import Surroundings
from scenegen_core.knowledge import default_knowledge
from scenegen_core.placement.answer import Query
from scenegen_core.placement.blocks import AT_ONCE, block_size
from scenegen_core.placement.feasible import ALLOWED, Space, verdicts
from scenegen_core.placement.heat_map import heat_maps, scale
from scenegen_core.placement.proposals import propose
from scenegen_core.placement.solve import draw
from scenegen_core.scene.compiled import all_gaps
from scenegen_core.scene.geometry import Floats

GAP = 185  # operations of one signed gap: scene/compiled.py, both parts and the choice
SEPARATION = 43  # of the separation alone
BOX = 95  # of a box that is looked at: two rays, and whether it is near (graph/scan_boxes.py)
GROUP = 75  # of the nearest member of a group, in its frame
WALL = 60  # of a wall: four rays and a gap (graph/scan_walls.py)
CUT = 5  # of a value that is put in its bin
NUMBER = 8  # bytes


@dataclass(frozen=True)
class Step:
    """A step of the map: what to run, and the least that it has to do."""

    name: str
    work: Callable[[], object]
    operations: float
    bytes: float


@njit(nogil=True)
def multiply_and_add(values: Floats, times: int) -> None:
    """32 multiplications and 32 additions a value and time, four chains side by side."""
    for _ in range(times):
        for i in range(len(values)):
            a = values[i]
            b, c, d = a + 1.0, a + 2.0, a + 3.0
            a, b, c, d = a * 0.5 + 0.1, b * 0.5 + 0.1, c * 0.5 + 0.1, d * 0.5 + 0.1
            a, b, c, d = a * 0.5 + 0.2, b * 0.5 + 0.2, c * 0.5 + 0.2, d * 0.5 + 0.2
            a, b, c, d = a * 0.5 + 0.3, b * 0.5 + 0.3, c * 0.5 + 0.3, d * 0.5 + 0.3
            a, b, c, d = a * 0.5 + 0.4, b * 0.5 + 0.4, c * 0.5 + 0.4, d * 0.5 + 0.4
            a, b, c, d = a * 0.5 + 0.5, b * 0.5 + 0.5, c * 0.5 + 0.5, d * 0.5 + 0.5
            a, b, c, d = a * 0.5 + 0.6, b * 0.5 + 0.6, c * 0.5 + 0.6, d * 0.5 + 0.6
            a, b, c, d = a * 0.5 + 0.7, b * 0.5 + 0.7, c * 0.5 + 0.7, d * 0.5 + 0.7
            a, b, c, d = a * 0.5 + 0.8, b * 0.5 + 0.8, c * 0.5 + 0.8, d * 0.5 + 0.8
            values[i] = a + b + c + d


def seconds(work: Callable[[], object], runs: int) -> float:
    """The median time of a run, after two to warm up."""
    found = []
    for run in range(-2, runs):
        begin = perf_counter()
        work()
        if run >= 0:
            found.append(perf_counter() - begin)
    return float(np.median(found))


def arithmetic(runs: int) -> float:
    """Operations a second of one core."""
    values = np.ones(1024)
    return 64 * len(values) * 1000 / seconds(lambda: multiply_and_add(values, 1000), runs)


def copying(megabytes: float, runs: int) -> float:
    """Bytes a second that one core reads and writes."""
    one = np.ones(int(megabytes * 1e6 / NUMBER))
    other = np.empty_like(one)
    return 2 * one.nbytes / seconds(lambda: np.copyto(other, one), runs)


def steps() -> Iterator[Step]:
    """The steps of the map of a chair in the room of the targets, in their order."""
    scene, knowledge = rooms.living_room(), default_knowledge()
    learnt, choice = knowledge["Chair"], knowledge.choice("Chair")
    around = Surroundings(scene, knowledge.groups)
    space = Space.of(around)
    proposals = propose(around, learnt.category, learnt.usual_size)
    everything = Situation(proposals.candidates, around)
    allowed = verdicts(everything, space) == ALLOWED
    possible = np.flatnonzero(allowed)
    chosen = proposals.candidates[possible]
    some = list(blocks(chosen, around, AT_ONCE))
    features = [measure(OWN_RELATIONS, one) for one in some]
    scores = np.full(len(allowed), -np.inf)
    scores[possible] = np.concatenate([choice.score(one) for one in features])
    tried, left, columns = len(allowed), len(possible), len(choice.columns)
    boxes, walls, groups = len(scene.boxes), len(scene.room.corners), len(knowledge.groups)
    terms = columns + len(choice.pairs)

    def tell() -> None:
        changed = Surroundings(scene, knowledge.groups)
        propose(changed, learnt.category, learnt.usual_size)

    def rule() -> None:
        for one in blocks(proposals.candidates, around, 4 * AT_ONCE):
            verdicts(one, space)

    def look() -> None:
        for one in blocks(chosen, around, AT_ONCE):
            measure(OWN_RELATIONS, one)

    yield Step("proposals", tell, 0, tried * 4 * NUMBER)
    yield Step("rules", rule, tried * (boxes + 2) * SEPARATION, tried * 6 * NUMBER)
    each = boxes * (GAP + BOX) + groups * GROUP + walls * WALL
    yield Step("columns", look, left * each, left * columns * NUMBER)
    yield Step(
        "tables",
        lambda: [choice.score(one) for one in features],
        left * (columns * CUT + terms),
        left * columns * (NUMBER + 1),
    )
    yield Step(
        "raster",
        lambda: heat_maps(proposals, scores, scale(scores[possible])),
        tried,
        tried * 2 * NUMBER,
    )


def blocks(poses: Candidates, around: Surroundings, at_once: int) -> Iterator[Situation]:
    """The blocks that a map works on with two threads."""
    size = block_size(len(poses), 2, at_once)
    return (Situation(poses[i : i + size], around) for i in range(0, len(poses), size))


def gaps_alone(runs: int) -> float:
    """Seconds of one signed gap where nothing else is done."""
    rng = np.random.default_rng(1)
    poses, others = rng.random((6, AT_ONCE)), rng.random((12, 6))
    out = np.empty((len(others), AT_ONCE))
    return seconds(lambda: all_gaps(poses, others, out), 10 * runs) / out.size


def main() -> None:
    """Measure; print a table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, default=20)
    runs = parser.parse_args().runs
    peak, memory = arithmetic(runs), copying(256, runs)
    print("| one core | |\n| --- | ---: |")
    print(f"| arithmetic | {peak / 1e9:.1f} thousand million operations a second |")
    print(f"| copying 256 MB | {memory / 1e9:.1f} GB a second, read and written |")
    print(f"| copying 0.2 MB | {copying(0.2, 50 * runs) / 1e9:.1f} GB a second |")
    gap = gaps_alone(runs)
    print(f"| a signed gap | {gap * 1e9:.1f} ns, {GAP / gap / peak:.0%} of the arithmetic |\n")
    print("| step | ms | arithmetic alone, ms | memory alone, ms | of the limit |")
    print("| --- | ---: | ---: | ---: | ---: |")
    rows = []
    for step in steps():
        operations, moved = step.operations / peak, step.bytes / memory
        rows.append([seconds(step.work, runs), operations, moved, max(operations, moved)])
        told(step.name, rows[-1])
    told("all, one core", np.sum(rows, axis=0).tolist())
    scene, knowledge = rooms.living_room(), default_knowledge()
    numbers = iter(range(10_000))
    whole = seconds(
        lambda: draw(rooms.changed(scene, next(numbers)), Query("Chair"), knowledge), runs
    )
    print(f"| the map, all cores | {1000 * whole:.1f} | | | |")


def told(name: str, times: Sequence[float]) -> None:
    """Print a row: seconds that it took, of arithmetic and memory alone, and of its limit."""
    took, operations, moved, limit = (1000 * time for time in times)
    print(f"| {name} | {took:.1f} | {operations:.2f} | {moved:.2f} | {limit / took:.0%} |")


if __name__ == "__main__":
    main()
