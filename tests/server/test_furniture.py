"""Parametric furniture, looked at with the tools of others."""

from __future__ import annotations

import subprocess
import sys
from hashlib import sha256
from itertools import product
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from scenegen_core.scene.model import PAPER_CATEGORIES, Vector3
from server.furniture import furniture_glb
from tests.server.glb_files import bounds, complaints, document, primitives

MILLIMETRE = 0.001
CATEGORIES = (*(category.name for category in PAPER_CATEGORIES), "Spaceship")
LABELS = {
    "Bed": ("bunk bed",),
    "Chair": ("stool", "pouf", "office chair", "armchair"),
    "Decor": ("plant", "floor lamp", "vase", "rug", "bowl", "curtain", "pendant", "table lamp"),
    "Other": ("refrigerator", "cooker", "washing machine", "toilet", "bathtub", "sink"),
    "Picture": ("mirror",),
    "Sofa": ("corner sofa",),
    "Storage": ("bookshelf", "nightstand", "dresser", "kitchen cabinet", "upper cabinet"),
    "Table": ("round table", "desk", "coffee table"),
}
SIZES: tuple[Vector3, ...] = (
    (0.9, 2.0, 0.8),
    (2.05, 1.6, 1.0),
    (0.45, 0.45, 0.9),
    (0.6, 1.8, 2.1),
    (0.03, 0.9, 0.7),
    (1.6, 2.3, 0.02),
    (0.4, 0.4, 1.7),
    (3.0, 4.5, 1.0),
    (0.05, 0.05, 0.05),
    (10.0, 10.0, 10.0),
    (0.05, 10.0, 0.05),
    (10.0, 0.05, 10.0),
    (0.05, 0.05, 10.0),
)
CASES = [
    (category, label, size)
    for category in CATEGORIES
    for label, size in product(("", *LABELS.get(category, ())), SIZES)
]


def outside(category: str, size: Vector3, *, wall: bool = False) -> np.ndarray:
    """The bounds (2, 3) that the geometry has to fill, by the contract."""
    depth, width, height = size
    if category == "Picture" or wall:
        return np.array([[-width / 2, -height / 2, 0], [width / 2, height / 2, depth]])
    return np.array([[-width / 2, 0, -depth / 2], [width / 2, height, depth / 2]])


def where(data: bytes, material: str) -> np.ndarray:
    """The positions (vertices, 3) of everything of a material."""
    return np.concatenate([p.positions for p in primitives(data) if p.material == material])


def test_every_piece_is_a_valid_glb(tmp_path: Path) -> None:
    files = {f"{c} {n} {s}": furniture_glb(c, s, n) for c, n, s in CASES}
    files |= {f"TV on the wall {s}": furniture_glb("TV", s, wall=True) for s in SIZES}
    assert complaints(files, tmp_path) == {}


def test_the_validator_does_find_what_is_wrong(tmp_path: Path) -> None:
    good = furniture_glb("Sofa", (0.9, 2.0, 0.8))
    bad = good.replace(b'"VEC3"', b'"VEC2"', 1)
    assert set(complaints({"good": good, "bad": bad}, tmp_path)) == {"bad"}


@pytest.mark.parametrize("category", CATEGORIES)
def test_a_piece_fills_its_size_exactly_and_stays_light(category: str) -> None:
    for label, size in product(("", *LABELS.get(category, ())), SIZES):
        data = furniture_glb(category, size, label)
        np.testing.assert_allclose(bounds(data), outside(category, size), atol=MILLIMETRE)
        parts = primitives(data)
        assert len(parts) <= 6, (label, size)
        assert sum(len(part.faces) for part in parts) <= 3000, (label, size)


@settings(deadline=None, max_examples=80)
@given(
    category=st.sampled_from(CATEGORIES),
    size=st.tuples(*[st.floats(0.05, 10.0)] * 3),
    wall=st.booleans(),
)
def test_any_size_gives_sane_geometry(category: str, size: Vector3, wall: bool) -> None:  # noqa: FBT001
    data = furniture_glb(category, size, wall=wall)
    hangs = wall and category == "TV"
    np.testing.assert_allclose(bounds(data), outside(category, size, wall=hangs), atol=MILLIMETRE)
    for part in primitives(data):
        np.testing.assert_allclose(np.linalg.norm(part.normals, axis=1), 1.0, atol=1e-5)
        assert part.faces.max() == len(part.positions) - 1


@pytest.mark.parametrize(("category", "label", "size"), CASES[:: len(SIZES)])
def test_every_triangle_looks_the_way_of_its_normals(
    category: str, label: str, size: Vector3
) -> None:
    for part in primitives(furniture_glb(category, size, label)):
        a, b, c = (part.positions[part.faces[:, corner]] for corner in range(3))
        across = np.cross(b - a, c - a)
        normals = part.normals[part.faces].mean(axis=1)
        solid = np.linalg.norm(across, axis=1) > 1e-9
        assert (np.einsum("ij,ij->i", across, normals)[solid] > 0).all(), part.material


def test_a_sofa_is_high_at_its_back_and_low_at_its_front() -> None:
    positions = where(furniture_glb("Sofa", (0.9, 2.0, 0.8)), "linen")
    middle = positions[np.abs(positions[:, 0]) < 0.6]
    assert middle[middle[:, 2] < -0.2, 1].max() > 0.75
    assert middle[middle[:, 2] > 0.2, 1].max() < 0.55


def test_a_bed_has_its_headboard_at_minus_z() -> None:
    positions = where(furniture_glb("Bed", (2.05, 1.6, 1.0)), "oak")
    assert positions[positions[:, 1] > 0.6, 2].max() < -0.9


@pytest.mark.parametrize("label", ["wardrobe", "dresser", "nightstand", "kitchen cabinet", ""])
def test_the_handles_of_storage_are_at_plus_z(label: str) -> None:
    size = (0.6, 1.2, 2.0 if label == "wardrobe" else 0.7)
    data = furniture_glb("Storage", size, label)
    grips = where(data, "oak" if label == "wardrobe" else "brass")
    assert grips[:, 2].min() > 0.25


def test_a_screen_on_the_wall_lies_flat_against_it_and_looks_into_the_room() -> None:
    data = furniture_glb("TV", (0.06, 1.2, 0.7), wall=True)
    screen = next(part for part in primitives(data) if part.material == "screen")
    assert bounds(data)[0, 2] == pytest.approx(0.0, abs=MILLIMETRE)
    assert screen.positions[:, 2].min() > 0.05
    np.testing.assert_allclose(screen.normals, np.tile([0, 0, 1], (len(screen.normals), 1)))


def test_wider_beds_have_two_pillows_and_wider_sofas_more_seats() -> None:
    def vertices(category: str, size: Vector3, material: str) -> int:
        return len(where(furniture_glb(category, size), material))

    assert vertices("Bed", (2, 1.6, 1), "cotton") > vertices("Bed", (2, 0.9, 1), "cotton")
    assert vertices("Sofa", (0.9, 2.4, 0.8), "linen") > vertices("Sofa", (0.9, 1.4, 0.8), "linen")


@pytest.mark.parametrize(
    ("category", "size", "label", "name"),
    [
        ("Sofa", (0.9, 2.0, 0.8), "", "sofa"),
        ("Sofa", (1.7, 2.6, 0.8), "", "corner sofa"),
        ("Sofa", (0.9, 2.6, 0.8), "Corner sofa", "corner sofa"),
        ("Bed", (2.0, 0.9, 1.7), "", "bunk bed"),
        ("Chair", (0.5, 0.5, 0.9), "", "chair"),
        ("Chair", (0.8, 0.8, 0.9), "", "armchair"),
        ("Chair", (0.4, 0.4, 0.45), "", "stool"),
        ("Chair", (0.6, 0.6, 1.1), "Office chair", "office chair"),
        ("Table", (0.9, 1.6, 0.75), "", "table"),
        ("Table", (0.6, 1.1, 0.4), "", "coffee table"),
        ("Table", (1.1, 1.1, 0.75), "round dining table", "round table"),
        ("Table", (0.7, 1.4, 0.75), "desk", "desk"),
        ("Storage", (0.6, 1.6, 2.1), "", "wardrobe"),
        ("Storage", (0.3, 0.9, 1.9), "bookcase", "bookcase"),
        ("Storage", (0.4, 1.7, 0.6), "", "sideboard"),
        ("Storage", (0.4, 0.45, 0.5), "", "nightstand"),
        ("Decor", (0.5, 0.5, 1.2), "", "plant"),
        ("Decor", (0.35, 0.35, 1.6), "", "floor lamp"),
        ("Decor", (2.0, 3.0, 0.02), "", "rug"),
        ("Decor", (0.2, 0.2, 0.35), "", "vase"),
        ("Decor", (0.3, 0.3, 0.14), "", "bowl"),
        ("Decor", (0.1, 1.5, 2.2), "", "curtain"),
        ("Decor", (0.3, 0.3, 0.5), "Desk lamp", "table lamp"),
        ("Decor", (0.4, 0.4, 0.5), "Pendant lamp", "pendant lamp"),
        ("Picture", (0.03, 0.5, 1.4), "mirror", "mirror"),
        ("Other", (0.7, 0.7, 1.8), "Refrigerator", "refrigerator"),
        ("Other", (0.7, 0.7, 0.7), "", "object"),
        ("Spaceship", (0.7, 0.7, 0.7), "", "object"),
    ],
)
def test_size_and_label_choose_the_shape(
    category: str, size: Vector3, label: str, name: str
) -> None:
    assert document(furniture_glb(category, size, label)).meshes[0].name == name


def test_two_pictures_of_other_sizes_show_other_paintings() -> None:
    def tones(size: Vector3) -> bytes:
        data = furniture_glb("Picture", size)
        gltf = document(data)
        part = next(p for p in gltf.meshes[0].primitives if p.attributes.COLOR_0 is not None)
        view = gltf.bufferViews[gltf.accessors[part.attributes.COLOR_0].bufferView]
        return bytes(gltf.binary_blob()[view.byteOffset : view.byteOffset + view.byteLength])

    assert len({tones((0.03, 0.5 + 0.1 * step, 0.7)) for step in range(6)}) > 1


def test_the_same_piece_has_the_same_bytes_in_another_process() -> None:
    code = (
        "import sys; from hashlib import sha256; from server.furniture import furniture_glb;"
        "print(sha256(furniture_glb('Storage', (0.3, 0.9, 1.9), 'bookcase')).hexdigest())"
    )
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    here = sha256(furniture_glb("Storage", (0.3, 0.9, 1.9), "bookcase")).hexdigest()
    assert run.stdout.strip() == here


def test_it_says_who_made_it() -> None:
    assert document(furniture_glb("Sofa", (0.9, 2.0, 0.8))).asset.generator == "SceneGen"
