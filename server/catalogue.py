"""What a user's own catalogue offers; ``catalogue_files`` reads it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

from scenegen_core.scene.model import Vector3


@dataclass(frozen=True, slots=True)
class Item:
    """A piece of the catalogue, ready to be shown."""

    id: str
    """Its path without the ending."""
    name: str
    category: str
    size: Vector3
    """Depth, width, height, metres."""
    data: bytes
    """GLB; its origin is the center of the base, or of the back where it hangs on the wall."""


@dataclass(frozen=True)
class Catalogue:
    """What a directory offers, and a sentence for every file that was skipped."""

    items: tuple[Item, ...] = ()
    problems: tuple[str, ...] = ()

    @cached_property
    def by_id(self) -> Mapping[str, Item]:
        """The items by their id."""
        return {item.id: item for item in self.items}
