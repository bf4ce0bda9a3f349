"""What choices teach: a rule that all follow, nothing where there is none, always the same."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from math import pi
from pathlib import Path

import numpy as np
import pytest

from scenegen_core.graph.situation import Situation
from scenegen_core.graph.surroundings import Surroundings
from scenegen_core.knowledge import Knowledge, boosting, learn, save_knowledge
from scenegen_core.knowledge.learning import Batch, Found
from scenegen_core.placement import choice_learning
from scenegen_core.placement.choice_learning import gather, with_choices
from scenegen_core.placement.choice_model import ChoiceModel
from scenegen_core.placement.feasible import ALLOWED, Space, verdicts
from scenegen_core.placement.proposals import Proposals, propose
from scenegen_core.scene.geometry import Floats
from scenegen_core.scene.model import PAPER_CATEGORIES, Box, Room, Scene
from tests.core.placement.drawn import category

GROUPS = PAPER_CATEGORIES
STOOL = (0.5, 0.6, 0.9)
ROOMS = 40
Pick = Callable[[Proposals], Floats]
"""1 for the poses that somebody might choose, 0 for the others: (n,)."""


def empty(rng: np.random.Generator, number: int) -> Scene:
    """A rectangle of some size."""
    width, depth = (3 + 3 * rng.random(2)).round(2).tolist()
    corners = ((0.0, 0.0), (width, 0.0), (width, depth), (0.0, depth))
    return Scene(Room(corners), id=f"room {number}", source="drawn")


def choosable(scene: Scene) -> Proposals:
    """Where a chair could be."""
    around = Surroundings(scene, GROUPS)
    found = propose(around, category("Chair"), STOOL)
    allowed = verdicts(Situation(found.candidates, around), Space.of(around)) == ALLOWED
    return replace(
        found,
        candidates=found.candidates[allowed],
        mounts=found.mounts[allowed],
        cells=found.cells[allowed],
        flush=found.flush[allowed],
    )


def with_chair(scene: Scene, pick: Pick, rng: np.random.Generator) -> Scene:
    """The room with a chair at one of the poses that are picked (n,)."""
    found = choosable(scene)
    which = int(rng.choice(np.flatnonzero(pick(found))))
    return scene.with_box(replace(found.candidates.box(which, "chair"), category="Chair"))


def rooms(pick: Pick, count: int = ROOMS, seed: int = 0) -> list[Scene]:
    rng = np.random.default_rng(seed)
    return [with_chair(empty(rng, number), pick, rng) for number in range(count)]


def anywhere(found: Proposals) -> Floats:
    return np.ones(len(found.candidates))


def back_to_the_wall(found: Proposals) -> Floats:
    return found.flush.astype(float)


def taught(scenes: list[Scene]) -> Knowledge:
    return with_choices(learn(scenes, GROUPS), gather(scenes, GROUPS))


def probabilities(knowledge: Knowledge, scene: Scene, found: Proposals) -> Floats:
    """How likely each possible pose is chosen."""
    situation = Situation(found.candidates, Surroundings(scene, GROUPS))
    scores = ChoiceModel(knowledge, "Chair").total(situation)
    mass = np.exp(scores - scores.max())
    return np.asarray(mass / mass.sum(), dtype=np.float64)


@pytest.fixture
def quick(monkeypatch: pytest.MonkeyPatch) -> None:
    """Few trees, where it does not matter how well they learn."""
    monkeypatch.setattr(boosting, "CURVE_TREES", 5)
    monkeypatch.setattr(boosting, "TRIAL_TREES", 5)
    monkeypatch.setattr(boosting, "SURFACE_TREES", 3)


def told(chances: Floats) -> float:
    """How much is known of where it goes, nats: 0 where all places are alike."""
    return float(np.log(len(chances)) + (chances * np.log(chances)).sum())


def test_a_rule_that_everyone_follows_is_learned() -> None:
    """All chairs have their back to a wall, which not one pose in fifty has."""
    scene = empty(np.random.default_rng(99), 99)
    found = choosable(scene)
    chances = probabilities(taught(rooms(back_to_the_wall)), scene, found)
    assert found.flush.mean() < 0.02
    assert chances[found.flush].sum() > 25 * found.flush.mean()
    assert told(chances) > np.log(5)
    best = found.candidates.box(int(chances.argmax()), "best")
    (width, depth), (x, y, _) = scene.room.corners[2], best.center
    walls = {0.0: x, pi / 2: y, pi: width - x, -pi / 2: depth - y}
    behind = min(walls, key=lambda turn: abs(np.exp(1j * best.heading) - np.exp(1j * turn)))
    assert walls[behind] <= 0.25 + 0.02 + 1e-9  # half its depth; what it keeps from walls


def test_where_there_is_no_rule_hardly_anything_is_learned() -> None:
    """Forty chairs by chance are told of no more than if half of the room were left out."""
    scene = empty(np.random.default_rng(99), 99)
    chances = probabilities(taught(rooms(anywhere)), scene, choosable(scene))
    assert told(chances) < np.log(2)


@pytest.mark.usefixtures("quick")
def test_the_knowledge_is_the_same_to_the_bit_whenever_and_wherever_it_is_learned(
    tmp_path: Path,
) -> None:
    def backwards(work: Callable[[Batch], Found], batches: Iterator[Batch], /) -> Iterator[Found]:
        measured = [work(batch) for batch in reversed(list(batches))]
        yield from reversed(measured)

    scenes = rooms(anywhere)
    known = learn(scenes, GROUPS)
    for name, mapper in (("forth", map), ("again", map), ("back", backwards)):
        chosen = gather(scenes, GROUPS, mapper=mapper)
        save_knowledge(with_choices(known, chosen), tmp_path / name)
    forth, again, back = ((tmp_path / name).read_bytes() for name in ("forth", "again", "back"))
    assert forth == again == back


def test_progress_counts_the_rooms() -> None:
    seen: list[int] = []
    gather(rooms(anywhere), GROUPS, progress=seen.append)
    assert seen == [32, 40]


@pytest.mark.usefixtures("quick")
def test_four_choices_are_too_few() -> None:
    assert taught(rooms(anywhere, 4)).choices == {}
    assert list(taught(rooms(anywhere, 5)).choices) == ["Chair"]


@pytest.mark.usefixtures("quick")
def test_each_choice_remembers_its_room_and_the_pose_that_was_chosen() -> None:
    scenes = rooms(anywhere, 6)
    choice = taught(scenes).choice("Chair")
    assert choice.rooms == tuple(f"room {number}" for number in range(6))
    expected = [one.bins[0] for one in gather(scenes, GROUPS)]
    np.testing.assert_array_equal(choice.examples, np.stack(expected))


@pytest.mark.usefixtures("quick")
def test_of_very_many_choices_some_teach(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(choice_learning, "MOST", 7)
    choice = taught(rooms(anywhere, 12)).choice("Chair")
    assert len(choice.examples) == len(choice.rooms) == 7
    assert len(set(choice.rooms)) == 7


def test_a_source_that_hardly_counts_teaches_hardly_anything() -> None:
    walls = [replace(scene, source="walls") for scene in rooms(back_to_the_wall, 20)]
    free = [
        replace(scene, source="free", id=f"free {scene.id}")
        for scene in rooms(lambda found: (~found.flush).astype(float), 20, seed=1)
    ]
    chosen = gather([*walls, *free], GROUPS)
    known = learn([*walls, *free], GROUPS)
    scene = empty(np.random.default_rng(99), 99)
    found = choosable(scene)
    at_walls = {
        heavy: probabilities(with_choices(known, chosen, weights={light: 1e-4}), scene, found)[
            found.flush
        ].sum()
        for heavy, light in (("walls", "free"), ("free", "walls"))
    }
    assert at_walls["walls"] > 20 * at_walls["free"]


@pytest.mark.usefixtures("quick")
def test_going_on_keeps_what_is_known_and_adds_to_it() -> None:
    known = taught(rooms(anywhere, 6))
    further = [replace(scene, id=f"new {scene.id}") for scene in rooms(back_to_the_wall, 5, seed=2)]
    grown = with_choices(known, gather(further, GROUPS), before=known)
    before, after = known.choice("Chair"), grown.choice("Chair")
    assert after.rooms == (*before.rooms, *(scene.id for scene in further))
    np.testing.assert_array_equal(after.examples[:6], before.examples)
    np.testing.assert_array_equal(after.surfaces[: len(before.pairs)], before.surfaces)
    assert grown.shared is known.shared


@pytest.mark.usefixtures("quick")
def test_going_on_with_nothing_new_changes_nothing() -> None:
    known = taught(rooms(anywhere, 6))
    grown = with_choices(known, gather([empty(np.random.default_rng(0), 0)], GROUPS), before=known)
    assert grown.choices is known.choices


def test_a_box_of_a_group_that_nobody_places_is_no_choice() -> None:
    scene = empty(np.random.default_rng(0), 0).with_box(
        Box("stove", "Other", (1.5, 1.5, 0.5), (0.6, 0.6, 1.0))
    )
    assert gather([scene], GROUPS) == ()
