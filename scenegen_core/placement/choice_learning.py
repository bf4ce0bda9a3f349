"""Learning what is chosen: the tables of every category, from choices that people made."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from functools import partial

import numpy as np

from scenegen_core.knowledge.boosting import ChoiceSets, fit
from scenegen_core.knowledge.choice import Choice, Table, choice_columns, without_examples
from scenegen_core.knowledge.knowledge import MIN_EXAMPLES, Knowledge
from scenegen_core.knowledge.learning import Mapper, batches
from scenegen_core.placement.choice_sets import ChoiceSet, choice_sets
from scenegen_core.scene.model import Category, Scene

MOST = 1500  # choices of one category; more teach no more (docs/model.md, the learning curve)
SHARED = 90  # choices of each category that teach what all furniture has in common


def gather(
    scenes: Sequence[Scene],
    groups: tuple[Category, ...],
    *,
    mapper: Mapper = map,
    progress: Callable[[int], None] = lambda _: None,
) -> tuple[ChoiceSet, ...]:
    """The choices made in the scenes; ``progress`` is told how many rooms are done."""
    found: list[ChoiceSet] = []
    done = 0
    for batch, some in zip(
        batches(scenes), mapper(partial(choice_sets, groups=groups), batches(scenes)), strict=True
    ):
        found.extend(some)
        done += len(batch)
        progress(done)
    return tuple(found)


def with_choices(
    knowledge: Knowledge,
    chosen: Iterable[ChoiceSet],
    *,
    weights: Mapping[str, float] | None = None,
    before: Knowledge | None = None,
    seed: int = 0,
) -> Knowledge:
    """The knowledge with what the choices teach, of every category that has enough of them.

    What all categories have in common is learned first, then how each differs from it: few examples
    are then enough. ``weights`` says how much a choice of a source counts, 1 where it is silent.
    ``before`` is knowledge to go on from: its choices are kept, and further ones adjust them.
    """
    by_category: defaultdict[str, list[ChoiceSet]] = defaultdict(list)
    for one in chosen:
        by_category[one.category].append(one)
    rng = np.random.default_rng(seed)
    enough = {
        name: _some(by_category[name], MOST, rng)
        for name in knowledge.categories
        if len(by_category[name]) >= MIN_EXAMPLES
    }
    if not enough:
        return knowledge
    shared = before.shared if before is not None else None
    if shared is None:
        shared = _in_common(enough, weights or {}, rng)
    known = before.choices if before is not None else {}
    learnt = {
        name: _learnt(knowledge, some, weights or {}, known.get(name), shared, rng)
        for name, some in enough.items()
    }
    in_order = {name: {**known, **learnt}.get(name) for name in knowledge.categories}
    choices = {name: choice for name, choice in in_order.items() if choice is not None}
    return replace(knowledge, choices=choices, shared=shared)


def _some(chosen: list[ChoiceSet], most: int, rng: np.random.Generator) -> list[ChoiceSet]:
    if len(chosen) <= most:
        return chosen
    return [chosen[i] for i in np.sort(rng.choice(len(chosen), most, replace=False))]


def _in_common(
    by_category: Mapping[str, list[ChoiceSet]],
    weights: Mapping[str, float],
    rng: np.random.Generator,
) -> Table:
    """The curves that all categories share, each category counting alike: (columns, BINS)."""
    some = {name: _some(chosen, SHARED, rng) for name, chosen in by_category.items()}
    sets = together([one for chosen in some.values() for one in chosen], weights)
    alike = np.concatenate([np.full(len(chosen), SHARED / len(chosen)) for chosen in some.values()])
    return fit(replace(sets, weights=sets.weights * alike), rng=rng, surfaces=0).curves


def _learnt(
    knowledge: Knowledge,
    chosen: list[ChoiceSet],
    weights: Mapping[str, float],
    known: Choice | None,
    shared: Table,
    rng: np.random.Generator,
) -> Choice:
    """The tables of a category: what is known, or shared, and how the choices differ from it."""
    base = known or without_examples(choice_columns(knowledge.groups), shared)
    own = fit(together(chosen, weights), rng=rng, base=base)
    examples = np.stack([one.bins[0] for one in chosen])
    return Choice(
        columns=base.columns,
        curves=base.curves + own.curves,
        pairs=np.concatenate([base.pairs, own.pairs]),
        surfaces=np.concatenate([base.surfaces, own.surfaces]),
        examples=np.concatenate([base.examples, examples]),
        rooms=(*base.rooms, *(one.room for one in chosen)),
    )


def together(chosen: Sequence[ChoiceSet], weights: Mapping[str, float]) -> ChoiceSets:
    """Choices of one category as arrays."""
    lengths = np.array([len(one.bins) for one in chosen])
    return ChoiceSets(
        bins=np.concatenate([one.bins for one in chosen]),
        starts=np.concatenate([[0], np.cumsum(lengths)[:-1]]),
        log_weights=np.concatenate([one.log_weights for one in chosen]),
        weights=np.array([weights.get(one.source, 1.0) for one in chosen]),
    )
