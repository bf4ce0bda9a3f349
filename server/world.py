"""What a running server has loaded; shared by all sessions, never changed."""

from __future__ import annotations

from dataclasses import dataclass

from scenegen_core.knowledge.files import default_knowledge, load_knowledge
from scenegen_core.knowledge.knowledge import Knowledge
from scenegen_core.placement.answer import MODELS
from server.assets import Assets
from server.catalogue import Catalogue
from server.edits import Vocabulary
from server.protocol import Welcome
from server.rooms import SampleRoom, sample_rooms
from server.settings import Settings
from server.translate import catalogue_items, category_infos


@dataclass(frozen=True, slots=True)
class World:
    """Knowledge, the catalogue, models and sample rooms."""

    knowledge: Knowledge
    catalogue: Catalogue
    assets: Assets
    rooms: dict[str, SampleRoom]
    lists: Welcome
    """A welcome without what is a session's own."""
    words: Vocabulary


def load_world(settings: Settings) -> World:
    """Load what the settings name; SceneGenError says what cannot be used."""
    path = settings.knowledge
    knowledge = default_knowledge() if path is None else load_knowledge(path)
    rooms = sample_rooms(settings.page)
    categories = category_infos(knowledge)
    placeable = tuple(info.name for info in categories if info.placeable)
    catalogue = Catalogue()
    if settings.catalogue is not None:
        from server.catalogue_files import load_catalogue  # noqa: PLC0415 (slow to import)

        catalogue = load_catalogue(settings.catalogue, placeable)
    assets = Assets(catalogue)
    return World(
        knowledge=knowledge,
        catalogue=catalogue,
        assets=assets,
        rooms=rooms,
        lists=Welcome(
            session="",
            revision=0,
            resumed=False,
            scene=None,
            categories=categories,
            catalogue=catalogue_items(catalogue, assets),
            rooms=tuple(room.info for room in rooms.values()),
            models=MODELS,
        ),
        words=Vocabulary(
            categories=tuple(info.name for info in categories),
            placeable=placeable,
            items=tuple(catalogue.by_id),
        ),
    )
