"""What ``scenegen place`` says beyond the places: why not here, what would help, what matters."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import asdict, dataclass
from typing import Any

from scenegen_core.errors import SceneError
from scenegen_core.knowledge import Knowledge
from scenegen_core.placement.answer import Inspection, Query
from scenegen_core.placement.mounts import HANGING_HEIGHT, Mount, mounts
from scenegen_core.placement.remedies import find_remedy
from scenegen_core.placement.solve import solve
from scenegen_core.placement.what_if import what_matters
from scenegen_core.scene.model import Scene

NOTHING_HELPS = "Neither 70 % of its size, nor one thing less, nor one rule less would give it one."


@dataclass(frozen=True, slots=True)
class Asked:
    """An object that was asked about, and the room that it was to go in."""

    scene: Scene
    query: Query
    knowledge: Knowledge


@dataclass(frozen=True, slots=True)
class More:
    """Something to say, in words and as plain data."""

    lines: tuple[str, ...]
    data: dict[str, Any]


def remedy(asked: Asked) -> More:
    """The nearest thing that gives a place where there is none."""
    found = find_remedy(asked.scene, asked.query, asked.knowledge)
    text = NOTHING_HELPS if found is None else found.text
    return More((f"  {text}",), {"remedy": None if found is None else asdict(found)})


def why_not(asked: Asked, x: float, y: float, heading: float) -> More:
    """What speaks against a spot, and what it would take."""
    solution = solve(asked.scene, asked.query, asked.knowledge)
    answer = solution.answer
    hangs = mounts(answer.category, answer.size)[0] is Mount.WALL
    z = HANGING_HEIGHT[answer.category] if hangs else answer.size[2] / 2
    seen = solution.inspect((x, y, z), heading)
    lines = tuple(_told(f"At ({x:g}, {y:g})", seen))
    return More(lines, {"why_not": {**asdict(seen), "center": [x, y, z], "yaw": heading}})


def _told(where: str, seen: Inspection) -> Iterator[str]:
    yield f"{where}: {seen.sentence}"
    for cost in seen.costs:
        best = f" (at the best place: {cost.best})" if cost.best not in ("", cost.here) else ""
        yield f"  {cost.difference:+.2f}  {cost.here or 'nothing to say'}{best}"
    if seen.elsewhere is not None:
        word = "Better" if seen.allowed else "It may stand"
        yield f"  {word} {seen.elsewhere.text}: {seen.elsewhere.sentence}"


def what_if(asked: Asked) -> More:
    """Which box matters most to the best place."""
    answer = solve(asked.scene, asked.query, asked.knowledge).answer
    if not answer.poses:
        raise SceneError("There is no good place, so nothing can matter to it; try a smaller one.")
    found = what_matters(asked.scene, asked.query, answer, asked.knowledge)
    text = "No single thing matters to the place." if found is None else found.text
    return More((text,), {"what_if": None if found is None else asdict(found)})
