"""The density of a feature vector under examples: a mixed-kernel estimate, in logarithms.

The paper's "Scene Augmentation": one product kernel an example, Gaussian for continuous columns,
Wang–Ryzin for ordered ones, normal-reference bandwidths; the estimate of statsmodels'
``KDEMultivariate``. Summed in logarithms, so nothing underflows and nothing ties.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import log, pi
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from scipy.special import entr

from scenegen_core.graph.relations import ABSENT
from scenegen_core.scene.geometry import Bools, Floats

Kind = Literal["continuous", "ordered"]
Bandwidths = Literal["bounded", "paper"]

RULE_OF_THUMB = 1.06  # Scott's normal reference factor, as statsmodels has it
ORDERED_BOUNDS = (0.02, 0.9)  # above 1 the Wang–Ryzin kernel is negative, at 0 it has no logarithm
CONSTANT_BANDWIDTH = 0.1  # of a continuous column that never varies; the paper's hand-tuned width
DISAGREEMENT = -1e4  # nats; one group there in the query and not in the example, or vice versa
BLOCK = 1 << 17  # pairs of query and example worked on at a time: 1 MB, which stays in the cache


@dataclass(frozen=True, eq=False)
class Terms:
    """Why a log density is what it is: columns + agreement = log density, exactly."""

    columns: Floats
    """(queries, columns): the log kernels of a column, averaged by the responsibilities."""
    agreement: Floats
    """(queries,): how many examples share the word, against all: entropy − log n, and what they
    disagree about; at most 0."""
    responsibilities: Floats
    """(queries, n): how much of the density each example carries; a row sums to 1."""


@dataclass(frozen=True, eq=False)
class Density:
    """A kernel density over examples; made by :meth:`fit`."""

    rows: Floats
    """The examples: (n, columns)."""
    ordered: Bools
    """(columns,): Wang–Ryzin where true, Gaussian where false."""
    can_be_absent: Bools
    """(columns,): continuous columns where the value ABSENT says that a group has no members."""
    bandwidths: Floats
    """(columns,): σ of the Gaussian, λ of Wang–Ryzin."""
    log_shares: Floats
    """(n,): the logarithm of the share of each example; −log n where all weigh the same."""

    @classmethod
    def fit(
        cls,
        rows: Floats,
        kinds: Sequence[Kind],
        *,
        fixed: Mapping[int, float] | None = None,
        bandwidths: Bandwidths = "bounded",
        weights: Floats | None = None,
    ) -> Density:
        """The density of examples (n, columns), n at least 1, with one kind a column.

        Ordered columns hold whole numbers, in examples and in queries.
        ``fixed`` gives bandwidths by column; continuous columns with one may hold ABSENT. The
        others follow the rule of thumb 1.06 σ n^(−1/(4 + columns)). ``bandwidths="paper"`` leaves
        the ordered ones unbounded, as the paper does. ``weights`` (n,), positive, say how much each
        example counts; the rule of thumb does not look at them.
        """
        ordered = np.array([kind == "ordered" for kind in kinds], dtype=np.bool_)
        widths = RULE_OF_THUMB * rows.std(axis=0) * len(rows) ** (-1.0 / (4 + rows.shape[1]))
        widths[~ordered & (widths == 0)] = CONSTANT_BANDWIDTH
        if bandwidths == "bounded":
            widths[ordered] = widths[ordered].clip(*ORDERED_BOUNDS)
        is_fixed = np.zeros_like(ordered)
        for column, width in (fixed or {}).items():
            widths[column] = width
            is_fixed[column] = True
        weights = np.ones(len(rows)) if weights is None else weights
        return cls(rows, ordered, is_fixed & ~ordered, widths, np.log(weights / weights.sum()))

    @property
    def sign(self) -> int:
        """The sign of the density: −1 when an odd number of ordered bandwidths pass 1.

        The factor 1 − λ of the Wang–Ryzin kernel is common to all examples, so one sign holds for
        all queries. Bounded bandwidths always give 1.
        """
        return -1 if np.count_nonzero(self.bandwidths[self.ordered] > 1) % 2 else 1

    def log_density(self, queries: Floats) -> Floats:
        """The log density of queries (q, columns): (q,), always finite.

        Only the examples that disagree least about which groups are present speak (at the paper's
        bandwidth of 0.1 the others carry exp(−5e7) of it); each disagreement costs DISAGREEMENT
        and drops its column. With the paper's unbounded bandwidths a density can be negative:
        then −log |density| is returned, which ranks as the negative density does.
        """
        result = np.empty(len(queries))
        for which, members in self._patterns(queries):
            agrees = self._agreement(queries[which[0]], members)
            for part in _blocks(which, len(members)):
                block = queries[part]
                scores = np.tile(self.log_shares[members], (len(part), 1))
                for column in range(self.rows.shape[1]):
                    scores += self._log_kernels(column, block, members, agrees)
                top = scores.max(axis=1, keepdims=True)
                scores -= top
                result[part] = top[:, 0] + np.log(np.exp(scores, out=scores).sum(axis=1))
        return self.sign * result

    def terms(self, queries: Floats) -> Terms:
        """The exact additive split of the log density of a few queries (q, columns).

        With s_i the log kernel product of example i, w_i its share and r = softmax(s + log w),
        log Σ w_i exp s_i is Σ r_i s_i + entropy(r) + Σ r_i log w_i, and s_i is a sum over columns.
        All examples that speak disagree with the query about equally many groups; what that costs
        is part of the agreement.
        """
        columns, agreement = np.empty(queries.shape), np.empty(len(queries))
        responsibilities = np.zeros((len(queries), len(self.rows)))
        for which, members in self._patterns(queries):
            agrees = self._agreement(queries[which[0]], members)
            kernels = np.stack(
                [
                    self._log_kernels(column, queries[which], members, agrees)
                    for column in range(self.rows.shape[1])
                ]
            )
            dropped = ~agrees.T[:, None, :]
            cost = DISAGREEMENT * np.count_nonzero(dropped[:, 0, 0])
            kernels[np.broadcast_to(dropped, kernels.shape)] = 0.0
            scores = kernels.sum(axis=0) + self.log_shares[members]
            shares = np.exp(scores - scores.max(axis=1, keepdims=True))
            shares /= shares.sum(axis=1, keepdims=True)
            columns[which] = np.einsum("cqi,qi->qc", kernels, shares)
            responsibilities[np.ix_(which, members)] = shares
            agreement[which] = cost
        agreement += entr(responsibilities).sum(axis=1) + responsibilities @ self.log_shares
        return Terms(self.sign * columns, self.sign * agreement, responsibilities)

    def _patterns(self, queries: Floats) -> list[tuple[NDArray[np.intp], NDArray[np.intp]]]:
        """Queries that miss the same groups, each set with the examples that disagree least."""
        absent = queries[:, self.can_be_absent] == ABSENT
        known = self.rows[:, self.can_be_absent] == ABSENT
        left = np.arange(len(queries))
        pairs = []
        while len(left):
            pattern = absent[left[0]]
            alike = (absent[left] == pattern).all(axis=1)
            disagreements = np.count_nonzero(known != pattern, axis=1)
            members = np.flatnonzero(disagreements == disagreements.min())
            pairs.append((left[alike], members))
            left = left[~alike]
        return pairs

    def _agreement(self, query: Floats, members: NDArray[np.intp]) -> Bools:
        """Do query and example agree on whether the column's group is there? (members, columns)."""
        absent: Bools = self.rows[members] == ABSENT
        agrees: Bools = ~self.can_be_absent | (absent == (query == ABSENT))
        return agrees

    def _log_kernels(
        self, column: int, queries: Floats, members: NDArray[np.intp], agrees: Bools
    ) -> Floats:
        """The log kernels of one column: (queries, members)."""
        values, examples = queries[:, column], self.rows[members, column]
        width = float(self.bandwidths[column])
        if self.ordered[column]:
            lowest = values.min()
            levels = np.arange(lowest, values.max() + 1)
            table: Floats = _wang_ryzin(levels[:, None] - examples, width)
            looked_up: Floats = table[(values - lowest).astype(np.intp)]
            return looked_up
        kernels: Floats = np.subtract.outer(values / width, examples / width)
        kernels *= kernels
        kernels *= -0.5
        kernels -= log(width) + 0.5 * log(2 * pi)
        kernels[:, ~agrees[:, column]] = DISAGREEMENT
        return kernels


def _wang_ryzin(differences: Floats, width: float) -> Floats:
    """The logarithm of the size of the Wang–Ryzin kernel: 1 − λ, else (1 − λ)/2 · λ^|d|.

    A factor 0 (λ of 0 or of exactly 1) counts as a disagreement, so the result is finite.
    """
    distances = np.abs(differences)
    smooth = log(width) if width > 0 else DISAGREEMENT
    scale = log(abs(1 - width)) if width != 1 else DISAGREEMENT
    return scale + np.where(distances == 0, 0.0, distances * smooth - log(2))


def _blocks(which: NDArray[np.intp], members: int) -> list[NDArray[np.intp]]:
    """The indices in runs small enough that their pairs with the members fit a block."""
    step = max(1, BLOCK // members)
    return [which[start : start + step] for start in range(0, len(which), step)]
