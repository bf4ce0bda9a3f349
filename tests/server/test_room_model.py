"""The furnished room as one GLB."""

from __future__ import annotations

from io import BytesIO
from math import pi
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from PIL import Image

from scenegen_core.scene.model import Box, Opening, Room, Scene
from server.furniture import furniture_glb
from server.room_model import room_glb
from tests.server.glb_files import bounds, complaints, document, exported, primitives

L_SHAPE = Room(
    corners=((0, 0), (6, 0), (6, 3), (4, 3), (4, 5), (0, 5)),
    height=2.5,
    doors=(Opening((0.5, 0), (1.4, 0), 0, 2.0, "door"),),
    windows=(Opening((6, 0.5), (6, 2.5), 0.9, 2.1, "window"),),
)
SOFA = Box("s", "Sofa", (2.0, 1.0, 0.4), (0.9, 2.0, 0.8), pi / 2, "Blue sofa")
PICTURE = Box("p", "Picture", (0.02, 4.0, 1.5), (0.04, 0.8, 0.6), 0.0)
PLACED = Box("c", "Chair", (3.0, 2.0, 0.45), (0.5, 0.5, 0.9), pi, placed=True)


def model(box: Box) -> bytes:
    return furniture_glb(box.category, box.size, box.label)


def room(*boxes: Box, shell: Room = L_SHAPE) -> bytes:
    return room_glb(Scene(shell, boxes, name="Living room"), model)


def area(data: bytes, material: str) -> float:
    """Square metres of all triangles of a material that look level or up into the room."""
    (part,) = (part for part in primitives(data) if part.material == material)
    a, b, c = (part.positions[part.faces[:, corner]] for corner in range(3))
    return float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2)


def furniture_bounds(data: bytes, name: str) -> np.ndarray:
    """Bounds (2, 3) of what hangs below the node of that name."""
    scene = trimesh.load_scene(BytesIO(data), file_type="glb")
    forest: Any = scene.graph.transforms
    below = forest.successors(name)
    corners = [
        trimesh.transform_points(scene.geometry[mesh].vertices, transform)
        for node in sorted(below & set(scene.graph.nodes_geometry))
        for transform, mesh in [scene.graph[node]]
    ]
    points = np.concatenate(corners)
    return np.array([points.min(axis=0), points.max(axis=0)])


def test_a_furnished_room_is_a_valid_glb(tmp_path: Path) -> None:
    files = {
        "furnished": room(SOFA, PICTURE, PLACED),
        "empty": room(),
        "without openings": room(shell=Room(corners=((0, 0), (3, 0), (1, 4)))),
    }
    assert complaints(files, tmp_path) == {}


def test_it_is_as_large_as_the_room_with_y_up() -> None:
    low, high = bounds(room())
    np.testing.assert_allclose(low, [0, 0, -5], atol=0.11)  # the walls are 0.1 m thick
    np.testing.assert_allclose(high, [6, 2.5, 0], atol=0.11)


def test_the_floor_has_the_area_of_the_outline_and_looks_up() -> None:
    data = room()
    assert area(data, "floor") == pytest.approx(6 * 5 - 2 * 2)
    (floor,) = (part for part in primitives(data) if part.material == "floor")
    assert (floor.normals == [0, 1, 0]).all()


def test_walls_have_the_doors_and_windows_cut_out() -> None:
    closed = Room(corners=L_SHAPE.corners, height=L_SHAPE.height)
    door, window, thick = 0.9 * 2.0, 2.0 * 1.2, 0.1
    reveals = thick * 2 * (0.9 + 2.0 + 2.0 + 1.2)
    opened = area(room(), "wall") - area(room(shell=closed), "wall")
    assert opened == pytest.approx(reveals - door - window, abs=1e-4)
    assert area(room(), "window glass") == pytest.approx(window, abs=1e-4)


def test_walls_look_into_the_room() -> None:
    square = Room(corners=((-2, -2), (2, -2), (2, 2), (-2, 2)))
    (walls,) = (p for p in primitives(room(shell=square)) if p.material == "wall")
    level = np.abs(walls.normals[:, 1]) < 0.5
    assert (np.einsum("ij,ij->i", walls.normals, walls.positions)[level] < 0).all()


def test_furniture_fills_its_boxes_in_the_page_frame() -> None:
    data = room(SOFA, PICTURE, PLACED)
    # x stays, y (page) = z (core), z (page) = -y (core); a heading along +y makes width run on x
    expected = {
        "Blue sofa": [[1.0, 0, -1.45], [3.0, 0.8, -0.55]],
        "Picture": [[0.0, 1.2, -4.4], [0.04, 1.8, -3.6]],
        "Chair": [[2.75, 0, -2.25], [3.25, 0.9, -1.75]],
    }
    for name, wanted in expected.items():
        np.testing.assert_allclose(furniture_bounds(data, name), wanted, atol=0.002)


def test_a_box_looks_along_its_heading() -> None:
    """A marker at the front of a model ends up where the heading points."""
    marker = trimesh.Scene()
    marker.add_geometry(trimesh.creation.box(extents=(1, 1, 1)), node_name="body")
    front = trimesh.creation.box(extents=(0.1, 0.1, 0.1))
    front.apply_translation((0, 0, 0.45))
    marker.add_geometry(front, node_name="front", parent_node_name="body")
    glb = exported(marker)
    box = Box("b", "Other", (3.0, 2.0, 0.5), (1.0, 1.0, 1.0), heading=pi / 6)
    data = room_glb(Scene(L_SHAPE, (box,)), lambda _: glb)
    ends = furniture_bounds(data, "front")
    wanted = np.array([3 + 0.45 * np.cos(pi / 6), 0.5, -(2 + 0.45 * np.sin(pi / 6))])
    np.testing.assert_allclose(ends.mean(axis=0), wanted, atol=1e-6)


def test_a_model_of_another_size_is_stretched_to_its_box() -> None:
    data = room_glb(Scene(L_SHAPE, (SOFA,)), lambda _: furniture_glb("Sofa", (1.0, 1.0, 1.0)))
    np.testing.assert_allclose(
        furniture_bounds(data, "Blue sofa"), [[1.0, 0, -1.45], [3.0, 0.8, -0.55]], atol=0.002
    )


def test_equal_models_are_stored_once() -> None:
    chairs = [Box(str(n), "Chair", (1.0 + n, 2, 0.45), (0.5, 0.5, 0.9)) for n in range(4)]
    one, four = room(chairs[0]), room(*chairs)
    assert len(document(four).meshes) == len(document(one).meshes)
    assert len(four) < len(one) + 2000


def test_a_textured_model_keeps_its_texture(tmp_path: Path) -> None:
    sheet = trimesh.creation.box(extents=(1, 1, 1))
    image = Image.new("RGB", (2, 2), (200, 100, 50))
    visual: Any = trimesh.visual
    sheet.visual = visual.TextureVisuals(uv=np.zeros((8, 2)), image=image)
    glb = exported(trimesh.Scene(sheet))
    box = Box("b", "Decor", (3.0, 2.0, 0.5), (1.0, 1.0, 1.0))
    data = room_glb(Scene(L_SHAPE, (SOFA, box)), lambda b: glb if b is box else model(b))
    gltf = document(data)
    (textured,) = (m for m in gltf.materials if m.pbrMetallicRoughness.baseColorTexture)
    image_number = gltf.textures[textured.pbrMetallicRoughness.baseColorTexture.index].source
    view = gltf.bufferViews[gltf.images[image_number].bufferView]
    blob = gltf.binary_blob()
    seen = Image.open(BytesIO(blob[view.byteOffset : view.byteOffset + view.byteLength]))
    assert seen.convert("RGB").getpixel((0, 0)) == (200, 100, 50)
    assert complaints({"room": data}, tmp_path) == {}


def test_nodes_are_named_after_the_furniture() -> None:
    names = [node.name for node in document(room(SOFA, PICTURE, PLACED)).nodes]
    assert {"Living room", "floor", "walls", "windows", "Blue sofa", "Picture", "Chair"} <= {*names}
