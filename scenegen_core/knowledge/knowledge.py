"""The knowledge model: for each category, the feature vectors of its examples (D_p and D_o)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from scenegen_core.errors import KnowledgeError
from scenegen_core.graph.relations import ABSENT, NEAR_WALL, NEARBY, SAME_DIRECTION, Column
from scenegen_core.knowledge.choice import MEASURED_WITH, Choice, Table
from scenegen_core.knowledge.density import Bandwidths, Density
from scenegen_core.knowledge.plans import Plan
from scenegen_core.knowledge.sources import Source
from scenegen_core.scene.geometry import Bools, Floats
from scenegen_core.scene.model import Category, Vector3
from scenegen_core.scene.resting import RESTS

POSITION = ("AD", "S", "RP")  # the paper's relations of position; Support is left out as there
ORIENTATION = ("F", "TC", "RP")  # the paper's relations of orientation ("Knowledge Model")
FIXED_BANDWIDTHS = {"AD": 0.1}  # metres; the paper's hand-tuned bandwidth of AverageDistance
STANDING = 0.3  # metres; what has its underside below stands on the floor (feet, plinths)
USUALLY = 0.3  # share of the examples from which on what stands speaks for the category
MIN_EXAMPLES = 5  # fewer say more about themselves than about the category

SETTINGS: Mapping[str, float] = {
    "near_wall": NEAR_WALL,
    "nearby": NEARBY,
    "same_direction": SAME_DIRECTION,
    "absent": ABSENT,
    "rests": RESTS,
    **MEASURED_WITH,
}
"""The constants that feature vectors depend on: knowledge measured with others does not fit."""


@dataclass(frozen=True, slots=True, eq=False)
class Prior:
    """What the examples of a category say about some relations."""

    density: Density
    columns: tuple[Column, ...]
    """What each column of the density is, in the order of ``measure``."""
    rooms: tuple[str, ...]
    """The id of the room that each example (row of the density) is from."""


@dataclass(frozen=True, eq=False)
class CategoryKnowledge:
    """The n examples of a category, measured by all relations."""

    category: Category
    columns: tuple[Column, ...]
    rows: Floats
    """Feature vectors: (n, columns)."""
    rooms: tuple[str, ...]
    """The id of the room of each example: n."""
    front_known: Bools
    """Is the heading evidence about orientation? (n,)"""
    sizes: Floats
    """Depth, width, height, metres: (n, 3)."""
    bottoms: Floats
    """Heights of the undersides above the floor, metres: (n,)."""
    weights: Floats
    """How much each example counts, positive: (n,)."""
    _priors: dict[tuple[tuple[str, ...], Bandwidths, bool], Prior] = field(
        default_factory=dict, init=False, repr=False
    )

    @property
    def examples(self) -> int:
        """How many examples there are."""
        return len(self.rows)

    @property
    def usual_size(self) -> Vector3:
        """Median depth, width, height, metres, of the half whose volumes are in the middle.

        Of what stands on the floor, where that is usual: upper cabinets are no usual storage.
        """
        standing = self.bottoms < STANDING
        sizes = self.sizes[standing] if standing.mean() >= USUALLY else self.sizes
        by_volume = sizes[np.argsort(sizes.prod(axis=1))]
        middle = by_volume[len(sizes) // 4 : len(sizes) - len(sizes) // 4]
        depth, width, height = np.median(middle, axis=0).tolist()
        return depth, width, height

    def position(
        self, relations: Sequence[str] = POSITION, *, bandwidths: Bandwidths = "bounded"
    ) -> Prior:
        """P(d_p(O) | D_p) for relations by their abbreviations; KnowledgeError if too few."""
        return self._prior(tuple(relations), bandwidths, fronts=False)

    def orientation(
        self, relations: Sequence[str] = ORIENTATION, *, bandwidths: Bandwidths = "bounded"
    ) -> Prior:
        """P(d_o(O) | D_o), from the examples whose front is known; KnowledgeError if too few."""
        return self._prior(tuple(relations), bandwidths, fronts=True)

    def _prior(self, relations: tuple[str, ...], bandwidths: Bandwidths, *, fronts: bool) -> Prior:
        """The prior, made when first asked for and kept."""
        key = (relations, bandwidths, fronts)
        if key not in self._priors:
            self._priors[key] = self._fit(relations, bandwidths, fronts=fronts)
        return self._priors[key]

    def _fit(self, relations: tuple[str, ...], bandwidths: Bandwidths, *, fronts: bool) -> Prior:
        which = np.flatnonzero(self.front_known) if fronts else np.arange(self.examples)
        if len(which) < MIN_EXAMPLES:
            kind = "examples whose front is known" if fronts else "examples"
            raise KnowledgeError(
                f"There are only {len(which)} {kind} of {self.category.name}, and {MIN_EXAMPLES} "
                "are needed; learn from more rooms that have one."
            )
        chosen = np.array([i for relation in relations for i in self._columns_of(relation)])
        names = tuple(self.columns[i] for i in chosen)
        density = Density.fit(
            self.rows[np.ix_(which, chosen)],
            [column.values for column in names],
            fixed={
                i: FIXED_BANDWIDTHS[column.relation]
                for i, column in enumerate(names)
                if column.relation in FIXED_BANDWIDTHS
            },
            bandwidths=bandwidths,
            weights=self.weights[which],
        )
        return Prior(density, names, tuple(self.rooms[i] for i in which))

    def _columns_of(self, relation: str) -> list[int]:
        found = [i for i, column in enumerate(self.columns) if column.relation == relation]
        if not found:
            raise KnowledgeError(
                f"This knowledge has not measured the relation {relation!r}; learn it again."
            )
        return found


@dataclass(frozen=True, eq=False)
class Knowledge:
    """What a corpus of rooms has taught."""

    groups: tuple[Category, ...]
    """The groups that the columns are about, in their order."""
    categories: Mapping[str, CategoryKnowledge]
    """The categories that there are examples of, by name, in the order of the groups."""
    sources: tuple[Source, ...]
    settings: Mapping[str, float]
    made_with: str
    """The program that learned it."""
    choices: Mapping[str, Choice] = field(default_factory=dict)
    """What is chosen of a category, by name, of those with enough examples."""
    shared: Table | None = None
    """The curves that all categories have in common; None where no choices were learned."""
    plans: Mapping[str, Plan] = field(default_factory=dict)
    """The rooms of the examples, to be drawn, by their ids."""

    def __getitem__(self, name: str) -> CategoryKnowledge:
        """The knowledge of a category; KnowledgeError if there is no example of it."""
        try:
            return self.categories[name]
        except KeyError:
            raise KnowledgeError(
                f"There are no examples of {name}; choose one of {', '.join(self.categories)}, or "
                "learn from rooms that have one."
            ) from None

    def choice(self, name: str) -> Choice:
        """What is chosen of a category; KnowledgeError if too few choices taught it."""
        if name not in self.choices:
            raise KnowledgeError(
                f"There are too few examples of {self[name].category.name} that could stand where "
                "they do; learn from more rooms that have one, or ask the model paper."
            )
        return self.choices[name]
