"""``scenegen inspect``: draw what knowledge says of each category, with the counts behind it."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path

from scenegen_core.errors import KnowledgeError
from scenegen_core.evaluation.knowledge_page import TABLES, sentence, write_knowledge
from scenegen_core.knowledge import default_knowledge, load_knowledge
from scenegen_core.knowledge.marginals import marginals


def add_arguments(parser: ArgumentParser) -> None:
    """Declare what the command takes."""
    parser.add_argument(
        "knowledge", nargs="?", type=Path, metavar="KNOWLEDGE", help="a file; else what ships"
    )
    parser.add_argument("--out", required=True, type=Path, metavar="DIR", help="where it goes")
    parser.add_argument(
        "--tables",
        action="store_true",
        help="write the curves and surfaces as CSV too, to edit; learn --tables reads them",
    )


def run(arguments: Namespace) -> int:
    """Draw, and say the main points."""
    told = arguments.knowledge or "shipped"
    known = load_knowledge(arguments.knowledge) if arguments.knowledge else default_knowledge()
    try:
        write_knowledge(arguments.out, known, tables=arguments.tables)
    except OSError as error:
        raise KnowledgeError(
            f"Cannot write to {arguments.out} ({error.strerror}); choose another folder with --out."
        ) from None
    for part in marginals(known).categories:
        print(sentence(part))
    print(f"Wrote {arguments.out / 'index.html'}.")
    if arguments.tables:
        print(f"Wrote {arguments.out / TABLES}; edit them, and read them with: scenegen learn")
        print(f"  --tables {arguments.out / TABLES} --on {told} --out edited.npz")
    return 0
