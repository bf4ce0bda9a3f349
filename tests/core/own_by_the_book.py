"""Our own relations, written down a second time from their description in docs/model.md.

One box, one scene, plain loops; shapely for gaps, rays, middles and areas: slow, and shares nothing
with ``scenegen_core.graph``. ``scene`` may hold the box itself or not. Of walls, places and boxes
that are equally near, the walls' and places' least turn counts, and the first box.
"""

from __future__ import annotations

import cmath
from cmath import exp
from collections.abc import Iterator, Sequence
from math import cos, hypot, inf, nan, pi, sin, sqrt

from shapely import LineString, MultiPoint, Point, Polygon
from shapely.geometry.base import BaseGeometry

from scenegen_core.scene.model import Box, Category, Opening, Scene, Symmetry
from tests.core.by_the_book import TIE, angle_between, center, footprint, ray, walls

Described = dict[tuple[str, str, str], float]
"""(relation, group, part) -> value."""
Place = tuple[float, float, float]
"""x, y, heading."""

FAR = 4.0  # metres; nothing is told to be further
AGAINST_WALL = 0.12  # metres
TOUCHES = 0.1  # metres
NEARBY = 1.0  # metres
IN_VIEW = 2.0  # metres; of what is further away the size is not told


def clamp(low: float, value: float, high: float) -> float:
    return max(low, min(value, high))


def folded(angle: float) -> float:
    """An angle up to quarter turns: how far two rectangles are from being parallel."""
    return min(abs((angle - quarter * pi / 2 + pi) % (2 * pi) - pi) for quarter in range(4))


def signed_gap(one: BaseGeometry, other: BaseGeometry) -> float:
    """The distance of two convex shapes, or less than 0: how far one must move to part them."""
    ours, theirs = corners(one), corners(other)
    differences = [(x - u, y - v) for x, y in ours for u, v in theirs]
    reach = MultiPoint(differences).convex_hull
    here = Point(0, 0)
    apart = float(reach.distance(here))
    return apart if apart > 0 else -float(reach.boundary.distance(here))


def corners(shape: BaseGeometry) -> list[tuple[float, float]]:
    line = shape.exterior if isinstance(shape, Polygon) else shape
    return [(x, y) for x, y in line.coords]


def runs(box: Box, direction: float, obstacles: Sequence[BaseGeometry]) -> float:
    """How far the ray from the middle runs to the first obstacle; inf if it meets none."""
    sight = ray(box, direction)
    met = [center(box).distance(sight.intersection(o)) for o in obstacles if sight.intersects(o)]
    return min(met, default=inf)


def symmetric(box: Box, groups: tuple[Category, ...]) -> bool:
    return any(g.name == box.category and g.symmetry is Symmetry.SYMMETRIC for g in groups)


def sight_of(box: Box, x: float, y: float, *, both_ways: bool) -> float:
    """How far from straight ahead the point lies; up to a half turn, if both ways are ahead."""
    dx, dy = x - box.center[0], y - box.center[1]
    if hypot(dx, dy) < TIE:
        return 0.0
    cosine = (dx * cos(box.heading) + dy * sin(box.heading)) / hypot(dx, dy)
    sine = (dy * cos(box.heading) - dx * sin(box.heading)) / hypot(dx, dy)
    bearing = angle_between(0.0, phase(cosine, sine))
    return min(bearing, pi - bearing) if both_ways else bearing


def phase(x: float, y: float) -> float:
    """The direction of a vector, radians."""
    return cmath.phase(complex(x, y))


def turned(box: Box, heading: float, *, both_ways: bool) -> float:
    between = box.heading - heading
    return folded(between) if both_ways else angle_between(box.heading, heading)


def around_the_walls(box: Box, scene: Scene, groups: tuple[Category, ...]) -> Described:
    outline, depth, width = walls(scene), box.size[0] / 2, box.size[1] / 2
    loose = symmetric(box, groups)
    ahead, behind, left, right = (
        max(runs(box, box.heading + quarter, outline) - half, 0.0)
        for quarter, half in ((0, depth), (pi, depth), (pi / 2, width), (-pi / 2, width))
    )
    side, far_side = sorted((left, right))
    if loose:
        behind, ahead = sorted((behind, ahead))
    gaps = [signed_gap(footprint(box), wall) for wall in outline]
    nearest, second = sorted(gaps)[:2]
    turns = []
    for wall, gap in zip(outline, gaps, strict=True):
        (x0, y0), (x1, y1) = wall.coords
        inward = phase(x1 - x0, y1 - y0) + pi / 2  # outlines run anticlockwise
        if gap <= nearest + TIE:
            turns.append(turned(box, inward, both_ways=loose))
    values = {
        "behind": min(behind, FAR),
        "ahead": min(ahead, FAR),
        "side": min(side, FAR),
        "far side": min(far_side, FAR),
        "nearest": clamp(0, nearest, FAR),
        "second": clamp(0, second, FAR),
        "flush": sum(gap < AGAINST_WALL for gap in gaps),
        "turn": min(turns),
        "centered": 1.0 if far_side == inf else (far_side - side) / (side + far_side + 0.1),
    }
    return {("W", "", part): value for part, value in values.items()}


def free_floor(box: Box, scene: Scene, groups: tuple[Category, ...]) -> Described:
    others = [other for other in scene.boxes if other.id != box.id]
    level = [
        other
        for other in others
        if min(box.top, other.top) - max(box.bottom, other.bottom) > 0.01
        and other.top - other.bottom > 0.05
    ]
    obstacles = [*walls(scene), *(footprint(other) for other in level)]
    depth, width = box.size[0] / 2, box.size[1] / 2
    ahead, behind, left, right = (
        clamp(-0.2, runs(box, box.heading + quarter, obstacles) - half, FAR)
        for quarter, half in ((0, depth), (pi, depth), (pi / 2, width), (-pi / 2, width))
    )
    side, far_side = sorted((left, right))
    if symmetric(box, groups):
        behind, ahead = sorted((behind, ahead))
    gaps = [signed_gap(footprint(box), footprint(other)) for other in level]
    everyone = [signed_gap(footprint(box), footprint(other)) for other in others]
    values = {
        "behind": behind,
        "ahead": ahead,
        "side": side,
        "far side": far_side,
        "centered": (far_side - side) / (abs(side) + abs(far_side) + 0.1),
        "nearest": clamp(-0.5, min(gaps, default=FAR), FAR),
        "touching": sum(gap < TOUCHES - TIE for gap in gaps),
        "within a metre": sum(gap < NEARBY - TIE for gap in everyone),
    }
    return {("FS", "", part): value for part, value in values.items()}


def middle_of_the_room(box: Box, scene: Scene, groups: tuple[Category, ...]) -> Described:
    room = Polygon(scene.room.corners)
    away = center(box).distance(room.centroid) / sqrt(room.area)
    bearing = sight_of(box, room.centroid.x, room.centroid.y, both_ways=symmetric(box, groups))
    return {("M", "", "distance"): away, ("M", "", "bearing"): bearing}


def nearest_opening(
    name: str, openings: Sequence[Opening], box: Box, groups: tuple[Category, ...]
) -> Described:
    if not openings:
        return {(name, "", part): nan for part in ("gap", "bearing", "offset")}
    lines = [LineString([opening.start, opening.end]) for opening in openings]
    gaps = [signed_gap(footprint(box), line) for line in lines]
    line = lines[first_of_least(gaps)]
    middle, along = line.interpolate(0.5, normalized=True), line.length
    (x0, y0), (x1, y1) = line.coords
    dx, dy = box.center[0] - middle.x, box.center[1] - middle.y
    return {
        (name, "", "gap"): clamp(0, min(gaps), FAR),
        (name, "", "bearing"): sight_of(box, middle.x, middle.y, both_ways=symmetric(box, groups)),
        (name, "", "offset"): min(abs(dx * (x1 - x0) + dy * (y1 - y0)) / along, FAR),
    }


def first_of_least(values: Sequence[float]) -> int:
    return next(i for i, value in enumerate(values) if value <= min(values) + TIE)


def neighbor(
    name: str, group: str, box: Box, members: Sequence[Box], groups: tuple[Category, ...]
) -> Described:
    """The nearest member of a group, each seen from the other."""
    parts = (
        "gap", "near", "before", "offset", "bearing", "turn", "faced", "lateral", "beside", "on",
        "top", "long",
    )  # fmt: skip
    if not members:
        return {(name, group, part): nan for part in parts}
    gaps = [signed_gap(footprint(box), footprint(other)) for other in members]
    other = members[first_of_least(gaps)]
    fronted = other.front_known and not symmetric(other, groups)
    half_depth, half_width = other.size[0] / 2, other.size[1] / 2
    # the middle of the box, from the other's middle, in the other's frame
    offset = complex(box.center[0] - other.center[0], box.center[1] - other.center[1])
    seen = offset * exp(-1j * other.heading)
    beyond, beside = abs(seen.real) - half_depth, abs(seen.imag) - half_width
    if fronted and seen.real >= -TIE:
        before, aside = max(seen.real - half_depth, -0.5), abs(seen.imag)
    elif fronted:
        before, aside = min(seen.real + half_depth, 0.5), abs(seen.imag)
    else:
        before = max(beyond, beside)
        aside = abs(seen.imag) if beyond >= beside - TIE else abs(seen.real)
    faced = seen.real > half_depth + TIE and beside < box.size[1] / 2 - TIE
    both_ways = symmetric(box, groups)
    values = {
        "gap": clamp(-0.5, min(gaps), FAR),
        "near": sum(gap < NEARBY - TIE for gap in gaps),
        "before": clamp(-FAR, before, FAR),
        "offset": min(aside, FAR),
        "bearing": sight_of(box, *other.center[:2], both_ways=both_ways),
        "turn": turned(box, other.heading, both_ways=both_ways or not fronted),
        "faced": float(faced) if fronted else nan,
        "lateral": min(abs((offset * exp(-1j * box.heading)).imag), FAR),
        "beside": clamp(-1, beside, FAR),
        "on": any(
            gap < -0.01 and abs(box.bottom - below.top) < 0.06
            for gap, below in zip(gaps, members, strict=True)
        ),
        "top": other.top if min(gaps) < IN_VIEW - TIE else nan,
        "long": max(other.size[:2]) if min(gaps) < IN_VIEW - TIE else nan,
    }
    return {(name, group, part): float(value) for part, value in values.items()}


def same_size(box: Box, other: Box) -> bool:
    pairs = zip(box.size, other.size, strict=True)
    return all(abs(a - b) <= max(0.1 * a, 0.03) for a, b in pairs)


def mirror_places(box: Box, scene: Scene) -> Iterator[Place]:
    """Where a box of the kind would mirror another about something beside that one."""
    others = [other for other in scene.boxes if other.id != box.id]
    kind = [other for other in others if other.category == box.category]
    solid = [o for o in others if o.category != box.category and o.top - o.bottom > 0.05]
    for one in kind:
        for partner in solid:
            if signed_gap(footprint(one), footprint(partner)) > 0.8:
                continue
            middle = complex(*partner.center[:2])
            offset = complex(*one.center[:2]) - middle
            for normal in (partner.heading, partner.heading + pi / 2):
                if abs((offset * exp(-1j * normal)).real) >= 0.1:  # else it is its own mirror image
                    line = normal + pi / 2
                    image = middle + exp(2j * line) * offset.conjugate()
                    yield image.real, image.imag, 2 * line - one.heading
            opposite = middle - offset
            yield opposite.real, opposite.imag, one.heading + pi


def mirrored(box: Box, scene: Scene, groups: tuple[Category, ...]) -> Described:
    kind = [o for o in scene.boxes if o.id != box.id and o.category == box.category]
    free = [
        (hypot(x - box.center[0], y - box.center[1]), heading)
        for x, y, heading in mirror_places(box, scene)
        if all(hypot(x - o.center[0], y - o.center[1]) > 0.25 for o in kind)
    ]
    if not free:
        return {("MI", "", "distance"): nan, ("MI", "", "turn"): nan}
    least = min(away for away, _ in free)
    turns = [
        turned(box, heading, both_ways=symmetric(box, groups))
        for away, heading in free
        if away <= least + TIE
    ]
    return {("MI", "", "distance"): min(least, 2.0), ("MI", "", "turn"): min(turns)}


def described(box: Box, scene: Scene, groups: tuple[Category, ...]) -> Described:
    """Every column of every relation."""
    names = {group.name for group in groups}
    others = [other for other in scene.boxes if other.id != box.id]
    found = {
        **around_the_walls(box, scene, groups),
        **free_floor(box, scene, groups),
        **middle_of_the_room(box, scene, groups),
        **nearest_opening("DR", scene.room.doors, box, groups),
        **nearest_opening("WN", scene.room.windows, box, groups),
        ("H", "", ""): box.bottom,
        **mirrored(box, scene, groups),
    }
    for group in groups:
        members = [
            other
            for other in others
            if other.category == group.name
            or (group.name == "Other" and other.category not in names)
        ]
        found |= neighbor("N", group.name, box, members, groups)
    alike = [o for o in others if o.category == box.category and same_size(box, o)]
    found |= neighbor("TW", "", box, alike, groups)
    area = Polygon(scene.room.corners).area
    sizes = zip(("depth", "width", "height", "room"), (*box.size, area), strict=True)
    return found | {("SZ", "", part): value for part, value in sizes}
