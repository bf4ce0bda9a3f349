"""What goes along when a thing is taken out of its room."""

from __future__ import annotations

from dataclasses import replace

import pytest

from scenegen_core.errors import SceneError
from scenegen_core.scene.model import Scene
from scenegen_core.scene.resting import carried, taken_out
from tests.core.placement.drawn import room, thing

SOFA = thing("Sofa", 2.0, 0.5, (0.9, 2.0, 0.8), heading=1.5707963)
CUSHION = thing("Other", 1.4, 0.4, (0.4, 0.4, 0.3), bottom=0.45, box_id="cushion")
PICTURE = thing("Picture", 2.0, 0.06, (0.04, 0.8, 0.6), heading=1.5707963, bottom=0.7)
TABLE = thing("Table", 4.0, 2.0, (1.0, 1.0, 0.75))
VASE = thing("Decor", 4.2, 2.2, (0.2, 0.2, 0.3), bottom=0.73, box_id="vase")
TRAY = thing("Other", 3.8, 1.8, (0.4, 0.4, 0.05), bottom=0.75, box_id="tray")
CUP = thing("Decor", 3.8, 1.8, (0.1, 0.1, 0.1), bottom=0.8, box_id="cup")
CHAIR = thing("Chair", 3.6, 2.0, (0.5, 0.4, 0.9))
LAMP = thing("Decor", 4.0, 2.0, (0.4, 0.4, 0.3), bottom=1.6, box_id="lamp")
ALL = room(SOFA, CUSHION, PICTURE, TABLE, VASE, TRAY, CUP, CHAIR, LAMP)


def left(scene: Scene) -> set[str]:
    """The ids of what is there."""
    return {box.id for box in scene.boxes}


@pytest.mark.parametrize(
    ("box_id", "gone"),
    [
        ("table", {"vase", "tray", "cup"}),  # not the chair under it, nor the lamp above
        ("sofa", {"cushion"}),  # not the picture behind it
        ("tray", {"cup"}),
        ("chair", set()),
        ("lamp", set()),
    ],
)
def test_what_stands_on_a_thing_goes_along(box_id: str, gone: set[str]) -> None:
    assert left(ALL) - left(taken_out(ALL, box_id)) == {box_id, *gone}


def test_what_a_source_says_counts_wherever_it_is() -> None:
    rug = replace(thing("Decor", 1.0, 3.0, (1.0, 1.0, 0.02), box_id="rug"), parent="table")
    assert [box.id for box in carried(room(TABLE, rug), TABLE)] == ["rug"]


def test_what_stands_on_a_rug_stands_on_the_floor() -> None:
    rug = thing("Decor", 4.0, 2.0, (2.0, 2.0, 0.02), box_id="rug")
    assert carried(room(rug, TABLE, CHAIR), rug) == ()


def test_two_things_that_carry_each_other_both_go() -> None:
    ones = (replace(TABLE, parent="vase"), replace(VASE, parent="table"))
    assert left(taken_out(room(*ones), "table")) == set()


def test_an_unknown_box_is_an_error() -> None:
    with pytest.raises(SceneError, match="There is no box 'piano'"):
        taken_out(ALL, "piano")
