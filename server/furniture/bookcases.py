"""Open shelves with books on them."""

from __future__ import annotations

from dataclasses import replace

from server.furniture.design import Design, Parts
from server.furniture.materials import OAK, PAINT, linear
from server.furniture.parts import Span, block

SPINES = tuple(
    linear(color)
    for color in ("#d8c7ab", "#a4755a", "#7f8f7c", "#e9e2d5", "#566467", "#c59a6e", "#b7a99a")
)
WIDTHS = (0.034, 0.05, 0.028, 0.042, 0.06, 0.036, 0.03, 0.046)  # metres
TALLNESS = (0.8, 0.66, 0.74, 0.86, 0.7, 0.62, 0.82)  # of the room between two shelves
BOARD = 0.025  # metres
MOST = 9  # books a shelf; the rest of it stays free


def bookcase(w: float, h: float, d: float) -> Parts:
    """Open shelves with books on them."""
    yield OAK, block((-w / 2, w / 2), (0, h), (-d / 2, -d / 2 + 0.012), 0.002)
    for side in (-1, 1):
        low, high = sorted((side * w / 2, side * (w / 2 - BOARD)))
        yield OAK, block((low, high), (0, h), (-d / 2, d / 2), 0.004)
    count = min(6, max(1, round((h - 0.08) / 0.36)))
    step = (h - BOARD - 0.06) / count
    inner = w / 2 - BOARD
    for number in range(count + 1):
        y = 0.06 + number * step
        yield OAK, block((-inner, inner), (y, y + BOARD), (-d / 2 + 0.01, d / 2 - 0.005), 0.003)
        if number < count:
            yield from _row_of_books(
                (-inner + 0.01, inner - 0.01),
                (y + BOARD, y + step),
                (-d / 2 + 0.03, d / 2 - 0.03),
                number,
            )
    yield OAK, block((-inner, inner), (0, 0.06), (d / 2 - 0.04, d / 2 - 0.02), 0.003)


def _row_of_books(x: Span, y: Span, z: Span, number: int) -> Parts:
    """Some books on shelf ``number``, standing at its left or right end."""
    room = x[1] - x[0]
    scale = max(1.0, 0.55 * room / (MOST * 0.041))
    at = 0.0
    for book in range(MOST):
        pick = 3 * number + book
        width = scale * WIDTHS[pick % len(WIDTHS)]
        if at + width > (0.6 + 0.1 * (number % 3)) * room:
            return
        left = x[0] + at if number % 2 == 0 else x[1] - at - width
        top = y[0] + TALLNESS[pick % len(TALLNESS)] * (y[1] - y[0])
        spine = block((left, left + width - 0.002), (y[0], top), (z[0], z[1] - 0.01), 0.004)
        yield PAINT, replace(spine, color=SPINES[(5 * number + 2 * book) % len(SPINES)])
        at += width


BOOKCASE = Design("bookcase", bookcase, (0.15, 0.25, 0.3), (0.8, 3.0, 2.8))
