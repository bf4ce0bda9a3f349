"""Records: the errors of every system in every task of a case, kept as lines of JSON."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import msgspec
from msgspec import Struct

from scenegen_core.errors import DataError
from scenegen_core.evaluation.bench import Task


class Record(Struct, frozen=True):
    """What one case said of all systems."""

    case: str
    """Names the case: room and box."""
    room: str
    source: str
    category: str
    fold: int
    errors: dict[str, dict[Task, dict[str, float]]]
    """System -> task -> measure -> error."""


class Settings(Struct, frozen=True):
    """What records depend on: records made otherwise are not mixed with them."""

    data: tuple[str, ...]
    folds: int
    seed: int
    systems: tuple[str, ...]
    knowledge: str
    rooms: int
    version: str


class Journal:
    """A file of records that an interrupted run goes on with: settings, then a line a case."""

    def __init__(self, path: Path | None, settings: Settings) -> None:
        self._path = path
        self.known: dict[str, Record] = {}
        if path is None:
            return
        if path.exists() and (lines := path.read_bytes().splitlines()):
            self._resume(path, lines, settings)
        else:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(msgspec.json.encode(settings) + b"\n")

    def _resume(self, path: Path, lines: list[bytes], settings: Settings) -> None:
        try:
            before = msgspec.json.decode(lines[0], type=Settings)
        except msgspec.DecodeError:
            raise DataError(f"{path} is not a journal of an evaluation; remove it.") from None
        if before != settings:
            raise DataError(
                f"{path} belongs to an evaluation with other settings; remove it or choose another "
                "folder with --out."
            )
        for record in _records(lines[1:]):
            self.known[record.case] = record

    def add(self, record: Record) -> None:
        """Keep a record, on disk first."""
        if self._path is not None:
            with self._path.open("ab") as file:
                file.write(msgspec.json.encode(record) + b"\n")
        self.known[record.case] = record


def _records(lines: list[bytes]) -> Iterator[Record]:
    """The records of lines; the last may be half a line, written when the run was cut."""
    for number, line in enumerate(lines, start=1):
        try:
            yield msgspec.json.decode(line, type=Record)
        except msgspec.DecodeError:
            if number < len(lines):
                raise DataError(
                    f"Line {number + 1} of the journal is damaged; remove the file."
                ) from None
