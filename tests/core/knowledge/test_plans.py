"""Plans of the rooms that were learned from."""

from __future__ import annotations

from math import pi
from pathlib import Path

from scenegen_core.knowledge.files import default_knowledge, load_knowledge, save_knowledge
from scenegen_core.knowledge.learning import learn
from scenegen_core.knowledge.plans import Plan, PlanBox, plan_of
from scenegen_core.scene.model import PAPER_CATEGORIES, Box, Opening, Room, Scene

OUTLINE = ((0.0, 0.0), (5.004, 0.0), (5.004, 4.0), (0.0, 4.0))
SOFA = Box("s", "Sofa", (2.506, 0.45, 0.4), (0.9, 2.1, 0.8), pi / 2)
LAMP = Box("l", "Other", (4.5, 3.5, 0.75), (0.3, 0.3, 1.5), -pi / 2)
SCENE = Scene(
    Room(
        OUTLINE,
        doors=(Opening((1.0, 0.0), (1.8, 0.0)),),
        windows=(Opening((5.004, 1.0), (5.004, 2.0)),),
    ),
    (SOFA, LAMP),
    id="home/room",
    source="ithor",
)
PLAN = Plan(
    source="ithor",
    corners=((0, 0), (500, 0), (500, 400), (0, 400)),
    doors=((100, 0, 180, 0),),
    windows=((500, 100, 500, 200),),
    boxes=(
        PlanBox("Sofa", x=251, y=45, depth=90, width=210, heading=90, top=80),
        PlanBox("Other", x=450, y=350, depth=30, width=30, heading=270, top=150),
    ),
)


def test_a_plan_is_the_room_in_centimetres_and_degrees() -> None:
    assert plan_of(SCENE) == PLAN


def test_plans_of_rooms_that_teach_are_learned_saved_and_loaded(tmp_path: Path) -> None:
    empty = Scene(Room(OUTLINE), (LAMP,), id="home/other")  # Other is no example of anything
    learned = learn([SCENE, empty], PAPER_CATEGORIES)
    save_knowledge(learned, tmp_path / "knowledge.npz")
    assert load_knowledge(tmp_path / "knowledge.npz").plans == {"home/room": PLAN}


def test_the_knowledge_that_ships_can_draw_every_room_that_it_names_and_stays_small() -> None:
    knowledge = default_knowledge()
    rooms = [part.rooms for part in knowledge.categories.values()]
    rooms += [choice.rooms for choice in knowledge.choices.values()]
    assert {room for some in rooms for room in some} <= set(knowledge.plans)
    ids = {source.id for source in knowledge.sources}
    assert all(plan.source in ids and len(plan.corners) > 2 for plan in knowledge.plans.values())
    root = Path(__file__).parents[3]
    assert (root / "scenegen_core/knowledge/default.npz").stat().st_size < 1_000_000
