"""Where would a sofa go in the living room, which way should it face, and why?

Run from the top of the repository: python examples/01_place_a_sofa.py
"""

from __future__ import annotations

from math import degrees
from pathlib import Path

from scenegen_core.knowledge import default_knowledge
from scenegen_core.placement.answer import Query
from scenegen_core.placement.solve import solve
from scenegen_core.scene.files import read_scene

ROOM = Path("web/public/rooms/living-room.json")


def main() -> None:
    """Print the five places on offer, and what speaks for and against the first."""
    scene = read_scene(ROOM.read_bytes())
    answer = solve(scene, Query("Sofa", size=(0.9, 2.0, 0.85)), default_knowledge()).answer

    print(f"{scene.name}: five places for a sofa")
    for pose in answer.poses:
        x, y, _ = pose.center
        print(
            f"{pose.rank}. {pose.sentence}\n"
            f"   at ({x:.2f}, {y:.2f}) m, turned {degrees(pose.heading):.0f}°, "
            f"likelihood {pose.likelihood:.0%}"
        )

    best = answer.poses[0]
    print(f"\nWhy the first? Its score is {best.score:.1f}, the sum of")
    for reason in sorted(best.reasons, key=lambda reason: -abs(reason.contribution))[:5]:
        print(f"  {reason.contribution:+7.2f}  {reason.text}")

    floor = next(heat_map for heat_map in answer.heat_maps if heat_map.surface == "floor")
    rows, columns = floor.values.shape
    print(f"\nThe heat map has {rows} x {columns} cells of {floor.cell:.2f} m.")


if __name__ == "__main__":
    main()
