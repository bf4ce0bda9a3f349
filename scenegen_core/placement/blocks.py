"""Blocks: many poses worked on a few thousand at a time, on all processors."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from os import cpu_count
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from scenegen_core.graph.situation import Situation

AT_ONCE = 2048  # poses, whose columns fit into a processor's cache

Number = TypeVar("Number", np.float64, np.int64)


def in_blocks(
    work: Callable[[Situation], NDArray[Number]], situation: Situation, at_once: int = AT_ONCE
) -> NDArray[Number]:
    """What work on a situation gives, one number a pose: (n,). Compiled loops leave the lock."""
    parts = [situation[i : i + at_once] for i in range(0, len(situation.candidates), at_once)]
    if len(parts) <= 1:
        return work(situation)
    with ThreadPoolExecutor(min(len(parts), cpu_count() or 1)) as threads:
        return np.concatenate(list(threads.map(work, parts)))
