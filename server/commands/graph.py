"""``scenegen graph``: the scene graph of a room, for other programs."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, Namespace
from pathlib import Path

from scenegen_core.errors import SceneError
from scenegen_core.graph.export import FORMATS
from scenegen_core.graph.scene_graph import scene_graph
from scenegen_core.scene.model import PAPER_CATEGORIES
from server.commands.rooms import open_room


def add_arguments(parser: ArgumentParser) -> None:
    """Declare what the command takes."""
    parser.add_argument("room", type=Path, metavar="ROOM", help="a file of rooms, of any format")
    parser.add_argument("--room-id", metavar="ID", help="which room of a file of several")
    parser.add_argument("--format", choices=FORMATS, default="json")
    parser.add_argument("--out", type=Path, metavar="FILE", help="instead of the terminal")


def run(arguments: Namespace) -> int:
    """Read the room, relate what is in it, write the graph."""
    scene = open_room(arguments.room, arguments.room_id)
    text = FORMATS[arguments.format](scene_graph(scene, PAPER_CATEGORIES))
    if arguments.out is None:
        sys.stdout.write(text)
        return 0
    try:
        arguments.out.write_text(text, encoding="utf-8")
    except OSError as error:
        raise SceneError(
            f"{arguments.out} cannot be written ({error.strerror}); choose another place."
        ) from None
    sys.stderr.write(f"Saved {arguments.out}.\n")
    return 0
