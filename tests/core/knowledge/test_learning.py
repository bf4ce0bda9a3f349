"""What drawn rooms teach, and what is asked of the knowledge."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from scenegen_core.errors import DataError, KnowledgeError
from scenegen_core.graph.relations import RELATIONS, columns
from scenegen_core.knowledge.files import default_knowledge, save_knowledge
from scenegen_core.knowledge.knowledge import CategoryKnowledge, Knowledge
from scenegen_core.knowledge.learning import Batch, Found, learn
from scenegen_core.scene.model import (
    PAPER_CATEGORIES,
    Box,
    Category,
    Room,
    Scene,
    Symmetry,
    Vector3,
)

ROOM = Room(((0.0, 0.0), (6.0, 0.0), (6.0, 5.0), (0.0, 5.0)), room_type="living room")


def living_room(number: int, *, shift: float = 0.0) -> Scene:
    """A sofa at the wall y = 0 that faces a table, and a box of no category."""
    return Scene(
        ROOM,
        (
            Box("sofa", "Sofa", (3.0 + shift, 0.5, 0.4), (0.9, 2.0, 0.8), 1.5707963),
            Box("table", "Table", (3.0 + shift, 2.0, 0.25), (0.6, 1.0, 0.5), front_known=False),
            Box("ball", "Ball", (5.0, 4.0, 0.1), (0.2, 0.2, 0.2)),
            Box("stove", "Other", (1.0, 4.0, 0.5), (0.6, 0.6, 1.0)),
        ),
        id=f"room {number}",
        source="drawn",
    )


def living_rooms(count: int) -> list[Scene]:
    return [living_room(number, shift=number / 10) for number in range(count)]


def cell(part: CategoryKnowledge, row: int, relation: str, group: str = "") -> float:
    names = [(column.relation, column.group) for column in part.columns]
    return float(part.rows[row, names.index((relation, group))])


@pytest.fixture
def knowledge() -> Knowledge:
    return learn(living_rooms(6), PAPER_CATEGORIES)


def test_every_box_is_measured_by_every_relation_in_its_room_without_it(
    knowledge: Knowledge,
) -> None:
    sofa = knowledge["Sofa"]
    assert sofa.columns == columns(RELATIONS, PAPER_CATEGORIES)
    assert cell(sofa, 0, "RP") == 1  # the wall behind is 0.5 m from the center, the others 2 m
    # the sofa ends at y = 0.95, the table (heading 0: its width of 1 m lies along y) begins at 1.5
    assert cell(sofa, 0, "AD", "Table") == pytest.approx(0.55)
    assert cell(sofa, 0, "AD", "Sofa") == 1000
    assert cell(sofa, 0, "S", "Table") == 1
    assert cell(sofa, 0, "S", "Sofa") == 0
    assert cell(sofa, 0, "F", "Table") == 1
    assert cell(sofa, 0, "TC") == 1


def test_each_example_remembers_its_room_size_and_height(knowledge: Knowledge) -> None:
    table = knowledge["Table"]
    assert table.examples == 6
    assert table.rooms == tuple(f"room {number}" for number in range(6))
    assert table.sizes.tolist() == [[0.6, 1.0, 0.5]] * 6
    assert table.bottoms.tolist() == [0.0] * 6
    assert table.usual_size == (0.6, 1.0, 0.5)


def test_the_usual_size_is_that_of_the_middle_half() -> None:
    sizes = [(0.1, 0.1, 0.1), (0.9, 2.0, 0.8), (0.8, 2.1, 0.7), (1.0, 1.9, 0.9), (9.0, 9.0, 9.0)]
    boxes = tuple(
        Box(str(i), "Sofa", (1.0 + i, 1.0, size[2] / 2), size) for i, size in enumerate(sizes)
    )
    assert learn([Scene(ROOM, boxes)], PAPER_CATEGORIES)["Sofa"].usual_size == (0.9, 2.0, 0.8)


@pytest.mark.parametrize(("count", "size"), [(1, (1.0, 2.0, 1.0)), (2, (1.5, 3.0, 1.5))])
def test_one_or_two_examples_have_a_usual_size_too(count: int, size: Vector3) -> None:
    boxes = tuple(
        Box(str(i), "Sofa", (i, 1.0, 0.5), (float(i), 2.0 * i, float(i)))
        for i in range(1, count + 1)
    )
    assert learn([Scene(ROOM, boxes)], PAPER_CATEGORIES)["Sofa"].usual_size == size


def test_other_and_categories_outside_the_groups_are_seen_but_not_learned(
    knowledge: Knowledge,
) -> None:
    assert list(knowledge.categories) == ["Sofa", "Table"]
    assert cell(knowledge["Sofa"], 0, "AD", "Other") < 1000
    with pytest.raises(KnowledgeError, match=r"no examples of Ball; choose one of Sofa, Table"):
        knowledge["Ball"]


def test_a_new_category_is_learned_when_it_is_among_the_groups() -> None:
    groups = (*PAPER_CATEGORIES, Category("Ball", Symmetry.SYMMETRIC))
    knowledge = learn(living_rooms(6), groups)
    assert knowledge["Ball"].examples == 6
    assert cell(knowledge["Sofa"], 0, "AD", "Ball") < 1000


def test_position_and_orientation_take_the_relations_of_the_paper(knowledge: Knowledge) -> None:
    sofa = knowledge["Sofa"]
    position = [column.relation for column in sofa.position().columns]
    orientation = [column.relation for column in sofa.orientation().columns]
    assert position == ["AD"] * 9 + ["S"] * 9 + ["RP"]
    assert orientation == ["F"] * 9 + ["TC", "RP"]
    assert sofa.position().density.rows.shape == (6, 19)
    assert sofa.position().density.bandwidths[:9].tolist() == [0.1] * 9


def test_other_relations_can_be_chosen_and_a_prior_is_made_once(knowledge: Knowledge) -> None:
    sofa = knowledge["Sofa"]
    chosen = sofa.position(("RP", "SP"))
    assert [column.relation for column in chosen.columns] == ["RP"] + ["SP"] * 9
    assert sofa.position(("RP", "SP")) is chosen
    assert sofa.position(("RP", "SP"), bandwidths="paper") is not chosen


def test_a_relation_that_was_not_measured_is_an_error(knowledge: Knowledge) -> None:
    with pytest.raises(KnowledgeError, match=r"'XX'; learn it again"):
        knowledge["Sofa"].position(("XX",))


def test_only_boxes_whose_front_is_known_teach_orientation() -> None:
    def turned(scene: Scene, *, known: bool, from_wall: bool) -> Scene:
        sofa = Box(
            "sofa", "Sofa", (3.0, 0.5, 0.4), (0.9, 2.0, 0.8), 1.57,
            front_known=known, front_from_wall=from_wall,
        )  # fmt: skip
        return scene.with_box(sofa)

    scenes = [
        *living_rooms(5),
        turned(living_room(5), known=False, from_wall=False),
        turned(living_room(6), known=True, from_wall=True),
    ]
    sofa = learn(scenes, PAPER_CATEGORIES)["Sofa"]
    assert sofa.examples == 7
    assert sofa.front_known.tolist() == [True] * 5 + [False] * 2
    assert len(sofa.position().rooms) == 7
    assert sofa.orientation().rooms == tuple(f"room {number}" for number in range(5))
    assert len(sofa.orientation().density.rows) == 5


def test_too_few_examples_are_an_error_when_they_are_asked_for() -> None:
    knowledge = learn(living_rooms(3), PAPER_CATEGORIES)
    with pytest.raises(KnowledgeError, match="only 3 examples of Sofa, and 5 are needed"):
        knowledge["Sofa"].position()


def test_too_few_known_fronts_are_an_error_only_for_orientation(knowledge: Knowledge) -> None:
    assert knowledge["Table"].position().density.rows.shape == (6, 19)
    with pytest.raises(KnowledgeError, match="only 0 examples whose front is known of Table"):
        knowledge["Table"].orientation()


@pytest.mark.parametrize("scenes", [[], [Scene(ROOM)]])
def test_rooms_without_furniture_teach_nothing(scenes: list[Scene]) -> None:
    with pytest.raises(DataError, match=f"nothing to learn from in {len(scenes)} rooms"):
        learn(scenes, PAPER_CATEGORIES)


def test_progress_counts_the_rooms() -> None:
    seen: list[int] = []
    learn(living_rooms(70), PAPER_CATEGORIES, progress=seen.append)
    assert seen == [32, 64, 70]


def test_the_knowledge_is_the_same_to_the_bit_in_whatever_order_batches_are_measured(
    tmp_path: Path,
) -> None:
    def backwards(work: Callable[[Batch], Found], batches: Iterator[Batch], /) -> Iterator[Found]:
        measured = [work(batch) for batch in reversed(list(batches))]
        yield from reversed(measured)

    for name, mapper in (("forth", map), ("back", backwards)):
        knowledge = learn(living_rooms(70), PAPER_CATEGORIES, mapper=mapper)
        save_knowledge(knowledge, tmp_path / name)
    assert (tmp_path / "forth").read_bytes() == (tmp_path / "back").read_bytes()


def test_an_example_of_double_weight_counts_like_two() -> None:
    once, twice = living_rooms(6), living_rooms(6)[:3]
    heavy = [replace(scene, source="heavy") for scene in twice]
    weighted = learn([*heavy, *once[3:]], PAPER_CATEGORIES, weights={"heavy": 2.0})
    doubled = learn([*heavy, *heavy, *once[3:]], PAPER_CATEGORIES)
    one, two = weighted["Sofa"].position().density, doubled["Sofa"].position().density
    same_widths = replace(two, bandwidths=one.bandwidths)
    np.testing.assert_allclose(one.log_density(one.rows), same_widths.log_density(one.rows))


def test_sources_are_counted_and_unknown_ones_state_no_license() -> None:
    (source,) = learn(living_rooms(3), PAPER_CATEGORIES).sources
    assert (source.name, source.license, source.rooms, source.objects) == (
        "drawn", "not stated", 3, 12,
    )  # fmt: skip


def test_a_sofa_in_a_new_room_is_likeliest_where_the_examples_have_it() -> None:
    prior = learn(living_rooms(8), PAPER_CATEGORIES)["Sofa"].position()
    rows = prior.density.rows[:1].repeat(2, axis=0)
    names = [(column.relation, column.group) for column in prior.columns]
    rows[1, names.index(("AD", "Table"))] = 2.5
    there, away = prior.density.log_density(rows)
    assert there > away


def test_the_knowledge_that_ships_can_place_all_eight_categories_of_the_paper() -> None:
    knowledge = default_knowledge()
    placeable = [category.name for category in PAPER_CATEGORIES if category.name != "Other"]
    assert list(knowledge.categories) == placeable
    for part in knowledge.categories.values():
        part.position()
        part.orientation()
        assert min(part.usual_size) > 0.01
        assert max(part.usual_size) < 3
    assert {source.license for source in knowledge.sources} == {"MIT", "Apache-2.0", "CC-BY-3.0"}
