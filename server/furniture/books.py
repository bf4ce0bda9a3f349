"""Rows of books for shelves."""

from __future__ import annotations

from dataclasses import replace

from server.furniture.design import Parts
from server.furniture.materials import PAINT, linear
from server.furniture.parts import Span, block

SPINES = tuple(
    linear(color)
    for color in ("#d8c7ab", "#a4755a", "#7f8f7c", "#e9e2d5", "#566467", "#c59a6e", "#b7a99a")
)
WIDTHS = (0.034, 0.05, 0.028, 0.042, 0.06, 0.036, 0.03, 0.046)  # metres
TALLNESS = (0.8, 0.66, 0.74, 0.86, 0.7, 0.62, 0.82)  # of the room between two shelves
MOST = 9  # books a shelf; the rest of it stays free


def row_of_books(x: Span, y: Span, z: Span, number: int) -> Parts:
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
