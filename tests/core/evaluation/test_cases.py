"""Which questions are asked, and that no home is on both sides of a fold."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from scenegen_core.errors import DataError
from scenegen_core.evaluation.cases import Case, cases, emptier, folds, home_of
from scenegen_core.scene.model import Scene
from tests.core.placement.drawn import room, thing

BED = thing("Bed", 1.5, 2, (2, 1.6, 0.5))
STAND = thing("Storage", 3, 2, (0.4, 0.4, 0.5), box_id="stand")
CRATE = thing("Other", 4, 3, (0.4, 0.4, 0.5))


def scene(name: str, home: str, x: float) -> Scene:
    """A room of a home with a bed at x; rooms of the same x are copies."""
    return replace(room(replace(BED, center=(x, 2, 0.25))), id=f"{home}/{name}", source="drawn")


def rng() -> np.random.Generator:
    return np.random.default_rng(0)


def parts(scenes: list[Scene], count: int) -> list[set[str]]:
    """The ids in each fold."""
    return [{one.id for one in part} for part in folds(scenes, count, rng=rng())]


def test_every_box_that_can_be_placed_is_a_case_in_its_scene_without_it() -> None:
    full = replace(room(BED, STAND, CRATE), id="one", source="drawn")
    found = cases([full], ["Bed", "Storage", "Sofa", "Other"])
    assert [case.box for case in found] == [BED, STAND]
    assert [[box.id for box in case.scene.boxes] for case in found] == [
        ["stand", "other"],
        ["bed", "other"],
    ]
    assert {case.source for case in found} == {"drawn"}


def test_cases_of_other_rooms_and_boxes_have_other_keys() -> None:
    scenes = [replace(room(BED, STAND), id=name) for name in ("one", "two")]
    assert len({case.key for case in cases(scenes, ["Bed", "Storage"])}) == 4


def test_a_home_is_what_stands_before_the_slash_within_one_source() -> None:
    assert home_of(scene("bath", "house 1", 1)) == home_of(scene("hall", "house 1", 2))
    assert home_of(scene("bath", "house 1", 1)) != home_of(scene("bath", "house 2", 1))
    other = replace(scene("bath", "house 1", 1), source="scanned")
    assert home_of(scene("bath", "house 1", 1)) != home_of(other)


def test_rooms_of_one_home_stay_together() -> None:
    scenes = [scene(str(i), f"house {i % 3}", 1 + 0.1 * i) for i in range(9)]
    found = parts(scenes, 3)
    assert sorted(map(sorted, found)) == [
        [f"house {h}/{i}" for i in range(h, 9, 3)] for h in range(3)
    ]


def test_copies_of_one_layout_stay_together_whatever_their_home() -> None:
    scenes = [scene("a", "h1", 1.0), scene("a", "h2", 1.0), scene("a", "h3", 1.5)]
    assert sorted(map(sorted, parts(scenes, 2))) == [["h1/a", "h2/a"], ["h3/a"]]


def test_what_is_joined_to_the_same_is_joined() -> None:
    """Home h1 and home h2 are joined by a room of h2 that copies one of h1, found last."""
    scenes = [
        scene("a", "h1", 1.0),
        scene("b", "h2", 1.2),
        scene("c", "h3", 1.4),
        scene("d", "h2", 1.0),
        scene("e", "h1", 1.6),
    ]
    assert sorted(map(sorted, parts(scenes, 2))) == [["h1/a", "h1/e", "h2/b", "h2/d"], ["h3/c"]]


def test_too_few_homes_are_said() -> None:
    one_home = [scene(str(i), "h1", 1 + i / 10) for i in range(5)]
    with pytest.raises(DataError, match="from 1 home, too few for 4 folds; give more rooms"):
        folds(one_home, 4, rng=rng())
    two_homes = [*one_home, scene("x", "h2", 3)]
    with pytest.raises(DataError, match="from 2 homes, too few"):
        folds(two_homes, 4, rng=rng())


@given(
    st.lists(st.tuples(st.integers(0, 9), st.integers(0, 30)), min_size=40, max_size=60),
    st.integers(0, 5),
)
def test_folds_part_the_scenes_and_share_no_home_and_no_layout(
    rooms: list[tuple[int, int]], seed: int
) -> None:
    scenes = [
        scene(str(number), f"h{number // 2}", 1 + x / 100 + kind / 10)
        for number, (kind, x) in enumerate(rooms)
    ]
    try:
        found = folds(scenes, 3, rng=np.random.default_rng(seed))
    except DataError:
        return  # copies have joined nearly all
    again = folds(scenes, 3, rng=np.random.default_rng(seed))
    assert found == again
    assert sorted(one.id for part in found for one in part) == sorted(one.id for one in scenes)
    for key in (home_of, lambda one: one.boxes[0].center):
        keys = [{key(one) for one in part} for part in found]
        assert sum(map(len, keys)) == len(set().union(*keys))


def test_folds_are_of_about_equal_size() -> None:
    scenes = [scene(str(i), f"h{i}", 1 + i / 100) for i in range(101)]
    assert sorted(len(part) for part in folds(scenes, 4, rng=rng())) == [25, 25, 25, 26]


def names(case: Case) -> list[str]:
    """What is left in the room of a case."""
    return [box.id for box in case.scene.boxes]


def test_emptier_rooms_lack_the_nearest_things_that_can_be_placed() -> None:
    bed = thing("Bed", 1, 1, (2, 1, 0.5))  # x 0 to 2, y 0.5 to 1.5
    rug = thing("Decor", 1, 1, (1, 1, 0.01), box_id="rug")  # under it
    lamp = thing("Decor", 2.3, 1, (0.2, 0.2, 1), box_id="lamp")  # 0.2 m away
    stool = thing("Other", 2.15, 1, (0.1, 0.1, 0.4), box_id="stool")  # nearer, but never placed
    sofa = thing("Sofa", 4, 1, (1, 2, 0.8))  # 1.5 m away, its middle 3 m
    tv = thing("TV", 1, 3.6, (0.1, 0.6, 0.6))  # 1.8 m away, its middle 2.6 m
    case = Case(room(sofa, tv, lamp, stool, rug), bed)
    one, two, three = emptier(case, 3, ["Bed", "Decor", "TV", "Sofa", "Other"])
    assert names(one) == ["sofa", "tv", "lamp", "stool"]
    assert names(two) == ["sofa", "tv", "stool"]
    assert names(three) == ["tv", "stool"]
    assert {found.box for found in (one, two, three)} == {bed}


def test_a_room_with_too_little_in_it_is_not_made_emptier() -> None:
    case = Case(room(STAND, CRATE), BED)
    assert emptier(case, 2, ["Bed", "Storage", "Other"]) == ()
    (one,) = emptier(case, 1, ["Bed", "Storage", "Other"])
    assert names(one) == ["other"]
