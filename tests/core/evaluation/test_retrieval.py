"""Retrieval: rooms laid over each other."""

from __future__ import annotations

from dataclasses import replace
from math import cos, pi, sin

import pytest

from scenegen_core.evaluation.cases import Case
from scenegen_core.evaluation.retrieval import lessons_of, recall
from scenegen_core.scene.model import Box, Room, Scene
from tests.core.evaluation.made import bedroom


def turned(scene: Scene, angle: float, by: tuple[float, float]) -> Scene:
    """The scene, turned about the origin and moved."""

    def moved(x: float, y: float) -> tuple[float, float]:
        return (
            x * cos(angle) - y * sin(angle) + by[0],
            x * sin(angle) + y * cos(angle) + by[1],
        )

    boxes = tuple(
        replace(b, center=(*moved(*b.center[:2]), b.center[2]), heading=b.heading + angle)
        for b in scene.boxes
    )
    corners = tuple(moved(*corner) for corner in scene.room.corners)
    return replace(scene, room=replace(scene.room, corners=corners), boxes=boxes, id="turned")


def mirrored(scene: Scene) -> Scene:
    """The scene in a mirror at x = 2, its corners anticlockwise again."""
    boxes = tuple(
        replace(b, center=(4 - b.center[0], *b.center[1:]), heading=pi - b.heading)
        for b in scene.boxes
    )
    corners = tuple((4 - x, y) for x, y in reversed(scene.room.corners))
    return replace(scene, room=replace(scene.room, corners=corners), boxes=boxes, id="mirrored")


def case_of(scene: Scene, box_id: str) -> Case:
    return Case(scene.without(box_id), scene[box_id])


@pytest.mark.parametrize("angle", [0.0, 0.3, pi / 2, pi, 4.0])
@pytest.mark.parametrize("seen", ["as it is", "in a mirror"])
@pytest.mark.parametrize("box", ["bed", "cupboard"])
def test_a_copy_of_the_room_gives_the_true_pose_however_it_lies(
    angle: float,
    seen: str,
    box: str,
) -> None:
    lesson = bedroom(3)
    room = turned(mirrored(lesson) if seen == "in a mirror" else lesson, angle, (7, -2))
    (found,) = recall(case_of(room, box), lessons_of([lesson]))
    assert found.center == pytest.approx(room[box].center[:2])
    turn = found.heading - room[box].heading
    assert (cos(turn), sin(turn)) == pytest.approx((1, 0), abs=1e-6)


def test_the_room_with_the_same_furniture_comes_first() -> None:
    like, unlike = bedroom(1), bedroom(2, Box("t", "Table", (3, 2, 0.4), (0.6, 0.6, 0.8)))
    first, second = recall(case_of(bedroom(1), "bed"), lessons_of([unlike, like]))
    assert first.center == pytest.approx(like["bed"].center[:2])
    assert second.center == pytest.approx(unlike["bed"].center[:2])


def test_rooms_without_such_a_thing_are_not_remembered() -> None:
    hall = Scene(Room(((0, 0), (4, 0), (4, 3), (0, 3)), room_type="bedroom"), id="hall")
    assert recall(case_of(bedroom(1), "bed"), lessons_of([hall])) == []
