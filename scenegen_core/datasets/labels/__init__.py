"""What the sources call things: raw label → category, one reviewed CSV a source."""

from __future__ import annotations

import csv
from functools import cache
from importlib.resources import files
from pathlib import Path
from types import MappingProxyType

from scenegen_core.datasets.remarks import Report, UnknownLabel
from scenegen_core.scene.model import OTHER, PAPER_CATEGORIES, Symmetry

_FACES_SOMEWHERE = {c.name for c in PAPER_CATEGORIES if c.symmetry is not Symmetry.SYMMETRIC}


@cache
def categories_of(source: str) -> MappingProxyType[str, str | None]:
    """The category of every label of a source; None for walls and other parts of the room."""
    text = files(__name__).joinpath(f"{source}.csv").read_text(encoding="utf-8")
    table = csv.DictReader(text.splitlines())
    return MappingProxyType({row["label"]: row["category"] or None for row in table})


def category_of(source: str, label: str, path: Path, report: Report) -> str | None:
    """The category of a label, None for parts of the room; an unknown one is reported: Other."""
    categories = categories_of(source)
    if label not in categories:
        report(UnknownLabel(path, source, label))
    return categories.get(label, OTHER)


def faces_somewhere(category: str) -> bool:
    """Whether things of the category have a front."""
    return category in _FACES_SOMEWHERE
