"""What each column of the model of choices measures, in plain words with its unit."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from math import degrees, inf

from scenegen_core.graph.relations import Column
from scenegen_core.graph.wording import noun, nouns
from scenegen_core.knowledge.choice import ANGLES, COUNTS, FLAG, edges_of

LIES = "where {one} lies (0 ahead, 180 behind), °"
AMONG = "off the middle between {walls} (0 midway, 1 at one)"

WORDS = {
    ("W", "behind"): "from its back to the wall, m",
    ("W", "ahead"): "from its front to the wall, m",
    ("W", "side"): "from its side to the wall, m",
    ("W", "far side"): "from its other side to the wall, m",
    ("W", "nearest"): "gap to the nearest wall, m",
    ("W", "second"): "gap to the second nearest wall, m",
    ("W", "flush"): "walls that it touches",
    ("W", "turn"): "turned from its back to the nearest wall, °",
    ("W", "centered"): AMONG.format(walls="the walls at its sides"),
    ("FS", "behind"): "free behind it, m",
    ("FS", "ahead"): "free in front of it, m",
    ("FS", "side"): "free at its side, m",
    ("FS", "far side"): "free at its other side, m",
    ("FS", "centered"): AMONG.format(walls="what is at its sides"),
    ("FS", "nearest"): "gap to the nearest thing, m",
    ("FS", "touching"): "things that it touches",
    ("FS", "within a metre"): "things within 1 m",
    ("M", "distance"): "from the middle of the room, in sizes of the room",
    ("M", "bearing"): LIES.format(one="the middle of the room"),
    ("H", ""): "height of its underside, m",
    ("MI", "distance"): "from where it would make a pair, m",
    ("MI", "turn"): "turned from where it would make a pair, °",
    ("SZ", "depth"): "its own depth, m",
    ("SZ", "width"): "its own width, m",
    ("SZ", "height"): "its own height, m",
    ("SZ", "room"): "size of the room, m²",
}
"""By relation and part."""

OF_ONE = {
    "gap": "gap to {one}, m",
    "near": "{several} within 1 m",
    "before": "in front of {one} (below 0 behind), m",
    "offset": "aside of the middle of {one}, m",
    "bearing": LIES,
    "turn": "turned against {one}, °",
    "faced": "is it in front of {one}?",
    "lateral": "how far aside {one} lies, seen from it, m",
    "beside": "beyond the side of {one}, m",
    "on": "does it stand on one of the {several}?",
    "top": "how high {one} reaches, m",
    "long": "longer side of {one}, m",
}
"""By part, where the relation is to the nearest of a kind."""

KINDS = {
    "TW": ("another just like it", "others just like it"),
    "DR": ("the nearest door", "doors"),
    "WN": ("the nearest window", "windows"),
}


def words(column: Column) -> str:
    """What a column measures: "gap to the nearest table, m"."""
    if (column.relation, column.part) in WORDS:
        return WORDS[column.relation, column.part]
    one, several = KINDS.get(column.relation) or (
        f"the nearest {noun(column.group)}",
        nouns(column.group),
    )
    return OF_ONE[column.part].format(one=one, several=several)


def bin_words(column: Column) -> tuple[str, ...]:
    """What each bin of a column holds: "0.1 to 0.15", "yes", "5 to 6"."""
    edges = edges_of(column)
    if edges == FLAG:
        return ("no", "yes")
    if edges == COUNTS:
        return tuple(_counts(edges))
    limits = [f"{_shown(edge, edges):g}" for edge in edges]
    inner = (f"{low} to {high}" for low, high in itertools.pairwise(limits))
    return (f"below {limits[0]}", *inner, f"{limits[-1]} or more")


def edge_words(column: Column) -> tuple[str, ...]:
    """What to write where two bins meet: "0.15"; degrees for angles."""
    edges = edges_of(column)
    return tuple(f"{_shown(edge, edges):g}" for edge in edges)


def is_counted(column: Column) -> bool:
    """Do the bins hold whole numbers, or yes and no?"""
    return edges_of(column) in (FLAG, COUNTS)


def _shown(edge: float, edges: tuple[float, ...]) -> float:
    return round(degrees(edge), 1) if edges == ANGLES else edge


def _counts(edges: tuple[float, ...]) -> Iterator[str]:
    limits = (-0.5, *edges, inf)
    for low, high in itertools.pairwise(limits):
        first, last = low + 0.5, high - 0.5
        yield (
            f"{first:g}+"
            if last == inf
            else f"{first:g}"
            if first == last
            else f"{first:g}–{last:g}"
        )
