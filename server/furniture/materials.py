"""The finishes: calm natural colors as physically based factors, no textures."""

from __future__ import annotations

from dataclasses import dataclass

Color = tuple[float, float, float]


def linear(color: str) -> Color:
    """The linear RGB of ``#rrggbb`` (sRGB, IEC 61966-2-1), 0 to 1."""
    red, green, blue = (_linear(int(color[start : start + 2], 16) / 255) for start in (1, 3, 5))
    return red, green, blue


def _linear(value: float) -> float:
    curve = value / 12.92 if value <= 0.04045 else ((value + 0.055) / 1.055) ** 2.4  # noqa: PLR2004
    return round(curve, 4)


@dataclass(frozen=True, slots=True)
class Material:
    """A finish."""

    name: str
    color: Color
    roughness: float
    metallic: float = 0.0
    glow: Color = (0.0, 0.0, 0.0)
    """Linear RGB that it gives off by itself."""
    thin: bool = False
    """Seen from both sides."""
    painted: bool = False
    """Its parts bring their own colors."""
    opacity: float = 1.0


OAK = Material("oak", linear("#c8a884"), 0.6)
WALNUT = Material("walnut", linear("#876b57"), 0.55)
LINEN = Material("linen", linear("#ddd3c3"), 0.95)
WOOL = Material("wool", linear("#a9a59a"), 0.95)
SAGE = Material("sage fabric", linear("#94a189"), 0.95)
CLAY = Material("clay fabric", linear("#c58f74"), 0.95)
COTTON = Material("cotton", linear("#f5f1ea"), 0.9)
MATTE_WHITE = Material("matte white", linear("#f0ece4"), 0.7)
WARM_GREY = Material("warm grey", linear("#b5aea3"), 0.75)
BRASS = Material("brass", linear("#c3a065"), 0.35, metallic=0.35)
STEEL = Material("steel", linear("#c9cbcb"), 0.35, metallic=0.35)
GRAPHITE = Material("graphite", linear("#34332f"), 0.6)
SCREEN = Material("screen", (1.0, 1.0, 1.0), 0.2, painted=True)
MIRROR = Material("mirror", (1.0, 1.0, 1.0), 0.08, painted=True)
LEAF = Material("leaf", (1.0, 1.0, 1.0), 0.7, painted=True)
TERRACOTTA = Material("terracotta", linear("#c98d6d"), 0.85)
SOIL = Material("soil", linear("#4d3d31"), 1.0)
CERAMIC = Material("ceramic", linear("#f3f1ec"), 0.25)
STONEWARE = Material("stoneware", linear("#a8b0a6"), 0.5)
SHADE = Material("lamp shade", linear("#f5e9d3"), 0.9, glow=linear("#6a5a3c"))
PAINT = Material("paint", (1.0, 1.0, 1.0), 0.85, painted=True)
