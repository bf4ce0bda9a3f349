"""Cases: an object taken out of its room; and folds that keep every home on one side."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from hashlib import blake2b
from itertools import accumulate, islice

import numpy as np

from scenegen_core.errors import DataError
from scenegen_core.scene.geometry import footprints, gaps
from scenegen_core.scene.model import OTHER, Box, Scene
from scenegen_core.scene.resting import taken_out


@dataclass(frozen=True, slots=True)
class Case:
    """One question: where did ``box`` stand in ``scene``, which lacks it?"""

    scene: Scene
    box: Box

    @property
    def source(self) -> str:
        """The source of the room."""
        return self.scene.source

    @property
    def key(self) -> str:
        """Names the case among all: source, room and box."""
        return f"{self.source}:{self.scene.id}#{self.box.id}"


def cases(scenes: Iterable[Scene], categories: Iterable[str]) -> tuple[Case, ...]:
    """A case for every box of a category that can be placed."""
    wanted = set(categories) - {OTHER}
    return tuple(
        Case(taken_out(scene, box.id), box)
        for scene in scenes
        for box in scene.boxes
        if box.category in wanted
    )


def emptier(case: Case, most: int, categories: Iterable[str]) -> tuple[Case, ...]:
    """The case without the nearest thing of these categories too, without the nearest two, …, most.

    () if the room has fewer. Nearest by the gap between footprints, below 0 where they overlap:
    those are what the answer hangs on most.
    """
    wanted = set(categories) - {OTHER}
    boxes = [box for box in case.scene.boxes if box.category in wanted]
    if len(boxes) < most:
        return ()
    away = gaps(footprints([case.box]), footprints(boxes))[0]
    gone = [boxes[index].id for index in np.argsort(away, kind="stable")[:most]]
    scenes = accumulate(gone, Scene.without, initial=case.scene)
    return tuple(Case(scene, case.box) for scene in islice(scenes, 1, None))


def home_of(scene: Scene) -> str:
    """The home that a room belongs to: the id up to "/"; rooms without homes are their own."""
    return f"{scene.source}:{scene.id.split('/')[0]}"


def folds(
    scenes: Sequence[Scene], count: int, *, rng: np.random.Generator
) -> tuple[tuple[Scene, ...], ...]:
    """The scenes in ``count`` parts of about equal size, no home (or copied layout) in two.

    DataError if there are fewer homes than parts.
    """
    groups = _groups(scenes)
    if len(groups) < count:
        raise DataError(
            f"These rooms come from {len(groups)} home{'s'[: len(groups) != 1]}, too few for "
            f"{count} folds; give more rooms, or ask for fewer folds."
        )
    parts: list[list[Scene]] = [[] for _ in range(count)]
    for index in rng.permutation(len(groups)):
        min(parts, key=len).extend(groups[index])
    return tuple(tuple(part) for part in parts)


def _groups(scenes: Sequence[Scene]) -> list[list[Scene]]:
    """Scenes that share a home or a layout, joined."""
    group_of: dict[str, int] = {}
    groups: list[list[Scene]] = []
    for scene in scenes:
        names = (home_of(scene), _layout(scene))
        known = sorted({group_of[name] for name in names if name in group_of})
        if not known:
            known = [len(groups)]
            groups.append([])
        target, *others = known
        groups[target].append(scene)
        for other in others:
            groups[target] += groups[other]
            groups[other] = []
        for name in (*names, *(n for n, g in group_of.items() if g in others)):
            group_of[name] = target
    return [group for group in groups if group]


def _layout(scene: Scene) -> str:
    """A digest of outline and furniture: copies of one layout share it."""
    parts = [[round(x, 2) for corner in scene.room.corners for x in corner]]
    parts += [[round(x, 2) for x in (*box.center, *box.size)] for box in scene.boxes]
    return "layout:" + blake2b(repr(parts).encode(), digest_size=8).hexdigest()
