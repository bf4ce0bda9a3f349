"""Plain words for where something stands: "against the north wall, 1.1 m from the table"."""

from __future__ import annotations

from math import pi, sqrt

import numpy as np
import shapely

from scenegen_core.graph.situation import Situation
from scenegen_core.graph.wording import metres, spoken
from scenegen_core.placement.mounts import SUPPORTS
from scenegen_core.scene.geometry import TIE, Floats, directions, gaps, walls_as_rectangles
from scenegen_core.scene.model import Box, Category, Opening, Symmetry

AGAINST = 0.25  # metres between footprint and wall that people still call "against"
CLOSE_BY = 0.8  # metres between footprint and wall that people call "near"
BESIDE = 0.35  # metres between two things that people call "next to"
IN_VIEW = 6.0  # metres as far as something is faced
NEIGHBOR = 3.0  # metres as far as a distance is worth telling
DUST = 6  # digits of a metre beyond which gaps differ by rounding only
ON_TOP = 0.1  # metres between an underside and the top that it stands on
CENTRAL = 0.2  # of the side of a square as large as the room: so far reaches its middle
FACING_GROUPS = ("TV", "Table", "Sofa", "Bed", "Picture", "Storage", "Chair")
"""What a sentence says is faced, the most telling first."""
UNTOLD_GROUPS = ("Other", "Decor", "Picture")
"""What nobody would measure a distance from."""

COMPASS = ("east", "north-east", "north", "north-west", "west", "south-west", "south", "south-east")


def sentence(situation: Situation, category: Category) -> str:
    """One sentence on the single pose of a situation, without its subject."""
    faced = faced_from(situation) if category.symmetry is Symmetry.ASYMMETRIC else None
    neighbor = _neighbor(situation, faced)
    parts = [_place(situation)]
    if neighbor is not None:
        parts.append(_beside(situation, neighbor))
    if faced is not None:
        parts.append(_facing(faced, neighbor))
    elif category.symmetry is Symmetry.ASYMMETRIC:
        parts.append(f"facing {compass(float(situation.candidates.headings[0]))}")
    text = ", ".join(parts)
    return text[0].upper() + text[1:]


def compass(heading: float) -> str:
    """The side of the plan that a heading looks to; north is up (+y)."""
    return COMPASS[round(heading / (pi / 4)) % 8]


def _place(situation: Situation) -> str:
    carrier = carrier_of(situation)
    if carrier is not None:
        return f"on the {spoken(carrier)}"
    walls, near = situation.surroundings.walls, situation.wall_gaps[0]
    if situation.candidates.bottoms[0] > AGAINST:
        wall = wall_behind(situation)
        return f"on the {wall} wall" if wall else "hanging"
    nearest = nearest_wall(situation)
    window = _by_window(situation)
    if near.min() < AGAINST:
        corner = corner_of(walls, near)
        return f"in the {corner} corner" if corner else f"against the {nearest} wall{window}"
    if near.min() < CLOSE_BY:
        return f"near the {nearest} wall{window}"
    return f"{'in the middle of' if is_central(situation) else 'out in'} the room{window}"


def nearest_wall(situation: Situation) -> str:
    """The side of the plan of the wall that is nearest."""
    near = situation.wall_gaps[0]
    outward = situation.surroundings.inward + pi
    return compass(float(outward[(near <= near.min() + TIE).argmax()]))


def wall_behind(situation: Situation) -> str:
    """The side of the plan of the wall that it hangs on; empty if none is so close."""
    near = situation.wall_gaps[0]
    outward = situation.surroundings.inward + pi
    behind = np.cos(outward - situation.candidates.headings[0])
    back = np.where(near < AGAINST, behind, np.inf).argmin()
    return compass(float(outward[back])) if near[back] < AGAINST else ""


def corner_of(walls: Floats, near: Floats) -> str:
    """The side of the plan of the corner between two walls that are touched; empty if none."""
    run = walls[:, 1] - walls[:, 0]
    unit = run / np.hypot(run[:, 0], run[:, 1])[:, None]
    after = np.roll(unit, -1, axis=0)
    turns = unit[:, 0] * after[:, 1] - unit[:, 1] * after[:, 0]
    touched = near < AGAINST
    found = touched & np.roll(touched, -1) & (turns > sqrt(0.5))
    if not found.any():
        return ""
    x, y = (unit - after)[found.argmax()]  # from the middle into the corner
    return compass(float(np.arctan2(y, x)))


def is_central(situation: Situation) -> bool:
    """Is the single pose in the middle of the room?"""
    room = shapely.Polygon(situation.surroundings.scene.room.corners)
    x, y, _ = situation.candidates.centers[0]
    return bool(np.hypot(x - room.centroid.x, y - room.centroid.y) < CENTRAL * sqrt(room.area))


def _by_window(situation: Situation) -> str:
    windows = situation.surroundings.scene.room.windows
    if not is_by(situation, windows):
        return ""
    return " by the window" if len(windows) == 1 else " by a window"


def is_by(situation: Situation, openings: tuple[Opening, ...]) -> bool:
    """Is one of the doors or windows close by?"""
    if not openings:
        return False
    segments = walls_as_rectangles(np.array([(o.start, o.end) for o in openings], dtype=float))
    return bool(gaps(situation.candidates.footprints, segments).min() < CLOSE_BY)


def carrier_of(situation: Situation) -> Box | None:
    """The box that it stands on, if any."""
    around, candidates = situation.surroundings, situation.candidates
    carriers = SUPPORTS.get(candidates.category, ())
    for index in np.flatnonzero(situation.meets[0]):
        box = around.scene.boxes[index]
        if box.category in carriers and abs(box.top - candidates.bottoms[0]) < ON_TOP:
            return box
    return None


def _neighbor(situation: Situation, faced: Box | None) -> Box | None:
    """The nearest piece that one would measure from, besides what is faced from afar."""
    unasked = (*UNTOLD_GROUPS, situation.candidates.category)
    stands = carrier_of(situation) is not None
    boxes = situation.surroundings.scene.boxes
    told = [
        (gap, index)
        for index, gap in enumerate(_gaps(situation).tolist())
        if boxes[index].category not in unasked
        and gap <= NEIGHBOR
        and (boxes[index] is not faced or gap < 0)
        and (not stands or gap >= 0)
    ]
    return boxes[min(told)[1]] if told else None


def _beside(situation: Situation, box: Box) -> str:
    """How it stands to a box near by."""
    index = situation.surroundings.scene.boxes.index(box)
    gap = float(situation.gaps[0, index])
    if _gaps(situation)[index] < 0:
        return f"{lies_to(situation, box)} the {spoken(box)}"
    return f"next to the {spoken(box)}" if gap < BESIDE else f"{metres(gap)} from the {spoken(box)}"


def _gaps(situation: Situation) -> Floats:
    """The gaps of the single pose; what touches is at 0, wherever rounding puts it: (m,)."""
    return np.asarray(situation.gaps[0].round(DUST), dtype=np.float64)


def lies_to(situation: Situation, box: Box) -> str:
    """How it lies to a box over the same floor: above, under or at it."""
    if situation.candidates.bottoms[0] >= box.top - AGAINST:
        return "above"
    return "under" if situation.candidates.tops[0] <= box.bottom + AGAINST else "at"


def _facing(faced: Box, neighbor: Box | None) -> str:
    """What it faces, once something near by has been named."""
    if neighbor is None or spoken(faced) != spoken(neighbor):
        return f"facing the {spoken(faced)}"
    return "facing it" if faced is neighbor else f"facing another {spoken(faced)}"


def faced_from(situation: Situation) -> Box | None:
    """The most telling thing ahead, within sight; of one kind the nearest."""
    around = situation.surroundings
    toward = directions(situation.candidates.headings)[0]
    ahead = (around.centers[:, :2] - situation.candidates.centers[0, :2]) @ toward > 0
    gap = _gaps(situation)
    seen = [
        (FACING_GROUPS.index(box.category), gap[index], index)
        for index, box in enumerate(around.scene.boxes)
        if box.category in FACING_GROUPS
        and situation.faces[0, index]
        and ahead[index]
        and gap[index] < IN_VIEW
        and (gap[index] >= 0 or lies_to(situation, box) == "at")
    ]
    return around.scene.boxes[min(seen)[2]] if seen else None
