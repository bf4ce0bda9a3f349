"""The models that can be asked, behind one interface: scores of poses, taken apart into parts."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from typing import Protocol

from scenegen_core.graph.situation import Situation
from scenegen_core.knowledge.knowledge import Knowledge
from scenegen_core.placement.answer import Model
from scenegen_core.placement.choice_model import ChoiceModel
from scenegen_core.placement.paper_model import PaperModel
from scenegen_core.placement.parts import Parts
from scenegen_core.scene.geometry import Floats


class PlacementModel(Protocol):
    """What is known of one category, ready to score poses."""

    @property
    def expects(self) -> bool:
        """Are its scores log-probabilities, fit to choose by expected distance?"""

    def total(self, situation: Situation) -> Floats:
        """The log scores of all poses of a situation, up to a constant of the room: (n,)."""

    def parts(self, situation: Situation) -> Parts:
        """The scores of a few poses taken apart; the parts add up to the totals."""

    def rooms(self, situation: Situation) -> tuple[str, ...]:
        """The known rooms that speak for the single pose of a situation, the loudest first."""


_MODELS: dict[Model, Callable[[Knowledge, str], PlacementModel]] = {
    "scenegen": ChoiceModel,
    "paper": PaperModel,
}


@lru_cache(maxsize=64)
def model_of(name: Model, knowledge: Knowledge, category: str) -> PlacementModel:
    """A model of a category, made once; KnowledgeError if too little is known."""
    return _MODELS[name](knowledge, category)
