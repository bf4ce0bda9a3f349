"""Shared by houses of ProcTHOR and rooms of AI2-THOR: Unity's values."""

from __future__ import annotations

from math import radians
from typing import Annotated

import numpy as np
from msgspec import Meta, Struct

from scenegen_core.datasets.outlines import point_of
from scenegen_core.scene.frames import heading_of_unity_turn, unity_to_core
from scenegen_core.scene.geometry import Floats
from scenegen_core.scene.model import Point

SOURCE = "thor"
Measure = Annotated[float, Meta(ge=-1e6, le=1e6)]
"""A number of Unity; those beyond are mistakes."""


class XYZ(Struct, frozen=True):
    """A position or a size in Unity's axes, metres; or turns about them, degrees."""

    x: Measure
    y: Measure
    z: Measure


def vector_of(value: XYZ) -> Floats:
    """The same as an array (3,)."""
    return np.array([value.x, value.y, value.z])


def plan_of(value: XYZ) -> Point:
    """The point of the plan under a position."""
    return point_of(unity_to_core(vector_of(value)))


def heading_of(rotation: XYZ) -> float:
    """The heading of a model that looks along Unity's +z before it is turned, radians."""
    return heading_of_unity_turn(radians(rotation.y))
