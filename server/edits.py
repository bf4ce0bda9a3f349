"""Edits of a scene, and why one is refused."""

from __future__ import annotations

from dataclasses import dataclass
from functools import reduce

from scenegen_core.errors import SceneError
from scenegen_core.scene.files import MAX_BOXES, BoxRecord, box_of, room_of, scene_of
from scenegen_core.scene.model import Scene
from server.protocol import Edit, Problem, PutBoxes, PutRoom, PutScene, Query, RemoveBox

PARTS: dict[type[Edit], str] = {
    PutScene: "$.scene",
    PutRoom: "$.room",
    PutBoxes: "$.boxes",
    RemoveBox: "$.id",
}
"""Where in an edit the thing is that can be wrong."""


@dataclass(frozen=True, slots=True)
class Vocabulary:
    """The names that a page may use."""

    categories: tuple[str, ...]
    placeable: tuple[str, ...]
    items: tuple[str, ...]


def edited(scene: Scene | None, edit: Edit, words: Vocabulary) -> Scene | Problem | None:
    """The scene after the edit (None if there is no room yet), or why the edit is refused."""
    wrong = _wrong_category(edit, words)
    if wrong is not None:
        return wrong
    try:
        after = _apply(scene, edit)
    except SceneError as error:
        return Problem(code="bad_scene", text=str(error), path=PARTS[type(edit)], seq=edit.seq)
    if after is not None and len(after.boxes) > MAX_BOXES:
        return Problem(
            code="too_many_boxes",
            text=f"A room holds at most {MAX_BOXES} boxes. Remove one before adding another.",
            path="$.boxes",
            seq=edit.seq,
        )
    return after


def wrong_query(query: Query, words: Vocabulary) -> Problem | None:
    """Why a query cannot be answered, if so."""
    if query.category not in words.placeable:
        return Problem(
            code="bad_query",
            text=f"{query.category!r} cannot be placed; "
            f"choose one of {', '.join(words.placeable)}.",
            path="$.query.category",
        )
    if query.item is not None and query.item not in words.items:
        return Problem(
            code="bad_query",
            text=f"There is no item {query.item!r} in the catalogue; choose another.",
            path="$.query.item",
        )
    return None


def _apply(scene: Scene | None, edit: Edit) -> Scene | None:
    match edit:
        case PutScene():
            return scene_of(edit.scene)
        case PutRoom():
            room = room_of(edit.room)
            return Scene(room) if scene is None else scene.with_room(room)
        case PutBoxes():
            if scene is None:
                raise SceneError("There is no room yet; draw its walls first.")
            return reduce(Scene.with_box, map(box_of, edit.boxes), scene)
        case RemoveBox():
            return None if scene is None else scene.without(edit.id)


def _wrong_category(edit: Edit, words: Vocabulary) -> Problem | None:
    for path, box in _boxes(edit):
        if box.category not in words.categories:
            return Problem(
                code="bad_scene",
                text=f"There is no category {box.category!r}; "
                f"choose one of {', '.join(words.categories)}.",
                path=f"{path}.category",
                seq=edit.seq,
            )
    return None


def _boxes(edit: Edit) -> list[tuple[str, BoxRecord]]:
    """The boxes that an edit brings, with their paths."""
    match edit:
        case PutScene():
            return [(f"$.scene.boxes[{i}]", box) for i, box in enumerate(edit.scene.boxes)]
        case PutBoxes():
            return [(f"$.boxes[{i}]", box) for i, box in enumerate(edit.boxes)]
        case PutRoom() | RemoveBox():
            return []
