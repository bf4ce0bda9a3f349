"""Records: the errors of every system in every task of a case, kept as lines of JSON."""

from __future__ import annotations

from pathlib import Path

import msgspec
from msgspec import Struct

from scenegen_core.errors import DataError
from scenegen_core.evaluation.bench import Task


class Chances(Struct, frozen=True):
    """What the probabilities of a system said of a case."""

    called: tuple[float, ...]
    """The probability that the truth is near an offered pose, for each."""
    holds: tuple[bool, ...]
    """Is it?"""
    log_score: float
    """Logarithm of the probability of the true cell, nats."""
    log_uniform: float
    """The same where every possible cell is equally likely."""


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
    chances: dict[str, Chances]
    """System -> what its probabilities said in the joint task, of those that give any."""
    truth: dict[str, float]
    """The physical facts of the object where it really stood."""


class Settings(Struct, frozen=True):
    """What records depend on: records made otherwise are not mixed with them."""

    data: tuple[str, ...]
    """Names of the files judged on."""
    learned: tuple[str, ...]
    """Names of the files learned from, or of the knowledge; empty where folds take turns."""
    digest: str
    """Of the bytes of all these files."""
    folds: int
    """0 where the rooms judged on are others than those learned from."""
    seed: int
    systems: tuple[str, ...]
    rooms: int
    taught: int
    """Rooms judged on that also taught the knowledge; 0 in folds."""
    left_out: dict[str, int]
    """Category -> cases not asked, since too few examples were left to learn from."""
    version: str


class Journal:
    """A file of records that an interrupted run goes on with: settings, then a line a case."""

    def __init__(self, path: Path | None, settings: Settings) -> None:
        self._path = path
        self.known: dict[str, Record] = {}
        if path is None:
            return
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
            self._open(path, settings)
        except OSError as error:
            raise DataError(
                f"{path} cannot be written ({error.strerror}); choose another folder with --out."
            ) from None

    def _open(self, path: Path, settings: Settings) -> None:
        """Begin the file, or go on with it after its last whole line."""
        before = path.read_bytes() if path.exists() else b""
        whole = before[: before.rfind(b"\n") + 1]
        if not whole:
            whole = msgspec.json.encode(settings) + b"\n"
        else:
            self._resume(path, whole.splitlines(), settings)
        if whole != before:
            path.write_bytes(whole)

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
        for number, line in enumerate(lines[1:], start=2):
            try:
                record = msgspec.json.decode(line, type=Record)
            except msgspec.DecodeError:
                raise DataError(f"Line {number} of {path} is damaged; remove the file.") from None
            self.known[record.case] = record

    def add(self, record: Record) -> None:
        """Keep a record, on disk first."""
        if self._path is not None:
            with self._path.open("ab") as file:
                file.write(msgspec.json.encode(record) + b"\n")
        self.known[record.case] = record
