"""Blocks: many poses worked on a few thousand at a time, on all processors."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from math import ceil
from os import cpu_count
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from scenegen_core.graph.situation import Situation

AT_ONCE = 8192  # poses at most; more no longer fit into a processor's caches
FEW = 2048  # poses; with less for each, more threads cost more than they save

Number = TypeVar("Number", np.float64, np.int64)


def in_blocks(
    work: Callable[[Situation], NDArray[Number]], situation: Situation, at_once: int = AT_ONCE
) -> NDArray[Number]:
    """What work on a situation gives, one number a pose: (n,).

    Compiled loops run side by side, what is between them does not: few large blocks, and as many
    for each processor.
    """
    count = len(situation.candidates)
    threads = max(1, min(cpu_count() or 1, count // FEW))
    size = block_size(count, threads, at_once)
    if size >= count:
        return work(situation)
    parts = [situation[i : i + size] for i in range(0, count, size)]
    with ThreadPoolExecutor(threads) as pool:
        return np.concatenate(list(pool.map(work, parts)))


def block_size(count: int, threads: int, at_once: int) -> int:
    """How many of ``count`` poses a block holds: at most ``at_once``, as many on each thread."""
    each = ceil(count / threads)
    return ceil(each / max(ceil(each / at_once), 1))
