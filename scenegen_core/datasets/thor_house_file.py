"""What a file of ProcTHOR's houses says, and the sizes of the assets that it names."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from types import MappingProxyType
from typing import TypeVar

import msgspec
from msgspec import Struct

from scenegen_core.datasets.contents import Head, content, lines
from scenegen_core.datasets.remarks import Report, Skipped
from scenegen_core.datasets.thor import XYZ
from scenegen_core.errors import DataError

DATABASE = Path("databases", "asset-database.json")
T = TypeVar("T")


class Asset(Struct, frozen=True, rename="camel"):
    """A model: what it shows, and its size in its own axes."""

    asset_id: str
    object_type: str
    bounding_box: XYZ


class Floor(Struct, frozen=True, rename="camel"):
    """A room."""

    id: str
    floor_polygon: tuple[XYZ, ...]
    room_type: str = ""


class Wall(Struct, frozen=True, rename="camel"):
    """One side of a wall: a rectangle."""

    id: str
    polygon: tuple[XYZ, ...]
    room_id: str = ""


class Extent(Struct, frozen=True):
    """The lowest and the highest corner of an opening: x along its wall, y up, metres."""

    min: XYZ
    max: XYZ


class Hole(Struct, frozen=True, rename="camel"):
    """A door or a window in a wall; older houses have a box where newer ones have two corners."""

    id: str
    wall0: str
    hole_polygon: tuple[XYZ, ...] = ()
    bounding_box: Extent | None = None


class Thing(Struct, frozen=True, rename="camel"):
    """An object with what stands on it."""

    id: str
    asset_id: str
    position: XYZ
    rotation: XYZ = XYZ(0, 0, 0)
    children: tuple[msgspec.Raw, ...] = ()


class House(Struct, frozen=True):
    """A whole house; what is listed is decoded one by one, so that broken ones can be left out."""

    rooms: tuple[msgspec.Raw, ...]
    walls: tuple[msgspec.Raw, ...] = ()
    doors: tuple[msgspec.Raw, ...] = ()
    windows: tuple[msgspec.Raw, ...] = ()
    objects: tuple[msgspec.Raw, ...] = ()


@cache
def assets_by_id() -> MappingProxyType[str, Asset]:
    """The assets of ProcTHOR's database; DataError says how to get it if it is missing."""
    package = find_spec("procthor")
    folders = package.submodule_search_locations if package is not None else None
    if not folders:
        raise DataError(
            "Houses of ProcTHOR need the sizes of its assets, from the package procthor; "
            'install it: pip install "scenegen[thor]".'
        )
    by_type = msgspec.json.decode(content(Path(folders[0]) / DATABASE), type=dict[str, list[Asset]])
    return MappingProxyType({a.asset_id: a for assets in by_type.values() for a in assets})


def houses(path: Path, report: Report) -> Iterator[tuple[int, House]]:
    """The houses, one a line, or one over many lines; with their numbers."""
    first = Head(path).start.split(b"\n", 1)[0].strip()
    texts = iter([content(path)]) if first == b"{" else lines(path)
    for number, text in enumerate(texts, start=1):
        if not text.strip():
            continue
        try:
            yield number, msgspec.json.decode(text, type=House)
        except (msgspec.DecodeError, UnicodeDecodeError) as error:
            report(Skipped(path, f"house {number}", str(error)))


def each(
    raw: Iterable[msgspec.Raw], kind: type[T], what: str, path: Path, report: Report
) -> Iterator[T]:
    """Each thing of a list; the broken ones are reported."""
    for number, text in enumerate(raw):
        try:
            yield msgspec.json.decode(text, type=kind)
        except (msgspec.DecodeError, UnicodeDecodeError) as error:
            report(Skipped(path, f"{what} {number}", str(error)))
