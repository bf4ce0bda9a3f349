"""What rooms have taught: densities of the relations of each category, learned, saved, loaded."""

from scenegen_core.knowledge.density import Density, Terms
from scenegen_core.knowledge.files import default_knowledge, load_knowledge, save_knowledge
from scenegen_core.knowledge.knowledge import CategoryKnowledge, Knowledge, Prior
from scenegen_core.knowledge.learning import learn
from scenegen_core.knowledge.sources import Source

__all__ = [
    "CategoryKnowledge",
    "Density",
    "Knowledge",
    "Prior",
    "Source",
    "Terms",
    "default_knowledge",
    "learn",
    "load_knowledge",
    "save_knowledge",
]
