"""The reductions of the paper ("Category reduction"): which rooms and boxes are fit to learn from.

The paper keeps eleven types of rooms, and takes out by hand the rooms of outlier areas and those
whose boxes are wrong; here each reduction is a rule, and is counted.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from statistics import median

from shapely import Polygon

from scenegen_core.datasets.drawn_in import drawn_in
from scenegen_core.scene.geometry import footprints
from scenegen_core.scene.model import Box, Category, Scene

ROOM_TYPES = (
    "library", "living room", "meeting room", "TV room", "bedroom", "rec room", "office",
    "dining room", "family room", "kitchen", "lounge",
)  # fmt: skip
"""The types of rooms that the paper keeps ("Category reduction")."""

AREAS = (3.0, 100.0)  # square metres; the paper took out outliers by hand and gives no limits
THINNEST = 0.001  # metres; a box thinner than that was not measured
OUTSIDE = 0.5  # share of the footprint; a box that is further out than that is a wrong box
OUTLINE_ERROR = 0.1  # metres; pictures hang in the thickness that outlines take off the walls
STANDING = ("Bed", "Chair", "Sofa", "Table")  # what stands on the floor, unless it is far above it
FLOOR_ERROR = 0.3  # metres; undersides that near to z = 0 show where a source has its floor
LEVEL = 0.02  # metres; a floor that near to z = 0 is left as it is

BEHIND = {"robot-at-virtualhome": 0.08}
"""Source -> how far behind the faces of its walls its outlines run, metres. In Robot@VirtualHome
all pictures hang 0.1 m from the outline, and what is pushed against walls is 0.08 to 0.11 m off."""


@dataclass(frozen=True, slots=True)
class Reductions:
    """What was taken out or put right, and what is left."""

    other_room_types: int
    """Rooms of a type outside the set."""
    outlier_areas: int
    """Rooms too small or too large."""
    thin_boxes: int
    """Boxes without depth, width or height."""
    outside_boxes: int
    """Boxes that lie mostly outside of their room."""
    empty_rooms: int
    """Rooms in which no box is left."""
    uneven_floors: int
    """Rooms whose floor was not at z = 0; they are kept, their boxes put on it."""
    rooms: int
    """Rooms that are left."""
    boxes: int
    """Boxes that are left."""


def recategorized(scene: Scene, categories: Iterable[Category]) -> Scene:
    """The scene whose boxes of a further category's name, or with it as label, are of it."""
    by_letters = {_letters(category.name): category.name for category in categories}
    if not by_letters:
        return scene
    boxes = (
        replace(box, category=found)
        if (found := by_letters.get(_letters(box.label)) or by_letters.get(_letters(box.category)))
        else box
        for box in scene.boxes
    )
    return replace(scene, boxes=tuple(boxes))


def clean(
    scenes: Iterable[Scene],
    *,
    room_types: Iterable[str] = ROOM_TYPES,
    areas: tuple[float, float] = AREAS,
) -> tuple[tuple[Scene, ...], Reductions]:
    """The scenes that are fit to learn from, without wrong boxes, and what was done to them.

    Room types are compared by their letters alone, and a room that holds one of the words counts:
    "LivingRoom/Kitchen" is a living room. A room whose type nobody says is kept. ``areas``: least
    and most, square metres.
    """
    words = tuple(_letters(word) for word in room_types)
    everything = [_in_its_walls(scene) for scene in scenes]
    typed = [scene for scene in everything if _is_one_of(scene.room.room_type, words)]
    sized = [scene for scene in typed if areas[0] <= _outline(scene).area <= areas[1]]
    solid = [_keep(scene, _solid(scene)) for scene in sized]
    inside = [_keep(scene, _inside(scene)) for scene in solid]
    furnished = [scene for scene in inside if scene.boxes]
    level = tuple(_put_on_floor(scene) for scene in furnished)
    return level, Reductions(
        other_room_types=len(everything) - len(typed),
        outlier_areas=len(typed) - len(sized),
        thin_boxes=_boxes(sized) - _boxes(solid),
        outside_boxes=_boxes(solid) - _boxes(inside),
        empty_rooms=len(inside) - len(furnished),
        uneven_floors=sum(one is not other for one, other in zip(furnished, level, strict=True)),
        rooms=len(level),
        boxes=_boxes(level),
    )


def _in_its_walls(scene: Scene) -> Scene:
    """The scene with its walls where their faces are."""
    return drawn_in(scene, BEHIND[scene.source]) if scene.source in BEHIND else scene


def _letters(word: str) -> str:
    return "".join(filter(str.isalpha, word)).lower()


def _is_one_of(room_type: str, words: tuple[str, ...]) -> bool:
    letters = _letters(room_type)
    return not letters or any(word in letters for word in words)


def _outline(scene: Scene) -> Polygon:
    return Polygon(scene.room.corners)


def _solid(scene: Scene) -> Iterator[Box]:
    """The boxes that have a depth, a width and a height."""
    return (box for box in scene.boxes if min(box.size) >= THINNEST)


def _inside(scene: Scene) -> Iterator[Box]:
    """The boxes whose footprint lies at least half in the room."""
    room = _outline(scene).buffer(OUTLINE_ERROR)
    for box, corners in zip(scene.boxes, footprints(scene.boxes).corners, strict=True):
        footprint = Polygon(corners)
        if footprint.difference(room).area <= OUTSIDE * footprint.area:
            yield box


def _put_on_floor(scene: Scene) -> Scene:
    """The scene with its boxes moved up or down so that what stands, stands at z = 0.

    Some sources measure heights from under the floor (Robot@VirtualHome: from 0.1 m below).
    """
    bottoms = [box.bottom for box in scene.boxes if box.category in STANDING]
    near = [bottom for bottom in bottoms if abs(bottom) <= FLOOR_ERROR]
    floor = median(near) if near else 0.0
    if abs(floor) <= LEVEL:
        return scene
    return _keep(scene, (_raised(box, -floor) for box in scene.boxes))


def _raised(box: Box, by: float) -> Box:
    x, y, z = box.center
    return replace(box, center=(x, y, z + by))


def _keep(scene: Scene, boxes: Iterable[Box]) -> Scene:
    return replace(scene, boxes=tuple(boxes))


def _boxes(scenes: Iterable[Scene]) -> int:
    return sum(len(scene.boxes) for scene in scenes)
