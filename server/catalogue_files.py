"""A user's own catalogue: a directory of GLB files, one a piece of furniture.

A file's category is the name of its folder (``sofa/oslo.glb``), the beginning of its name
(``sofa-oslo.glb``), or what ``catalogue.json`` says: ``{"oslo.glb": {"category": "Sofa", "name":
"Oslo"}}``. Files are strangers: each is checked, and one that is not usable is skipped and named.
"""

from __future__ import annotations

from collections.abc import Iterable
from hashlib import sha256
from pathlib import Path

import msgspec
import numpy as np
from msgspec import Struct

from server.catalogue import Catalogue, Item
from server.furniture import on_wall
from server.furniture.embedding import Guest
from server.furniture.glb import Packer
from server.furniture.mesh import Floats
from server.model_file import SMALLEST, Model, read_model, size_problem

MANIFEST = "catalogue.json"
MAX_FILES = 500
MAX_FILE_BYTES = 30_000_000
MAX_TOTAL_BYTES = 500_000_000
MAX_MANIFEST_BYTES = 1_000_000
MAX_ID = 80  # characters, as on the wire
MAX_NAME = 120  # characters, as on the wire


class Entry(Struct, frozen=True, forbid_unknown_fields=True):
    """What the manifest says of a file."""

    category: str
    name: str = ""


def load_catalogue(directory: Path, categories: Iterable[str]) -> Catalogue:
    """Read every GLB of the directory, sorted by path; never fails for one bad file.

    Args:
        directory: Holds GLB files, or folders of them, one level deep.
        categories: The names of the categories that can be placed.
    """
    known = {name.casefold(): name for name in categories}
    items: list[Item] = []
    problems: list[str] = []
    try:
        entries = _manifest(directory)
        paths = _files(directory, entries)
    except (ValueError, OSError) as error:
        return Catalogue(problems=(f"{directory}: {error}.",))
    free = MAX_TOTAL_BYTES
    for path in paths[:MAX_FILES]:
        try:
            item = _item(directory, path, entries, known, limit=min(free, MAX_FILE_BYTES))
        except (ValueError, OSError) as error:
            problems.append(f"{path}: {error}.")
        else:
            items.append(item)
            free -= len(item.data)
    if len(paths) > MAX_FILES:
        problems.append(f"{directory}: only the first {MAX_FILES} of {len(paths)} files are used.")
    return Catalogue(tuple(items), tuple(problems))


def _manifest(directory: Path) -> dict[str, Entry]:
    path = directory / MANIFEST
    if not path.exists():
        return {}
    try:
        return msgspec.json.decode(_read(directory, MANIFEST, MAX_MANIFEST_BYTES),
                                   type=dict[str, Entry])  # fmt: skip
    except msgspec.DecodeError as error:
        raise ValueError(f"{MANIFEST} is wrong: {error}") from None


def _files(directory: Path, entries: dict[str, Entry]) -> list[str]:
    """The paths inside the directory, with / and sorted, of what it holds or its manifest names."""
    if not directory.is_dir():
        raise ValueError("there is no such directory; make it or name another")
    found = [*directory.glob("*.glb"), *directory.glob("*/*.glb")]
    return sorted({path.relative_to(directory).as_posix() for path in found} | set(entries))


def _item(
    directory: Path, path: str, entries: dict[str, Entry], known: dict[str, str], *, limit: int
) -> Item:
    """The item of one file; ValueError or OSError says why it is not usable."""
    entry = entries.get(path)
    category = _category(path, entry, known)
    model = read_model(_read(directory, path, limit))
    size = model.bounds[1] - model.bounds[0]
    problem = size_problem(size)
    if problem:
        raise ValueError(problem)
    width, height, depth = (max(SMALLEST, float(length)) for length in size)
    stem = path.rsplit(".", 1)[0]
    return Item(
        id=stem if len(stem) <= MAX_ID else sha256(stem.encode()).hexdigest()[:32],
        name=((entry.name if entry else "") or _name(stem, category))[:MAX_NAME],
        category=category,
        size=(depth, width, height),
        data=_moved(model, -_origin(model.bounds, category)),
    )


def _category(path: str, entry: Entry | None, known: dict[str, str]) -> str:
    """The category's own spelling of what the manifest, folder or name says."""
    folder, _, file = path.rpartition("/")
    said = entry.category if entry else folder or file.split("-", 1)[0].rsplit(".", 1)[0]
    word = said.casefold()
    category = known.get(word) or known.get(word.removesuffix("s"))
    if category is None:
        names = ", ".join(known.values())
        raise ValueError(f"there is no category {said!r}; put it in a folder named {names}")
    return category


def _name(stem: str, category: str) -> str:
    """A name for people: the file's own, without the category before it."""
    words = stem.rpartition("/")[2].replace("_", "-").split("-")
    if len(words) > 1 and words[0].casefold() == category.casefold():
        words = words[1:]
    return " ".join(words).strip().capitalize() or category


def _read(directory: Path, path: str, limit: int) -> bytes:
    """The bytes of a file that lies inside the directory, however it is named or linked."""
    root, file = directory.resolve(), (directory / path).resolve()
    if not file.is_relative_to(root):
        raise ValueError("it lies outside of the catalogue; copy it there")
    if not file.is_file():
        raise ValueError("there is no such file; correct catalogue.json")
    with file.open("rb") as stream:
        data = stream.read(limit + 1)
    if len(data) > limit:
        raise ValueError(f"it is larger than the {limit / 1e6:.1f} MB left for it; simplify it")
    return data


def _origin(bounds: Floats, category: str) -> Floats:
    """Where the origin belongs: the center of the base, or of the back on the wall: (3,)."""
    middle = bounds.mean(axis=0)
    if on_wall(category):
        return np.array([middle[0], middle[1], bounds[0, 2]])
    return np.array([middle[0], bounds[0, 1], middle[2]])


def _moved(model: Model, by: Floats) -> bytes:
    """The model, without animations, cameras and lights, inside one node that shifts it."""
    packer = Packer()
    packer.gltf.asset.copyright = model.gltf.asset.copyright
    try:
        inner = Guest(packer, model.gltf).stand(model.roots)
        return packer.glb([packer.node("placed", translation=by.tolist(), children=inner)])
    except RecursionError:
        raise ValueError("its JSON is nested too deeply; export it again") from None
