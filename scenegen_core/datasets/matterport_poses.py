"""Pose labels: which way the objects of Matterport3D face, which the data set does not say.

A file ``<house>.poses.json`` beside a house maps the index of an object to the axis of its box
that it faces along, ``{"12": {"axis": 2}}``, or to about where it faces, ``{"12": {"heading":
1.57}}`` in radians. The axes are numbered as :func:`level_axes` gives them.
"""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import msgspec
import numpy as np
from msgspec import Meta, Struct

from scenegen_core.datasets.contents import content
from scenegen_core.datasets.matterport_file import House, Thing
from scenegen_core.datasets.remarks import Report, Skipped
from scenegen_core.errors import DataError
from scenegen_core.scene.geometry import Floats


class Label(Struct, frozen=True, forbid_unknown_fields=True):
    """Which way an object faces: one of its level axes, or a heading near one, radians."""

    axis: Annotated[int, Meta(ge=0, le=3)] | None = None
    heading: float | None = None

    def __post_init__(self) -> None:
        """Refuse labels that say nothing or two things."""
        if (self.axis is None) == (self.heading is None):
            raise ValueError("a label is either an axis or a heading")

    def axis_of(self, headings: Floats) -> int:
        """The number of the labelled axis; ``headings`` (4,) are those of the axes, radians."""
        if self.axis is not None:
            return self.axis
        assert self.heading is not None
        return int(np.argmax(np.cos(headings - self.heading)))


def level_axes(thing: Thing) -> tuple[Floats, Floats]:
    """The four level directions of a box, (4, 2), and the depth and width along each, (4, 2) m.

    The first is the first level axis of the file, a; the next is b = c x a with c straight up, a
    quarter turn anticlockwise (eq. relabel_scheme); then -a and -b.
    """
    upright = int(np.argmax(np.abs(thing.axes[:, 2])))
    first, second = (i for i in range(3) if i != upright)
    a = thing.axes[first, :2] / np.linalg.norm(thing.axes[first, :2])
    b = np.array([-a[1], a[0]])
    size = 2 * thing.half[[first, second]]
    return np.array([a, b, -a, -b]), np.array([size, size[::-1], size, size[::-1]])


def labels_beside(path: Path, house: House, report: Report) -> dict[int, Label]:
    """The pose labels beside a house; those that are not usable are reported."""
    beside = path.with_name(f"{path.name.split('.')[0]}.poses.json")
    if not beside.exists():
        return {}
    try:
        raw = msgspec.json.decode(content(beside), type=dict[str, msgspec.Raw])
    except (msgspec.DecodeError, UnicodeDecodeError) as error:
        raise DataError(f"{beside} does not hold pose labels: {error}.") from None
    indices = {str(thing.index): thing.index for thing in house.things}
    labels: dict[int, Label] = {}
    for index, text in raw.items():
        try:
            labels[indices[index]] = msgspec.json.decode(text, type=Label)
        except KeyError:
            report(Skipped(beside, f"object {index!r}", "the house has no such object"))
        except msgspec.DecodeError as error:
            report(Skipped(beside, f"object {index!r}", str(error)))
    return labels
