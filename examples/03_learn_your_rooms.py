"""Learn from your own rooms, keep what was learned, and ask it.

Run from the top of the repository: python examples/03_learn_your_rooms.py
"""

from __future__ import annotations

from pathlib import Path
from tempfile import TemporaryDirectory

from scenegen_core.knowledge import learn, load_knowledge, save_knowledge
from scenegen_core.placement.answer import Query
from scenegen_core.placement.solve import solve
from scenegen_core.scene.files import read_scene
from scenegen_core.scene.model import PAPER_CATEGORIES

ROOMS = Path("web/public/rooms")  # scene files, as the page saves them


def main() -> None:
    """Learn from all rooms but the bedroom, then ask for a storage in the bedroom."""
    rooms = [read_scene(path.read_bytes()) for path in sorted(ROOMS.glob("*.json"))]
    bedroom = next(room for room in rooms if room.id == "bedroom")
    others = [room for room in rooms if room is not bedroom]

    with TemporaryDirectory() as directory:
        path = Path(directory) / "mine.npz"
        save_knowledge(learn(others, PAPER_CATEGORIES, made_with="example 3"), path)
        mine = load_knowledge(path)

    print(f"Learned from {len(others)} rooms:")
    for name, part in mine.categories.items():
        print(f"  {name:<8} {part.examples} examples")

    # Four rooms are enough for the model of the paper; ours wants choices (scenegen learn --on).
    answer = solve(bedroom, Query("Storage", model="paper"), mine).answer
    print("\nWhere a storage would go in the bedroom:")
    for pose in answer.poses:
        print(f"  {pose.rank}. {pose.sentence}")


if __name__ == "__main__":
    main()
