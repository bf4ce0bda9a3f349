"""``scenegen evaluate``: how good is it? The paper's tables on anybody's rooms."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, Namespace
from importlib.metadata import version
from pathlib import Path

import msgspec
import numpy as np

from scenegen_core.datasets.cleaning import clean
from scenegen_core.datasets.formats import read_all
from scenegen_core.datasets.remarks import Skipped, UnknownLabel
from scenegen_core.errors import DataError
from scenegen_core.evaluation.records import Journal, Record, Settings
from scenegen_core.evaluation.run import Job, cross_validated, held_out
from scenegen_core.evaluation.run import run as run_jobs
from scenegen_core.evaluation.summary import summarize
from scenegen_core.evaluation.systems import SYSTEMS
from scenegen_core.knowledge import default_knowledge, load_knowledge
from scenegen_core.scene.model import PAPER_CATEGORIES, Scene
from server.commands.progress import Meter

JOURNAL = "journal.jsonl"
RESULTS = "results.json"


def add_arguments(parser: ArgumentParser) -> None:
    """Declare what the command takes."""
    parser.add_argument(
        "data", nargs="*", type=Path, metavar="DATA", help="rooms to learn from and to judge on"
    )
    parser.add_argument(
        "--test", nargs="+", type=Path, default=[], metavar="DATA", help="rooms to judge on only"
    )
    parser.add_argument("--folds", type=int, default=4, help="parts of DATA, by home (4)")
    parser.add_argument("--knowledge", type=Path, metavar="FILE", help="with --test: judge this")
    parser.add_argument(
        "--model",
        action="append",
        choices=[system.name for system in SYSTEMS],
        help="judge only this one; again for more",
    )
    parser.add_argument("--out", type=Path, metavar="DIR", help="write the report here; resumable")
    parser.add_argument("--json", action="store_true", help="print the results as one JSON object")
    parser.add_argument("--seed", type=int, default=1, help="decides folds and draws (1)")
    parser.add_argument("--workers", type=int, default=2, help="processes (2)")


def run(arguments: Namespace) -> int:
    """Judge, print, write."""
    if bool(arguments.data) == bool(arguments.test):
        raise DataError(
            "Name rooms to judge in folds (scenegen evaluate DATA…), or rooms to judge the "
            "knowledge on (scenegen evaluate --test DATA…), not both."
        )
    scenes = _scenes(arguments.data or arguments.test)
    jobs = _jobs(arguments, scenes)
    systems = tuple(arguments.model or (system.name for system in SYSTEMS))
    settings = Settings(
        data=tuple(path.name for path in arguments.data or arguments.test),
        folds=arguments.folds if arguments.data else 0,
        seed=arguments.seed,
        systems=systems,
        knowledge=arguments.knowledge.name if arguments.knowledge else "",
        rooms=len(scenes),
        version=version("scenegen"),
    )
    journal = Journal(arguments.out / JOURNAL if arguments.out else None, settings)
    meter = Meter("cases")
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


def _scenes(paths: list[Path]) -> tuple[Scene, ...]:
    remarks: list[Skipped | UnknownLabel] = []
    scenes, reductions = clean(read_all(paths, remarks.append))
    for remark in remarks:
        print(remark, file=sys.stderr)
    print(
        f"{reductions.rooms} rooms with {reductions.boxes} objects after cleaning", file=sys.stderr
    )
    return scenes


def _jobs(arguments: Namespace, scenes: tuple[Scene, ...]) -> list[Job]:
    if arguments.data:
        return list(cross_validated(scenes, PAPER_CATEGORIES, arguments.folds, seed=arguments.seed))
    knowledge = load_knowledge(arguments.knowledge) if arguments.knowledge else default_knowledge()
    return [held_out(scenes, knowledge)]


def _tell(arguments: Namespace, settings: Settings, records: tuple[Record, ...]) -> None:
    rng = np.random.default_rng(settings.seed)
    results = summarize(records, rng=rng)
    if arguments.json:
        print(msgspec.json.encode(results).decode())
    if arguments.out:
        from scenegen_core.evaluation.report import write_report  # noqa: PLC0415 (draws plots)

        write_report(arguments.out, settings, records, results)
        print(f"report: {arguments.out / 'index.html'}", file=sys.stderr)
    if not arguments.json and not arguments.out:
        for name, tables in results["models"].items():
            print(name, {t: v["overall"] for t, v in tables.items() if "overall" in v})
