"""What of a box its model depends on; boxes of one look share one GLB."""

from __future__ import annotations

from dataclasses import dataclass

from scenegen_core.scene.model import Box, Vector3


@dataclass(frozen=True, slots=True)
class Look:
    """Category, size in whole centimetres, label and catalogue item of an object."""

    category: str
    size: tuple[int, int, int]
    """Depth, width, height, centimetres: coarse, so that resizing does not flood the page."""
    label: str = ""
    item: str | None = None

    @property
    def metres(self) -> Vector3:
        """Depth, width, height, metres."""
        depth, width, height = self.size
        return depth / 100, width / 100, height / 100


def look_of(box: Box) -> Look:
    """The look of a box."""
    return look(box.category, box.size, label=box.label, item=box.item)


def look(category: str, size: Vector3, *, label: str = "", item: str | None = None) -> Look:
    """The look of an object of that size, metres."""
    depth, width, height = (max(1, round(length * 100)) for length in size)
    return Look(category, (depth, width, height), label, item)
