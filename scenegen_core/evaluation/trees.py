"""Gradient-boosted trees on the same columns, all interactions allowed: a yardstick, never shipped.

What a model that nobody can read gets out of the same choices: how much is lost by adding up named
curves and surfaces. LightGBM, with the same likelihood of what was chosen as objective.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Mapping
from functools import lru_cache
from importlib import import_module
from typing import Any

import numpy as np

from scenegen_core.evaluation.bench import Bench, Table
from scenegen_core.graph.own_relations import OWN_RELATIONS
from scenegen_core.graph.relations import measure
from scenegen_core.knowledge.boosting import ChoiceSets
from scenegen_core.knowledge.choice import binned, choice_columns
from scenegen_core.knowledge.knowledge import MIN_EXAMPLES, Knowledge
from scenegen_core.placement.choice_learning import together
from scenegen_core.placement.choice_sets import ChoiceSet
from scenegen_core.scene.geometry import Floats

Forest = Mapping[str, str]
"""Category -> the trees as LightGBM writes them."""

ROUNDS = 200
SETTINGS = {
    "num_leaves": 8, "learning_rate": 0.08, "min_data_in_leaf": 30, "lambda_l2": 5.0,
    "max_bin": 40, "feature_fraction": 0.3, "min_sum_hessian_in_leaf": 0.3, "seed": 0,
    "num_threads": 1, "deterministic": True, "verbose": -1,
}  # fmt: skip
"""The best of a dozen tried on one fold."""


def can_grow() -> bool:
    """Is LightGBM installed, with the OpenMP library that it needs of the system?"""
    try:
        import_module("lightgbm")
    except (ImportError, OSError):
        return False
    return True


def grow(chosen: Iterable[ChoiceSet]) -> Forest:
    """The trees of every category with enough choices."""
    import lightgbm  # noqa: PLC0415 (an optional extra)

    by_category: defaultdict[str, list[ChoiceSet]] = defaultdict(list)
    for one in chosen:
        by_category[one.category].append(one)
    forest = {}
    for category, some in by_category.items():
        if len(some) < MIN_EXAMPLES:
            continue
        sets = together(some, {})
        labels = np.zeros(len(sets.bins))
        labels[sets.starts] = 1
        data = lightgbm.Dataset(sets.bins.astype(np.float32), label=labels)
        settings = {**SETTINGS, "objective": _objective(sets, labels)}
        forest[category] = lightgbm.train(settings, data, ROUNDS).model_to_string()
    return forest


def trees(bench: Bench, table: Table, knowledge: Knowledge, _: np.random.Generator) -> Floats:
    """The score of every scored pose."""
    features = measure(OWN_RELATIONS, table.situation)
    bins = binned(features, choice_columns(knowledge.groups)).astype(np.float32)
    found = _planted(bench.forest[bench.category.name]).predict(bins, num_threads=1)
    return np.asarray(found, dtype=np.float64)


@lru_cache(maxsize=16)
def _planted(text: str) -> Any:
    import lightgbm  # noqa: PLC0415 (an optional extra)

    return lightgbm.Booster(model_str=text)


def _objective(sets: ChoiceSets, labels: Floats) -> Callable[[Floats, Any], tuple[Floats, Floats]]:
    """Gradient and curvature of the negative log-likelihood of what was chosen."""
    set_of = np.repeat(np.arange(len(sets.starts)), np.diff(np.append(sets.starts, len(labels))))

    def derivatives(predicted: Floats, _: Any) -> tuple[Floats, Floats]:
        scores = predicted + sets.log_weights
        mass = np.exp(scores - np.maximum.reduceat(scores, sets.starts)[set_of])
        share = mass / np.add.reduceat(mass, sets.starts)[set_of]
        return share - labels, np.maximum(share * (1 - share), 1e-4)

    return derivatives
