"""What a relation says in plain English: "faces the TV", "1.1 m from the tables"."""

from __future__ import annotations

CORNER = 2  # walls; whoever is near two or more is near a corner (paper, RoomPosition)

TOUCHING = 0.05  # metres; a distance that is shown as none

SINGULAR = {"Decor": "decor piece", "Storage": "storage piece", "Other": "other thing"}
"""Categories whose name is no word for one thing."""


def noun(category: str) -> str:
    """One thing of a category within a sentence: chair, TV, storage piece."""
    word = SINGULAR.get(category, category)
    return word if word.isupper() else word.lower()


def nouns(category: str) -> str:
    """Several things of a category within a sentence: chairs, TVs, storage pieces."""
    return f"{noun(category)}s"


def the(category: str, count: int) -> str:
    """All things of a category within a sentence: the table, the tables."""
    return f"the {noun(category) if count == 1 else nouns(category)}"


def some(category: str, count: int) -> str:
    """So many things of a category within a sentence: a table, 2 tables."""
    return f"1 {noun(category)}" if count == 1 else f"{count} {nouns(category)}"


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
    """What a relation to a group says; ``members`` are those that the value is about."""
    count = round(abs(value))
    those = the(category, 1) if members == 1 else some(category, count)
    match relation:
        case "AverageDistance" if value < TOUCHING:
            return f"right at {the(category, members)}"
        case "AverageDistance":
            return f"{value:.1f} m from {the(category, members)}"
        case "SurroundedBy":
            return f"close to {those}"
        case "Support":
            return f"{'stands on' if value > 0 else 'is under'} {those}"
        case "Facing":
            return f"faces {those}"
        case _:
            return f"next to {those}"


def about_direction(part: str, category: str) -> str:
    """What DirectionSimilarity says of one neighbor."""
    way = "the same way as" if part == "same" else "the opposite way to"
    return f"faces {way} {the(category, 1)}"


def about_membership(category: str, members: int) -> str:
    """That something belongs to its group of so many."""
    return f"the only {noun(category)}" if members == 1 else f"one of the {nouns(category)}"
