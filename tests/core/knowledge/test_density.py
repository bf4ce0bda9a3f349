"""The log density, against statsmodels' KDEMultivariate and against values worked out by hand."""

from __future__ import annotations

from math import exp, log, pi

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from statsmodels.nonparametric.kernel_density import KDEMultivariate

from scenegen_core.knowledge.density import Density, Kind
from scenegen_core.knowledge.files import default_knowledge
from scenegen_core.scene.geometry import Floats

ABSENT = 1000.0
REPRESENTABLE = 1e-290  # statsmodels' products lose digits below that


@st.composite
def examples_and_queries(draw: st.DrawFn) -> tuple[Floats, Floats, list[Kind]]:
    kinds: list[Kind] = draw(
        st.lists(st.sampled_from(["continuous", "ordered"]), min_size=1, max_size=5)
    )
    n = draw(st.integers(len(kinds) + 1, 25))
    distances = st.floats(0, 8, allow_nan=False).map(lambda x: round(x, 3))
    counts = st.integers(0, 6).map(float)
    columns = [
        draw(arrays(np.float64, n + 4, elements=distances if kind == "continuous" else counts))
        for kind in kinds
    ]
    values = np.column_stack(columns)
    return values[:n], values[n:], kinds


def statsmodels_of(density: Density, *, bandwidths: Floats | str | None = None) -> KDEMultivariate:
    return KDEMultivariate(
        density.rows,
        "".join("o" if ordered else "c" for ordered in density.ordered),
        bw=density.bandwidths if bandwidths is None else bandwidths,
        rng=np.random.default_rng(0),
    )


def assert_equals_statsmodels(density: Density, queries: Floats) -> int:
    expected = np.atleast_1d(statsmodels_of(density).pdf(queries))
    there = expected > REPRESENTABLE
    actual = density.log_density(queries)
    np.testing.assert_allclose(actual[there], np.log(expected[there]), rtol=0, atol=1e-10)
    assert np.isfinite(actual).all()
    return int(there.sum())


@settings(deadline=None)
@given(examples_and_queries())
def test_log_density_is_the_logarithm_of_statsmodels(
    case: tuple[Floats, Floats, list[Kind]],
) -> None:
    rows, queries, kinds = case
    density = Density.fit(rows, kinds)
    assert assert_equals_statsmodels(density, rows) == len(rows)
    assert_equals_statsmodels(density, queries)


@settings(deadline=None)
@given(examples_and_queries())
def test_paper_bandwidths_are_the_normal_reference_of_statsmodels(
    case: tuple[Floats, Floats, list[Kind]],
) -> None:
    rows, _, kinds = case
    varies = np.array([len(np.unique(column)) > 1 for column in rows.T])
    density = Density.fit(rows, kinds, bandwidths="paper")
    reference = statsmodels_of(density, bandwidths="normal_reference").bw
    np.testing.assert_allclose(density.bandwidths[varies], reference[varies], rtol=1e-12)


@pytest.mark.parametrize("category", ["Bed", "Chair", "Picture", "Sofa", "Storage", "TV"])
def test_log_density_is_that_of_statsmodels_on_the_columns_of_real_rooms(category: str) -> None:
    density = default_knowledge()[category].position().density
    rng = np.random.default_rng(3)
    rows = density.rows[rng.choice(len(density.rows), 40)]
    moved = rows.copy()
    present = rows[:, density.can_be_absent] != ABSENT
    moved[:, density.can_be_absent] += present * rng.normal(0, 0.1, present.shape)
    assert assert_equals_statsmodels(density, rows) == 40
    assert assert_equals_statsmodels(density, moved) == 40


def test_queries_far_from_every_example_are_told_apart_where_statsmodels_gives_zero() -> None:
    density = Density.fit(np.array([[0.0], [1.0], [2.0]]), ["continuous"], fixed={0: 0.1})
    queries = np.array([[50.0], [60.0], [70.0]])
    assert (statsmodels_of(density).pdf(queries) == 0).all()
    near, far, farther = density.log_density(queries)
    assert near > far > farther


def test_one_example_gives_the_kernels_themselves() -> None:
    density = Density.fit(np.array([[2.0, 3.0]]), ["continuous", "ordered"])
    assert density.bandwidths.tolist() == [0.1, 0.02]
    at_it, moved, counted = density.log_density(np.array([[2.0, 3.0], [2.1, 3.0], [2.0, 5.0]]))
    gaussian = log(1 / (0.1 * (2 * pi) ** 0.5))
    assert at_it == pytest.approx(gaussian + log(0.98))
    assert moved == pytest.approx(gaussian - 0.5 + log(0.98))
    assert counted == pytest.approx(gaussian + log(0.98 / 2 * 0.02**2))


def test_more_columns_than_examples_and_constant_columns_give_numbers() -> None:
    rows = np.array([[1.0, 0.0, 2.0, 1.5], [1.0, 0.0, 3.0, 1.5]])
    density = Density.fit(rows, ["continuous", "ordered", "ordered", "continuous"])
    assert density.bandwidths[[0, 1, 3]].tolist() == [0.1, 0.02, 0.1]
    assert np.isfinite(density.log_density(np.array([[1.0, 0, 2, 1.5], [9.0, 4, 0, -3]]))).all()


def test_ordered_bandwidths_are_bounded_unless_the_paper_is_asked_for() -> None:
    rows = np.array([[0.0, 0], [0, 0], [9, 0], [9, 0], [18, 0]])
    bounded = Density.fit(rows, ["ordered", "ordered"])
    paper = Density.fit(rows, ["ordered", "ordered"], bandwidths="paper")
    assert bounded.bandwidths.tolist() == [0.9, 0.02]
    # σ of 0, 0, 9, 9, 18 is √45.36; 5 examples, 2 columns
    assert paper.bandwidths[0] == pytest.approx(1.06 * 45.36**0.5 * 5 ** (-1 / 6))
    assert paper.bandwidths[1] == 0


@pytest.mark.parametrize(("columns", "sign"), [(1, -1), (2, 1)])
def test_unbounded_bandwidths_rank_as_the_paper_does_even_where_its_density_is_negative(
    columns: int, sign: int
) -> None:
    rng = np.random.default_rng(1)
    rows = rng.integers(0, 12, (30, columns)).astype(float)
    density = Density.fit(rows, ["ordered"] * columns, bandwidths="paper")
    queries = np.repeat(np.arange(20.0)[:, None], columns, axis=1)
    expected = statsmodels_of(density).pdf(queries)
    assert (np.sign(expected) == sign).all()
    ranks = density.log_density(queries)
    assert np.argsort(ranks).tolist() == np.argsort(expected).tolist()
    np.testing.assert_allclose(ranks, sign * np.log(np.abs(expected)), atol=1e-10)


def test_an_ordered_bandwidth_of_zero_or_one_stays_finite() -> None:
    rows = np.array([[0.0, 1.0], [0.0, 2.0]])
    kinds: list[Kind] = ["ordered", "ordered"]
    density = Density.fit(rows, kinds, fixed={1: 1.0}, bandwidths="paper")
    assert density.bandwidths.tolist() == [0, 1]
    assert np.isfinite(density.log_density(np.array([[0.0, 1.0], [3.0, 1.0]]))).all()


class TestAbsentGroups:
    rows = np.array(
        [
            [1.0, 2.0, ABSENT],
            [1.1, 2.0, ABSENT],
            [1.0, ABSENT, 3.0],
            [ABSENT, ABSENT, ABSENT],
        ]
    )
    density = Density.fit(rows, ["continuous"] * 3, fixed=dict.fromkeys(range(3), 0.1))

    def test_examples_with_the_same_groups_speak_and_the_others_are_silent(self) -> None:
        query = np.array([[1.0, 2.0, ABSENT]])
        unit = (0.1 * (2 * pi) ** 0.5) ** -3
        expected = log(unit * (1 + exp(-0.5)) / 4)
        assert self.density.log_density(query)[0] == pytest.approx(expected, abs=1e-12)
        assert statsmodels_of(self.density).pdf(query) == pytest.approx(exp(expected))
        assert self.density.terms(query).responsibilities[0, 2:].tolist() == [0, 0]

    def test_fewer_disagreements_always_weigh_more_than_nearness(self) -> None:
        # the first lacks nothing but is 5 m off; the second disagrees with every example
        far = np.array([[6.0, 7.0, ABSENT]])
        unlike = np.array([[1.0, 2.0, 3.0]])
        least = np.array([[ABSENT, 2.0, 3.0]])
        scores = [self.density.log_density(q)[0] for q in (far, unlike, least)]
        assert scores[0] > scores[1] > scores[2]

    def test_a_disagreement_costs_ten_thousand_and_drops_its_column(self) -> None:
        # one disagreement with the first three examples: (group 3), (group 3), (group 2)
        log_unit = -2 * log(0.1 * (2 * pi) ** 0.5)
        kernels = 1 + exp(-0.5) + 1
        expected = -1e4 + log_unit + log(kernels / 4)
        assert self.density.log_density(np.array([[1.0, 2.0, 3.0]]))[0] == pytest.approx(
            expected, abs=1e-8
        )

    def test_queries_of_several_rooms_are_answered_as_if_each_were_alone(self) -> None:
        queries = np.array(
            [[1.0, 2.0, ABSENT], [1.0, 2.0, 3.0], [2.0, 2.0, ABSENT], [ABSENT, ABSENT, 3.0]]
        )
        alone = [self.density.log_density(query[None])[0] for query in queries]
        assert self.density.log_density(queries).tolist() == alone


@settings(deadline=None)
@given(examples_and_queries())
def test_the_terms_of_the_columns_and_the_agreement_add_up_to_the_log_density(
    case: tuple[Floats, Floats, list[Kind]],
) -> None:
    rows, queries, kinds = case
    density = Density.fit(rows, kinds)
    terms = density.terms(queries)
    np.testing.assert_allclose(
        terms.columns.sum(axis=1) + terms.agreement, density.log_density(queries), rtol=1e-12
    )
    np.testing.assert_allclose(terms.responsibilities.sum(axis=1), 1)
    assert (terms.agreement <= 1e-12).all()


@pytest.mark.parametrize("category", ["Bed", "Chair", "TV"])
def test_the_terms_add_up_in_real_rooms_too(category: str) -> None:
    prior = default_knowledge()[category].position()
    queries = prior.density.rows[:50].copy()
    queries[25:, 3] = 2.5  # a picture that most of the examples lack
    terms = prior.density.terms(queries)
    np.testing.assert_allclose(
        terms.columns.sum(axis=1) + terms.agreement,
        prior.density.log_density(queries),
        rtol=0,
        atol=1e-9,
    )


def test_the_nearest_examples_carry_most_of_the_density() -> None:
    density = Density.fit(np.array([[0.0], [1.0], [2.0], [3.0]]), ["continuous"], fixed={0: 0.5})
    shares = density.terms(np.array([[1.9], [0.2]])).responsibilities
    assert np.argsort(-shares, axis=1)[:, :2].tolist() == [[2, 1], [0, 1]]


def test_many_queries_at_once_give_what_each_gives_alone() -> None:
    rng = np.random.default_rng(2)
    rows = np.column_stack([rng.uniform(0, 5, 300), rng.integers(0, 4, 300)]).astype(float)
    density = Density.fit(rows, ["continuous", "ordered"])
    queries = np.column_stack([rng.uniform(0, 5, 1500), rng.integers(0, 4, 1500)]).astype(float)
    together = density.log_density(queries)
    assert together[[0, 700, 1499]].tolist() == [
        density.log_density(queries[[i]])[0] for i in (0, 700, 1499)
    ]


def test_no_queries_give_no_densities() -> None:
    density = Density.fit(np.array([[0.0], [1.0]]), ["continuous"])
    assert density.log_density(np.empty((0, 1))).shape == (0,)
