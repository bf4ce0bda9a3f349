"""The bytes of files, plain, gzipped or in a zip archive, never more than a limit of them."""

from __future__ import annotations

import gzip
import zipfile
import zlib
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cached_property
from pathlib import Path
from typing import IO, cast

import msgspec

from scenegen_core.errors import DataError

LARGEST = 256_000_000  # bytes, unpacked; a scanned house has a few, more is a mistake or an attack
LARGEST_ROWS = 4_000_000_000  # bytes, unpacked; rows are read one by one
LONGEST_LINE = 16_000_000  # bytes; a room of a thousand objects has a tenth of a million
MOST_MEMBERS = 10_000  # of a zip archive
START = 65_536  # bytes that show what a file is
GZIP = b"\x1f\x8b"
BOM = b"\xef\xbb\xbf"  # some programs begin their text with it

_Fields = dict[str, msgspec.Raw]


class Head:
    """What tells one format from another; found out when it is asked for."""

    def __init__(self, path: Path) -> None:
        self.path = path

    @cached_property
    def start(self) -> bytes:
        """The first bytes, unpacked when the file is gzipped."""
        with _opened(self.path) as file:
            return file.read(START).removeprefix(BOM)

    @cached_property
    def fields(self) -> _Fields:
        """The fields of the JSON object that the file or its first line is, undecoded.

        Of a list of objects, those of the first; empty when it is not JSON.
        """
        first, *others = self.start.strip().splitlines() or [b""]
        if not first.startswith((b"{", b"[")):
            return {}
        whole = _fields(first) or _fields(content(self.path))
        return whole or next(filter(None, map(_fields, others)), {})

    @cached_property
    def members(self) -> tuple[str, ...]:
        """The names in a zip archive; none when it is no archive."""
        if not self.start.startswith(b"PK"):
            return ()
        with _archive(self.path) as archive:
            return tuple(archive.namelist())

    def says(self, field: str, value: object) -> bool:
        """Whether a field of the JSON object has that value."""
        return field in self.fields and msgspec.json.decode(self.fields[field]) == value


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


def _fields(text: bytes) -> _Fields:
    try:
        found = msgspec.json.decode(text, type=_Fields | list[msgspec.Raw])
        if isinstance(found, list):
            return msgspec.json.decode(found[0], type=_Fields) if found else {}
    except (msgspec.DecodeError, UnicodeDecodeError):
        return {}
    return found
