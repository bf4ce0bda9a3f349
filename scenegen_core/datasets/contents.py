"""The bytes of files, plain, gzipped or in a zip archive, never more than a limit of them."""

from __future__ import annotations

import gzip
import zipfile
import zlib
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cached_property
from pathlib import Path
from typing import IO, Annotated, cast

import msgspec
from msgspec import Meta

from scenegen_core.errors import DataError

LARGEST = 256_000_000  # bytes, unpacked; a scanned house has a few, more is a mistake or an attack
LARGEST_ROWS = 4_000_000_000  # bytes, unpacked; rows are read one by one
LONGEST_LINE = 16_000_000  # bytes; a room of a thousand objects has a tenth of a million
MOST_MEMBERS = 10_000  # of a zip archive
START = 65_536  # bytes that show what a file is
GZIP = b"\x1f\x8b"
ZIP = b"PK\x03\x04"
BOM = b"\xef\xbb\xbf"  # some programs begin their text with it
BROKEN_JSON = (msgspec.DecodeError, UnicodeDecodeError, RecursionError)
"""What reading JSON raises when it is wrong; the last when it is nested without end."""

Measured = Annotated[float, Meta(ge=-100_000, le=100_000)]
"""Metres or degrees in a file; beyond that a number is a mistake, and products overflow."""

Fields = dict[str, msgspec.Raw]


class Head:
    """What tells one format from another; found out when it is asked for."""

    def __init__(self, path: Path) -> None:
        self.path = path

    @cached_property
    def start(self) -> bytes:
        """The first bytes, unpacked when the file is gzipped."""
        with _opened(self.path) as file:
            return file.read(START).removeprefix(BOM)

    @property
    def is_broken_json(self) -> bool:
        """Whether it begins as JSON but is none, nor is any of its first lines."""
        if self.fields or not self._looks_like_json:
            return False
        try:
            msgspec.json.decode(content(self.path), type=msgspec.Raw)
        except BROKEN_JSON:
            return True
        return False

    @property
    def _looks_like_json(self) -> bool:
        return self.start.lstrip().startswith((b"{", b"["))

    @cached_property
    def fields(self) -> Fields:
        """The fields of the JSON object that the file or its first line is, undecoded.

        Of a list of objects, those of the first; empty when it is not JSON.
        """
        if not self._looks_like_json:
            return {}
        with _opened(self.path) as file:
            first = file.readline(LONGEST_LINE).removeprefix(BOM)
        found = fields_of(first) or fields_of(content(self.path))
        return found or next(filter(None, map(fields_of, self.start.splitlines())), {})

    @cached_property
    def members(self) -> tuple[str, ...]:
        """The names in a zip archive; none when it is no archive."""
        if not self.start.startswith(ZIP):
            return ()
        with _archive(self.path) as archive:
            return tuple(name for name in archive.namelist() if not _is_junk(name))

    def says(self, field: str, value: object) -> bool:
        """Whether a field of the JSON object has that value."""
        return field in self.fields and msgspec.json.decode(self.fields[field]) == value


def fields_of(text: bytes) -> Fields:
    """The fields of a JSON object, undecoded; of a list, those of its first; empty if neither."""
    try:
        found = msgspec.json.decode(text, type=Fields | list[msgspec.Raw])
        if isinstance(found, list):
            return msgspec.json.decode(found[0], type=Fields) if found else {}
    except BROKEN_JSON:
        return {}
    return found


def content(path: Path, limit: int = LARGEST) -> bytes:
    """All bytes of a file, unpacked when it is gzipped; DataError says what is wrong."""
    with _opened(path) as file:
        found = file.read(limit + 1)
    if len(found) > limit:
        raise DataError(_too_large(str(path), limit))
    return found.removeprefix(BOM)


def lines(path: Path) -> Iterator[bytes]:
    """The lines of a file, unpacked when it is gzipped; DataError says what is wrong."""
    total = 0
    with _opened(path) as file:
        while line := file.readline(LONGEST_LINE + 1):
            total += len(line)
            if len(line) > LONGEST_LINE:
                raise DataError(_too_large(f"A line of {path}", LONGEST_LINE))
            if total > LARGEST_ROWS:
                raise DataError(_too_large(str(path), LARGEST_ROWS))
            yield line


def member(path: Path, name: str, limit: int = LARGEST) -> bytes:
    """The bytes of one file of a zip archive; DataError says what is wrong."""
    with _archive(path) as archive, archive.open(name) as file:
        found = file.read(limit + 1)
    if len(found) > limit:
        raise DataError(_too_large(f"{name} in {path}", limit))
    return found.removeprefix(BOM)


def members(path: Path, suffix: str) -> Iterator[tuple[str, bytes]]:
    """The files of a zip archive whose names end so, with their bytes.

    DataError says what is wrong, also when they are too large together.
    """
    left = LARGEST
    with _archive(path) as archive:
        for name in archive.namelist():
            if name.lower().endswith(suffix) and not _is_junk(name):
                with archive.open(name) as file:
                    found = file.read(left + 1)
                left -= len(found)
                if left < 0:
                    raise DataError(_too_large(str(path), LARGEST))
                yield name, found.removeprefix(BOM)


def _is_junk(name: str) -> bool:
    """Whether it is a note that macOS puts beside each file of an archive."""
    return name.startswith("__MACOSX/")


@contextmanager
def _opened(path: Path) -> Iterator[IO[bytes]]:
    """The file, unpacked when it is gzipped."""
    with _named(path), path.open("rb") as file:
        packed = file.read(len(GZIP)) == GZIP
        file.seek(0)
        if not packed:
            yield file
            return
        with gzip.open(file) as unpacked:
            yield cast(IO[bytes], unpacked)


@contextmanager
def _archive(path: Path) -> Iterator[zipfile.ZipFile]:
    with _named(path), zipfile.ZipFile(path) as archive:
        if len(archive.infolist()) > MOST_MEMBERS:
            raise DataError(f"{path} holds more than {MOST_MEMBERS} files; take out what it needs.")
        yield archive


@contextmanager
def _named(path: Path) -> Iterator[None]:
    """Errors of the system, of gzip and of zip as a DataError that names the file."""
    try:
        yield
    except FileNotFoundError:
        raise DataError(f"There is no file {path}; check its name and folder.") from None
    except IsADirectoryError:
        raise DataError(f"{path} is a folder; name a file in it.") from None
    except (OSError, EOFError, zlib.error, zipfile.BadZipFile, RuntimeError, KeyError,
            NotImplementedError) as error:  # fmt: skip
        reason = getattr(error, "strerror", None) or error
        raise DataError(
            f"{path} cannot be read ({reason}); check that it is complete and not locked."
        ) from None


def _too_large(what: str, limit: int) -> str:
    return f"{what} is larger than {limit / 1e6:.0f} MB; split it, or check where it comes from."
