"""What files of AI2-THOR's object metadata say: the objects of one room, or of many."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import msgspec
import numpy as np
from msgspec import Struct, field

from scenegen_core.datasets.contents import Head, content
from scenegen_core.datasets.plans import scene_id
from scenegen_core.datasets.remarks import Report, Skipped
from scenegen_core.datasets.thor import XYZ, Measure
from scenegen_core.errors import DataError, SceneError
from scenegen_core.scene.files import MAX_ID
from scenegen_core.scene.geometry import Floats

KINDS = {0: "kitchen", 2: "living room", 3: "bedroom", 4: "bathroom"}  # by hundreds of FloorPlan312


class Corners(Struct, frozen=True):
    """The eight corners of a box."""

    points: tuple[tuple[Measure, Measure, Measure], ...] = field(name="cornerPoints")


class Thing(Struct, frozen=True):
    """An object of a room."""

    id: str = field(name="objectId")
    label: str = field(name="objectType")
    rotation: XYZ
    asset: str = field(name="assetId", default="")
    along_axes: Corners | None = field(name="axisAlignedBoundingBox", default=None)
    oriented: Corners | None = field(name="objectOrientedBoundingBox", default=None)
    parents: tuple[str, ...] | None = field(name="parentReceptacles", default=None)

    @property
    def corners(self) -> Floats:
        """The corners of its box in Unity's axes, (8, 3) metres; SceneError if it has none."""
        box = self.oriented or self.along_axes
        if box is None or not box.points:
            raise SceneError("it has no box")
        return np.array(box.points)


Things = tuple[msgspec.Raw, ...]
"""The objects of a room, undecoded, so that broken ones can be left out."""


class _Event(Struct, frozen=True):
    """The metadata of an event."""

    objects: Things
    scene: str = field(name="sceneName", default="")


def rooms(path: Path) -> Iterator[tuple[str, str, Things]]:
    """The id, the type and the objects of each room."""
    fields, text = Head(path).fields, content(path)
    try:
        if "objectId" in fields:
            yield scene_id(path), "", msgspec.json.decode(text, type=Things)
        elif "objects" in fields:
            event = msgspec.json.decode(text, type=_Event)
            yield event.scene[:MAX_ID] or scene_id(path), _kind_of(event.scene), event.objects
        else:
            kinds = msgspec.json.decode(text, type=dict[str, tuple[Things, ...]])
            for kind, of_kind in kinds.items():
                for number, things in enumerate(of_kind, start=1):
                    yield scene_id(path, kind, str(number)), _in_words(kind), things
    except (msgspec.DecodeError, UnicodeDecodeError) as error:
        raise DataError(f"{path} is not a list of AI2-THOR's objects: {error}.") from None


def _kind_of(scene: str) -> str:
    """The type of an iTHOR room by its number; empty for others."""
    number = scene.removeprefix("FloorPlan").split("_")[0]
    return KINDS.get(int(number) // 100, "") if number.isdigit() else ""


def _in_words(kind: str) -> str:
    """The type of the rooms of a list: those of "living_rooms" are living rooms."""
    return kind.removesuffix("s").replace("_", " ")


def things_of(raw: Things, path: Path, report: Report) -> Iterator[Thing]:
    """The objects that have a box; the others are reported."""
    for number, text in enumerate(raw):
        try:
            thing = msgspec.json.decode(text, type=Thing)
            _ = thing.corners
        except (msgspec.DecodeError, UnicodeDecodeError, SceneError) as error:
            report(Skipped(path, f"object {number}", str(error)))
        else:
            yield thing
