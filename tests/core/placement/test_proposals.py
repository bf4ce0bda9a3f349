"""The poses that are tried: nothing worth trying is missing, and every one is in its cell."""

from __future__ import annotations

from math import cos, pi, sin

import numpy as np
import pytest
from scipy.spatial import cKDTree

from scenegen_core.graph.surroundings import Surroundings
from scenegen_core.placement.mounts import Mount
from scenegen_core.placement.proposals import Grid, Proposals, propose, unrolled
from scenegen_core.scene.geometry import Floats
from scenegen_core.scene.model import PAPER_CATEGORIES, Scene, Vector3
from tests.core.placement.drawn import (
    L_SHAPE,
    NORTH,
    SOUTH,
    TURN,
    WEST,
    category,
    moved,
    room,
    thing,
)

GAP = 0.02  # metres to the wall
TABLE = thing("Table", 2.5, 2.0, (1.0, 2.0, 0.75), heading=0.4)
SIDEBOARD = thing("Storage", 4.0, 0.25, (0.5, 1.2, 0.8), heading=NORTH)


def proposals(scene: Scene, name: str, size: Vector3) -> Proposals:
    return propose(Surroundings(scene, PAPER_CATEGORIES), category(name), size)


def poses(found: Proposals) -> Floats:
    """Position and direction of each proposal: (n, 5)."""
    heading = found.candidates.headings
    return np.column_stack([found.candidates.centers, np.cos(heading), np.sin(heading)])


def are_the_same(ones: Floats, others: Floats) -> bool:
    """Is each pose within a micrometer of one of the others, and the other way round?"""
    there, _ = cKDTree(others).query(ones)
    back, _ = cKDTree(ones).query(others)
    return bool(np.max(there) < 1e-6 and np.max(back) < 1e-6)


def has(found: Proposals, x: float, y: float, heading: float, z: float) -> bool:
    """Is there a proposal within a micrometer of that pose?"""
    candidates = found.candidates
    off = np.abs(candidates.centers - [x, y, z]).max(axis=1)
    turn = np.abs(np.exp(1j * candidates.headings) - np.exp(1j * heading))
    return bool((np.maximum(off, turn) < 1e-6).any())


def test_a_sofa_is_tried_in_sixteen_headings_in_the_middle_of_every_cell() -> None:
    found = proposals(room(), "Sofa", (0.9, 2.0, 0.8))
    grid = found.candidates.centers[~found.flush]
    assert len(grid) == 50 * 40 * 16
    for i, j, k in [(0, 0, 0), (49, 39, 15), (17, 3, 5)]:
        assert has(found, 0.05 + 0.1 * i, 0.05 + 0.1 * j, k * pi / 8, 0.4)


def test_a_sofa_is_tried_flush_with_every_wall_and_in_every_corner_both_ways() -> None:
    found = proposals(room(), "Sofa", (0.9, 2.0, 0.8))
    near, far = 0.45 + GAP, 1.0 + GAP
    corners = [
        (far, near, NORTH), (5 - far, near, NORTH),
        (5 - near, far, WEST), (5 - near, 4 - far, WEST),
        (5 - far, 4 - near, SOUTH), (far, 4 - near, SOUTH),
        (near, 4 - far, 0.0), (near, far, 0.0),
    ]  # fmt: skip
    for x, y, heading in corners:
        assert has(found, x, y, heading, 0.4)


def test_along_a_wall_the_poses_are_no_more_than_a_cell_apart() -> None:
    found = proposals(room(), "Sofa", (0.9, 2.0, 0.8))
    at_south = np.isclose(found.candidates.centers[:, 1], 0.47) & found.flush
    steps = np.diff(np.sort(found.candidates.centers[at_south, 0]))
    assert 0 < steps.min() <= steps.max() <= 0.1 + 1e-9


def test_every_wall_of_an_l_is_tried_with_the_back_to_it() -> None:
    found = proposals(room(corners=L_SHAPE), "Storage", (0.4, 0.8, 2.0))
    flush = found.candidates[found.flush]
    sides = {
        "south": (flush.centers[:, 1], 0.22, NORTH),
        "east end": (flush.centers[:, 0], 6 - 0.22, WEST),
        "north of the foot": (flush.centers[:, 1], 2 - 0.22, SOUTH),
        "east of the stem": (flush.centers[:, 0], 3 - 0.22, WEST),
        "north of the stem": (flush.centers[:, 1], 5 - 0.22, SOUTH),
        "west": (flush.centers[:, 0], 0.22, 0.0),
    }
    for side, (across, where, heading) in sides.items():
        facing = np.abs(np.exp(1j * flush.headings) - np.exp(1j * heading)) < 1e-6
        assert (np.isclose(across, where) & facing).any(), side


def test_what_stands_at_a_wall_is_touched_on_both_sides() -> None:
    """The chests take x = 0.7 … 1.5 and 2.13 … 2.93: between them 0.63 m are free."""
    chests = [
        thing("Storage", x, 0.3, (0.6, 0.8, 0.9), heading=NORTH, box_id=f"{x}") for x in (1.1, 2.53)
    ]
    found = proposals(room(*chests), "Storage", (0.5, 0.6, 0.8))
    for x in (0.7 - 0.3, 1.5 + 0.3, 2.13 - 0.3, 2.93 + 0.3):
        assert has(found, x, 0.25 + GAP, NORTH, 0.4), x


def test_what_is_away_from_the_wall_or_at_another_is_not_touched() -> None:
    table = thing("Table", 2.5, 2.0, (1.0, 1.63, 0.75))
    alone, beside = (proposals(scene, "Sofa", (0.9, 2.0, 0.8)) for scene in (room(), room(table)))
    assert are_the_same(poses(alone), poses(beside))


def test_a_niche_takes_what_is_as_wide_without_a_gap() -> None:
    niche = ((0, 0), (5, 0), (5, 4), (3, 4), (3, 5), (1.6, 5), (1.6, 4), (0, 4))
    found = proposals(room(corners=niche), "Bed", (2.0, 1.4, 0.5))
    assert has(found, 2.3, 5 - 1.0 - GAP, SOUTH, 0.25)
    assert not has(proposals(room(corners=niche), "Bed", (2.0, 1.42, 0.5)), 2.3, 3.98, SOUTH, 0.25)


def test_a_long_plant_box_is_tried_both_ways_on_a_table() -> None:
    found = proposals(room(TABLE), "Decor", (0.2, 0.5, 0.2))
    on_top = found.candidates.headings[found.candidates.centers[:, 2] > 0.5]
    turns = {round(float(heading) - TABLE.heading, 6) for heading in on_top}
    assert turns == {0.0, round(pi / 2, 6)}


def test_a_wall_shorter_than_the_object_is_not_tried() -> None:
    found = proposals(room(), "Sofa", (0.9, 4.5, 0.8))
    flush = found.candidates.centers[found.flush]
    assert {round(y, 6) for y in flush[:, 1].tolist()} == {0.47, 3.53}


def test_storage_on_the_grid_faces_away_from_its_nearest_wall() -> None:
    found = proposals(room(), "Storage", (0.4, 0.8, 2.0))
    grid = found.candidates[~found.flush]
    assert len(grid) == 50 * 40
    for x, y, heading in [(0.55, 2.05, 0.0), (4.35, 2.05, WEST), (2.55, 0.95, NORTH)]:
        (index,) = np.flatnonzero(np.abs(grid.centers[:, :2] - [x, y]).max(axis=1) < 1e-6)
        assert grid.headings[index] == pytest.approx(heading)


def test_a_square_table_is_tried_one_way_and_a_long_one_two_ways() -> None:
    square = proposals(room(), "Table", (0.8, 0.8, 0.7))
    long = proposals(room(), "Table", (0.8, 1.6, 0.7))
    assert (~square.flush).sum() == 50 * 40
    assert (~long.flush).sum() == 2 * 50 * 40
    assert has(long, 0.8 + GAP, 0.4 + GAP, NORTH, 0.35)  # its long side to the south wall
    assert has(long, 0.4 + GAP, 0.8 + GAP, WEST, 0.35)  # its short side to it


def test_headings_follow_the_longest_wall_of_a_turned_room() -> None:
    found = proposals(moved(room()), "Sofa", (0.9, 2.0, 0.8))
    turns = np.unique((found.candidates.headings - TURN).round(6) % (pi / 8))
    assert set(turns.round(5)) <= {0.0, round(pi / 8, 5)}


def test_rows_count_from_the_south_and_columns_from_the_west() -> None:
    grid = Grid((-2.0, 1.0), (3, 7))
    points = np.array([[-1.95, 1.05], [-1.35, 1.05], [-1.95, 1.25], [-1.31, 1.29]])
    assert grid.index(points).tolist() == [0, 6, 14, 20]
    assert grid.middles()[[0, 6, 14, 20]] == pytest.approx(
        np.array([[-1.95, 1.05], [-1.35, 1.05], [-1.95, 1.25], [-1.35, 1.25]])
    )


def test_the_grid_of_the_floor_covers_an_uneven_room() -> None:
    corners = ((-1.03, 0.5), (3.0, 0.5), (3.0, 2.25), (1.0, 2.25), (1.0, 4.0), (-1.03, 4.0))
    found = proposals(room(corners=corners), "Table", (0.5, 0.5, 0.5))
    grid = found.grids[Mount.FLOOR]
    assert grid.origin == (-1.03, 0.5)
    assert grid.shape == (35, 41)  # 3.5 m of rows, 4.03 m of columns
    rows, columns = np.divmod(found.cells, 41)
    x, y = found.candidates.centers[:, 0], found.candidates.centers[:, 1]
    assert (np.abs(x - (-1.03 + 0.1 * (columns + 0.5))) <= 0.05 + 1e-9).all()
    assert (np.abs(y - (0.5 + 0.1 * (rows + 0.5))) <= 0.05 + 1e-9).all()


def test_walls_are_unrolled_from_the_first_corner_anticlockwise() -> None:
    walls: Floats = np.array(room().room.walls, dtype=float)
    points = np.array(
        [[1.0, 0.02, 1.5], [4.98, 3.0, 0.8], [2.0, 3.98, 2.0], [0.02, 3.0, 1.0], [0.02, 1.0, 1.0]]
    )
    # 5 m south, 4 m east, 5 m north, 4 m west
    expected = [[1.0, 1.5], [8.0, 0.8], [12.0, 2.0], [15.0, 1.0], [17.0, 1.0]]
    assert unrolled(walls, points) == pytest.approx(np.array(expected))


def test_pictures_hang_on_every_wall_around_eye_level() -> None:
    found = proposals(room(), "Picture", (0.04, 0.8, 0.6))
    candidates = found.candidates
    assert set(found.mounts.tolist()) == {Mount.WALL}
    assert {round(z, 6) for z in candidates.centers[:, 2].tolist()} == {
        1.2, 1.3, 1.4, 1.5, 1.6, 1.7, 1.8
    }  # fmt: skip
    for x, y, heading in [
        (0.4, 0.02, NORTH), (4.6, 0.02, NORTH), (4.98, 0.4, WEST),
        (0.4, 3.98, SOUTH), (0.02, 3.6, 0.0),
    ]:  # fmt: skip
        assert has(found, x, y, heading, 1.5)
    assert found.grids[Mount.WALL].shape == (26, 180)  # 2.6 m high, 18 m round
    rows, columns = np.divmod(found.cells, 180)
    on_south = np.isclose(candidates.centers[:, 1], 0.02) & np.isclose(
        np.sin(candidates.headings), 1
    )
    assert (
        np.abs(candidates.centers[on_south, 0] - 0.1 * (columns[on_south] + 0.5)) < 0.0501
    ).all()
    assert (np.abs(candidates.centers[:, 2] - 0.1 * (rows + 0.5)) < 0.0501).all()


def test_a_vase_is_tried_all_over_a_turned_table_and_nowhere_beyond() -> None:
    found = proposals(room(TABLE), "Decor", (0.2, 0.2, 0.3))
    on_top = found.candidates[found.mounts == Mount.TOP]
    assert np.unique(on_top.centers[:, 2]).tolist() == [0.75 + 0.15]
    assert (on_top.centers[:, :2] == [2.5, 2.0]).all(axis=1).any()  # its very middle
    offset = on_top.centers[:, :2] - [2.5, 2.0]
    along = offset @ [cos(0.4), sin(0.4)]
    across = offset @ [-sin(0.4), cos(0.4)]
    assert np.abs(along).max() <= 0.5 + 1e-9
    assert np.abs(across).max() <= 1.0 + 1e-9
    assert len(on_top) == pytest.approx(1.0 * 2.0 / 0.01, rel=0.05)  # a cell is 0.01 m²


def test_a_television_on_a_sideboard_looks_where_the_sideboard_does() -> None:
    found = proposals(room(SIDEBOARD), "TV", (0.2, 1.0, 0.6))
    on_top = found.candidates[found.mounts == Mount.TOP]
    assert len(on_top) > 10
    assert np.cos(on_top.headings - NORTH) == pytest.approx(1.0)


def test_a_television_on_a_table_is_tried_along_all_its_axes() -> None:
    found = proposals(room(TABLE), "TV", (0.2, 0.8, 0.6))
    on_top = found.candidates.headings[found.mounts == Mount.TOP]
    assert set(on_top.round(6).tolist()) == {round(0.4 + k * pi / 2, 6) for k in range(4)}


def test_nothing_is_put_on_a_wardrobe_or_on_a_chair() -> None:
    tall = thing("Storage", 1, 1, (0.6, 1.2, 2.0))
    chair = thing("Chair", 3, 3, (0.5, 0.5, 0.45))
    found = proposals(room(tall, chair), "TV", (0.2, 0.4, 0.3))
    assert Mount.TOP not in set(found.mounts.tolist())


@pytest.mark.parametrize(
    ("name", "size", "surfaces"),
    [
        ("Sofa", (0.9, 2.0, 0.8), {Mount.FLOOR}),
        ("Picture", (0.04, 0.8, 0.6), {Mount.WALL}),
        ("TV", (0.1, 1.1, 0.7), {Mount.WALL, Mount.TOP}),
        ("TV", (0.5, 0.7, 0.6), {Mount.TOP}),
        ("TV", (0.4, 1.1, 1.2), {Mount.FLOOR}),
        ("Decor", (0.3, 0.3, 0.4), {Mount.FLOOR, Mount.TOP}),
        ("Decor", (0.4, 0.4, 1.5), {Mount.FLOOR}),
        ("Decor", (2.0, 3.0, 0.02), {Mount.FLOOR}),
    ],
)
def test_a_thing_has_a_map_for_each_surface_that_it_can_rest_on(
    name: str, size: Vector3, surfaces: set[Mount]
) -> None:
    found = proposals(room(TABLE), name, size)
    assert set(found.grids) == surfaces == set(found.mounts.tolist())


@pytest.mark.parametrize("name", ["Sofa", "Storage", "Table", "Decor", "TV", "Picture"])
def test_moving_the_scene_moves_the_proposals(name: str) -> None:
    scene = room(TABLE, SIDEBOARD, corners=L_SHAPE)
    size = (0.3, 0.9, 0.5)
    here, there = proposals(scene, name, size), proposals(moved(scene, 0, (3, -7)), name, size)
    assert are_the_same(poses(here) + np.array([3, -7, 0, 0, 0]), poses(there))
    inner = np.abs(here.candidates.centers[:, 0] % 0.1 - 0.05) < 0.049  # not on the edge of a cell
    inner &= np.abs(here.candidates.centers[:, 1] % 0.1 - 0.05) < 0.049
    assert inner.any()
    assert (there.cells[inner] == here.cells[inner]).all()


@pytest.mark.parametrize("name", ["Sofa", "Table", "Decor", "TV", "Picture"])
def test_a_square_room_turned_by_a_quarter_has_the_same_proposals_turned(name: str) -> None:
    table = thing("Table", 2.5, 1.5, (1.0, 2.0, 0.75))
    scene = room(table, corners=((0, 0), (4, 0), (4, 4), (0, 4)))
    size = (0.3, 0.9, 0.5)
    here = poses(proposals(scene, name, size))
    there = poses(proposals(moved(scene, pi / 2, (4, 0)), name, size))
    x, y, z, along, across = here.T
    assert are_the_same(np.stack([4 - y, x, z, -across, along], axis=1), there)
