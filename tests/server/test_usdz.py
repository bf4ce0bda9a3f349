"""Models for iPhones, opened with Pixar's library and taken apart by hand."""

from __future__ import annotations

import asyncio
import struct
from collections.abc import Iterator
from io import BytesIO
from math import pi
from pathlib import Path
from zipfile import ZIP_STORED, ZipFile

import numpy as np
import pytest
import trimesh
from PIL import Image
from pxr import Usd, UsdGeom, UsdShade, UsdValidation
from starlette.testclient import TestClient

from scenegen_core.scene.model import PAPER_CATEGORIES, Box, Room, Scene
from server.app import make_app
from server.furniture import furniture_glb
from server.furniture.materials import OAK
from server.looks import look
from server.room_model import boxes_glb
from server.settings import Settings
from server.store import Store, Stored
from server.usdz import usdz
from server.world import World
from tests.server.driving import browser
from tests.server.glb_files import bounds, exported

SIZE = (0.9, 2.1, 0.8)  # depth, width, height
SOFA = furniture_glb("Sofa", SIZE)
ROOM = Room(corners=((0, 0), (6, 0), (6, 5), (0, 5)))
CHAIR = Box("c", "Chair", (4.0, 1.0, 0.45), (0.5, 0.6, 0.9), placed=True)
LAMP = Box("l", "Lamp", (1.0, 3.0, 0.8), (0.3, 0.3, 1.6), pi / 2, placed=True)
PICTURE = Box("p", "Picture", (2.0, 4.98, 1.5), (0.04, 0.8, 0.6), -pi / 2, placed=True)
BED = Box("b", "Bed", (1.0, 1.0, 0.3), (2.0, 1.6, 0.6))  # stood there before


def stored_files(data: bytes) -> list[tuple[str, int, int, bytes]]:
    """(name, compression, where its data begins, data) of a zip, read header by header."""
    files, at = [], 0
    while data[at : at + 4] == b"PK\x03\x04":
        method, size, name_length, extra_length = struct.unpack_from("<8xH8xI4xHH", data, at)
        begin = at + 30 + name_length + extra_length
        name = data[at + 30 : at + 30 + name_length].decode()
        files.append((name, method, begin, data[begin : begin + size]))
        at = begin + size
    assert data[at : at + 4] == b"PK\x01\x02"
    return files


def opened(data: bytes, directory: Path) -> Usd.Stage:
    path = directory / f"{len(list(directory.iterdir()))}.usdz"  # what was read once stays read
    path.write_bytes(data)
    return Usd.Stage.Open(str(path))


def meshes(stage: Usd.Stage) -> list[UsdGeom.Mesh]:
    return [UsdGeom.Mesh(prim) for prim in stage.Traverse() if prim.IsA(UsdGeom.Mesh)]


def box_of(stage: Usd.Stage) -> np.ndarray:
    """Bounds (2, 3) of all that is in it, as Pixar's library computes them from the points."""
    cache = UsdGeom.BBoxCache(Usd.TimeCode.Default(), ["default"], useExtentsHint=False)
    found = cache.ComputeWorldBound(stage.GetDefaultPrim()).ComputeAlignedRange()
    return np.array([found.GetMin(), found.GetMax()])


def shader(mesh: UsdGeom.Mesh) -> UsdShade.Shader:
    material, _ = UsdShade.MaterialBindingAPI(mesh).ComputeBoundMaterial()
    return material.ComputeSurfaceSource()[0]


def colors(stage: Usd.Stage) -> set[tuple[float, ...]]:
    found = {tuple(shader(mesh).GetInput("diffuseColor").Get()) for mesh in meshes(stage)}
    return {tuple(round(value, 2) for value in color) for color in found}


def test_it_is_in_metres_with_y_up_and_as_large_as_the_furniture(tmp_path: Path) -> None:
    stage = opened(usdz(SOFA), tmp_path)
    assert UsdGeom.GetStageMetersPerUnit(stage) == 1.0
    assert UsdGeom.GetStageUpAxis(stage) == UsdGeom.Tokens.y
    depth, width, height = SIZE
    wanted = [[-width / 2, 0, -depth / 2], [width / 2, height, depth / 2]]
    np.testing.assert_allclose(box_of(stage), wanted, atol=0.001)


@pytest.mark.parametrize("category", [category.name for category in PAPER_CATEGORIES])
def test_every_category_keeps_its_size_and_its_triangles(category: str, tmp_path: Path) -> None:
    glb = furniture_glb(category, (0.5, 0.7, 0.9))
    stage = opened(usdz(glb), tmp_path)
    np.testing.assert_allclose(box_of(stage), bounds(glb), atol=0.001)
    triangles = sum(len(mesh.GetFaceVertexCountsAttr().Get()) for mesh in meshes(stage))
    assert triangles == trimesh.load_scene(BytesIO(glb), file_type="glb").triangles.shape[0]


def test_files_inside_are_stored_and_begin_at_multiples_of_64_bytes() -> None:
    files = stored_files(usdz(textured()))
    assert [name for name, *_ in files] == ["model.usda", "textures/0.png"]
    assert [(method, begin % 64) for _, method, begin, _ in files] == [(0, 0), (0, 0)]
    assert files[0][3].startswith(b"#usda 1.0\n")


def complaints(stage: Usd.Stage) -> set[str]:
    """What all of Pixar's validators say."""
    validators = UsdValidation.ValidationRegistry().GetOrLoadAllValidators()
    found = UsdValidation.ValidationContext(validators).Validate(stage)
    return {error.GetName() for error in found}


def test_pixars_validators_find_nothing(tmp_path: Path) -> None:
    for data in (usdz(SOFA), usdz(textured()), usdz(boxes_glb((CHAIR, LAMP, PICTURE), model))):
        assert complaints(opened(data, tmp_path)) == set()


def test_pixars_validators_would_find_what_is_out_of_line(tmp_path: Path) -> None:
    file = BytesIO()
    with ZipFile(file, "w", ZIP_STORED) as zipped:
        zipped.writestr("model.usda", stored_files(usdz(SOFA))[0][3])
    assert "ByteMisalignment" in complaints(opened(file.getvalue(), tmp_path))


def test_the_same_model_gives_the_same_bytes() -> None:
    assert usdz(SOFA) == usdz(SOFA)


def test_colors_come_along(tmp_path: Path) -> None:
    stage = opened(usdz(SOFA), tmp_path)
    assert tuple(round(value, 2) for value in OAK.color) in colors(stage)
    assert len(colors(stage)) == 3  # oak, linen, sage fabric
    rough = {round(shader(mesh).GetInput("roughness").Get(), 2) for mesh in meshes(stage)}
    assert rough == {0.6, 0.95}


def test_the_colors_of_vertices_become_surfaces(tmp_path: Path) -> None:
    block = trimesh.creation.box()
    block.unmerge_vertices()
    red, blue = (255, 0, 0, 255), (0, 0, 255, 255)
    block.visual.vertex_colors = np.repeat([red, blue], 18, axis=0)
    stage = opened(usdz(exported(block)), tmp_path)
    shares = [len(mesh.GetFaceVertexCountsAttr().Get()) for mesh in meshes(stage)]
    assert shares == [6, 6]
    assert colors(stage) == {(1, 0, 0), (0, 0, 1)}


def textured() -> bytes:
    """A square with a picture: red above, green below."""
    picture = Image.new("RGB", (4, 4), (0, 255, 0))
    picture.paste((255, 0, 0), (0, 0, 4, 2))
    corners = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
    square = trimesh.Trimesh(corners, [[0, 1, 2], [0, 2, 3]], process=False)
    uv = [[0, 0], [1, 0], [1, 1], [0, 1]]
    material = trimesh.visual.material.PBRMaterial(
        baseColorTexture=picture, baseColorFactor=(255, 255, 255, 255)
    )
    square.visual = trimesh.visual.TextureVisuals(uv=uv, material=material)
    return exported(square)


def test_a_picture_on_a_model_comes_along_the_right_way_up(tmp_path: Path) -> None:
    data = usdz(textured())
    stage = opened(data, tmp_path)
    (mesh,) = meshes(stage)
    source = shader(mesh).GetInput("diffuseColor").GetConnectedSource()[0]
    assert source.GetPrim().GetAttribute("info:id").Get() == "UsdUVTexture"
    ((_, _, _, png),) = [file for file in stored_files(data) if file[0].endswith(".png")]
    picture = Image.open(BytesIO(png))
    st = np.array(UsdGeom.PrimvarsAPI(mesh).GetPrimvar("st").Get())
    heights = np.array(mesh.GetPointsAttr().Get())[:, 1]
    for (s, t), height in zip(st, heights, strict=True):
        pixel = picture.getpixel((round(s * 3), round((1 - t) * 3)))  # t counts from below
        assert pixel == ((255, 0, 0) if height == 1 else (0, 255, 0))


def test_surfaces_look_outward_even_in_a_mirrored_model(tmp_path: Path) -> None:
    scene = trimesh.Scene()
    scene.add_geometry(trimesh.creation.box(), transform=np.diag([-1.0, 1.0, 2.0, 1.0]))
    stage = opened(usdz(exported(scene)), tmp_path)
    (mesh,) = meshes(stage)
    points = np.array(mesh.GetPointsAttr().Get())
    corners = points[np.array(mesh.GetFaceVertexIndicesAttr().Get()).reshape(-1, 3)]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    assert (np.einsum("ij,ij->i", across, corners.mean(axis=1)) > 0).all()


def model(box: Box) -> bytes:
    return furniture_glb(box.category, box.size, box.label)


def test_what_was_placed_stands_as_in_the_room_round_the_origin(tmp_path: Path) -> None:
    stage = opened(usdz(boxes_glb((CHAIR, LAMP, PICTURE), model)), tmp_path)
    # Page frame: x stays, y = z (core), z = -y (core). Centers reach from (1, 1) to (4, 4.98).
    x, z = (1.0 + 4.0) / 2, -(1.0 + 4.98) / 2
    low = [1.0 - 0.15 - x, 0.0, -5.0 - z]  # lamp, floor, picture
    high = [4.25 - x, 1.8, -1.0 + 0.3 - z]  # chair, picture, chair
    np.testing.assert_allclose(box_of(stage), [low, high], atol=0.01)


@pytest.fixture
def client(world: World, page_files: Path, tmp_path: Path) -> Iterator[TestClient]:
    store = tmp_path / "sessions.sqlite3"
    scenes = {
        "furnished": Scene(ROOM, (BED, CHAIR, LAMP)),
        "bare": Scene(ROOM, (BED,)),
    }
    asyncio.run(fill(store, scenes))
    with browser(make_app(Settings(store=store, page=page_files), world)) as client:
        yield client


async def fill(path: Path, scenes: dict[str, Scene]) -> None:
    store = Store(path)
    for session, scene in scenes.items():
        await store.save(session, Stored(1, scene))
    await store.close()


def test_a_phone_fetches_what_was_placed_in_its_room(client: TestClient, tmp_path: Path) -> None:
    response = client.get("/usdz/sessions/furnished.usdz")
    assert response.headers["content-type"] == "model/vnd.usdz+zip"
    assert response.headers["cache-control"] == "no-store"
    size = np.diff(box_of(opened(response.content, tmp_path)), axis=0)[0]
    np.testing.assert_allclose(size, [3.0 + 0.15 + 0.25, 1.6, 2.0 + 0.15 + 0.3], atol=0.01)


@pytest.mark.parametrize("session", ["bare", "unknown"])
def test_a_room_with_nothing_placed_has_no_model(client: TestClient, session: str) -> None:
    response = client.get(f"/usdz/sessions/{session}.usdz")
    assert response.status_code == 404
    assert "place something first" in response.json()["text"]


def test_a_phone_fetches_one_object_by_its_hash(
    client: TestClient, world: World, tmp_path: Path
) -> None:
    digest = world.assets.digest(look("Sofa", SIZE))
    response = client.get(f"/usdz/{digest}.usdz")
    assert response.headers["content-type"] == "model/vnd.usdz+zip"
    assert "immutable" in response.headers["cache-control"]
    size = np.diff(box_of(opened(response.content, tmp_path)), axis=0)[0]
    np.testing.assert_allclose(size, [SIZE[1], SIZE[2], SIZE[0]], atol=0.01)
    assert client.get(f"/usdz/{'0' * 32}.usdz").status_code == 404
