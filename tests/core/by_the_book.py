"""The paper's nine relations, written down a second time straight from its equations.

One box, one scene, plain loops, shapely for the distances: slow, and shares nothing with
``scenegen_core.graph``. ``scene`` may hold the box O_k itself or not; the paper's "j ≠ k" is a
comparison of ids. The paper gives ϱ, ε and φ no numbers, so they are arguments.

Where the paper is silent or contradicts itself (docs/decisions.md): distances lie in the floor
plan; TowardsCenter takes the text's l/2 walls, rounded up, and the first wall that the ray meets;
angles are wrapped; "perpendicular" is within φ; a neighbor without a known front has no direction;
of walls that are equally far or near all count (two that share an inner corner often are).
"""

from __future__ import annotations

from math import ceil, cos, pi, sin

from shapely import LineString, Point, Polygon

from scenegen_core.scene.model import Box, Scene

FAR = 10_000.0  # metres; a ray that long leaves every room
NOBODY = 1000.0  # AverageDistance to a group of which the room holds none
TIE = 1e-9  # metres; walls no more apart than that are equally far
RESTING = 0.05  # metres between an upper side and the underside of what stands on it


def footprint(box: Box) -> Polygon:
    """B(O_k) in the floor plan."""
    x, y, _ = box.center
    depth, width, _ = box.size
    ax, ay = cos(box.heading), sin(box.heading)
    bx, by = -ay, ax
    corners = []
    for along, across in ((1, 1), (-1, 1), (-1, -1), (1, -1)):
        u, v = along * depth / 2, across * width / 2
        corners.append((x + u * ax + v * bx, y + u * ay + v * by))
    return Polygon(corners)


def center(box: Box) -> Point:
    """Ȯ_k in the floor plan."""
    return Point(box.center[0], box.center[1])


def ray(box: Box, direction: float) -> LineString:
    """{Ȯ_k + γ d | γ ≥ 0} for the unit vector d at that angle."""
    x, y, _ = box.center
    return LineString([(x, y), (x + FAR * cos(direction), y + FAR * sin(direction))])


def walls(scene: Scene) -> list[LineString]:
    """W_1..W_l."""
    corners = scene.room.corners
    return [LineString([corners[i], corners[(i + 1) % len(corners)]]) for i in range(len(corners))]


def members(box: Box, scene: Scene, group: str) -> list[Box]:
    """{O_j ∈ g_i | j ≠ k}."""
    return [other for other in scene.boxes if other.category == group and other.id != box.id]


def distance(box: Box, other: Box) -> float:
    """δ(B(O_k), B(O_j))."""
    return float(footprint(box).distance(footprint(other)))


def angle_between(first: float, second: float) -> float:
    """|θ − θ'| on the circle: 0 to π."""
    return abs((first - second + pi) % (2 * pi) - pi)


def room_position(box: Box, scene: Scene, near_wall: float) -> int:
    """RoomPosition(O_k, R): how many walls are nearer to the center than ϱ."""
    return sum(center(box).distance(wall) < near_wall for wall in walls(scene))


def average_distance(box: Box, scene: Scene, group: str) -> float:
    """AverageDistance(O_k, g_i)."""
    distances = [distance(box, other) for other in members(box, scene, group)]
    return sum(distances) / len(distances) if distances else NOBODY


def surrounded_by(box: Box, scene: Scene, group: str, nearby: float) -> int:
    """SurroundedBy(O_k, g_i): strictly nearer than ε."""
    return sum(distance(box, other) < nearby for other in members(box, scene, group))


def on_top_of(upper: Box, lower: Box) -> bool:
    """Whether the one stands on the other: the source says so, or heights and footprints do."""
    if upper.parent == lower.id:
        return True
    shared = footprint(upper).intersection(footprint(lower)).area
    return bool(shared > 0 and abs(upper.bottom - lower.top) <= RESTING)


def support(box: Box, scene: Scene, group: str) -> int:
    """Support(O_k, g_i)."""
    others = members(box, scene, group)
    if any(on_top_of(box, other) for other in others):
        return 1
    if any(on_top_of(other, box) for other in others):
        return -1
    return 0


def towards_center(box: Box, scene: Scene) -> int:
    """TowardsCenter(O_k): the ray's first wall is one of the furthest ⌈l/2⌉."""
    outline = walls(scene)
    distances = [center(box).distance(wall) for wall in outline]
    last = sorted(distances, reverse=True)[ceil(len(outline) / 2) - 1]
    sight = ray(box, box.heading)
    met = [
        (center(box).distance(sight.intersection(wall)), i)
        for i, wall in enumerate(outline)
        if sight.intersects(wall)
    ]
    return int(bool(met) and distances[min(met)[1]] >= last - TIE)


def away_from_wall(box: Box, scene: Scene, same_direction: float) -> int:
    """AwayFromWall(O_k) = f(Ȯ_k, −a_k, c_1) ∧ (a_k ⊥ c_1)."""
    outline = walls(scene)
    least = min(footprint(box).distance(wall) for wall in outline)
    for wall in outline:
        (x0, y0), (x1, y1) = wall.coords
        along = abs((x1 - x0) * cos(box.heading) + (y1 - y0) * sin(box.heading)) / wall.length
        if (
            footprint(box).distance(wall) <= least + TIE
            and along <= sin(same_direction)
            and ray(box, box.heading + pi).intersects(wall)
        ):
            return 1
    return 0


def direction_similarity(
    box: Box, scene: Scene, nearby: float, same_direction: float
) -> tuple[int, int]:
    """DirectionSimilarity(O_k) = [Same(O_k), Opp(O_k)]."""
    same = opposite = 0
    for other in scene.boxes:
        if other.id == box.id or not other.front_known or distance(box, other) > nearby:
            continue
        between = angle_between(box.heading, other.heading)
        same += between <= same_direction
        opposite += abs(pi - between) <= same_direction
    return same, opposite


def facing(box: Box, scene: Scene, group: str, nearby: float) -> int:
    """Facing(O_k, g_i)."""
    return sum(
        distance(box, other) <= nearby and ray(box, box.heading).intersects(footprint(other))
        for other in members(box, scene, group)
    )


def next_to(box: Box, scene: Scene, group: str, nearby: float) -> int:
    """NextTo(O_k, g_i): h of ±b_k is one indicator, so each neighbor counts once."""
    left, right = ray(box, box.heading + pi / 2), ray(box, box.heading - pi / 2)
    return sum(
        distance(box, other) <= nearby
        and (left.intersects(footprint(other)) or right.intersects(footprint(other)))
        for other in members(box, scene, group)
    )
