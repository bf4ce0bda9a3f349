"""The axes of core and page, against a golden file that the page's tests read too."""

from __future__ import annotations

import json
from math import cos, degrees, radians, sin
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from scenegen_core.scene.frames import (
    heading_of_sweet_home_turn,
    heading_of_unity_turn,
    page_turn,
    sweet_home_to_core,
    to_core,
    to_page,
    unity_to_core,
)

GOLDEN: dict[str, Any] = json.loads(
    (Path(__file__).parents[1] / "golden" / "frames.json").read_text(encoding="utf-8")
)
CORE = np.array([pair["core"] for pair in GOLDEN["points"]], dtype=np.float64)
PAGE = np.array([pair["page"] for pair in GOLDEN["points"]], dtype=np.float64)
FRONTS = pytest.mark.parametrize("front", GOLDEN["fronts"], ids=lambda front: front["name"])


def test_core_points_become_the_page_points_of_the_golden_file() -> None:
    np.testing.assert_array_equal(to_page(CORE), PAGE)


def test_page_points_become_the_core_points_of_the_golden_file() -> None:
    np.testing.assert_array_equal(to_core(PAGE), CORE)


def test_the_swap_keeps_the_frame_right_handed() -> None:
    x, y, z = to_page(np.eye(3))
    np.testing.assert_array_equal(np.cross(x, y), z)


@FRONTS
def test_a_heading_is_the_turn_of_the_golden_file(front: dict[str, Any]) -> None:
    turn = page_turn(radians(front["heading_degrees"]))
    assert degrees(turn) == pytest.approx(front["turn_degrees"])


@FRONTS
def test_a_turned_model_looks_where_its_heading_points(front: dict[str, Any]) -> None:
    turn = page_turn(radians(front["heading_degrees"]))
    looks_along = [sin(turn), 0.0, cos(turn)]  # +z turned about +y
    np.testing.assert_allclose(looks_along, front["page_front"], atol=1e-12)


def test_what_unity_has_ahead_and_above_lies_ahead_and_above() -> None:
    right, up, forward = np.eye(3)
    assert unity_to_core(right).tolist() == [1, 0, 0]
    assert unity_to_core(forward).tolist() == [0, 1, 0]
    assert unity_to_core(up).tolist() == [0, 0, 1]


def test_unitys_left_hand_becomes_a_right_hand() -> None:
    right, up, forward = unity_to_core(np.eye(3))
    # Left-handed: right x up = forward only with the opposite sign of the usual product.
    np.testing.assert_array_equal(np.cross(right, up), -forward)


@pytest.mark.parametrize(("turn", "heading"), [(0, 90), (90, 0), (180, -90), (270, -180)])
def test_unity_turns_clockwise_from_straight_ahead(turn: float, heading: float) -> None:
    assert degrees(heading_of_unity_turn(radians(turn))) == pytest.approx(heading)


def test_a_sweet_home_plan_in_centimetres_has_y_turned_up() -> None:
    right, down = np.array([100.0, 0.0, 0.0]), np.array([0.0, 200.0, 50.0])
    assert sweet_home_to_core(right).tolist() == [1, 0, 0]
    assert sweet_home_to_core(down).tolist() == [0, -2, 0.5]
    assert sweet_home_to_core(down[:2]).tolist() == [0, -2]
    assert down.tolist() == [0, 200, 50]


@pytest.mark.parametrize(("turn", "heading"), [(0, -90), (90, -180), (180, -270), (-90, 0)])
def test_a_sweet_home_piece_turns_clockwise_from_facing_down(turn: float, heading: float) -> None:
    assert degrees(heading_of_sweet_home_turn(radians(turn))) == pytest.approx(heading)
