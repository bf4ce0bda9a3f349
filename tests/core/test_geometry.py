"""Plane geometry on arrays, against shapely on one shape at a time."""

from __future__ import annotations

from math import cos, hypot, inf, pi, sin, sqrt

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from shapely import LineString, Point, Polygon
from shapely import box as shapely_box
from shapely.affinity import rotate, translate

from scenegen_core.scene.geometry import (
    Rectangles,
    directions,
    distances_to_rectangles,
    distances_to_segments,
    gaps,
    left_of,
    ray_lengths,
    rays_hit,
    walls_as_rectangles,
    wrapped,
)

places = st.tuples(st.floats(-4, 4), st.floats(-4, 4))
angles = st.one_of(st.floats(-4, 4), st.integers(-8, 8).map(lambda n: n * pi / 4))
rectangles = st.builds(
    lambda center, half, heading: Rectangles(
        np.array([center]), np.array([half]), np.array([heading])
    ),
    places,
    st.tuples(st.floats(0.05, 2), st.floats(0.05, 2)),
    angles,
)


def polygon(rectangle: Rectangles) -> Polygon:
    """The one rectangle as shapely turns and shifts it."""
    (half, side), (x, y) = rectangle.halves[0], rectangle.centers[0]
    turned = rotate(shapely_box(-half, -side, half, side), rectangle.headings[0], use_radians=True)
    shape: Polygon = translate(turned, x, y)
    return shape


def test_corners_run_anticlockwise_from_front_left() -> None:
    sofa = Rectangles(np.array([[1.0, 2.0]]), np.array([[0.5, 1.0]]), np.array([pi / 2]))
    np.testing.assert_allclose(
        sofa.corners[0], [(0, 2.5), (0, 1.5), (2, 1.5), (2, 2.5)], atol=1e-12
    )


def test_axes_are_the_heading_and_a_quarter_anticlockwise_of_it() -> None:
    box = Rectangles(np.zeros((1, 2)), np.ones((1, 2)), np.array([pi / 2]))
    np.testing.assert_allclose(box.axes[0], [(0, 1), (-1, 0)], atol=1e-12)


@given(one=rectangles, other=rectangles)
def test_a_gap_is_the_distance_between_shapes_that_do_not_meet(
    one: Rectangles, other: Rectangles
) -> None:
    gap = gaps(one, other)[0, 0]
    assert max(gap, 0) == pytest.approx(polygon(one).distance(polygon(other)), abs=1e-9)
    assert gap == pytest.approx(gaps(other, one)[0, 0], abs=1e-9)


@given(one=rectangles, other=rectangles)
def test_a_negative_gap_is_how_far_one_must_move_to_part_them(
    one: Rectangles, other: Rectangles
) -> None:
    depth = -gaps(one, other)[0, 0]
    assume(depth > 1e-3)
    turns = [turn + k * pi / 2 for turn in (one.headings[0], other.headings[0]) for k in range(4)]

    def left_over(length: float, turn: float) -> float:
        shifted = translate(polygon(one), length * cos(turn), length * sin(turn))
        return float(shifted.intersection(polygon(other)).area)

    assert min(left_over(depth + 1e-6, turn) for turn in turns) == pytest.approx(0, abs=1e-9)
    assert min(left_over(depth * 0.9, k * pi / 16) for k in range(32)) > 0


def test_there_are_no_gaps_to_nothing() -> None:
    shapes = Rectangles(np.zeros((3, 2)), np.ones((3, 2)), np.zeros(3))
    assert gaps(shapes, shapes[:0]).shape == (3, 0)
    assert gaps(shapes[:0], shapes).shape == (0, 3)


@given(one=rectangles, start=places, end=places)
def test_a_wall_is_a_rectangle_without_width(
    one: Rectangles, start: tuple[float, float], end: tuple[float, float]
) -> None:
    assume(hypot(start[0] - end[0], start[1] - end[1]) > 1e-3)
    wall = walls_as_rectangles(np.array([[start, end]]))
    distance = polygon(one).distance(LineString([start, end]))
    assert max(gaps(one, wall)[0, 0], 0) == pytest.approx(distance, abs=1e-9)


@given(point=places, start=places, end=places)
def test_the_distance_to_a_segment_is_shapely_s(
    point: tuple[float, float], start: tuple[float, float], end: tuple[float, float]
) -> None:
    found = distances_to_segments(np.array([point]), np.array([[start, end]]))[0, 0]
    expected = Point(point).distance(LineString([start, end]))
    assert found == pytest.approx(expected, abs=1e-6)


@given(rectangles, places)
def test_the_distance_to_a_rectangle_is_shapely_s(
    shape: Rectangles, place: tuple[float, float]
) -> None:
    distance = distances_to_rectangles(np.array([place]), shape)[0, 0]
    assert distance == pytest.approx(polygon(shape).distance(Point(place)), abs=1e-9)


@given(point=places, turn=angles, start=places, end=places)
def test_a_ray_runs_until_it_meets_the_segment(
    point: tuple[float, float],
    turn: float,
    start: tuple[float, float],
    end: tuple[float, float],
) -> None:
    assume(hypot(start[0] - end[0], start[1] - end[1]) > 1e-3)
    toward = directions(np.array([turn]))
    segment = LineString([start, end])
    found = ray_lengths(np.array([point]), toward, np.array([[start, end]]))[0, 0]
    sight = LineString([point, (point[0] + 100 * cos(turn), point[1] + 100 * sin(turn))])
    ends = (
        sight.distance(Point(start)),
        sight.distance(Point(end)),
        segment.distance(Point(point)),
    )
    assume(min(ends) > 1e-6)  # a graze may go either way
    if sight.intersects(segment):
        assert found == pytest.approx(Point(point).distance(sight.intersection(segment)), abs=1e-6)
    else:
        assert found == inf


@given(point=places, turn=angles, other=rectangles)
def test_a_ray_hits_the_rectangle_that_lies_on_its_way(
    point: tuple[float, float], turn: float, other: Rectangles
) -> None:
    shape = polygon(other)
    sight = LineString([point, (point[0] + 100 * cos(turn), point[1] + 100 * sin(turn))])
    shared = sight.intersection(shape).length
    assume(shared > 1e-6 or sight.distance(shape) > 1e-6)  # a graze may go either way
    hit = rays_hit(np.array([point]), directions(np.array([turn])), other)[0, 0]
    assert bool(hit) == (shared > 0)


def test_a_ray_from_inside_hits_whichever_way_it_runs() -> None:
    box = Rectangles(np.array([[1.0, 1.0]]), np.array([[0.5, 0.5]]), np.array([0.3]))
    turns = np.linspace(-pi, pi, 16)
    assert rays_hit(np.full((16, 2), 1.1), directions(turns), box).all()


def test_a_ray_does_not_look_back() -> None:
    behind = Rectangles(np.array([[-3.0, 0.0]]), np.array([[0.5, 0.5]]), np.array([0.0]))
    wall = np.array([[[-2.0, -1.0], [-2.0, 1.0]]])
    here, ahead = np.zeros((1, 2)), np.array([[1.0, 0.0]])
    assert not rays_hit(here, ahead, behind).any()
    assert ray_lengths(here, ahead, wall)[0, 0] == inf
    assert ray_lengths(here, -ahead, wall)[0, 0] == pytest.approx(2)


def test_left_of_north_is_west() -> None:
    np.testing.assert_array_equal(left_of(np.array([[0.0, 1.0]])), [[-1.0, 0.0]])


def test_headings_are_directions_from_plus_x_anticlockwise() -> None:
    half = sqrt(0.5)
    np.testing.assert_allclose(
        directions(np.array([0, pi / 4, pi])), [(1, 0), (half, half), (-1, 0)], atol=1e-12
    )


@given(angle=st.floats(-100, 100))
def test_a_wrapped_angle_points_the_same_way(angle: float) -> None:
    small = float(wrapped(np.array([angle]))[0])
    assert -pi <= small < pi
    assert (cos(small), sin(small)) == pytest.approx((cos(angle), sin(angle)), abs=1e-9)
