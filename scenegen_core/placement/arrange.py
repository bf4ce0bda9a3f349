"""Several objects, one after another: each sees those placed before (Algorithm 1, repeated)."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from scenegen_core.knowledge.knowledge import Knowledge
from scenegen_core.placement.answer import Answer, Query
from scenegen_core.placement.solve import solve
from scenegen_core.scene.model import Box, Scene


def arrange(
    scene: Scene,
    queries: Sequence[Query],
    knowledge: Knowledge,
    *,
    progress: Callable[[int], None] = lambda _: None,
) -> tuple[Scene, tuple[Answer, ...]]:
    """The furnished scene and the answer to each query; an object without a place is left out."""
    answers = []
    for number, query in enumerate(queries, start=1):
        answer = solve(scene, query, knowledge).answer
        if answer.poses:
            scene = scene.with_box(placed_box(answer, _free_id(scene, query.category)))
        answers.append(answer)
        progress(number)
    return scene, tuple(answers)


def placed_box(answer: Answer, box_id: str) -> Box:
    """The box of the best pose of an answer."""
    best = answer.poses[0]
    return Box(
        id=box_id,
        category=answer.category,
        center=best.center,
        size=answer.size,
        heading=best.heading,
        placed=True,
    )


def _free_id(scene: Scene, category: str) -> str:
    """An id that no box of the scene has: "sofa-1"."""
    number = 1
    while f"{category.lower()}-{number}" in scene:
        number += 1
    return f"{category.lower()}-{number}"
