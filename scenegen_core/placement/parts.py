"""Parts: log scores taken apart into what each relation to each group adds."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from scenegen_core.scene.geometry import Floats

Subject = tuple[str, str]
"""A relation by its abbreviation, and the group or part that it is about, or empty."""


@dataclass(frozen=True, slots=True)
class Parts:
    """What every subject adds to the log scores of n poses."""

    subjects: tuple[Subject, ...]
    values: Floats
    """(n, subjects); the sum of a row is the log score of the pose."""
    measured: tuple[Mapping[str, float], ...]
    """Subject -> its columns as measured at the first pose, by their parts."""
