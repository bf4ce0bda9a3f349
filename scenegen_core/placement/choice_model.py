"""The model ``scenegen``: curves and surfaces of named relations that add up (docs/model.md)."""

from __future__ import annotations

from functools import cached_property

import numpy as np

from scenegen_core.graph.own_relations import OWN_RELATIONS, SIZE
from scenegen_core.graph.relations import measure
from scenegen_core.graph.situation import Situation
from scenegen_core.knowledge.knowledge import Knowledge
from scenegen_core.placement.blocks import in_blocks
from scenegen_core.placement.parts import Parts, Subject
from scenegen_core.scene.geometry import Floats


class ChoiceModel:
    """The tables of one category, ready to score poses."""

    expects = True

    def __init__(self, knowledge: Knowledge, category: str, *, pairs: bool = True) -> None:
        choice = knowledge.choice(category)
        self._choice = choice if pairs else choice.without_surfaces
        self._columns = [(column.relation, column.group) for column in self._choice.columns]
        self._subjects: tuple[Subject, ...] = tuple(
            dict.fromkeys(subject for subject in self._columns if subject[0] != SIZE.short)
        )

    def total(self, situation: Situation) -> Floats:
        """The log of how much likelier each pose is chosen: (n,). Uses all processors."""
        return in_blocks(self._score, situation)

    def _score(self, situation: Situation) -> Floats:
        return self._choice.score(measure(OWN_RELATIONS, situation))

    def parts(self, situation: Situation) -> Parts:
        """What every subject adds: its curves, and half of every surface that it has part in.

        Half each is the Shapley value of a pair. The object's own size is the same at every pose:
        what a surface with it says is all about the other column.
        """
        features = measure(OWN_RELATIONS, situation)
        measured: dict[Subject, dict[str, float]] = {subject: {} for subject in self._subjects}
        for column, value in zip(self._choice.columns, features[0].tolist(), strict=True):
            if column.relation != SIZE.short:
                measured[column.relation, column.group][column.part] = value
        return Parts(
            self._subjects,
            self._by_subject(self._choice.terms(features)),
            tuple(measured.values()),
        )

    def rooms(self, situation: Situation) -> tuple[str, ...]:
        """The rooms whose examples score for the most similar reasons."""
        here = self.parts(situation).values[0]
        differs = np.abs(self._known - here).sum(axis=1)
        return tuple(
            dict.fromkeys(self._choice.rooms[i] for i in np.argsort(differs, kind="stable"))
        )

    @cached_property
    def _known(self) -> Floats:
        """What every subject added where people chose: (examples, subjects)."""
        return self._by_subject(self._choice.terms_of_bins(self._choice.examples))

    def _by_subject(self, terms: Floats) -> Floats:
        """Curves and surfaces summed by subject: (n, subjects)."""
        return np.asarray(terms @ self._belongs, dtype=np.float64)

    @cached_property
    def _belongs(self) -> Floats:
        """What share of each curve and surface belongs to each subject: (terms, subjects)."""
        place = {subject: i for i, subject in enumerate(self._subjects)}
        terms = [(i, i) for i in range(len(self._columns))]
        terms += [(int(one), int(two)) for one, two in self._choice.pairs]
        shares = np.zeros((len(terms), len(place)))
        for share, term in zip(shares, terms, strict=True):
            columns = (self._columns[column] for column in term)
            about = [subject for subject in columns if subject[0] != SIZE.short]
            for subject in about:
                share[place[subject]] += 1 / len(about)
        return shares
