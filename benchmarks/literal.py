"""Both models by the book, one pose at a time: what the compiled loops are measured against.

``paper``: statsmodels' ``KDEMultivariate.pdf`` of the paper's relations, one shapely call a
relation. ``scenegen``: our own relations by shapely, then one look into a table a term.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from statsmodels.nonparametric.kernel_density import KDEMultivariate

from scenegen_core.graph.candidates import Candidates
from scenegen_core.graph.relations import NEAR_WALL, NEARBY, Column
from scenegen_core.knowledge import Knowledge
from scenegen_core.knowledge.choice import HAIR, MISSING, edges_of
from scenegen_core.knowledge.knowledge import Prior
from scenegen_core.scene.model import Box, Scene
from tests.core import by_the_book as book
from tests.core.own_by_the_book import described

Score = Callable[[Box, Scene], float]


def paper(knowledge: Knowledge, category: str) -> Score:
    """P(d_p) · P(d_o) of a box in a scene."""
    known = knowledge[category]
    priors = known.position(), known.orientation()
    densities = [_statsmodels(prior) for prior in priors]

    def score(box: Box, scene: Scene) -> float:
        product = 1.0
        for prior, density in zip(priors, densities, strict=True):
            row = [_measured(column, box, scene) for column in prior.columns]
            product *= float(density.pdf(np.array([row])))
        return product

    return score


def _statsmodels(prior: Prior) -> KDEMultivariate:
    kinds = "".join("o" if ordered else "c" for ordered in prior.density.ordered)
    return KDEMultivariate(
        prior.density.rows, kinds, bw=prior.density.bandwidths, rng=np.random.default_rng(0)
    )


def _measured(column: Column, box: Box, scene: Scene) -> float:
    match column.relation:
        case "AD":
            return book.average_distance(box, scene, column.group)
        case "S":
            return book.surrounded_by(box, scene, column.group, NEARBY)
        case "F":
            return book.facing(box, scene, column.group, NEARBY)
        case "TC":
            return book.towards_center(box, scene)
        case _:
            return book.room_position(box, scene, NEAR_WALL)


def scenegen(knowledge: Knowledge, category: str) -> Score:
    """The sum of curves and surfaces of a box in a scene."""
    choice = knowledge.choice(category)
    edges = [edges_of(column) for column in choice.columns]

    def score(box: Box, scene: Scene) -> float:
        values = described(box, scene, knowledge.groups)
        bins = []
        for column, cuts in zip(choice.columns, edges, strict=True):
            value = values[column.relation, column.group, column.part]
            bins.append(MISSING if np.isnan(value) else sum(value >= cut - HAIR for cut in cuts))
        total = sum(float(choice.curves[c, one]) for c, one in enumerate(bins))
        pairs = enumerate(choice.pairs.tolist())
        return total + sum(float(choice.surfaces[k, bins[a], bins[b]]) for k, (a, b) in pairs)

    return score


def boxes(candidates: Candidates) -> list[Box]:
    """Every candidate as a box."""
    return [candidates.box(i, "new") for i in range(len(candidates))]
