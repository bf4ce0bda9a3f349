"""``scenegen learn``: make a knowledge file from files of rooms."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, ArgumentTypeError, Namespace
from collections.abc import Iterator, Sequence
from contextlib import AbstractContextManager, nullcontext
from dataclasses import asdict
from pathlib import Path

from scenegen_core.datasets.cleaning import ROOM_TYPES, Reductions, clean, recategorized
from scenegen_core.datasets.remarks import Remark, Skipped
from scenegen_core.errors import DataError
from scenegen_core.knowledge import (
    Knowledge,
    default_knowledge,
    learn,
    load_knowledge,
    save_knowledge,
)
from scenegen_core.knowledge.growing import together, with_groups
from scenegen_core.knowledge.learning import Mapper
from scenegen_core.knowledge.reading_tables import read_tables
from scenegen_core.placement.choice_learning import gather, with_choices
from scenegen_core.scene.model import PAPER_CATEGORIES, Category, Scene, Symmetry
from server.commands.progress import Meter
from server.commands.rooms import read_rooms

MAX_WEIGHT = 1e6
SHIPPED = "shipped"  # --on: what ships with the program


def add_arguments(parser: ArgumentParser) -> None:
    """Declare what the command takes."""
    parser.add_argument(
        "data", nargs="*", type=Path, metavar="DATA", help="files of rooms, of any format"
    )
    parser.add_argument(
        "--out", required=True, type=Path, metavar="FILE", help="where the knowledge goes (.npz)"
    )
    parser.add_argument(
        "--weight",
        action="append",
        default=[],
        type=weight,
        metavar="SOURCE=W",
        help="how much an example of a source counts (1); again for more sources",
    )
    parser.add_argument(
        "--room-types",
        type=lambda text: tuple(text.split(",")),
        default=ROOM_TYPES,
        metavar="A,B,…",
        help="the types of rooms to learn from (the paper's eleven; rooms without a type count)",
    )
    parser.add_argument(
        "--on",
        metavar="FILE",
        help="knowledge to go on from: its own is kept; 'shipped' is what ships with the program",
    )
    parser.add_argument(
        "--tables",
        type=Path,
        metavar="DIR",
        help="tables of inspect --tables, edited: they take the place of those of --on",
    )
    parser.add_argument(
        "--category",
        action="append",
        default=[],
        type=category,
        metavar="NAME[:SYMMETRY]",
        help="a further category: what has that category or label; asymmetric, symmetric (no "
        "front) or inside facing (its back to a wall); again for more",
    )
    parser.add_argument(
        "--without-choices", action="store_true", help="learn for the model paper only: faster"
    )
    parser.add_argument(
        "--dask", metavar="ADDRESS", help="measure on a dask scheduler; 'local' starts one here"
    )
    parser.add_argument("--workers", type=int, default=2, help="processes, with --dask local (2)")


def weight(text: str) -> tuple[str, float]:
    """A source and how much it counts: "procthor-gen=0.1"."""
    source, _, number = text.partition("=")
    try:
        value = float(number)
    except ValueError:
        value = 0.0
    if not 0 < value <= MAX_WEIGHT:
        raise ArgumentTypeError(
            f"{text!r}: write a source and a weight above 0, like procthor-gen=0.1"
        )
    return source, value


def category(text: str) -> Category:
    """A category and whether it has a front: "Piano", "Rug:symmetric"."""
    name, _, symmetry = text.partition(":")
    try:
        return Category(name.strip(), Symmetry(symmetry.strip() or Symmetry.ASYMMETRIC))
    except ValueError:
        ways = ", ".join(way.value for way in Symmetry)
        raise ArgumentTypeError(f"{text!r}: after the colon write one of {ways}") from None


def run(arguments: Namespace) -> int:
    """Read, clean, learn, save, and say what came of it; edited tables alone are only saved."""
    before = _before(arguments)
    if before and not arguments.data:
        save_knowledge(before, arguments.out)
        made_of = f"{arguments.on} with the tables of {arguments.tables}"
        sys.stdout.write(f"Wrote {arguments.out}, which is {made_of}.\n")
        return 0
    groups = before.groups if before else (*PAPER_CATEGORIES, *arguments.category)
    rooms, remarks = read_rooms(arguments.data)
    named = [recategorized(room, arguments.category) for room in rooms]
    scenes, reductions = clean(named, room_types=arguments.room_types)
    weights = dict(arguments.weight)
    _check_sources(weights, scenes)
    meter = Meter("rooms")
    with _mapper(arguments) as mapper:
        knowledge = learn(
            scenes,
            groups,
            made_with=" ".join(["scenegen learn", *(path.name for path in arguments.data)]),
            weights=weights,
            mapper=mapper,
            progress=lambda done: meter.show(done, len(scenes)),
        )
        meter.end()
        if not arguments.without_choices:
            meter = Meter("rooms chosen in")
            chosen = gather(
                scenes,
                knowledge.groups,
                mapper=mapper,
                progress=lambda done: meter.show(done, len(scenes)),
            )
            meter.end()
            knowledge = with_choices(
                together(before, knowledge) if before else knowledge,
                chosen,
                weights=weights,
                before=before,
            )
        elif before:
            knowledge = together(before, knowledge)
    save_knowledge(knowledge, arguments.out)
    sys.stdout.write("\n".join(_summary(knowledge, reductions, remarks, arguments.out)) + "\n")
    return 0


def _before(arguments: Namespace) -> Knowledge | None:
    """The knowledge to go on from, with edited tables and the further categories."""
    if not (arguments.data or arguments.tables):
        raise DataError("There is nothing to learn from; name files of rooms, or --tables.")
    if arguments.on is None:
        if arguments.tables:
            raise DataError("--tables needs the knowledge that they are of: --on FILE, or shipped.")
        return None
    known = default_knowledge() if arguments.on == SHIPPED else load_knowledge(Path(arguments.on))
    if arguments.tables:
        known = read_tables(known, arguments.tables)
    return with_groups(known, tuple(arguments.category))


def _mapper(arguments: Namespace) -> AbstractContextManager[Mapper]:
    """Where rooms are measured."""
    if arguments.dask is None:
        return nullcontext(map)
    from scenegen_core.knowledge.cluster import dask_mapper  # noqa: PLC0415 (an optional extra)

    return dask_mapper(arguments.dask, arguments.workers)


def _check_sources(weights: dict[str, float], scenes: Sequence[Scene]) -> None:
    known = dict.fromkeys(scene.source for scene in scenes)
    for source in weights:
        if source not in known:
            raise DataError(
                f"No room is of the source {source!r} that --weight names; "
                f"these are: {', '.join(known)}."
            )


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
    unknown = len(remarks) - skipped
    counts = {"skipped": skipped, "unknown_labels": unknown, **asdict(reductions)}
    for reason, count in counts.items():
        yield f"{reason.replace('_', ' '):<17} {count:>6}"
    yield f"Wrote {out} ({out.stat().st_size / 1000:.0f} kB)."
