"""What stands on what: who takes a table out takes the vase on it along."""

from __future__ import annotations

import numpy as np

from scenegen_core.scene.geometry import distances_to_rectangles, footprints
from scenegen_core.scene.model import Box, Scene

RESTS = 0.05  # metres; an underside this close to an upper side rests on it (bounding boxes err)
HANGS = "Picture"
"""The category that never stands on anything, whatever is below."""


def taken_out(scene: Scene, box_id: str) -> Scene:
    """The scene without a box and without what stands or lies on it, and on that in turn.

    SceneError if there is no such box.
    """
    gone, waiting = {box_id}, [scene[box_id]]
    while waiting:
        more = [box for box in carried(scene, waiting.pop()) if box.id not in gone]
        gone |= {box.id for box in more}
        waiting += more
    return scene.without(*gone)


def carried(scene: Scene, carrier: Box) -> tuple[Box, ...]:
    """What a box carries: what the source says, what stands on it, and what lies in it.

    What stands on a rug stands on the floor: nobody takes the sofa out with its rug. A cushion lies
    on the seat, below the top of the back: its underside is off the floor, over the footprint, and
    on top of nothing else.
    """
    return tuple(
        box
        for box in scene.boxes
        if box.id != carrier.id
        and (box.parent == carrier.id or _stands_on(box, carrier) or _lies_in(box, carrier, scene))
    )


def _stands_on(box: Box, carrier: Box) -> bool:
    on_top = box.bottom > RESTS and abs(box.bottom - carrier.top) <= RESTS
    return on_top and box.category != HANGS and _over(box, carrier)


def _lies_in(box: Box, carrier: Box, scene: Scene) -> bool:
    return (
        box.category != HANGS
        and carrier.bottom + RESTS < box.bottom < carrier.top
        and _over(box, carrier)
        and not any(_stands_on(box, other) for other in scene.boxes if other.id != box.id)
    )


def _over(box: Box, carrier: Box) -> bool:
    """Is the middle of the box over the footprint of the carrier?"""
    center = np.array([box.center[:2]], dtype=float)
    return bool(distances_to_rectangles(center, footprints([carrier]))[0, 0] <= 0)
