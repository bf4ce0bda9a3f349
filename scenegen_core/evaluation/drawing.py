"""Drawing with matplotlib, which is asked for only when something is drawn."""

from __future__ import annotations

import io
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

from scenegen_core.errors import DataError

if TYPE_CHECKING:
    from matplotlib.figure import Figure

COLORS = ("#000000", "#D55E00", "#0072B2", "#009E73", "#CC79A7", "#E69F00", "#56B4E9")
"""Okabe and Ito's colors, told apart by people who see few; yellow, too pale for lines, is out."""
DASHES = ("-", (0, (6, 2)), (0, (2, 1)), (0, (6, 2, 1, 2)), (0, (9, 2)), (0, (1, 1)), (0, (4, 1)))
"""A second way to tell lines apart."""

STYLE: dict[Any, Any] = {
    "font.family": "sans-serif",
    "font.size": 9.0,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "svg.fonttype": "none",
    "svg.hashsalt": "scenegen",
}


def need_drawing() -> None:
    """DataError if nothing can be drawn."""
    try:
        import matplotlib as mpl  # noqa: F401, PLC0415 (optional, and slow to import)
    except ImportError:
        raise DataError(
            "Pictures are drawn with matplotlib, which is not installed; "
            "run: pip install 'scenegen[report]'"
        ) from None


@contextmanager
def figure(width: float, height: float) -> Iterator[Figure]:
    """An empty figure of that size, inches, in our style."""
    need_drawing()
    from matplotlib import rc_context  # noqa: PLC0415
    from matplotlib.figure import Figure  # noqa: PLC0415

    with rc_context(STYLE):
        yield Figure(figsize=(width, height), layout="constrained")


def svg(drawn: Figure) -> str:
    """The figure as SVG to put into a page; the same figure gives the same text."""
    file = io.StringIO()
    drawn.savefig(file, format="svg", metadata={"Date": None})
    text = file.getvalue()
    return text[text.index("<svg") :]
