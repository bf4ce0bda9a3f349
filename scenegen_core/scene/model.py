"""The values everything else speaks of: categories, boxes, rooms, scenes.

Frame: metres, right-handed, z up, floor at z = 0; headings in radians anticlockwise from +x.
All values are frozen; an edit returns a new one.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from enum import Enum

from scenegen_core.errors import SceneError

Point = tuple[float, float]
Vector3 = tuple[float, float, float]


class Symmetry(Enum):
    """How a category of objects faces (paper, "Orientation Relationships")."""

    ASYMMETRIC = "asymmetric"
    """G_asym: can face any way (bed, chair, sofa, TV)."""
    SYMMETRIC = "symmetric"
    """G_sym: no front (decor, table)."""
    INSIDE_FACING = "inside facing"
    """G_in: always faces away from its wall (picture, storage)."""


@dataclass(frozen=True, slots=True)
class Category:
    """A group g_i of objects of one type.

    Categories are data, not an enumeration, so that knowledge can teach new ones.
    """

    name: str
    symmetry: Symmetry


PAPER_CATEGORIES: tuple[Category, ...] = (
    Category("Bed", Symmetry.ASYMMETRIC),
    Category("Chair", Symmetry.ASYMMETRIC),
    Category("Decor", Symmetry.SYMMETRIC),
    Category("Picture", Symmetry.INSIDE_FACING),
    Category("Sofa", Symmetry.ASYMMETRIC),
    Category("Storage", Symmetry.INSIDE_FACING),
    Category("Table", Symmetry.SYMMETRIC),
    Category("TV", Symmetry.ASYMMETRIC),
    Category("Other", Symmetry.SYMMETRIC),
)
"""The nine groups of the paper's implementation, in the order of its feature columns."""

OTHER = "Other"
"""The catch-all group: seen in a room, never placed (the paper learns no model of it)."""


@dataclass(frozen=True, slots=True)
class Box:
    """An object O_k: an upright box with a heading.

    ``center`` is the middle of the box; ``size`` is the full (depth along the heading, width,
    height) in metres; ``heading`` is the direction a_k of the front in radians.
    """

    id: str
    category: str
    center: Vector3
    size: Vector3
    heading: float = 0.0
    label: str = ""
    front_known: bool = True
    """False when only the axes are known, not which way the front points."""
    front_from_wall: bool = False
    """True when the front was inferred from the nearest wall: no evidence about orientation."""
    parent: str | None = None
    """Id of the box that it stands on, where the source says so."""
    placed: bool = False
    """True for a virtual object that was placed, False for furniture that is really there."""
    item: str | None = None
    """The catalogue item that a placed object shows."""

    @property
    def bottom(self) -> float:
        """Height of the underside above the floor, metres."""
        return self.center[2] - self.size[2] / 2

    @property
    def top(self) -> float:
        """Height of the upper side above the floor, metres."""
        return self.center[2] + self.size[2] / 2


@dataclass(frozen=True, slots=True)
class Opening:
    """A door or a window: a segment on the outline, from ``bottom`` to ``top`` above the floor."""

    start: Point
    end: Point
    bottom: float = 0.0
    top: float = 2.0
    id: str = ""


DEFAULT_HEIGHT = 2.6  # metres; used where a source gives no height of the ceiling


@dataclass(frozen=True, slots=True)
class Room:
    """The room R: a simple polygon, corners anticlockwise; wall W_i joins corner i to i+1."""

    corners: tuple[Point, ...]
    height: float = DEFAULT_HEIGHT
    doors: tuple[Opening, ...] = ()
    windows: tuple[Opening, ...] = ()
    room_type: str = ""

    @property
    def walls(self) -> tuple[tuple[Point, Point], ...]:
        """The walls W_1..W_l as segments, in order."""
        return tuple(zip(self.corners, (*self.corners[1:], self.corners[0]), strict=True))


@dataclass(frozen=True, slots=True)
class Scene:
    """A room with the boxes in it."""

    room: Room
    boxes: tuple[Box, ...] = ()
    id: str = ""
    name: str = ""
    source: str = ""
    _index: dict[str, Box] = field(init=False, repr=False, compare=False, hash=False)

    def __post_init__(self) -> None:
        """Index the boxes by id; two boxes of one id are an error."""
        index = {box.id: box for box in self.boxes}
        if len(index) != len(self.boxes):
            ids = [box.id for box in self.boxes]
            twice = next(i for i in ids if ids.count(i) > 1)
            raise SceneError(f"Two boxes have the id {twice!r}; give each its own.")
        object.__setattr__(self, "_index", index)

    def __getitem__(self, box_id: str) -> Box:
        """The box of that id; SceneError if there is none."""
        try:
            return self._index[box_id]
        except KeyError:
            raise SceneError(f"There is no box {box_id!r} in this room.") from None

    def __contains__(self, box_id: object) -> bool:
        return box_id in self._index

    def without(self, *box_ids: str) -> Scene:
        """The scene without those boxes."""
        return replace(self, boxes=tuple(box for box in self.boxes if box.id not in box_ids))

    def with_box(self, box: Box) -> Scene:
        """The scene with the box added, or put in the place of the one with the same id."""
        if box.id in self._index:
            boxes = tuple(box if old.id == box.id else old for old in self.boxes)
        else:
            boxes = (*self.boxes, box)
        return replace(self, boxes=boxes)

    def with_room(self, room: Room) -> Scene:
        """The scene with another room round the same boxes."""
        return replace(self, room=room)
