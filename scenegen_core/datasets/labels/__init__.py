"""What the sources call things: raw label → category, one reviewed CSV a source."""

from __future__ import annotations

import csv
from importlib.resources import files


def categories_of(source: str) -> dict[str, str | None]:
    """The category of every label of a source; None for walls and other parts of the room."""
    text = files(__name__).joinpath(f"{source}.csv").read_text(encoding="utf-8")
    return {row["label"]: row["category"] or None for row in csv.DictReader(text.splitlines())}
