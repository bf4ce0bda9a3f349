"""``scenegen learn``: make a knowledge file from files of rooms."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, Namespace
from collections.abc import Callable, Iterator
from dataclasses import asdict
from pathlib import Path

from scenegen_core.datasets.cleaning import Reductions, clean
from scenegen_core.datasets.formats import read_all
from scenegen_core.datasets.remarks import Remark, Skipped
from scenegen_core.knowledge import Knowledge, learn, save_knowledge
from scenegen_core.scene.model import PAPER_CATEGORIES


def add_arguments(parser: ArgumentParser) -> None:
    """Declare what the command takes."""
    parser.add_argument(
        "data", nargs="+", type=Path, metavar="DATA", help="files of rooms, of any format"
    )
    parser.add_argument(
        "--out", required=True, type=Path, metavar="FILE", help="where the knowledge goes (.npz)"
    )


def run(arguments: Namespace) -> int:
    """Read, clean, learn, save, and say what came of it."""
    remarks: list[Remark] = []
    scenes, reductions = clean(read_all(arguments.data, remarks.append))
    knowledge = learn(
        scenes,
        PAPER_CATEGORIES,
        made_with=" ".join(["scenegen learn", *(path.name for path in arguments.data)]),
        progress=_progress(len(scenes)),
    )
    save_knowledge(knowledge, arguments.out)
    sys.stdout.write("\n".join(_summary(knowledge, reductions, remarks, arguments.out)) + "\n")
    return 0


def _progress(total: int) -> Callable[[int], None]:
    """A counter on stderr that is redrawn on one line, for people who watch."""

    def show(done: int) -> None:
        if sys.stderr.isatty():
            end = "\n" if done == total else ""
            sys.stderr.write(f"\rMeasured {done} of {total} rooms{end}")
            sys.stderr.flush()

    return show


def _summary(
    knowledge: Knowledge, reductions: Reductions, remarks: list[Remark], out: Path
) -> Iterator[str]:
    """What was learned, from where, and what was left out and why."""
    yield f"{'Category':<10} {'examples':>8} {'front known':>12}   usual depth × width × height, m"
    for name, part in knowledge.categories.items():
        depth, width, height = part.usual_size
        yield (
            f"{name:<10} {part.examples:>8} {int(part.front_known.sum()):>12}   "
            f"{depth:.2f} × {width:.2f} × {height:.2f}"
        )
    yield ""
    for source in knowledge.sources:
        yield (
            f"{source.name}: {source.rooms} rooms, {source.objects} objects "
            f"({source.license}, {source.copyright})"
        )
    yield ""
    skipped = sum(isinstance(remark, Skipped) for remark in remarks)
    for reason, count in {"skipped": skipped, **asdict(reductions)}.items():
        yield f"{reason.replace('_', ' '):<17} {count:>6}"
    yield from (f"left out: {remark}" for remark in remarks if isinstance(remark, Skipped))
    yield f"Wrote {out} ({out.stat().st_size / 1000:.0f} kB)."
