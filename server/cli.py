"""The command line: ``scenegen <command>``; each command is a module of ``server.commands``."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Sequence
from importlib import import_module

from scenegen_core.errors import SceneGenError

COMMANDS = {
    "serve": "open the page in a browser: draw a room, place furniture",
    "place": "say where something would go in a room, and why",
    "graph": "write the scene graph of a room",
    "convert": "read rooms of any format; write them as a scene or as rows",
    "learn": "learn knowledge from files of rooms",
    "inspect": "draw what knowledge says of each category",
    "evaluate": "say how good it is: take objects out of rooms and ask where they go",
}

INTERRUPTED = 130  # the shell's code for a program that Ctrl+C ended


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a command; the exit code: 0, or 2 with a sentence on stderr."""
    given = list(sys.argv[1:] if arguments is None else arguments)
    parser = argparse.ArgumentParser(
        prog="scenegen", description="Where would this sofa go, which way should it face, and why?"
    )
    commands = parser.add_subparsers(dest="command", required=True, metavar="command")
    for name, summary in COMMANDS.items():
        command = commands.add_parser(name, help=summary, description=summary)
        if given[:1] == [name]:  # so that one command never waits for the imports of another
            import_module(f"server.commands.{name}").add_arguments(command)
    options = parser.parse_args(given)
    try:
        code: int = import_module(f"server.commands.{options.command}").run(options)
    except SceneGenError as error:
        print(f"scenegen: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        return INTERRUPTED
    except BrokenPipeError:  # the reader of our output (head, less) has gone
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0
    return code


if __name__ == "__main__":
    sys.exit(main())
