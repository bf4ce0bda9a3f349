"""What matters most: the box whose removal moves the best place furthest."""

from __future__ import annotations

from math import acos, cos, dist, pi
from pathlib import Path

import pytest

from scenegen_core.knowledge import default_knowledge
from scenegen_core.placement.answer import Cancelled, Query
from scenegen_core.placement.solve import solve
from scenegen_core.placement.what_if import what_matters
from scenegen_core.scene.files import read_scene
from scenegen_core.scene.resting import taken_out
from tests.core.placement.drawn import NORTH, room, thing

KNOWLEDGE = default_knowledge()
LIVING_ROOM = read_scene((Path(__file__).parents[2] / "fixtures/living_room.json").read_bytes())
SOFA = Query("Sofa", size=(0.9, 1.5, 0.8))


def test_it_is_the_box_without_which_the_best_place_is_furthest_away() -> None:
    answer = solve(LIVING_ROOM, SOFA, KNOWLEDGE).answer
    done: list[int] = []
    found = what_matters(LIVING_ROOM, SOFA, answer, KNOWLEDGE, progress=done.append)
    here = answer.poses[0]
    assert found is not None
    assert found.center is not None
    assert done == list(range(len(LIVING_ROOM.boxes)))
    changes = {}
    for box in LIVING_ROOM.boxes:
        best = solve(taken_out(LIVING_ROOM, box.id), SOFA, KNOWLEDGE).answer.poses[0]
        turned = acos(min(1.0, cos(best.heading - here.heading)))
        moved = round(dist(best.center, here.center) + turned / pi, 9)
        changes[box.id] = (moved, abs(best.score - here.score))
    assert found.box == max(changes, key=lambda box: changes[box])
    assert found.moved == pytest.approx(dist(found.center, here.center))


def test_a_tv_that_can_only_stand_on_one_chest_has_no_place_without_it() -> None:
    """It is too deep to hang and too low to stand on the floor."""
    chest = thing("Storage", 2.5, 0.3, (0.5, 1.2, 0.6), heading=NORTH, label="Chest")
    plant = thing("Decor", 4.5, 3.5, (0.3, 0.3, 0.9))
    scene, query = room(chest, plant), Query("TV", size=(0.4, 0.8, 0.6))
    answer = solve(scene, query, KNOWLEDGE).answer
    found = what_matters(scene, query, answer, KNOWLEDGE)
    assert found is not None
    assert (found.box, found.center) == ("storage", None)
    assert found.text == "Without the chest there would be no place for it."


def test_an_empty_room_has_nothing_that_matters() -> None:
    answer = solve(room(), SOFA, KNOWLEDGE).answer
    assert what_matters(room(), SOFA, answer, KNOWLEDGE) is None


def test_the_search_can_be_abandoned() -> None:
    answer = solve(LIVING_ROOM, SOFA, KNOWLEDGE).answer
    with pytest.raises(Cancelled):
        what_matters(LIVING_ROOM, SOFA, answer, KNOWLEDGE, cancelled=lambda: True)
