"""Things with doors, drawers and shelves; their doors are on +z."""

from __future__ import annotations

from scenegen_core.scene.model import Vector3
from server.furniture.bookcases import BOOKCASE
from server.furniture.design import Design, Parts, legs, named
from server.furniture.materials import BRASS, MATTE_WHITE, OAK, WALNUT, WARM_GREY, Material
from server.furniture.parts import Span, block

TALL = 1.3  # metres; from there on it is a wardrobe
SMALL = 0.75  # metres; narrower low pieces are nightstands or chests of drawers
DOOR = 0.55  # metres, about the width of a door
BOARD = 0.025  # metres
FRONT = 0.02  # metres, thickness of a door
GAP = 0.004  # metres between doors


def choose(size: Vector3, label: str) -> Design:
    """The storage for the size (depth, width, height) and label."""
    labelled = (design for words, design in NAMED if named(label, *words))
    return next(labelled, None) or _by_proportions(size)


def _by_proportions(size: Vector3) -> Design:
    """What has about these proportions."""
    _, width, height = size
    if height >= TALL:
        return WARDROBE
    if max(width, height) < SMALL:
        return NIGHTSTAND
    return SIDEBOARD if width > height else DRAWERS


def wardrobe(w: float, h: float, d: float) -> Parts:
    """Tall doors with long handles on a recessed plinth."""
    yield WARM_GREY, block((-w / 2 + 0.02, w / 2 - 0.02), (0, 0.07), (-d / 2, d / 2 - 0.06))
    yield MATTE_WHITE, block((-w / 2, w / 2), (0.06, h), (-d / 2, d / 2 - FRONT - 0.02))
    count = min(8, max(1, round(w / DOOR)))
    width = (w - 0.01) / count
    for number in range(count):
        x = -w / 2 + 0.005 + number * width
        yield from _door((x, x + width), (0.065, h - 0.005), d / 2 - 0.02, MATTE_WHITE)
        right = number % 2 == 0 and count > 1
        grip = x + width - 0.05 if right else x + 0.05
        yield (
            OAK,
            block(
                (grip - 0.009, grip + 0.009),
                (0.42 * h, 0.42 * h + min(0.45, 0.25 * h)),
                (d / 2 - 0.022, d / 2),
                0.005,
            ),
        )


def sideboard(w: float, h: float, d: float) -> Parts:
    """A low wooden body on legs: doors at the ends, drawers in the middle."""
    foot = min(0.16, 0.25 * h)
    yield from legs(
        w / 2 - 0.1, d / 2 - 0.08, foot + 0.01, thickness=0.04, material=OAK, splay=0.02
    )
    yield OAK, block((-w / 2, w / 2), (foot, h), (-d / 2, d / 2 - 0.015), 0.01)
    front = d / 2 - 0.008
    count = min(6, max(2, round(w / 0.5)))
    width = (w - 2 * BOARD) / count
    low, high = foot + BOARD, h - BOARD
    for number in range(count):
        x = (-w / 2 + BOARD + number * width, -w / 2 + BOARD + (number + 1) * width)
        if count > 2 and number == count // 2:  # noqa: PLR2004 (room between two doors)
            yield from _drawer_stack(x, (low, high), front, 3 if h > 0.6 else 2, MATTE_WHITE)  # noqa: PLR2004
        else:
            yield from _door(x, (low, high), front, MATTE_WHITE)
            grip = x[1] - 0.04 if number < count // 2 else x[0] + 0.04
            middle = (low + high) / 2
            yield (
                BRASS,
                block(
                    (grip - 0.006, grip + 0.006),
                    (middle - 0.05, middle + 0.05),
                    (front - 0.01, d / 2),
                    0.003,
                ),
            )


def nightstand(w: float, h: float, d: float) -> Parts:
    """A small body with two drawers on legs."""
    foot = 0.25 * h
    yield from legs(
        w / 2 - 0.05, d / 2 - 0.06, foot + 0.01, thickness=0.035, material=OAK, splay=0.01
    )
    yield OAK, block((-w / 2, w / 2), (foot, h), (-d / 2, d / 2 - 0.015), 0.01)
    yield from _drawer_stack(
        (-w / 2 + 0.02, w / 2 - 0.02), (foot + 0.02, h - 0.025), d / 2 - 0.008, 2, MATTE_WHITE
    )


def drawers(w: float, h: float, d: float) -> Parts:
    """A chest of drawers."""
    yield OAK, block((-w / 2 + 0.02, w / 2 - 0.02), (0, 0.06), (-d / 2, d / 2 - 0.05))
    yield OAK, block((-w / 2, w / 2), (0.05, h), (-d / 2, d / 2 - 0.015), 0.01)
    count = min(7, max(2, round((h - 0.1) / 0.22)))
    columns = 2 if w > 1.1 else 1  # noqa: PLR2004 (metres; wider drawers would jam)
    width = (w - 2 * BOARD) / columns
    for column in range(columns):
        x = -w / 2 + BOARD + column * width
        yield from _drawer_stack(
            (x, x + width), (0.07, h - 0.035), d / 2 - 0.008, count, MATTE_WHITE
        )


def kitchen(w: float, h: float, d: float) -> Parts:
    """Base cabinets under a worktop."""
    yield WARM_GREY, block((-w / 2, w / 2), (0, 0.1), (-d / 2, d / 2 - 0.07))
    yield (
        MATTE_WHITE,
        block((-w / 2 + 0.003, w / 2 - 0.003), (0.09, h - 0.03), (-d / 2, d / 2 - 0.04)),
    )
    yield WALNUT, block((-w / 2, w / 2), (h - 0.035, h), (-d / 2, d / 2), 0.006)
    count = min(8, max(1, round(w / 0.6)))
    width = w / count
    split = h - 0.05 - 0.2 * h
    for number in range(count):
        x = (-w / 2 + number * width, -w / 2 + (number + 1) * width)
        yield from _door(x, (0.1, split), d / 2 - 0.022, MATTE_WHITE)
        yield from _drawer_stack(x, (split, h - 0.045), d / 2 - 0.022, 1, MATTE_WHITE)
        yield (
            BRASS,
            block(
                (sum(x) / 2 - 0.07, sum(x) / 2 + 0.07),
                (split - 0.05, split - 0.038),
                (d / 2 - 0.025, d / 2 - 0.006),
                0.004,
            ),
        )


def wall_cabinet(w: float, h: float, d: float) -> Parts:
    """Doors only, with their grips below."""
    yield MATTE_WHITE, block((-w / 2, w / 2), (0.01, h), (-d / 2, d / 2 - 0.03))
    count = min(8, max(1, round(w / DOOR)))
    width = w / count
    for number in range(count):
        x = (-w / 2 + number * width, -w / 2 + (number + 1) * width)
        yield from _door(x, (0, h), d / 2 - 0.01, MATTE_WHITE)
        yield (
            BRASS,
            block(
                (sum(x) / 2 - 0.06, sum(x) / 2 + 0.06), (0.03, 0.042), (d / 2 - 0.012, d / 2), 0.003
            ),
        )


def _door(x: Span, y: Span, front: float, material: Material) -> Parts:
    """A flat door whose face is at z = front."""
    yield material, block((x[0] + GAP / 2, x[1] - GAP / 2), y, (front - FRONT, front), 0.004)


def _drawer_stack(x: Span, y: Span, front: float, count: int, material: Material) -> Parts:
    """Drawers one above the other, each with a handle that stands out by 8 mm."""
    step = (y[1] - y[0]) / count
    middle, half = sum(x) / 2, min(0.07, 0.2 * (x[1] - x[0]))
    for number in range(count):
        low = y[0] + number * step
        yield (
            material,
            block(
                (x[0] + GAP / 2, x[1] - GAP / 2),
                (low + GAP / 2, low + step - GAP),
                (front - FRONT, front),
                0.004,
            ),
        )
        grip = low + 0.62 * step
        yield (
            BRASS,
            block(
                (middle - half, middle + half),
                (grip, grip + 0.012),
                (front - 0.005, front + 0.008),
                0.003,
            ),
        )


WARDROBE = Design("wardrobe", wardrobe, (0.3, 0.35, 1.2), (1.0, 4.0, 3.0))
SIDEBOARD = Design("sideboard", sideboard, (0.25, 0.6, 0.3), (0.8, 3.5, 1.3))
NIGHTSTAND = Design("nightstand", nightstand, (0.2, 0.22, 0.25), (0.8, 1.0, 1.0))
DRAWERS = Design("chest of drawers", drawers, (0.25, 0.3, 0.45), (0.8, 2.4, 2.0))
WALL_CABINET = Design("wall cabinet", wall_cabinet, (0.15, 0.25, 0.2), (0.8, 4.0, 1.6))
KITCHEN = Design("kitchen cabinet", kitchen, (0.3, 0.3, 0.4), (1.0, 5.0, 1.2))
NAMED: tuple[tuple[tuple[str, ...], Design], ...] = (
    (("shelf", "shelv", "book", "rack"), BOOKCASE),
    (("upper", "hanging", "wall cabinet"), WALL_CABINET),
    (("kitchen", "counter"), KITCHEN),
    (("wardrobe", "closet"), WARDROBE),
    (("drawer", "dresser", "commode", "filing"), DRAWERS),
    (("nightstand", "bedside"), NIGHTSTAND),
    (("tv unit", "sideboard"), SIDEBOARD),
)
