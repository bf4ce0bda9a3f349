"""Every form that rooms come in, recognized by content, and reading any of them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path

from scenegen_core.datasets import (
    ifc,
    matterport,
    mruk,
    quest,
    roomplan,
    rows,
    scene_file,
    sweethome3d,
    thor_house,
    thor_metadata,
)
from scenegen_core.datasets.contents import Head
from scenegen_core.datasets.remarks import Report, Skipped, log
from scenegen_core.errors import DataError, SceneGenError
from scenegen_core.scene.model import Scene


@dataclass(frozen=True, slots=True)
class Format:
    """A form that rooms come in."""

    name: str
    description: str
    """What its files are, for people: "neither … nor …"."""
    recognizes: Callable[[Head], bool]
    read: Callable[[Path, Report], Iterator[Scene]]
    """The rooms of a file, one by one. What is broken is reported and left out; SceneGenError if
    nothing of the file is usable."""


FORMATS = (
    Format("scene", "a scene file", scene_file.recognizes, scene_file.read_scenes),
    Format("rows", "rows of rooms", rows.recognizes, rows.read_scenes),
    Format("quest", "a capture of a Quest headset", quest.recognizes, quest.read_scenes),
    Format("mruk", "a scene of MR Utility Kit", mruk.recognizes, mruk.read_scenes),
    Format("roomplan", "a RoomPlan scan", roomplan.recognizes, roomplan.read_scenes),
    Format(
        "sweethome3d", "a home of Sweet Home 3D", sweethome3d.recognizes, sweethome3d.read_scenes
    ),
    Format("procthor", "houses of ProcTHOR", thor_house.recognizes, thor_house.read_scenes),
    Format("ai2thor", "objects of AI2-THOR", thor_metadata.recognizes, thor_metadata.read_scenes),
    Format("matterport", "a house of Matterport3D", matterport.recognizes, matterport.read_scenes),
    Format("ifc", "a building model (IFC)", ifc.recognizes, ifc.read_scenes),
)
"""In the order they are tried; at most one recognizes a file."""


def format_of(path: Path) -> Format:
    """The format of a file; DataError if it cannot be read or is none of them."""
    head = Head(path)
    for form in FORMATS:
        if form.recognizes(head):
            return form
    if head.is_broken_json:
        raise DataError(f"{path} begins as JSON but is none; check that it is complete.")
    *others, last = (form.description for form in FORMATS)
    raise DataError(f"{path} is neither {', '.join(others)} nor {last}; choose another file.")


def read_scenes(path: Path, report: Report = log) -> Iterator[Scene]:
    """The rooms of a file of any format, one by one; SceneGenError if it is not usable."""
    scenes = format_of(path).read(path, report)
    first = next(scenes, None)
    if first is None:
        raise DataError(f"{path} holds no usable room; choose another file.")
    yield first
    yield from scenes


def read_all(
    paths: Iterable[Path],
    report: Report = log,
    *,
    progress: Callable[[int, int], None] = lambda _done, _total: None,
) -> Iterator[Scene]:
    """The rooms of many files; a folder stands for the files in it.

    A file that is not usable is reported and left out; DataError if one is not there or none is
    usable. ``progress`` is told after each file how many of how many are done.
    """
    files = _files(paths)
    unusable = 0
    for done, path in enumerate(files, start=1):
        try:
            yield from read_scenes(path, report)
        except SceneGenError as error:
            if len(files) == 1:
                raise
            report(Skipped(path, "", str(error)))
            unusable += 1
        progress(done, len(files))
    if unusable == len(files):
        raise DataError(f"None of the {unusable} files is usable; choose others.")


def _files(paths: Iterable[Path]) -> list[Path]:
    """The files, and those in the folders, each once; DataError if one is missing."""
    found: list[Path] = []
    for path in paths:
        if not path.exists():
            raise DataError(f"There is no file {path}; check its name and folder.")
        inside = [file for file in sorted(path.rglob("*")) if file.is_file()] or [path]
        found += inside if path.is_dir() else [path]
    return list(dict.fromkeys(found))
