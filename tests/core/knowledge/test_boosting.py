"""Learning of tables: single Newton steps by hand, and what many of them find."""

from __future__ import annotations

from collections.abc import Sequence
from math import log

import numpy as np
import pytest

from scenegen_core.knowledge import boosting
from scenegen_core.knowledge.boosting import ChoiceSets, Tables, fit
from scenegen_core.knowledge.choice import BINS, MISSING, Choice, choice_columns, without_examples
from scenegen_core.scene.model import PAPER_CATEGORIES

LOW, HIGH = 3, 7
"""Two bins."""
Pose = tuple[int, ...]


def choices(*sets: Sequence[Pose], weight: float = 1.0, stands_for: float = 1.0) -> ChoiceSets:
    """Choices of the first pose of each; each other one stands for so many."""
    lengths = [len(poses) for poses in sets]
    starts = np.cumsum([0, *lengths[:-1]])
    log_weights = np.full(sum(lengths), log(stands_for))
    log_weights[starts] = 0.0
    return ChoiceSets(
        bins=np.array([pose for poses in sets for pose in poses], dtype=np.uint8),
        starts=starts,
        log_weights=log_weights,
        weights=np.full(len(sets), weight),
    )


def random_choices(count: int, columns: int, *, seed: int = 0) -> ChoiceSets:
    """Five poses each, of bins drawn from LOW and HIGH; any is the one chosen."""
    drawn = np.random.default_rng(seed).choice([LOW, HIGH], (count, 5, columns))
    return choices(*([tuple(pose) for pose in poses] for poses in drawn.tolist()))


def learn(sets: ChoiceSets, *, surfaces: int = 0, base: Choice | None = None) -> Tables:
    return fit(sets, rng=np.random.default_rng(0), surfaces=surfaces, base=base)


@pytest.fixture
def one_tree(monkeypatch: pytest.MonkeyPatch) -> None:
    """Stop after one tree, which may look at every column."""
    monkeypatch.setattr(boosting, "CURVE_TREES", 1)
    monkeypatch.setattr(boosting, "SHARE", 1.0)


# --- one step, by hand ----------------------------------------------------------------------------


@pytest.mark.usefixtures("one_tree")
def test_a_step_is_the_gradient_over_the_damped_curvature_on_either_side() -> None:
    """Of two poses each has P = 1/2: gradient ∓1/2, curvature 1/4. Ten choices: ∓5 and 2.5."""
    curve = learn(choices(*([[(LOW,), (HIGH,)]] * 10))).curves[0]
    assert curve[LOW] == pytest.approx(0.05 * 5 / (2.5 + 8))
    assert curve[HIGH] == pytest.approx(-0.05 * 5 / (2.5 + 8))


@pytest.mark.usefixtures("one_tree")
def test_a_pose_that_stands_for_three_is_as_likely_as_three() -> None:
    """P = 1/4 and 3/4: gradient ∓3/4, curvature 3/16 each."""
    curve = learn(choices(*([[(LOW,), (HIGH,)]] * 10), stands_for=3)).curves[0]
    assert curve[LOW] == pytest.approx(0.05 * 7.5 / (1.875 + 8))
    assert curve[HIGH] == pytest.approx(-0.05 * 7.5 / (1.875 + 8))


@pytest.mark.usefixtures("one_tree")
def test_a_choice_of_double_weight_counts_like_two() -> None:
    heavy = learn(choices(*([[(LOW,), (HIGH,)]] * 10), weight=2))
    twice = learn(choices(*([[(LOW,), (HIGH,)]] * 20)))
    np.testing.assert_allclose(heavy.curves, twice.curves)


@pytest.mark.usefixtures("one_tree")
@pytest.mark.parametrize("chosen", [LOW, HIGH])
def test_what_is_missing_goes_to_the_side_that_it_is_chosen_like(chosen: int) -> None:
    other = LOW + HIGH - chosen
    sets = [[(chosen,), (other,)]] * 10 + [[(MISSING,), (other,)]] * 10
    curve = learn(choices(*sets)).curves[0]
    assert curve[MISSING] == curve[chosen] > 0 > curve[other]


@pytest.mark.usefixtures("one_tree")
def test_the_column_that_explains_most_is_cut() -> None:
    """The second says it always, the first four times of five."""
    often = [[(LOW, LOW), (HIGH, HIGH)]] * 8 + [[(HIGH, LOW), (LOW, HIGH)]] * 2
    curves = learn(choices(*often)).curves
    assert not curves[0].any()
    assert curves[1, LOW] > 0 > curves[1, HIGH]


@pytest.mark.usefixtures("one_tree")
def test_a_single_choice_teaches_nothing() -> None:
    """A curvature of 1/4 on either side is less than the half that a split needs."""
    assert not learn(choices([(LOW,), (HIGH,)])).curves.any()


def test_a_tree_of_a_pair_steps_in_each_quarter() -> None:
    """Chosen is what is alike in both columns: neither says anything without the other.

    In each quarter ten poses of P = 1/2: gradient ∓5, curvature 2.5, damping 8.
    """
    sets = choices(*([[(LOW, LOW), (LOW, HIGH)]] * 10), *([[(HIGH, HIGH), (HIGH, LOW)]] * 10))
    surfaces = np.zeros((1, BINS, BINS))
    state = boosting._Boosting(sets, sets.log_weights, np.random.default_rng(0))
    state.pair_tree(np.array([[0, 1]]), surfaces)
    step = 0.05 * 5 / (2.5 + 8)
    assert surfaces[0][np.ix_([LOW, HIGH], [LOW, HIGH])] == pytest.approx(
        np.array([[step, -step], [-step, step]])
    )


# --- many steps -----------------------------------------------------------------------------------


def test_in_the_end_a_choice_is_as_likely_as_it_is_frequent() -> None:
    """Three of four choose the low one: their scores are log 3 apart."""
    sets = [[(LOW,), (HIGH,)]] * 75 + [[(HIGH,), (LOW,)]] * 25
    curve = learn(choices(*sets)).curves[0]
    assert curve[LOW] - curve[HIGH] == pytest.approx(log(3), abs=1e-3)


def test_what_the_base_says_is_not_learned_again() -> None:
    named = choice_columns(PAPER_CATEGORIES)[:1]
    sets = choices(*([[(LOW,), (HIGH,)]] * 75), *([[(HIGH,), (LOW,)]] * 25))
    curves = np.zeros((1, BINS), dtype=np.float32)
    curves[0, LOW] = log(3)
    assert np.abs(learn(sets, base=without_examples(named, curves)).curves).max() < 1e-5


def test_what_is_chosen_for_two_reasons_together_gets_a_surface_of_both() -> None:
    """Six columns of chance; chosen is the pose whose second and fifth are alike."""
    rng = np.random.default_rng(3)
    sets = []
    for _ in range(150):
        poses = rng.choice([LOW, HIGH], (4, 6))
        poses[0, 4] = poses[0, 1]
        poses[1:, 4] = LOW + HIGH - poses[1:, 1]
        sets.append([tuple(pose) for pose in poses.tolist()])
    tables = learn(choices(*sets), surfaces=3)
    assert [1, 4] in tables.pairs.tolist()
    surface = tables.surfaces[tables.pairs.tolist().index([1, 4])]
    alike, unlike = surface[[LOW, HIGH], [LOW, HIGH]], surface[[LOW, HIGH], [HIGH, LOW]]
    assert alike.min() > unlike.max() + 1


@pytest.mark.parametrize("value", [LOW, MISSING])
def test_where_all_poses_are_alike_nothing_is_learned(value: int) -> None:
    tables = learn(choices(*([[(value, LOW)] * 4] * 30)), surfaces=3)
    assert not tables.curves.any()
    assert len(tables.pairs) == 0


def test_what_is_the_same_at_every_pose_of_a_choice_has_no_curve() -> None:
    """As the size of the object is, or the area of the room."""
    sets = [[(size, LOW), (size, HIGH)] for size in (LOW, HIGH) for _ in range(20)]
    curves = learn(choices(*sets)).curves
    assert not curves[0].any()
    assert curves[1, LOW] > 0.5


def test_choices_by_chance_are_told_from_each_other_by_little() -> None:
    curves = learn(random_choices(400, 3)).curves
    assert np.ptp(curves[:, [LOW, HIGH]], axis=1).max() < 0.3


def test_learning_again_gives_the_same_tables() -> None:
    sets = random_choices(60, 4)
    one, two = (learn(sets, surfaces=2) for _ in range(2))
    np.testing.assert_array_equal(one.curves, two.curves)
    np.testing.assert_array_equal(one.pairs, two.pairs)
    np.testing.assert_array_equal(one.surfaces, two.surfaces)
