"""Progress of long work, one line on stderr that is rewritten."""

from __future__ import annotations

import sys
from time import monotonic

EVERY = 0.5  # seconds between two updates on a terminal
EVERY_PLAIN = 30.0  # seconds between two lines in a log


class Meter:
    """Says how much is done, and how long the rest will take."""

    def __init__(self, unit: str) -> None:
        self._unit = unit
        self._terminal = sys.stderr.isatty()
        self._started = self._shown = monotonic()
        self._first: int | None = None

    def show(self, done: int, total: int) -> None:
        """Tell that ``done`` of ``total`` are done; cheap when called often."""
        now = monotonic()
        if self._first is None:
            self._first = done - 1  # what a run before this one did says nothing about speed
        if now - self._shown < (EVERY if self._terminal else EVERY_PLAIN) and done < total:
            return
        self._shown = now
        speed = (done - self._first) / max(now - self._started, 1e-9)
        left = (total - done) / max(speed, 1e-9)
        text = f"{done} of {total} {self._unit}, {_minutes(left)} left"
        print(text, end="\r" if self._terminal else "\n", file=sys.stderr, flush=True)

    def end(self) -> None:
        """Leave the line."""
        if self._terminal:
            print(file=sys.stderr)


def _minutes(seconds: float) -> str:
    return f"{seconds:.0f} s" if seconds < 100 else f"{seconds / 60:.0f} min"  # noqa: PLR2004
