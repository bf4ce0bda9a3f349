"""What comes of the work that a session wanted."""

from __future__ import annotations

from dataclasses import dataclass

from scenegen_core.placement.solve import Solution
from server.looks import Look
from server.protocol import Answer
from server.wire import Binary


@dataclass(frozen=True, slots=True)
class Furnished:
    """Models that are ready: looks and digests by box id."""

    revision: int
    models: dict[str, tuple[Look, str]]


@dataclass(frozen=True, slots=True)
class Solved:
    """An answer as it travels, and what it was made from."""

    solution: Solution
    answer: Answer
    maps: tuple[Binary, ...]
