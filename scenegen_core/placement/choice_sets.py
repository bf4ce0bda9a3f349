"""Choice sets: what people chose, and some of what they could have chosen in the same room.

The one that counts as chosen is the proposal nearest to where the object really stands: otherwise a
model learns to tell exact poses from poses on a grid. It must be possible like the others, or the
model learns that overlapping means real.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from hashlib import blake2b

import numpy as np

from scenegen_core.graph.own_relations import OWN_RELATIONS
from scenegen_core.graph.relations import measure
from scenegen_core.graph.situation import Situation
from scenegen_core.graph.surroundings import Surroundings
from scenegen_core.knowledge.choice import Bins, binned, choice_columns
from scenegen_core.placement.feasible import ALLOWED, Space, verdicts
from scenegen_core.placement.proposals import Proposals, propose
from scenegen_core.scene.geometry import Bools, Floats, Ints, wrapped
from scenegen_core.scene.model import OTHER, Box, Category, Scene, Symmetry
from scenegen_core.scene.resting import taken_out

SNAP = 0.45  # metres; no further than this may the nearest proposal be from the truth
SNAP_TURN = dict.fromkeys(Symmetry, np.pi / 8 + 0.01) | {Symmetry.SYMMETRIC: np.pi / 4 + 0.01}
"""Radians; no further than this may its heading be: of what has no front, quarters are tried."""
TURN_COSTS = 0.25  # metres a radian, where proposals are compared with the truth
HEIGHT_COSTS = 0.3  # metres a metre of height
NEAREST = 40  # proposals near the truth that are tried
TRIED = (600, 240)  # other proposals that are tried, free ones and flush ones
KEPT = (120, 80)  # of the possible ones among them, how many are kept


@dataclass(frozen=True, eq=False)
class ChoiceSet:
    """A choice: the pose in the first row was chosen among all."""

    category: str
    room: str
    source: str
    bins: Bins
    """(poses, columns)."""
    log_weights: Floats
    """log of how many possible poses each row stands for: (poses,)."""


def choice_sets(scenes: Sequence[Scene], groups: tuple[Category, ...]) -> tuple[ChoiceSet, ...]:
    """A choice of every box that could be proposed about where it stands."""
    return tuple(found for scene in scenes for found in _of_scene(scene, groups))


def _of_scene(scene: Scene, groups: tuple[Category, ...]) -> Iterator[ChoiceSet]:
    by_name = {group.name: group for group in groups if group.name != OTHER}
    for box in scene.boxes:
        if box.category in by_name:
            found = _choice(scene, box, by_name[box.category], groups)
            if found is not None:
                yield found


def _choice(
    scene: Scene, box: Box, category: Category, groups: tuple[Category, ...]
) -> ChoiceSet | None:
    around = Surroundings(taken_out(scene, box.id), groups)
    space = Space.of(around)
    proposals = propose(around, category, box.size)
    chosen = _nearest(proposals, box, category, around, space)
    if chosen is None:
        return None
    others, weights = _alternatives(proposals, chosen, around, space, rng=_rng(scene, box))
    rows = np.concatenate([[chosen], others])
    features = measure(OWN_RELATIONS, Situation(proposals.candidates[rows], around))
    return ChoiceSet(
        category=box.category,
        room=scene.id,
        source=scene.source,
        bins=binned(features, choice_columns(groups)),
        log_weights=np.concatenate([[0.0], np.log(weights)]),
    )


def _nearest(
    proposals: Proposals, box: Box, category: Category, around: Surroundings, space: Space
) -> int | None:
    """The possible proposal nearest to the box; None if none is near."""
    candidates = proposals.candidates
    away = np.hypot(*(candidates.centers[:, :2] - np.array(box.center[:2])).T)
    turn = _turns(candidates.headings, box, category)
    higher = np.abs(candidates.centers[:, 2] - box.center[2])
    cost = away + TURN_COSTS * turn + HEIGHT_COSTS * np.minimum(higher, 1)
    near = np.flatnonzero((away < SNAP) & (turn < SNAP_TURN[category.symmetry]))
    near = near[np.argsort(cost[near], kind="stable")[:NEAREST]]
    possible = near[_possible(proposals, near, around, space)]
    return int(possible[0]) if len(possible) else None


def _turns(headings: Floats, box: Box, category: Category) -> Floats:
    """How far headings are from the true one, as far as that is known: (n,) radians."""
    turn = np.abs(wrapped(headings - box.heading))
    if category.symmetry is Symmetry.SYMMETRIC:
        return np.minimum(turn, np.pi - turn)
    if not box.front_known:
        return np.asarray(np.abs((turn + np.pi / 4) % (np.pi / 2) - np.pi / 4), dtype=np.float64)
    return turn


def _alternatives(
    proposals: Proposals,
    chosen: int,
    around: Surroundings,
    space: Space,
    *,
    rng: np.random.Generator,
) -> tuple[Ints, Floats]:
    """Some other possible proposals, free and flush ones, and how many each stands for."""
    rows, weights = [], []
    for which, tried, kept in zip((~proposals.flush, proposals.flush), TRIED, KEPT, strict=True):
        everyone = np.setdiff1d(np.flatnonzero(which), [chosen])
        some = rng.choice(everyone, min(tried, len(everyone)), replace=False)
        possible = some[_possible(proposals, some, around, space)]
        share = len(possible) / max(len(some), 1)
        picked = possible[:kept]
        rows.append(picked)
        weights.append(np.full(len(picked), share * len(everyone) / max(len(picked), 1)))
    return np.concatenate(rows), np.concatenate(weights)


def _possible(proposals: Proposals, rows: Ints, around: Surroundings, space: Space) -> Bools:
    situation = Situation(proposals.candidates[rows], around)
    return np.asarray(verdicts(situation, space) == ALLOWED, dtype=np.bool_)


def _rng(scene: Scene, box: Box) -> np.random.Generator:
    """Chance that hangs on the box alone: the same wherever and whenever it is learned."""
    digest = blake2b(f"{scene.source}:{scene.id}#{box.id}".encode(), digest_size=8).digest()
    return np.random.default_rng(int.from_bytes(digest, "big"))
