"""Our own scene files as one of the formats that rooms come in."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

from scenegen_core.datasets.contents import Head, content
from scenegen_core.datasets.remarks import Report
from scenegen_core.scene.files import read_scene
from scenegen_core.scene.model import Scene


def recognizes(head: Head) -> bool:
    """Whether the file says of itself that it is a scene."""
    return head.says("format", "scenegen.scene")


def read_scenes(path: Path, _report: Report) -> Iterator[Scene]:
    """The one room of the file; SceneError says what is wrong with it."""
    scene = read_scene(content(path))
    yield scene if scene.id else replace(scene, id=path.stem)
