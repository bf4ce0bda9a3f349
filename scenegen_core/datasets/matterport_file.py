"""What a Matterport3D ``.house`` file says, line by line.

The format is the one that the data set publishes: the first letter of a line tells its kind, the
fields follow, separated by spaces; spaces in names are written as ``#``. Metres, z up.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TypeVar

import numpy as np

from scenegen_core.datasets.remarks import Report, Skipped
from scenegen_core.errors import DataError
from scenegen_core.scene.geometry import Floats

FARTHEST = 1e6  # metres; numbers beyond that, and those that are none, are mistakes
SHORT = 0.5  # of a unit: directions that short, or that near to each other, are wrong

T = TypeVar("T")


@dataclass(frozen=True, slots=True)
class Region:
    """A room or another part of a house (``R``)."""

    index: int
    level: int
    label: str
    box: Floats
    """Its lowest and highest corner, (2, 3) metres."""


@dataclass(frozen=True, slots=True)
class Surface:
    """A part of the floor of a region (``S``)."""

    index: int
    region: int


@dataclass(frozen=True, slots=True)
class Vertex:
    """A corner of a surface (``V``)."""

    surface: int
    position: Floats


@dataclass(frozen=True, slots=True)
class Category:
    """What objects are: the annotators' word and the one of 41 classes (``C``)."""

    index: int
    name: str
    mpcat40: str


@dataclass(frozen=True, slots=True)
class Thing:
    """An object: an oriented box (``O``)."""

    index: int
    region: int
    category: int
    center: Floats
    axes: Floats
    """Unit directions of the box, (3, 3): the two of the file and their cross product."""
    half: Floats
    """Half the size along each of the axes, (3,) metres."""


@dataclass(frozen=True, slots=True)
class House:
    """A whole file."""

    regions: tuple[Region, ...]
    surfaces: tuple[Surface, ...]
    vertices: tuple[Vertex, ...]
    categories: dict[int, Category]
    things: tuple[Thing, ...]


def house_of(text: str, path: Path, report: Report) -> House:
    """The house of a file's text; broken lines are reported, DataError if there is no region."""
    rows = list(enumerate(map(str.split, text.splitlines()), start=1))

    def each(letter: str, read: Callable[[list[str]], T]) -> Iterator[T]:
        for number, row in rows:
            if row[:1] != [letter]:
                continue
            try:
                yield read(row)
            except (ValueError, IndexError):
                report(Skipped(path, f"line {number}", f"it is no complete {letter} line"))

    house = House(
        regions=tuple(each("R", _region)),
        surfaces=tuple(each("S", lambda row: Surface(int(row[1]), int(row[2])))),
        vertices=tuple(each("V", lambda row: Vertex(int(row[2]), _numbers(row, 4, 3)))),
        categories={category.index: category for category in each("C", _category)},
        things=tuple(each("O", _thing)),
    )
    if not house.regions:
        raise DataError(f"{path} has no region; check that it is complete.")
    for row in each("H", lambda row: row):
        _compare(row, house, path, report)
    return house


def _region(row: list[str]) -> Region:
    return Region(int(row[1]), int(row[2]), row[5], _numbers(row, 9, 6).reshape(2, 3))


def _category(row: list[str]) -> Category:
    return Category(int(row[1]), row[3].replace("#", " "), row[5])


def _thing(row: list[str]) -> Thing:
    first, second = (_numbers(row, start, 3) for start in (7, 10))
    axes = np.array([first, second, np.cross(first, second)])
    if np.linalg.norm(axes, axis=1).min() < SHORT:
        raise ValueError(row)
    index, region, category = map(int, row[1:4])
    return Thing(index, region, category, _numbers(row, 4, 3), axes, _numbers(row, 13, 3))


def _numbers(row: list[str], start: int, count: int) -> Floats:
    """So many numbers from a field on; ValueError if they are not there or far too large."""
    numbers = np.array([float(field) for field in row[start : start + count]])
    if len(numbers) < count or not (np.abs(numbers) <= FARTHEST).all():
        raise ValueError(row)
    return numbers


def _compare(head: list[str], house: House, path: Path, report: Report) -> None:
    """Report when the file has less than its first line says: then it was cut off."""
    counts = {"objects": (8, len(house.things)), "regions": (10, len(house.regions))}
    for what, (field, found) in counts.items():
        if head[field : field + 1] not in ([], [str(found)]):
            report(Skipped(path, "", f"it has {found} {what}, its head says {head[field]}"))
