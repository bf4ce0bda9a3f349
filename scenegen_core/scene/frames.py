"""The only place where axes are swapped.

Core: right-handed, z up, heading anticlockwise from +x. Page, glTF and WebXR: right-handed,
y up; a model's front looks along +z (the glTF convention). Unity: left-handed, y up; a model's
front looks along +z, and it turns clockwise as seen from above. Sweet Home 3D: plans in
centimetres, x to the right, y down the page, z up; a piece's front looks down the page, and it
turns clockwise.
"""

from __future__ import annotations

from math import pi

import numpy as np

from scenegen_core.scene.geometry import Floats


def to_page(points: Floats) -> Floats:
    """Core points as page points, (…, 3) metres: x stays, z becomes y, y becomes −z."""
    return np.stack([points[..., 0], points[..., 2], -points[..., 1]], axis=-1)


def to_core(points: Floats) -> Floats:
    """Page points as core points, (…, 3) metres; the inverse of :func:`to_page`."""
    return np.stack([points[..., 0], -points[..., 2], points[..., 1]], axis=-1)


def page_turn(heading: float) -> float:
    """The turn about the page's +y, radians, that makes a model's +z front point along heading."""
    return heading + pi / 2


def unity_to_core(points: Floats) -> Floats:
    """Unity's points as core points, (…, 3) metres: y and z change places, which turns the hand."""
    return np.stack([points[..., 0], points[..., 2], points[..., 1]], axis=-1)


def heading_of_unity_turn(turn: float) -> float:
    """The heading of a model turned about Unity's +y, radians."""
    return pi / 2 - turn


def sweet_home_to_core(points: Floats) -> Floats:
    """Points of a Sweet Home 3D plan, (…, 2 or 3) centimetres, as core points in metres."""
    turned = points / 100
    turned[..., 1] = -turned[..., 1]
    return turned


def heading_of_sweet_home_turn(turn: float) -> float:
    """The heading of a piece of furniture that a Sweet Home 3D plan shows turned, radians."""
    return -pi / 2 - turn
