"""What a relation says in plain English: "faces the TV", "1.1 m from the tables"."""

from __future__ import annotations

import re

from scenegen_core.scene.model import Box

CORNER = 2  # walls; whoever is near two or more is near a corner (paper, RoomPosition)

TOUCHING = 0.05  # metres; a distance that is shown as none
LONG = 0.95  # metres; from here on lengths are told in metres ("1.0 m"), below in centimetres

WORDS = re.compile(r"(?<=[a-z])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z]{2})")
"""Where the words of CoffeeTable and TVStand part."""

SINGULAR = {"Decor": "decor piece", "Storage": "storage piece", "Other": "other thing"}
"""Categories whose name is no word for one thing."""


def noun(name: str) -> str:
    """One thing of a category, or of a label, within a sentence: TV unit, storage piece."""
    spaced = WORDS.sub(" ", SINGULAR.get(name, name)).replace("_", " ")
    return " ".join(word if word.isupper() else word.lower() for word in spaced.split())


def spoken(box: Box) -> str:
    """What people call a box within a sentence: by its label, else by its category."""
    return noun(box.label or box.category)


def nouns(category: str) -> str:
    """Several things of a category within a sentence: chairs, TVs, storage pieces."""
    return f"{noun(category)}s"


def metres(length: float) -> str:
    """A length as people say it: 1.1 m, 40 cm."""
    return f"{length:.1f} m" if length >= LONG else f"{round(length * 100, -1):.0f} cm"


def the(name: str, count: int) -> str:
    """All things of a category within a sentence: the table, the tables."""
    return f"the {noun(name) if count == 1 else nouns(name)}"


def some(category: str, count: int, members: int) -> str:
    """So many of a category's members: the table, one of the tables, 2 tables."""
    if count == 1:
        return the(category, 1) if members == 1 else f"one of {the(category, members)}"
    return f"{count} {nouns(category)}"


def about_room(relation: str, value: float) -> str:
    """What a relation to the room says."""
    match relation:
        case "RoomPosition" if value == 0:
            return "in the middle of the room"
        case "RoomPosition":
            return "near one wall" if value < CORNER else "near a corner"
        case "TowardsCenter":
            return "faces into the room"
        case _:
            return "has its back to the wall"


def about_group(relation: str, value: float, category: str, members: int) -> str:
    """What a relation to a group of so many members says, or to one thing of that label."""
    those = some(category, round(abs(value)), members)
    match relation:
        case "AverageDistance" if value < TOUCHING:
            return f"right at {the(category, members)}"
        case "AverageDistance":
            return f"{metres(value)} from {the(category, members)}"
        case "SurroundedBy":
            return f"close to {those}"
        case "Support":
            return f"{'stands on' if value > 0 else 'is under'} {those}"
        case "Facing":
            return f"faces {those}"
        case _:
            return f"next to {those}"


def about_direction(part: str, name: str) -> str:
    """What DirectionSimilarity says of one neighbor."""
    way = "the same way as" if part == "same" else "the opposite way to"
    return f"faces {way} {the(name, 1)}"


def about_membership(category: str, members: int) -> str:
    """That something belongs to its group of so many."""
    return f"the only {noun(category)}" if members == 1 else f"one of the {nouns(category)}"
