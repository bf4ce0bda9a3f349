"""Questions beyond "where?", over a real socket."""

from __future__ import annotations

from msgspec.structs import replace

from scenegen_core.scene.files import BoxRecord, OpeningRecord, RoomRecord, SceneRecord
from server.protocol import Answer, Ask, Inspect, Inspected, Matters, Query, Weighing, WhatMatters
from tests.server.driving import ROOM, TABLE, page

SOFA = Ask(id="sofa", query=Query(category="Sofa", size=(0.9, 1.5, 0.8)))
TELLY = BoxRecord(
    id="tv", category="TV", center=(4.9, 2.0, 0.8), size=(0.1, 1.0, 0.6), heading=3.14
)
CLOSET = RoomRecord(corners=((0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)))


def test_a_pose_that_is_forbidden_comes_with_the_nearest_that_is_not(url: str) -> None:
    """Half of 0.9 m is 0.45 m: from 0.2 m off the west wall it is 0.25 m until it is free."""
    with page(url) as here:
        here.open()
        here.send(SOFA)
        here.until(Answer)
        here.send(Inspect(id="i", center=(0.2, 3.0, 0.4), heading=0.0))
        seen = here.until(Inspected)
    assert (seen.allowed, seen.rule) == (False, "room")
    assert seen.elsewhere is not None
    assert abs(seen.elsewhere.distance - 0.25) < 0.01
    assert seen.elsewhere.text == "25 cm further from the west wall"


def test_what_matters_most_is_told_after_word_of_how_far_the_search_has_come(url: str) -> None:
    with page(url) as here:
        here.open(SceneRecord(room=ROOM, boxes=(TABLE, TELLY)))
        here.send(SOFA)
        here.until(Answer)
        here.send(WhatMatters(id="m"))
        weighing = here.until(Weighing)
        assert (weighing.id, weighing.total) == ("m", 2)
        matters = here.until(Matters)
    assert (matters.id, matters.ask, matters.revision) == ("m", "sofa", 1)
    assert matters.found is not None
    assert matters.found.box in ("table", "tv")


def test_where_there_is_no_place_what_would_give_one_comes_a_little_later(url: str) -> None:
    """Walls are 2 m apart: 0.85 of 2.3 m is the first size that fits."""
    with page(url) as here:
        here.open(SceneRecord(room=CLOSET, boxes=()))
        here.send(Ask(id="bed", query=Query(category="Bed", size=(2.3, 0.9, 0.5))))
        first, second = here.until(Answer), here.until(Answer)
    assert first.no_good_place is not None
    assert second.no_good_place is not None
    assert first.no_good_place.remedy is None
    remedy = second.no_good_place.remedy
    assert remedy is not None
    assert remedy.kind == "size"
    assert remedy.size is not None
    assert abs(remedy.size[0] - 0.85 * 2.3) < 0.006


def test_a_rule_that_is_relaxed_does_not_count(url: str) -> None:
    """In a corridor between two windows, 0.5 m before each, a wardrobe of 0.8 m has no place."""
    corridor = RoomRecord(
        corners=((0.0, 0.0), (4.0, 0.0), (4.0, 1.5), (0.0, 1.5)),
        windows=(
            OpeningRecord(id="s", start=(0.0, 0.0), end=(4.0, 0.0), bottom=0.9, top=2.0),
            OpeningRecord(id="n", start=(4.0, 1.5), end=(0.0, 1.5), bottom=0.9, top=2.0),
        ),
    )
    wardrobe = Query(category="Storage", size=(0.8, 0.8, 2.0))
    with page(url) as here:
        here.open(SceneRecord(room=corridor, boxes=()))
        here.send(Ask(id="a", query=wardrobe))
        assert here.until(Answer).placements == ()
        here.send(Ask(id="b", query=replace(wardrobe, relaxed=("window",))))
        answer = here.until(Answer)
        while answer.ask != "b":  # what would help the first comes in between
            answer = here.until(Answer)
        assert answer.placements
