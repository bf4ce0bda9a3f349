"""What readers say while they read: each thing left out, each label that nobody has reviewed.

And the checks that every reader makes before it hands on a box or an opening.
"""

from __future__ import annotations

import logging
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path

import msgspec

from scenegen_core.errors import SceneError
from scenegen_core.scene.files import BoxRecord, OpeningRecord, box_of, box_record
from scenegen_core.scene.model import Box, Opening

logger = logging.getLogger(__name__)


@dataclass(frozen=True, slots=True)
class Skipped:
    """Something that could not be used, and why."""

    path: Path
    what: str
    """Where it is in the file: "line 3", "object 'sofa-1'"; empty for the file itself."""
    reason: str

    def __str__(self) -> str:
        if not self.what and str(self.path) in self.reason:
            return self.reason
        return f"{', '.join(filter(None, [str(self.path), self.what]))}: {self.reason}"


@dataclass(frozen=True, slots=True)
class UnknownLabel:
    """A label that the reviewed list of its source lacks; its box counts as Other."""

    path: Path
    source: str
    """Which list lacks it (``labels/<source>.csv``)."""
    label: str

    def __str__(self) -> str:
        return f"{self.path}: unknown label {self.label!r} counts as Other"


Remark = Skipped | UnknownLabel
Report = Callable[[Remark], None]


def log(remark: Remark) -> None:
    """Report as a warning of this module's logger."""
    logger.warning("Left out: %s" if isinstance(remark, Skipped) else "%s", remark)


def told(remarks: Sequence[Remark]) -> Iterator[str]:
    """All that was said, a line each; a label once, with how many things have it."""
    yield from (f"left out: {remark}" for remark in remarks if isinstance(remark, Skipped))
    labels = Counter((r.source, r.label) for r in remarks if isinstance(r, UnknownLabel))
    for (source, label), count in labels.most_common():
        yield f"unknown label, counts as Other: {label!r} ({source}), {count}"


def usable_boxes(boxes: Iterable[Box], path: Path, report: Report) -> tuple[Box, ...]:
    """The boxes that a scene can carry, each id once; the others are reported.

    A box whose parent is not among them stands on nothing that is known.
    """
    kept: dict[str, Box] = {}
    for box in boxes:
        what = f"object {box.id!r}"
        if box.id in kept:
            report(Skipped(path, what, "another object has the same id"))
            continue
        try:
            kept[box.id] = _checked(box)
        except SceneError as error:
            report(Skipped(path, what, str(error)))
    return tuple(box if box.parent in kept else replace(box, parent=None) for box in kept.values())


def usable_openings(openings: Iterable[Opening], path: Path, report: Report) -> tuple[Opening, ...]:
    """The doors or windows that a room can have; the others are reported."""
    kept: list[Opening] = []
    for opening in openings:
        problem = problem_of(opening)
        if problem:
            report(Skipped(path, f"opening {opening.id!r}", problem))
        else:
            kept.append(opening)
    return tuple(kept)


def problem_of(opening: Opening) -> str:
    """Why a room cannot have that door or window; empty when it can."""
    try:
        msgspec.convert(asdict(opening), OpeningRecord)
    except msgspec.ValidationError as error:
        return str(error)
    return "" if opening.bottom < opening.top else "it ends below where it begins"


def _checked(box: Box) -> Box:
    """The box; SceneError if a number of it is beyond the limits of scenes."""
    try:
        return box_of(msgspec.convert(msgspec.to_builtins(box_record(box)), BoxRecord))
    except msgspec.ValidationError as error:
        raise SceneError(str(error)) from None
