"""Knowledge as one versioned .npz file: arrays, and a JSON header as bytes; no pickles."""

from __future__ import annotations

import zipfile
import zlib
from importlib import resources
from itertools import chain
from pathlib import Path
from typing import IO, Any, Literal

import msgspec
import numpy as np
from msgspec import Struct
from numpy.lib.npyio import NpzFile
from numpy.typing import NDArray

from scenegen_core.errors import KnowledgeError
from scenegen_core.graph.relations import Column
from scenegen_core.knowledge.choice import BINS, Choice, Table, choice_columns
from scenegen_core.knowledge.knowledge import SETTINGS, CategoryKnowledge, Knowledge
from scenegen_core.knowledge.plans import Plan
from scenegen_core.knowledge.sources import Source
from scenegen_core.scene.model import Category

VERSION: Literal[2] = 2
ARRAYS = ("rows", "rooms", "front_known", "sizes", "bottoms", "weights")
"""The arrays of a category; ``rooms`` holds indices into the header's rooms."""
TABLES = ("curves", "pairs", "surfaces", "examples")
"""The arrays of a choice, beside the indices of the rooms of its examples."""
KINDS = {"curves": "f", "pairs": "i", "surfaces": "f", "examples": "u", "rooms": "i"}
"""What kind of numbers they hold: compiled loops trust them as indices."""

BROKEN = (
    ValueError, TypeError, KeyError, IndexError, EOFError, zipfile.BadZipFile, zlib.error,
)  # fmt: skip
"""What NumPy and msgspec raise when a file is not what it should be."""

ZIPPED = b"PK\x03\x04"
"""How an archive begins."""

LEARN_AGAIN = "learn it again with: scenegen learn ROOMS --out knowledge.npz"


class _Header(Struct, frozen=True, tag_field="format", tag="scenegen.knowledge"):
    made_with: str
    settings: dict[str, float]
    groups: tuple[Category, ...]
    columns: tuple[Column, ...]
    categories: tuple[str, ...]
    choices: tuple[str, ...]
    rooms: tuple[str, ...]
    sources: tuple[Source, ...]
    version: Literal[2] = VERSION


class _Version(Struct, frozen=True):
    """Just enough of a header to say what is wrong with it."""

    version: int


def save_knowledge(knowledge: Knowledge, path: Path) -> None:
    """Write a file that :func:`load_knowledge` reads; the same knowledge gives the same bytes.

    KnowledgeError if it cannot be written there.
    """
    parts = tuple(knowledge.categories.values())
    choices = tuple(knowledge.choices.values())
    named = (*(part.rooms for part in parts), *(choice.rooms for choice in choices))
    rooms = tuple(dict.fromkeys(chain.from_iterable(named)))
    index = {room: i for i, room in enumerate(rooms)}
    header = _Header(
        made_with=knowledge.made_with,
        settings=dict(knowledge.settings),
        groups=knowledge.groups,
        columns=parts[0].columns,
        categories=tuple(knowledge.categories),
        choices=tuple(knowledge.choices),
        rooms=rooms,
        sources=knowledge.sources,
    )
    arrays: dict[str, NDArray[Any]] = {
        "header": np.frombuffer(msgspec.json.encode(header), dtype=np.uint8)
    }
    plans = {room: plan for room, plan in knowledge.plans.items() if room in index}
    arrays["plans"] = np.frombuffer(msgspec.json.encode(plans), dtype=np.uint8)
    for number, part in enumerate(parts):
        for name in ARRAYS:
            arrays[f"{number}.{name}"] = getattr(part, name)
        arrays[f"{number}.rooms"] = np.array([index[room] for room in part.rooms], dtype=np.int32)
    if knowledge.shared is not None:
        arrays["shared"] = knowledge.shared
    for number, choice in enumerate(choices):
        for name in TABLES:
            arrays[f"choice.{number}.{name}"] = getattr(choice, name)
        rooms_of = np.array([index[room] for room in choice.rooms], dtype=np.int32)
        arrays[f"choice.{number}.rooms"] = rooms_of
    try:
        with path.open("wb") as file:
            np.savez_compressed(file, allow_pickle=False, **arrays)
    except OSError as error:
        raise KnowledgeError(
            f"Cannot write the knowledge to {path} ({error.strerror}); choose another file."
        ) from error


def load_knowledge(path: Path) -> Knowledge:
    """The knowledge of a file; KnowledgeError says what to do if it cannot be used."""
    try:
        with path.open("rb") as file:
            return _read(file, str(path))
    except OSError as error:
        raise KnowledgeError(
            f"Cannot open the knowledge {path} ({error.strerror}); {LEARN_AGAIN}."
        ) from error


def default_knowledge() -> Knowledge:
    """The knowledge that ships with the program."""
    with resources.files("scenegen_core.knowledge").joinpath("default.npz").open("rb") as file:
        return _read(file, "default.npz")


def _read(file: IO[bytes], name: str) -> Knowledge:
    try:
        if file.read(len(ZIPPED)) != ZIPPED:
            raise KnowledgeError(f"{name} is not a knowledge file; {LEARN_AGAIN}.")
        file.seek(0)
        archive = np.load(file, allow_pickle=False)
        assert isinstance(archive, NpzFile)
        with archive:
            header = _header(archive["header"].tobytes(), name)
            parts = [_category(archive, header, i) for i in range(len(header.categories))]
            choices = [_choice(archive, header, i) for i in range(len(header.choices))]
            shared = _shared(archive, header) if header.choices else None
            plans = _plans(archive)
    except BROKEN as error:
        raise KnowledgeError(f"The knowledge file {name} is broken; {LEARN_AGAIN}.") from error
    return Knowledge(
        groups=header.groups,
        categories=dict(zip(header.categories, parts, strict=True)),
        sources=header.sources,
        settings=header.settings,
        made_with=header.made_with,
        choices=dict(zip(header.choices, choices, strict=True)),
        shared=shared,
        plans=plans,
    )


def _plans(archive: NpzFile) -> dict[str, Plan]:
    """The plans of the rooms; files from before there were plans have none."""
    if "plans" not in archive:
        return {}
    return msgspec.json.decode(archive["plans"].tobytes(), type=dict[str, Plan])


def _header(text: bytes, name: str) -> _Header:
    """The header, of this version and measured with the settings of this program."""
    version = msgspec.json.decode(text, type=_Version).version
    if version != VERSION:
        raise KnowledgeError(
            f"{name} has version {version}; this program reads version {VERSION}: {LEARN_AGAIN}."
        )
    header = msgspec.json.decode(text, type=_Header)
    if header.settings != SETTINGS:
        raise KnowledgeError(
            f"{name} was measured with {header.settings}, this program measures with "
            f"{dict(SETTINGS)}: {LEARN_AGAIN}."
        )
    return header


def _category(archive: NpzFile, header: _Header, number: int) -> CategoryKnowledge:
    """One category; one of BROKEN if its arrays do not fit together."""
    group = {group.name: group for group in header.groups}[header.categories[number]]
    arrays = {name: archive[f"{number}.{name}"] for name in ARRAYS}
    shapes = {name: array.shape for name, array in arrays.items()}
    examples = len(arrays["rooms"])
    expected = {
        "rows": (examples, len(header.columns)),
        "rooms": (examples,),
        "front_known": (examples,),
        "sizes": (examples, 3),
        "bottoms": (examples,),
        "weights": (examples,),
    }
    if shapes != expected or not all(np.isfinite(array).all() for array in arrays.values()):
        raise ValueError(shapes)
    return CategoryKnowledge(
        category=group,
        columns=header.columns,
        rows=arrays["rows"],
        rooms=tuple(header.rooms[i] for i in arrays["rooms"].tolist()),
        front_known=arrays["front_known"],
        sizes=arrays["sizes"],
        bottoms=arrays["bottoms"],
        weights=arrays["weights"],
    )


def _shared(archive: NpzFile, header: _Header) -> Table:
    """What all categories have in common; one of BROKEN if it does not fit the groups."""
    curves = archive["shared"]
    if curves.shape != (len(choice_columns(header.groups)), BINS) or not np.isfinite(curves).all():
        raise ValueError(curves.shape)
    return curves


def _choice(archive: NpzFile, header: _Header, number: int) -> Choice:
    """What is chosen of one category; one of BROKEN if its arrays do not fit together."""
    arrays = {name: archive[f"choice.{number}.{name}"] for name in (*TABLES, "rooms")}
    named = choice_columns(header.groups)
    pairs, examples = len(arrays["pairs"]), len(arrays["rooms"])
    expected = {
        "curves": (len(named), BINS),
        "pairs": (pairs, 2),
        "surfaces": (pairs, BINS, BINS),
        "examples": (examples, len(named)),
        "rooms": (examples,),
    }
    shapes = {name: array.shape for name, array in arrays.items()}
    kinds = {name: array.dtype.kind for name, array in arrays.items()}
    if shapes != expected or kinds != KINDS:
        raise ValueError(shapes)
    finite = np.isfinite(arrays["curves"]).all() and np.isfinite(arrays["surfaces"]).all()
    known = (arrays["pairs"] >= 0).all() and (arrays["pairs"] < len(named)).all()
    if not (finite and known and (arrays["examples"] < BINS).all()):
        raise ValueError(number)
    return Choice(
        columns=named,
        curves=arrays["curves"],
        pairs=arrays["pairs"],
        surfaces=arrays["surfaces"],
        examples=arrays["examples"],
        rooms=tuple(header.rooms[i] for i in arrays["rooms"].tolist()),
    )
