"""Hard facts about placements, worked out by hand."""

from __future__ import annotations

from dataclasses import replace

import pytest

from scenegen_core.evaluation.bench import Bench
from scenegen_core.evaluation.cases import Case
from scenegen_core.evaluation.physical import PHYSICAL, physical
from scenegen_core.scene.model import PAPER_CATEGORIES, Box, Scene
from tests.core.placement.drawn import DOOR, NORTH, WEST, moved, moved_box, room, thing

CUBE = (1.0, 1.0, 1.0)
TABLE = thing("Table", 2.5, 2.0, (1.0, 1.0, 0.75))
RUG = thing("Decor", 2.5, 2.0, (2.0, 2.0, 0.02))
BED = thing("Bed", 1.2, 3.4, (2, 1, 0.5))
CHAIR = (0.5, 0.5, 0.9)

FACTS: dict[str, tuple[Scene, Box, set[str]]] = {
    "a good place": (
        room(TABLE, doors=(DOOR,)),
        thing("Storage", 4.4, 3, CUBE, heading=WEST),
        set(),
    ),
    "1 % of the smaller shared": (room(TABLE), thing("Storage", 3.49, 2, CUBE), set()),
    "3 % of the smaller shared": (room(TABLE), thing("Storage", 3.47, 2, CUBE), {"collides"}),
    "a small thing inside a large one": (
        room(TABLE),
        thing("Decor", 2.9, 2, (0.1, 0.1, 0.5)),
        {"collides"},
    ),
    "on top of it": (room(TABLE), thing("Decor", 2.5, 2, (0.3, 0.3, 0.3), bottom=0.75), set()),
    "2 cm into its top": (
        room(TABLE),
        thing("Decor", 2.5, 2, (0.3, 0.3, 0.3), bottom=0.73),
        {"collides"},
    ),
    "a chair under a table": (room(TABLE), thing("Chair", 3, 2, CHAIR, heading=WEST), set()),
    "on a rug": (room(RUG), thing("Storage", 2.5, 2, CUBE), set()),
    "half a percent outside": (room(), thing("Storage", 0.495, 2, CUBE), set()),
    "two percent outside": (room(), thing("Storage", 0.48, 2, CUBE), {"outside"}),
    "far outside": (room(), thing("Storage", 20, 2, CUBE), {"outside", "breaks_path"}),
    # the door's square: x 1..1.8, y 0..0.8
    "in the door's square": (
        room(doors=(DOOR,)),
        thing("Storage", 2.2, 0.5, CUBE),
        {"blocks_door"},
    ),
    "beside the door's square": (room(doors=(DOOR,)), thing("Storage", 2.35, 0.5, CUBE), set()),
    "above the door": (
        room(doors=(DOOR,)),
        thing("Picture", 1.4, 0.02, (0.04, 0.6, 0.4), heading=NORTH, bottom=2.1),
        set(),
    ),
    "a rug before the door": (
        room(doors=(DOOR,)),
        thing("Decor", 1.4, 0.5, (0.9, 0.8, 0.02)),
        set(),
    ),
    "across the way to the bed": (
        room(BED, doors=(DOOR,)),
        thing("Table", 2.5, 2.2, (0.5, 5.0, 0.7), heading=NORTH),
        {"breaks_path"},
    ),
    "everything at once": (
        room(TABLE, doors=(DOOR,)),
        thing("Storage", 1.9, 1.5, (3, 4, 1)),
        {"collides", "outside", "blocks_door", "breaks_path"},
    ),
}


def broken(scene: Scene, box: Box) -> set[str]:
    """The facts that are broken."""
    found = physical(Bench(Case(scene, box), PAPER_CATEGORIES), box)
    assert tuple(found) == PHYSICAL
    assert set(found.values()) <= {0.0, 1.0}
    return {name for name, value in found.items() if value}


@pytest.mark.parametrize("name", FACTS)
def test_facts_are_found(name: str) -> None:
    scene, box, expected = FACTS[name]
    assert broken(scene, box) == expected


@pytest.mark.parametrize("name", FACTS)
def test_facts_do_not_depend_on_how_the_room_lies(name: str) -> None:
    scene, box, expected = FACTS[name]
    assert broken(moved(scene), moved_box(box)) == expected


def test_a_door_drawn_the_other_way_round_is_the_same_door() -> None:
    reverse = replace(DOOR, start=DOOR.end, end=DOOR.start)
    box = thing("Storage", 2.2, 0.5, CUBE)
    assert broken(room(doors=(reverse,)), box) == {"blocks_door"}
