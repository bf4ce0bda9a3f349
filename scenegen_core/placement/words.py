"""Plain words for where something stands: "against the north wall, 1.1 m from the table"."""

from __future__ import annotations

import re
from math import pi

import numpy as np

from scenegen_core.graph.relations import ABSENT
from scenegen_core.graph.situation import Situation
from scenegen_core.placement.mounts import SUPPORTS
from scenegen_core.placement.proposals import inward
from scenegen_core.scene.geometry import directions, distances_to_segments
from scenegen_core.scene.model import Box, Category, Symmetry

AGAINST = 0.25  # metres between footprint and wall that people still call "against"
CLOSE_BY = 0.8  # metres between footprint and wall that people call "near"
BESIDE = 0.35  # metres between two things that people call "next to"
IN_VIEW = 6.0  # metres as far as something is faced
NEIGHBOR = 3.0  # metres as far as a distance is worth telling
FACING_GROUPS = ("TV", "Table", "Sofa", "Bed", "Picture", "Storage", "Chair")
"""What a sentence says is faced, the most telling first."""

COMPASS = ("east", "north-east", "north", "north-west", "west", "south-west", "south", "south-east")


def sentence(situation: Situation, category: Category) -> str:
    """One sentence on the single pose of a situation, without its subject."""
    parts = [_place(situation, category), *_neighbor(situation), *_front(situation, category)]
    text = ", ".join(part for part in parts if part)
    return text[0].upper() + text[1:]


def spoken(box: Box) -> str:
    """What people call a box: its label in plain lower case, else its category."""
    words = re.sub(r"(?<=[a-z])(?=[A-Z])", " ", box.label or box.category).replace("_", " ")
    return words if words == "TV" or words.startswith("TV ") else words.lower()


def metres(length: float) -> str:
    """A length as people say it."""
    return f"{length:.1f} m" if length >= 0.95 else f"{round(length * 100, -1):.0f} cm"  # noqa: PLR2004 (1.0 m)


def compass(heading: float) -> str:
    """The side of the plan that a heading looks to; north is up (+y)."""
    return COMPASS[round(heading / (pi / 4)) % 8]


def side_of_wall(situation: Situation, wall: int) -> str:
    """Which wall it is: the side of the room that it closes."""
    return compass(float(inward(situation.surroundings.walls)[wall]) + pi)


def _place(situation: Situation, category: Category) -> str:
    carrier = _carrier(situation)
    if carrier is not None:
        return f"on the {spoken(carrier)}"
    near = situation.wall_gaps[0]
    order = np.argsort(near, kind="stable")
    sides = list(
        dict.fromkeys(side_of_wall(situation, wall) for wall in order if near[wall] < AGAINST)
    )
    hangs = situation.candidates.bottoms[0] > AGAINST
    if hangs:
        return f"on the {sides[0]} wall" if sides else "on the wall"
    window = _by_window(situation)
    if len(sides) > 1 and (corner := _corner(sides[0], sides[1])):
        return f"in the {corner} corner"
    if sides:
        return f"against the {sides[0]} wall{window}"
    if near[order[0]] < CLOSE_BY:
        return f"near the {side_of_wall(situation, order[0])} wall{window}"
    return (
        f"in the open floor{window}"
        if category.symmetry is not Symmetry.SYMMETRIC
        else (f"in the middle of the floor{window}")
    )


def _corner(one: str, two: str) -> str:
    """Give "north-west" of "west" and "north"; empty if they do not make a corner."""
    pair = {one, two}
    return next((name for name in COMPASS if "-" in name and set(name.split("-")) == pair), "")


def _by_window(situation: Situation) -> str:
    windows = situation.surroundings.scene.room.windows
    if not windows:
        return ""
    segments = np.array([(w.start, w.end) for w in windows], dtype=float)
    center = situation.candidates.centers[:, :2]
    reach = max(situation.candidates.size[:2]) / 2 + CLOSE_BY
    return " by the window" if distances_to_segments(center, segments).min() < reach else ""


def _carrier(situation: Situation) -> Box | None:
    """The box that it stands on, if any."""
    around, candidates = situation.surroundings, situation.candidates
    carriers = SUPPORTS.get(candidates.category, ())
    for index in np.flatnonzero(situation.meets[0]):
        box = around.scene.boxes[index]
        if box.category in carriers and abs(box.top - candidates.bottoms[0]) < BESIDE / 4:
            return box
    return None


def _neighbor(situation: Situation) -> list[str]:
    """How far the nearest piece is that one would measure from."""
    boxes = situation.surroundings.scene.boxes
    faced = _faced(situation)
    carrier = _carrier(situation)
    told = [
        (float(situation.gaps[0, i]), box)
        for i, box in enumerate(boxes)
        if box.category not in ("Other", "Decor", "Picture", situation.candidates.category)
        and box is not faced
        and box is not carrier
    ]
    if not told:
        return []
    gap, box = min(told, key=lambda pair: pair[0])
    if gap > NEIGHBOR:
        return []
    if gap < 0:
        over = situation.candidates.bottoms[0] >= box.top - AGAINST
        return [f"above the {spoken(box)}" if over else f"at the {spoken(box)}"]
    return [
        f"next to the {spoken(box)}" if gap < BESIDE else f"{metres(gap)} from the {spoken(box)}"
    ]


def _front(situation: Situation, category: Category) -> list[str]:
    if category.symmetry is not Symmetry.ASYMMETRIC:
        return []
    faced = _faced(situation)
    if faced is not None:
        return [f"facing the {spoken(faced)}"]
    return [f"facing {compass(float(situation.candidates.headings[0]))}"]


def _faced(situation: Situation) -> Box | None:
    """The most telling thing ahead, within sight."""
    around = situation.surroundings
    ahead = situation.faces[0] & (situation.gaps[0] < IN_VIEW) & (situation.gaps[0] > 0)
    toward = directions(situation.candidates.headings)[0]
    side = (around.centers[:, :2] - situation.candidates.centers[0, :2]) @ toward
    seen = [around.scene.boxes[i] for i in np.flatnonzero(ahead & (side > 0))]
    ranked = [box for group in FACING_GROUPS for box in seen if box.category == group]
    return ranked[0] if ranked else None


def reason_text(relation: str, group: str, value: float) -> str:
    """What one column of a feature vector says, in words."""
    count = round(value)
    name = group if group == "TV" else group.lower()
    names = name if count == 1 or name in ("storage", "decor", "other") else f"{name}s"
    texts = {
        "RP": f"near {count} wall{'' if count == 1 else 's'}" if count else "away from the walls",
        "AD": f"{metres(value)} from the {name}" if value < ABSENT else f"no {name} in the room",
        "S": f"{count} {names} within 1 m" if count else f"no {name} within 1 m",
        "SP": {1: f"stands on {name}", -1: f"stands under {name}"}.get(count, f"not on {name}"),
        "TC": "faces the middle of the room" if count else "turned to a near wall",
        "AW": "its back to the nearest wall" if count else "its back to no wall",
        "DS": f"{count} neighbors face the {group} way"
        if count
        else f"no neighbor faces the {group} way",
        "F": f"faces {count} {names}" if count else f"faces no {name} close by",
        "NT": f"next to {count} {names}" if count else f"next to no {name}",
    }
    return texts[relation]
