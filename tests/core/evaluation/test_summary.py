"""Means by hand, intervals against scipy's, the form that is printed."""

from __future__ import annotations

from math import isclose

import numpy as np
import pytest
from scipy import stats

from scenegen_core.evaluation.bootstrap import interval, relative
from scenegen_core.evaluation.summary import paired, summarize
from tests.core.evaluation.made import joint, record


def rng() -> np.random.Generator:
    return np.random.default_rng(5)


def test_means_are_those_worked_out_by_hand() -> None:
    records = [
        record(1, {"paper": joint(1.0, 0.5, collides=1.0)}, room="a"),
        record(2, {"paper": joint(2.0, 0.6)}, room="a", category="Sofa"),
        record(3, {"paper": joint(6.0, 1.0)}, room="b", category="Sofa"),
    ]
    results = summarize(records, rng=rng())
    assert (results["rooms"], results["queries"]) == (2, 3)
    table = results["models"]["paper"]["joint"]
    assert list(table) == ["overall", "Bed", "Sofa"]
    assert (table["overall"]["n"], table["Bed"]["n"], table["Sofa"]["n"]) == (3, 1, 2)
    assert table["overall"]["top1"] == 3.0  # (1 + 2 + 6) / 3
    assert table["Sofa"]["top1"] == 4.0
    assert table["overall"]["spread5"] == pytest.approx(0.7)
    assert results["models"]["paper"]["physical"] == {
        "collides": pytest.approx(1 / 3),
        "outside": 0.0,
        "blocks_door": 0.0,
        "breaks_path": 0.0,
    }


def test_a_measure_that_does_not_apply_is_left_out() -> None:
    records = [
        record(1, {"F": {"orientation": {"angle": 0.2}}}),
        record(2, {"F": {"orientation": {"angle": 0.4}}}, room="r2"),
        record(3, {"F": {}}, category="Table"),
    ]
    model = summarize(records, rng=rng())["models"]["F"]
    assert list(model) == ["orientation"]
    assert set(model["orientation"]["overall"]) == {"n", "angle", "ci"}
    assert model["orientation"]["overall"]["n"] == 2
    assert list(model["orientation"]["overall"]["ci"]) == ["angle"]
    assert list(model["orientation"]) == ["overall", "Bed"]


def test_rooms_of_one_name_from_two_sources_are_two() -> None:
    records = [record(1, {"paper": joint(1, 1)}, source=source) for source in ("one", "two")]
    assert summarize(records, rng=rng())["rooms"] == 2


def test_with_one_query_a_room_the_interval_is_that_of_the_ordinary_bootstrap() -> None:
    values = np.random.default_rng(3).exponential(2.0, 80)
    ours = interval([(str(room), value) for room, value in enumerate(values)], rng=rng())
    theirs = stats.bootstrap(
        (values,), np.mean, n_resamples=20_000, method="percentile", rng=rng()
    ).confidence_interval
    width = theirs.high - theirs.low
    assert ours == pytest.approx((theirs.low, theirs.high), abs=0.08 * width)


def test_queries_of_one_room_hang_together() -> None:
    apart = [(str(i), float(i % 2)) for i in range(40)]
    together = [(str(i % 2), float(i % 2)) for i in range(40)]
    narrow, wide = interval(apart, rng=rng()), interval(together, rng=rng())
    assert wide == (0.0, 1.0)  # two rooms: both may be the same one
    assert narrow[1] - narrow[0] < 0.4


def test_a_relative_change_is_that_of_the_means() -> None:
    values = [("a", (1.0, 2.0)), ("b", (2.0, 2.0)), ("c", (3.0, 4.0))]
    change, low, high = relative(values, rng=rng())
    assert isclose(change, 6 / 8 - 1)
    assert low >= 1 / 2 - 1  # the best room drawn three times
    assert high <= 0  # the worst


def test_a_paired_difference_is_over_the_cases_that_both_answer() -> None:
    records = [
        record(1, {"paper": joint(1.0, 1.0), "rules": joint(3.0, 1.5)}, room="a"),
        record(2, {"paper": joint(2.0, 1.0), "rules": joint(3.0, 1.5)}, room="b"),
        record(3, {"paper": joint(50.0, 9.0)}, room="c"),
    ]
    found = paired(records, "paper", "rules", "joint", rng=rng())
    assert found["top1"] == (-1.5, -2.0, -1.0)
    assert found["spread5"] == (-0.5, -0.5, -0.5)
    assert "angle" not in found
