"""Working in blocks gives what working on all at once gives, on however many processors."""

from __future__ import annotations

import numpy as np
import pytest

from scenegen_core.graph.candidates import Candidates
from scenegen_core.graph.situation import Situation
from scenegen_core.graph.surroundings import Surroundings
from scenegen_core.placement import blocks
from scenegen_core.placement.blocks import AT_ONCE, FEW, in_blocks
from scenegen_core.scene.geometry import Floats
from scenegen_core.scene.model import PAPER_CATEGORIES
from tests.core.placement.drawn import room


def situation(count: int) -> Situation:
    """So many poses, each with another x."""
    centers = np.zeros((count, 3))
    centers[:, 0] = np.arange(count)
    poses = Candidates("Chair", (0.5, 0.5, 0.9), centers, np.zeros(count))
    return Situation(poses, Surroundings(room(), PAPER_CATEGORIES))


@pytest.mark.parametrize("processors", [1, 2, 3, 64])
@pytest.mark.parametrize("count", [0, 1, FEW, FEW + 1, 2 * FEW, AT_ONCE + 1, 5 * AT_ONCE + 7])
def test_blocks_are_large_and_hold_all_poses_in_their_order(
    count: int, processors: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(blocks, "cpu_count", lambda: processors)
    sizes: list[int] = []

    def work(some: Situation) -> Floats:
        sizes.append(len(some.candidates))
        return some.candidates.centers[:, 0] ** 2

    assert np.array_equal(in_blocks(work, situation(count)), np.arange(count) ** 2.0)
    assert max(sizes) <= AT_ONCE
    assert len(sizes) == 1 or min(sizes) >= FEW / 2
