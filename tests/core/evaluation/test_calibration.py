"""Probabilities: what they say of a case, and how right they are, by hand."""

from __future__ import annotations

from math import log

import numpy as np
import pytest

from scenegen_core.evaluation.bench import Bench, Table
from scenegen_core.evaluation.calibration import calibration
from scenegen_core.evaluation.cases import Case
from scenegen_core.evaluation.chances import chances
from scenegen_core.evaluation.measure import Answer, Picks
from scenegen_core.evaluation.records import Chances, Record
from scenegen_core.evaluation.summary import summarize
from scenegen_core.graph.candidates import Candidates
from scenegen_core.graph.situation import Situation
from scenegen_core.scene.model import PAPER_CATEGORIES
from tests.core.evaluation.made import joint, record
from tests.core.placement.drawn import room, thing

Pose = tuple[float, float, float, int, float]
"""x, y, z, cell, probability; 0 is impossible."""


def said(
    truth: tuple[float, float],
    bottom: float,
    poses: list[Pose],
    *offered: int,
    expects: bool = False,
) -> Chances:
    """What these poses say of a crate of 0.4 m that stood there."""
    box = thing("Storage", *truth, (0.4, 0.4, 0.4), bottom=bottom)
    bench = Bench(Case(room(), box), PAPER_CATEGORIES)
    candidates = Candidates(
        "Storage", box.size, np.array([pose[:3] for pose in poses]), np.zeros(len(poses))
    )
    shares = np.array([pose[4] for pose in poses])
    table = Table(
        candidates=candidates,
        cells=np.array([pose[3] for pose in poses]),
        possible=shares > 0,
        flush=shares < 0,
        situation=Situation(candidates, bench.around),
        scored=np.flatnonzero(shares),
    )
    with np.errstate(divide="ignore"):
        scores = np.log(shares) + 70.0  # a constant of the room says nothing
    picks = Picks(offered[0], np.array(offered), np.array(offered), offered=True)
    return chances(Answer("joint", bench, table, scores, picks), expects=expects)


def test_a_place_is_called_with_all_poses_within_half_a_metre() -> None:
    found = said(
        (1.1, 1.0),
        0.0,
        [
            (1.0, 1.0, 0.2, 0, 0.1),
            (1.0, 1.0, 0.2, 0, 0.2),  # turned
            (1.4, 1.0, 0.2, 1, 0.3),
            (3.0, 1.0, 0.2, 2, 0.4),
            (1.1, 1.0, 0.2, 3, 0.0),  # where it stood, which is not possible
        ],
        3,
        1,
    )
    assert found.called == pytest.approx((0.4, 0.6))
    assert found.holds == (False, True)
    assert found.log_score == pytest.approx(log(0.3))  # the cell at x = 1
    assert found.log_uniform == pytest.approx(-log(3))


def test_the_true_cell_is_at_the_true_height() -> None:
    found = said((1, 1), 1.0, [(1, 1, 0.2, 0, 0.9), (1, 1.1, 1.2, 1, 0.1)], 0)
    assert found.log_score == pytest.approx(log(0.1))
    assert found.called == pytest.approx((1.0,))


def test_scores_far_below_the_smallest_number_keep_their_logarithm() -> None:
    found = said((1, 1), 0.0, [(3, 1, 0.2, 0, 1.0), (1, 1, 0.2, 1, 1e-300)], 0)
    assert found.log_score == pytest.approx(log(1e-300))
    assert found.holds == (False,)


def test_a_system_that_expects_leaves_room_for_what_no_pose_comes_near() -> None:
    """15 % are spread over the two places: 0.85 · 0.8 + 0.075, half of that for each pose."""
    poses: list[Pose] = [
        (1, 1, 0.2, 0, 0.4),
        (1, 1, 0.2, 0, 0.4),
        (3, 1, 0.2, 1, 0.2),
        (1, 1, 0.2, 2, 0.0),
    ]
    found = said((3, 1), 0.0, poses, 0, 2, expects=True)
    assert found.called == pytest.approx((0.85 * 0.8 + 0.075, 0.85 * 0.2 + 0.075))
    assert found.log_score == pytest.approx(log(0.245))


def asked(number: int, room_id: str, *said: tuple[float, bool], category: str = "Bed") -> Record:
    """A case whose places were called so, and held so; log scores of −1, and −2 for chance."""
    called, holds = zip(*said, strict=True)
    return record(
        number,
        {"paper": joint(1.0, 0.5)},
        room=room_id,
        category=category,
        chances={"paper": Chances(called, holds, float(-number), -2.0)},
    )


# called 20 %: one of five holds; called 90 %: both hold
RIGHT = (
    asked(1, "a", (0.2, True), (0.2, False), (0.2, False), (0.9, True)),
    asked(2, "b", (0.2, False), (0.2, False), (0.9, True), category="Sofa"),
)


def rng() -> np.random.Generator:
    return np.random.default_rng(4)


def test_calibration_is_that_worked_out_by_hand() -> None:
    found = calibration(RIGHT, "paper", rng=rng())
    assert (found["n"], found["holds"]) == (7, pytest.approx(3 / 7))
    assert found["called"] == pytest.approx(2.8 / 7)
    assert found["brier"] == pytest.approx((0.64 + 4 * 0.04 + 2 * 0.01) / 7)
    assert found["brier_flat"] == pytest.approx(3 / 7 * 4 / 7)
    assert found["ece"] == pytest.approx(2 / 7 * 0.1)
    assert (found["log_score"], found["log_uniform"]) == (-1.5, -2.0)
    low, high = found["ci"]["log_score"]
    assert (low, high) == (-2.0, -1.0)


def test_bins_hold_what_was_called_within_them() -> None:
    fifth, sure = calibration(RIGHT, "paper", rng=rng())["bins"]
    assert (fifth["from"], fifth["to"], fifth["n"]) == (0.2, pytest.approx(0.3), 5)
    assert (fifth["called"], fifth["holds"]) == (pytest.approx(0.2), pytest.approx(0.2))
    assert (sure["n"], sure["called"], sure["holds"]) == (2, pytest.approx(0.9), 1.0)


def test_what_is_called_certain_is_in_the_last_bin() -> None:
    (last,) = calibration([asked(1, "a", (1.0, True), (0.95, False))], "paper", rng=rng())["bins"]
    assert (last["n"], last["holds"]) == (2, 0.5)


def test_probabilities_are_summed_up_like_a_task() -> None:
    without = record(3, {"rules": joint(1.0, 1.0)})
    models = summarize([*RIGHT, without], rng=rng())["models"]
    assert list(models["paper"]["calibration"]) == ["overall", "Bed", "Sofa"]
    assert models["paper"]["calibration"]["Sofa"]["n"] == 3
    assert "calibration" not in models["rules"]
