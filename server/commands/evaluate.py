"""``scenegen evaluate``: how good is it? The paper's tables on anybody's rooms."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, ArgumentTypeError, Namespace
from collections.abc import Callable, Iterator, Mapping
from hashlib import blake2b
from importlib.metadata import version
from importlib.resources import files
from pathlib import Path
from typing import Any

import msgspec
import numpy as np

from scenegen_core.datasets.cleaning import clean
from scenegen_core.datasets.formats import read_all
from scenegen_core.datasets.remarks import Skipped, UnknownLabel
from scenegen_core.errors import DataError
from scenegen_core.evaluation.drawing import need_drawing
from scenegen_core.evaluation.jobs import (
    Job,
    cross_validated,
    held_out,
    left_out,
    taught,
    taught_by,
)
from scenegen_core.evaluation.records import Journal, Record, Settings
from scenegen_core.evaluation.report import write_report
from scenegen_core.evaluation.run import run as run_jobs
from scenegen_core.evaluation.summary import MEASURES, summarize
from scenegen_core.evaluation.systems import SYSTEMS
from scenegen_core.evaluation.trees import can_grow
from scenegen_core.knowledge import default_knowledge, load_knowledge
from scenegen_core.scene.model import PAPER_CATEGORIES, Scene
from server.commands.progress import Meter

JOURNAL = "journal.jsonl"
DEFAULT_KNOWLEDGE = Path(str(files("scenegen_core.knowledge") / "default.npz"))


def add_arguments(parser: ArgumentParser) -> None:
    """Declare what the command takes."""
    parser.add_argument(
        "data", nargs="*", type=Path, metavar="DATA", help="rooms to learn from and to judge on"
    )
    parser.add_argument(
        "--test",
        nargs="+",
        type=Path,
        default=[],
        metavar="DATA",
        help="rooms to judge on only, with what DATA teaches, or --knowledge",
    )
    parser.add_argument(
        "--folds", type=_at_least(2), default=4, help="parts of DATA that take turns, by home (4)"
    )
    parser.add_argument(
        "--knowledge", type=Path, metavar="FILE", help="with --test: judge this, not what ships"
    )
    parser.add_argument(
        "--model",
        action="append",
        choices=[system.name for system in SYSTEMS],
        help="judge only this one; again for more",
    )
    parser.add_argument("--out", type=Path, metavar="DIR", help="write the report here; resumable")
    parser.add_argument("--json", action="store_true", help="print the results as one JSON object")
    parser.add_argument("--seed", type=_at_least(0), default=1, help="decides folds and draws (1)")
    parser.add_argument("--workers", type=_at_least(1), default=2, help="processes (2)")


def _at_least(least: int) -> Callable[[str], int]:
    def number(text: str) -> int:
        if not text.isdecimal() or int(text) < least:
            raise ArgumentTypeError(f"{text!r}: give a whole number, {least} or more")
        return int(text)

    return number


def run(arguments: Namespace) -> int:
    """Judge, print, write."""
    _check(arguments)
    if arguments.out:
        need_drawing()  # now, not after the long run
    judged = _scenes(arguments.test or arguments.data)
    systems = _systems(arguments)
    jobs = _jobs(arguments, judged, systems)
    settings = _settings(arguments, systems, judged, jobs)
    if settings.taught:
        print(
            f"{settings.taught} of these rooms have taught the knowledge: the numbers flatter it",
            file=sys.stderr,
        )
    for name, count in settings.left_out.items():
        print(f"{name}: {count} left out, too few examples to learn from", file=sys.stderr)
    journal = Journal(arguments.out / JOURNAL if arguments.out else None, settings)
    meter = Meter("objects")
    records = run_jobs(
        jobs,
        journal,
        systems=systems,
        seed=arguments.seed,
        workers=arguments.workers,
        progress=meter.show,
    )
    meter.end()
    _tell(arguments, settings, records)
    return 0


def _systems(arguments: Namespace) -> tuple[str, ...]:
    """The systems to ask: those named, or all that can be had."""
    if arguments.model:
        return tuple(system.name for system in SYSTEMS if system.name in arguments.model)
    return tuple(system.name for system in SYSTEMS if can_grow() or not system.needs_forest)


def _check(arguments: Namespace) -> None:
    forested = [s.name for s in SYSTEMS if s.needs_forest and s.name in (arguments.model or [])]
    if forested and not can_grow():
        raise DataError(
            "Trees need the package lightgbm; install scenegen with its extra: "
            "pip install 'scenegen[trees]'."
        )
    if not (arguments.data or arguments.test):
        raise DataError(
            "Name rooms to judge in folds (scenegen evaluate DATA…), or rooms to judge what "
            "ships on (scenegen evaluate --test DATA…)."
        )
    if arguments.knowledge and (arguments.data or not arguments.test):
        raise DataError("--knowledge is judged with --test DATA… alone; leave the other DATA out.")


def _settings(
    arguments: Namespace, systems: tuple[str, ...], scenes: tuple[Scene, ...], jobs: list[Job]
) -> Settings:
    judged = arguments.test or arguments.data
    learned = arguments.data if arguments.test else []
    if arguments.test and not learned:
        learned = [arguments.knowledge or DEFAULT_KNOWLEDGE]
    digest = blake2b(digest_size=8)
    for path in (*learned, *judged):
        if path.is_file():
            digest.update(path.read_bytes())
    return Settings(
        data=tuple(path.name for path in judged),
        learned=tuple(path.name for path in learned),
        digest=digest.hexdigest(),
        folds=0 if arguments.test else arguments.folds,
        seed=arguments.seed,
        systems=systems,
        rooms=len(scenes),
        taught=taught(scenes, jobs[0].knowledge) if arguments.test else 0,
        left_out=left_out(jobs),
        version=version("scenegen"),
    )


def _scenes(paths: list[Path]) -> tuple[Scene, ...]:
    remarks: list[Skipped | UnknownLabel] = []
    scenes, reductions = clean(read_all(paths, remarks.append))
    for remark in remarks:
        print(remark, file=sys.stderr)
    print(f"after cleaning: rooms {reductions.rooms}, objects {reductions.boxes}", file=sys.stderr)
    return scenes


def _jobs(arguments: Namespace, judged: tuple[Scene, ...], systems: tuple[str, ...]) -> list[Job]:
    asked = [system for system in SYSTEMS if system.name in systems]
    choices = any(system.needs_choices for system in asked)
    forest = any(system.needs_forest for system in asked)
    if not arguments.test:
        jobs = []
        for job in cross_validated(
            judged,
            PAPER_CATEGORIES,
            arguments.folds,
            seed=arguments.seed,
            choices=choices,
            forest=forest,
        ):
            jobs.append(job)
            print(f"learned for fold {len(jobs)} of {arguments.folds}", file=sys.stderr)
        return jobs
    if arguments.data:
        lessons = _scenes(arguments.data)
        return [taught_by(lessons, judged, PAPER_CATEGORIES, choices=choices, forest=forest)]
    known = load_knowledge(arguments.knowledge) if arguments.knowledge else default_knowledge()
    return [held_out(judged, known)]


def _tell(arguments: Namespace, settings: Settings, records: tuple[Record, ...]) -> None:
    results = summarize(records, rng=np.random.default_rng(settings.seed))
    if arguments.json:
        print(msgspec.json.encode(results).decode())
    if arguments.out:
        try:
            write_report(arguments.out, settings, records, results)
        except OSError as error:
            raise DataError(
                f"The report cannot be written to {arguments.out} ({error.strerror}); choose "
                "another folder with --out."
            ) from None
        print(f"report: {arguments.out / 'index.html'}", file=sys.stderr)
    if not arguments.json and not arguments.out:
        print("\n".join(told(results)))


def told(results: Mapping[str, Any]) -> Iterator[str]:
    """The means over all categories as lines of text: a block a task, a line a system."""
    yield f"{results['queries']} objects in {results['rooms']} rooms"
    for task in ("joint", "position", "orientation", "joint2", "joint3"):
        rows = {n: t[task]["overall"] for n, t in results["models"].items() if task in t}
        if rows:
            heads = "".join(f"{measure:>9}" for measure in MEASURES)
            yield f"\n{task:<16}{heads}"
        for name, found in rows.items():
            yield f"{name:<16}" + "".join(f"{_two(found.get(m)):>9}" for m in MEASURES)


def _two(value: float | None) -> str:
    return "" if value is None else f"{value:.2f}"
