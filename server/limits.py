"""How much one page and one address may send."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass


@dataclass(slots=True)
class Allowance:
    """Messages a page may send: ``rate`` a second, saved up for at most one second."""

    rate: int
    saved: float
    since: float
    """When ``saved`` was true, seconds on a clock that only goes forward."""

    @staticmethod
    def full(rate: int, *, now: float) -> Allowance:
        """An allowance nothing was taken of."""
        return Allowance(rate, float(rate), now)

    def take(self, *, now: float) -> bool:
        """Take one message; False if there is none left."""
        self.saved = min(self.rate, self.saved + (now - self.since) * self.rate)
        self.since = now
        if self.saved < 1:
            return False
        self.saved -= 1
        return True


class Addresses:
    """Open sockets by address."""

    def __init__(self, most: int) -> None:
        self._most = most
        self._open: Counter[str] = Counter()

    @contextmanager
    def enter(self, address: str) -> Iterator[bool]:
        """Whether one more socket may be open; counted while inside."""
        self._open[address] += 1
        try:
            yield self._open[address] <= self._most
        finally:
            self._open[address] -= 1
            self._open += Counter()  # forgets addresses without sockets
