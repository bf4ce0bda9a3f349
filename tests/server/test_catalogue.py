"""A user's own models: found, measured, put on their base, and refused with a reason."""

from __future__ import annotations

import json
from collections.abc import Callable
from math import cos, pi, sin
from pathlib import Path
from struct import pack
from typing import Any

import numpy as np
import pytest
import trimesh
from hypothesis import given, settings
from hypothesis import strategies as st

from server.catalogue import Catalogue
from server.catalogue_files import load_catalogue
from server.model_file import MAX_DEPTH
from tests.server.glb_files import bounds, complaints, exported

CATEGORIES = ("Bed", "Sofa", "Picture", "Decor")


def box_glb(
    extents: tuple[float, float, float], at: tuple[float, float, float] = (0, 0, 0)
) -> bytes:
    """A box of that width, height and depth round a point, written by trimesh."""
    mesh = trimesh.creation.box(extents=extents)
    mesh.apply_translation(at)
    return exported(trimesh.Scene(mesh))


def changed(data: bytes, change: Callable[[dict[str, Any]], object]) -> bytes:
    """The GLB with its JSON changed."""
    length = int.from_bytes(data[12:16], "little")
    value = json.loads(data[20 : 20 + length])
    change(value)
    text = json.dumps(value).encode()
    text += b" " * (-len(text) % 4)
    rest = data[20 + length :]
    return (
        pack("<4sIIII", b"glTF", 2, 20 + len(text) + len(rest), len(text), 0x4E4F534A) + text + rest
    )


def load(directory: Path, **files: bytes) -> Catalogue:
    for name, data in files.items():
        (directory / f"{name.replace('_', '-')}.glb").write_bytes(data)
    return load_catalogue(directory, CATEGORIES)


def problem(directory: Path, data: bytes) -> str:
    """The sentence about a file that has to be refused."""
    catalogue = load(directory, sofa_bad=data, sofa_good=box_glb((2, 0.8, 0.9)))
    assert [item.id for item in catalogue.items] == ["sofa-good"]
    (sentence,) = catalogue.problems
    assert sentence.startswith("sofa-bad.glb: ")
    return sentence


def test_the_folder_the_name_or_the_manifest_says_the_category(tmp_path: Path) -> None:
    model = box_glb((2, 0.8, 0.9))
    (tmp_path / "Sofas").mkdir()
    (tmp_path / "Sofas" / "oslo_two.glb").write_bytes(model)
    (tmp_path / "bed-paris.glb").write_bytes(model)
    (tmp_path / "x1.glb").write_bytes(model)
    manifest = {"x1.glb": {"category": "Decor", "name": "Blue thing"}}
    (tmp_path / "catalogue.json").write_text(json.dumps(manifest))

    catalogue = load_catalogue(tmp_path, CATEGORIES)

    assert catalogue.problems == ()
    assert [(item.id, item.category, item.name) for item in catalogue.items] == [
        ("Sofas/oslo_two", "Sofa", "Oslo two"),
        ("bed-paris", "Bed", "Paris"),
        ("x1", "Decor", "Blue thing"),
    ]
    assert catalogue.by_id["x1"].data == catalogue.items[2].data


def test_the_size_is_depth_width_height_in_metres(tmp_path: Path) -> None:
    (item,) = load(tmp_path, sofa=box_glb((2.0, 0.8, 0.9))).items
    assert item.size == pytest.approx((0.9, 2.0, 0.8))


def test_the_origin_moves_to_the_center_of_the_base(tmp_path: Path) -> None:
    (item,) = load(tmp_path, sofa=box_glb((2.0, 0.8, 0.9), at=(5, -3, 1))).items
    np.testing.assert_allclose(bounds(item.data), [[-1, 0, -0.45], [1, 0.8, 0.45]], atol=1e-6)
    assert complaints({"item": item.data}, tmp_path) == {}


def test_a_picture_gets_its_origin_at_the_center_of_its_back(tmp_path: Path) -> None:
    (item,) = load(tmp_path, picture=box_glb((0.6, 0.4, 0.02), at=(1, 1, 1))).items
    np.testing.assert_allclose(bounds(item.data), [[-0.3, -0.2, 0], [0.3, 0.2, 0.02]], atol=1e-6)


def test_the_size_counts_turned_scaled_and_nested_nodes(tmp_path: Path) -> None:
    half = pi / 4

    def nest(value: dict[str, Any]) -> None:
        (mesh,) = (n for n, node in enumerate(value["nodes"]) if "mesh" in node)
        inner = {"children": [mesh], "rotation": [0, sin(half), 0, cos(half)]}  # a quarter turn
        stretched = [2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 7, 0, 0, 1]  # x twice, moved by 7
        start = len(value["nodes"])
        value["nodes"] += [inner, {"children": [start], "matrix": stretched}]
        value["scenes"] = [{"nodes": [start + 1]}]

    (item,) = load(tmp_path, sofa=changed(box_glb((2.0, 0.8, 0.9)), nest)).items
    assert item.size == pytest.approx((2.0, 1.8, 0.8))
    np.testing.assert_allclose(bounds(item.data), [[-0.9, 0, -1], [0.9, 0.8, 1]], atol=1e-6)


@pytest.mark.parametrize(
    ("width", "hint"),
    [(210.0, "centimetres"), (2100.0, "millimetres"), (0.005, "metres")],
)
def test_a_model_of_an_absurd_size_is_refused_with_the_unit_it_seems_to_be_in(
    tmp_path: Path, width: float, hint: str
) -> None:
    assert hint in problem(tmp_path, box_glb((width, 0.4 * width, 0.5 * width)))


def test_a_sheet_without_thickness_counts_as_a_centimetre(tmp_path: Path) -> None:
    def flatten(value: dict[str, Any]) -> None:
        (node,) = (node for node in value["nodes"] if "mesh" in node)
        node.pop("matrix", None)
        node["scale"] = [1, 1, 0]

    (item,) = load(tmp_path, picture=changed(box_glb((0.6, 0.4, 0.1)), flatten)).items
    assert item.size == pytest.approx((0.01, 0.6, 0.4))


@pytest.mark.parametrize(
    ("data", "reason"),
    [
        (b"", "not a GLB"),
        (b"solid cube\n" * 9, "not a GLB"),
        (box_glb((2, 1, 1))[:-8], "cut short"),
        (pack("<4sIIII", b"glTF", 1, 20, 0, 0), "glTF 1"),
        (pack("<4sIIII4s", b"glTF", 2, 24, 4, 0x4E4F534A, b"{]]]"), "JSON"),
        (pack("<4sIIII4s", b"glTF", 2, 24, 4, 0x4E4F534A, b"{}  "), "asset"),
        (pack("<4sIIII", b"glTF", 2, 20, 99, 0x4E4F534A), "cut short"),
    ],
)
def test_what_is_no_glb_is_refused(tmp_path: Path, data: bytes, reason: str) -> None:
    assert reason in problem(tmp_path, data)


SOFA = box_glb((2, 0.8, 0.9))


def loop(value: dict[str, Any]) -> None:
    value["nodes"].append({"children": [len(value["nodes"])]})
    value["scenes"][0]["nodes"] = [len(value["nodes"]) - 1]


def deep(value: dict[str, Any]) -> None:
    start = len(value["nodes"])
    value["nodes"] += [{"children": [start + n + 1]} for n in range(MAX_DEPTH)] + [{}]
    value["scenes"][0]["nodes"] = [start]


def nested(value: dict[str, Any]) -> None:
    """An extension that Python's own stack cannot walk through, but the decoder can."""
    inner: dict[str, Any] = {}
    for _ in range(800):
        inner = {"inner": inner}
    value["materials"] = [{"extensions": {"X": inner}}]


def shared(value: dict[str, Any]) -> None:
    """Slices that are small in the file and huge when each is written by itself."""
    value["bufferViews"] += [value["bufferViews"][0]] * 10_000


BREAKAGES: dict[str, tuple[Callable[[dict[str, Any]], object], str]] = {
    "external buffer": (lambda v: v["buffers"][0].update(uri="/etc/passwd"), "other files"),
    "web buffer": (lambda v: v["buffers"][0].update(uri="http://x/y.bin"), "other files"),
    "external image": (lambda v: v.update(images=[{"uri": "../secret.png"}]), "other files"),
    "decoder": (lambda v: v.update(extensionsRequired=["KHR_draco_mesh_compression"]), "draco"),
    "lines": (lambda v: v["meshes"][0]["primitives"][0].update(mode=1), "no triangles"),
    "no nodes": (lambda v: v["scenes"][0].update(nodes=[]), "no triangles"),
    "missing node": (lambda v: v["scenes"][0].update(nodes=[99]), "not there"),
    "missing scene": (lambda v: v.update(scene=7), "not there"),
    "negative index": (lambda v: v["scenes"][0].update(nodes=[-1]), "$.scenes[0].nodes[0]"),
    "loop": (loop, "circle"),
    "deep": (deep, "deep"),
    "view too long": (lambda v: v["bufferViews"][0].update(byteLength=10**9), "missing"),
    "array too long": (lambda v: v["accessors"][0].update(count=10**9), "longer"),
    "no bounds": (lambda v: [a.pop("max", None) for a in v["accessors"]], "how large"),
    "infinite": (lambda v: v["nodes"].append({"scale": [1e308] * 3, "children": [0]})
                 or v["scenes"][0].update(nodes=[len(v["nodes"]) - 1])
                 or v["nodes"][0].update(scale=[1e308] * 3, mesh=0), "not numbers"),
    "heavy": (lambda v: [a.update(count=9 * 10**6, bufferView=None) for a in v["accessors"]],
              "simplify"),
    "missing material": (lambda v: v["meshes"][0]["primitives"][0].update(material=9), "not there"),
    "nested": (nested, "nested too deeply"),
    "shared": (shared, "over and over"),
    "no count": (lambda v: v["accessors"][0].pop("count"), "no count - at `$.accessors[0]`"),
    "no length": (lambda v: v["bufferViews"][0].pop("byteLength"), "$.bufferViews[0]"),
    "long": (lambda v: v.update(extras={"a": "x" * 5_000_000}), "larger than 4 MB"),
    "wrong type": (lambda v: v.update(nodes="all"), "$.nodes"),
}  # fmt: skip


@pytest.mark.parametrize("name", BREAKAGES)
def test_a_broken_or_hostile_model_is_skipped_with_a_reason(tmp_path: Path, name: str) -> None:
    change, reason = BREAKAGES[name]
    assert reason in problem(tmp_path, changed(box_glb((2, 0.8, 0.9)), change))


def test_parts_of_unknown_kinds_after_the_data_are_left_out(tmp_path: Path) -> None:
    known = box_glb((2, 0.8, 0.9))
    data = known + pack("<I4s8s", 8, b"XYZ\xff", b"whatever")
    data = data[:8] + pack("<I", len(data)) + data[12:]
    assert load(tmp_path, sofa=data).items[0].data == load(tmp_path, sofa=known).items[0].data


def test_animations_cameras_and_lights_of_a_model_stay_behind(tmp_path: Path) -> None:
    def decorate(value: dict[str, Any]) -> None:
        value["cameras"] = [
            {"type": "perspective", "perspective": {"yfov": 1.0, "znear": 0.1, "zfar": 9.0}}
        ]
        value["extensions"] = {"KHR_lights_punctual": {"lights": [{"type": "point"}]}}
        value["extensionsUsed"] = ["KHR_lights_punctual"]
        value["nodes"][0] |= {"camera": 0, "extensions": {"KHR_lights_punctual": {"light": 0}}}

    data = changed(box_glb((2, 0.8, 0.9)), decorate)
    assert complaints({"before": data}, tmp_path) == {}
    (item,) = load(tmp_path, sofa=data).items
    assert b"camera" not in item.data
    assert b"KHR_lights_punctual" not in item.data
    assert complaints({"after": item.data}, tmp_path) == {}


@settings(deadline=None, max_examples=200)
@given(at=st.integers(0, 1500), values=st.binary(min_size=1, max_size=3))
def test_a_damaged_file_never_stops_the_others(
    tmp_path_factory: pytest.TempPathFactory, at: int, values: bytes
) -> None:
    data = bytearray(box_glb((2, 0.8, 0.9)))
    data[at : at + len(values)] = values
    catalogue = load(tmp_path_factory.mktemp("damaged"), bed_bad=bytes(data), sofa=SOFA)
    assert catalogue.items[-1].id == "sofa"
    assert len(catalogue.items) + len(catalogue.problems) == 2


def test_an_unknown_category_is_refused_and_the_known_ones_are_named(tmp_path: Path) -> None:
    catalogue = load(tmp_path, piano_one=box_glb((1.5, 1, 0.6)))
    assert catalogue.items == ()
    assert "'piano'" in catalogue.problems[0]
    assert "Bed, Sofa, Picture, Decor" in catalogue.problems[0]


@pytest.mark.parametrize("path", ["../sofa.glb", "/etc/hostname", "sofa-link.glb", "sofa-no.glb"])
def test_nothing_outside_of_the_directory_is_read(tmp_path: Path, path: str) -> None:
    (tmp_path / "sofa.glb").write_bytes(box_glb((2, 0.8, 0.9)))
    inside = tmp_path / "inside"
    inside.mkdir()
    (inside / "sofa-link.glb").symlink_to(tmp_path / "sofa.glb")
    (inside / "catalogue.json").write_text(json.dumps({path: {"category": "Sofa"}}))
    catalogue = load_catalogue(inside, CATEGORIES)
    assert catalogue.items == ()
    assert all("outside" in text or "no such file" in text for text in catalogue.problems)


def test_a_file_that_is_too_large_is_not_read(tmp_path: Path) -> None:
    with (tmp_path / "sofa-huge.glb").open("wb") as stream:
        stream.truncate(31_000_000)
    assert "larger" in load_catalogue(tmp_path, CATEGORIES).problems[0]


@pytest.mark.parametrize("text", ["{", "[]", '{"a.glb": {"name": "no category"}}'])
def test_a_wrong_manifest_is_named(tmp_path: Path, text: str) -> None:
    (tmp_path / "catalogue.json").write_text(text)
    assert "catalogue.json" in load_catalogue(tmp_path, CATEGORIES).problems[0]


def test_a_directory_that_is_not_there_is_named(tmp_path: Path) -> None:
    catalogue = load_catalogue(tmp_path / "nowhere", CATEGORIES)
    assert "no such directory" in catalogue.problems[0]
