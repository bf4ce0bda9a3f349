"""The paper's published numbers, as data; never mixed with ours in one file.

Source: Keshavarzi et al. 2020, tables "ablation_pos" (Table 1) and "ablation_orien" (Table 2):
Matterport3D, 4 folds of 100 rooms. Metres and radians. Rooms of other sizes give other metres:
compare ratios and skill, never these numbers alone.
"""

from __future__ import annotations

POSITION: dict[str, dict[str, tuple[float, float]]] = {
    "AD+S+RP": {
        "Bed": (1.58, 0.87), "Chair": (2.26, 1.35), "Storage": (2.27, 1.45),
        "Decor": (2.71, 1.71), "Picture": (2.80, 1.99), "Table": (2.15, 1.47),
        "Sofa": (2.56, 1.58), "TV": (2.49, 1.52), "overall": (2.40, 1.54),
    },
    "AD+RP": {
        "Bed": (1.40, 0.95), "Chair": (2.40, 1.47), "Storage": (2.55, 1.67),
        "Decor": (2.79, 1.96), "Picture": (2.95, 2.03), "Table": (2.26, 1.46),
        "Sofa": (2.58, 1.58), "TV": (2.39, 1.731), "overall": (2.49, 1.65),
    },
    "S+RP": {
        "Bed": (1.85, 1.32), "Chair": (2.46, 1.56), "Storage": (2.46, 1.64),
        "Decor": (3.38, 2.14), "Picture": (2.82, 1.92), "Table": (2.67, 1.72),
        "Sofa": (2.53, 1.64), "TV": (2.51, 1.55), "overall": (2.67, 1.73),
    },
    "RP": {
        "Bed": (1.99, 1.31), "Chair": (2.95, 2.31), "Storage": (2.75, 1.53),
        "Decor": (3.12, 2.56), "Picture": (2.95, 2.21), "Table": (2.70, 1.57),
        "Sofa": (2.55, 1.72), "TV": (2.95, 2.32), "overall": (2.80, 1.96),
    },
}  # fmt: skip
"""System -> category -> (top 1, nearest of the top 5), metres."""

ORIENTATION: dict[str, dict[str, float]] = {
    "F+C+RP": {"Bed": 0.65, "Chair": 0.98, "Sofa": 0.67, "TV": 0.66, "overall": 0.85},
    "F": {"Bed": 1.13, "Chair": 1.66, "Sofa": 1.51, "TV": 0.91, "overall": 1.54},
    "F+C": {"Bed": 1.13, "Chair": 1.55, "Sofa": 1.18, "TV": 0.49, "overall": 1.35},
    "F+C+NT": {"Bed": 1.18, "Chair": 1.53, "Sofa": 1.23, "TV": 0.46, "overall": 1.35},
    "F+C+DS": {"Bed": 1.54, "Chair": 1.55, "Sofa": 1.21, "TV": 0.59, "overall": 1.39},
    "F+C+DS+NT": {"Bed": 1.22, "Chair": 1.50, "Sofa": 1.23, "TV": 0.63, "overall": 1.35},
}
"""System -> category -> angle between predicted and true orientation, radians."""
