"""Knowledge as a file: what is saved comes back, and what cannot be used says what to do."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from scenegen_core.errors import KnowledgeError
from scenegen_core.knowledge.choice import BINS, Choice, choice_columns
from scenegen_core.knowledge.files import default_knowledge, load_knowledge, save_knowledge
from scenegen_core.knowledge.knowledge import Knowledge
from scenegen_core.knowledge.learning import learn
from scenegen_core.scene.model import PAPER_CATEGORIES, Box, Room, Scene

Arrays = dict[str, NDArray[Any]]

ROOM = Room(((0.0, 0.0), (5.0, 0.0), (5.0, 4.0), (0.0, 4.0)))


@pytest.fixture
def knowledge() -> Knowledge:
    scenes = [
        Scene(
            ROOM,
            (
                Box("b", "Bed", (1.0 + i / 7, 1.0, 0.3), (2.0, 1.6, 0.6), 0.3),
                Box("t", "TV", (4.0, 2.0, 1.2), (0.1, 1.0, 0.6), 3.1, front_from_wall=i == 0),
            ),
            id=f"home/{i}",
            source="ithor",
        )
        for i in range(6)
    ]
    return learn(scenes, PAPER_CATEGORIES, made_with="a test")


def choice_of(knowledge: Knowledge, seed: int) -> Choice:
    """A choice of numbers by chance."""
    rng = np.random.default_rng(seed)
    named = choice_columns(knowledge.groups)
    return Choice(
        columns=named,
        curves=rng.normal(size=(len(named), BINS)).astype(np.float32),
        pairs=rng.integers(len(named), size=(3, 2)),
        surfaces=rng.normal(size=(3, BINS, BINS)).astype(np.float32),
        examples=rng.integers(BINS, size=(2, len(named))).astype(np.uint8),
        rooms=("home/3", "elsewhere"),
    )


@pytest.fixture
def with_choices(knowledge: Knowledge) -> Knowledge:
    """The same with choices of the TV alone."""
    choice = choice_of(knowledge, 1)
    return replace(knowledge, choices={"TV": choice}, shared=choice_of(knowledge, 2).curves)


@pytest.fixture
def path_of_choices(tmp_path: Path, with_choices: Knowledge) -> Path:
    path = tmp_path / "choices.npz"
    save_knowledge(with_choices, path)
    return path


@pytest.fixture
def path(tmp_path: Path, knowledge: Knowledge) -> Path:
    path = tmp_path / "knowledge.npz"
    save_knowledge(knowledge, path)
    return path


def change(path: Path, edit: Callable[[Arrays], None]) -> None:
    with np.load(path) as archive:
        arrays: Arrays = dict(archive)
    edit(arrays)
    np.savez_compressed(path, allow_pickle=True, **arrays)


def change_header(path: Path, **fields: object) -> None:
    def edit(arrays: Arrays) -> None:
        header = json.loads(arrays["header"].tobytes()) | fields
        arrays["header"] = np.frombuffer(json.dumps(header).encode(), dtype=np.uint8)

    change(path, edit)


def test_what_is_saved_comes_back(path: Path, knowledge: Knowledge) -> None:
    loaded = load_knowledge(path)
    assert loaded.groups == PAPER_CATEGORIES
    assert loaded.sources == knowledge.sources
    assert loaded.settings == knowledge.settings
    assert loaded.made_with == "a test"
    assert list(loaded.categories) == ["Bed", "TV"]
    for name, before in knowledge.categories.items():
        after = loaded[name]
        assert after.category == before.category
        assert after.columns == before.columns
        assert after.rooms == before.rooms
        np.testing.assert_array_equal(after.rows, before.rows)
        np.testing.assert_array_equal(after.front_known, before.front_known)
        np.testing.assert_array_equal(after.sizes, before.sizes)
        np.testing.assert_array_equal(after.bottoms, before.bottoms)


def test_choices_that_are_saved_come_back(path_of_choices: Path, with_choices: Knowledge) -> None:
    loaded = load_knowledge(path_of_choices)
    assert list(loaded.choices) == ["TV"]
    before, after = with_choices.choice("TV"), loaded.choice("TV")
    assert after.columns == before.columns
    assert after.rooms == before.rooms
    for name in ("curves", "pairs", "surfaces", "examples"):
        np.testing.assert_array_equal(getattr(after, name), getattr(before, name))
        assert getattr(after, name).dtype == getattr(before, name).dtype
    np.testing.assert_array_equal(loaded.shared, with_choices.shared)


def test_knowledge_without_choices_comes_back_without(path: Path) -> None:
    loaded = load_knowledge(path)
    assert loaded.choices == {}
    assert loaded.shared is None
    with pytest.raises(KnowledgeError, match=r"too few examples of Bed .* ask the model paper"):
        loaded.choice("Bed")


def test_loaded_knowledge_gives_the_same_densities(path: Path, knowledge: Knowledge) -> None:
    before, after = (each["Bed"].position().density for each in (knowledge, load_knowledge(path)))
    np.testing.assert_array_equal(
        after.log_density(before.rows + 0.01), before.log_density(before.rows + 0.01)
    )


def test_the_same_knowledge_gives_the_same_bytes(
    path: Path, path_of_choices: Path, tmp_path: Path
) -> None:
    again = tmp_path / "again.npz"
    for one in (path, path_of_choices):
        save_knowledge(load_knowledge(one), again)
        assert again.read_bytes() == one.read_bytes()


def test_a_place_that_cannot_be_written_is_named(tmp_path: Path, knowledge: Knowledge) -> None:
    with pytest.raises(KnowledgeError, match=r"none/k\.npz.*choose another"):
        save_knowledge(knowledge, tmp_path / "none" / "k.npz")


def test_a_missing_file_says_how_to_make_one(tmp_path: Path) -> None:
    with pytest.raises(KnowledgeError, match=r"none\.npz.*scenegen learn"):
        load_knowledge(tmp_path / "none.npz")


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"", "is not a knowledge file; learn it again"),
        (b"plain text", "is not a knowledge file; learn it again"),
        (b"PK\x03\x04 no archive", "is broken; learn it again"),
    ],
)
def test_a_file_that_is_no_archive_is_refused(tmp_path: Path, content: bytes, words: str) -> None:
    path = tmp_path / "knowledge.npz"
    path.write_bytes(content)
    with pytest.raises(KnowledgeError, match=words):
        load_knowledge(path)


def test_a_single_array_is_no_knowledge(tmp_path: Path) -> None:
    path = tmp_path / "array.npy"
    np.save(path, np.arange(3))
    with pytest.raises(KnowledgeError, match=r"not a knowledge file"):
        load_knowledge(path)


def test_a_file_that_ends_too_early_is_broken(path: Path) -> None:
    path.write_bytes(path.read_bytes()[:-200])
    with pytest.raises(KnowledgeError, match="is broken"):
        load_knowledge(path)


def test_a_file_whose_bytes_were_changed_is_broken(path: Path) -> None:
    content = bytearray(path.read_bytes())
    content[400:420] = bytes(20)
    path.write_bytes(content)
    with pytest.raises(KnowledgeError, match="is broken"):
        load_knowledge(path)


def test_another_version_is_named(path: Path) -> None:
    change_header(path, version=1)
    with pytest.raises(KnowledgeError, match="version 1; this program reads version 2"):
        load_knowledge(path)


def test_knowledge_measured_with_other_constants_is_refused(path: Path) -> None:
    change_header(path, settings={"near_wall": 0.5})
    with pytest.raises(KnowledgeError, match=r"near_wall.*learn it again"):
        load_knowledge(path)


def forget(name: str) -> Callable[[Arrays], None]:
    def edit(arrays: Arrays) -> None:
        del arrays[name]

    return edit


def put(name: str, values: object) -> Callable[[Arrays], None]:
    def edit(arrays: Arrays) -> None:
        arrays[name] = np.asarray(values)

    return edit


@pytest.mark.parametrize(
    "edit",
    [
        forget("header"),
        forget("0.rows"),
        put("header", np.frombuffer(b"{}", dtype=np.uint8)),
        put("0.rows", np.zeros((6, 3))),
        put("1.sizes", np.zeros((5, 3))),
        put("1.bottoms", [0, 1, 2, np.nan, 4, 5]),
        put("0.rooms", [0, 1, 2, 3, 4, 99]),
        put("0.rows", [["a"] * 50] * 6),
    ],
)
def test_arrays_that_do_not_fit_are_refused(path: Path, edit: Callable[[Arrays], None]) -> None:
    change(path, edit)
    with pytest.raises(KnowledgeError, match="is broken"):
        load_knowledge(path)


COLUMNS = len(choice_columns(PAPER_CATEGORIES))


@pytest.mark.parametrize(
    "edit",
    [
        forget("shared"),
        forget("choice.0.curves"),
        forget("choice.0.rooms"),
        put("shared", np.zeros((3, BINS))),
        put("shared", np.full((COLUMNS, BINS), np.inf)),
        put("choice.0.curves", np.zeros((COLUMNS, BINS - 1), dtype=np.float32)),
        put("choice.0.curves", np.full((COLUMNS, BINS), np.nan, dtype=np.float32)),
        put("choice.0.curves", np.full((COLUMNS, BINS), "a")),
        put("choice.0.pairs", np.array([[0, 1], [1, 2], [2, COLUMNS]])),
        put("choice.0.pairs", np.array([[0, 1], [1, 2], [2, -1]])),
        put("choice.0.pairs", np.array([[0, 1], [1, 2]])),
        put("choice.0.pairs", np.array([[0, 1], [1, 2], [2.0, 3.0]])),
        put("choice.0.surfaces", np.zeros((3, BINS, BINS), dtype=bool)),
        put("choice.0.examples", np.full((2, COLUMNS), BINS, dtype=np.uint8)),
        put("choice.0.examples", np.full((2, COLUMNS), -1, dtype=np.int8)),
        put("choice.0.rooms", [0, 99]),
        put("choice.0.rooms", [0]),
    ],
)
def test_choices_that_do_not_fit_are_refused(
    path_of_choices: Path, edit: Callable[[Arrays], None]
) -> None:
    change(path_of_choices, edit)
    with pytest.raises(KnowledgeError, match="is broken"):
        load_knowledge(path_of_choices)


def test_a_category_that_is_no_group_is_refused(path: Path) -> None:
    change_header(path, categories=["Bed", "Piano"])
    with pytest.raises(KnowledgeError, match="is broken"):
        load_knowledge(path)


def test_pickles_are_never_opened(path: Path) -> None:
    change(path, put("0.rows", np.array([{"a": 1}], dtype=object)))
    with pytest.raises(KnowledgeError, match="is broken"):
        load_knowledge(path)


def test_the_shipped_knowledge_names_its_sources_and_their_licenses() -> None:
    notice = (Path(__file__).parents[3] / "NOTICE").read_text(encoding="utf-8")
    sources = default_knowledge().sources
    assert sources
    for source in sources:
        assert source.name in notice
        assert source.license in notice
        assert source.copyright in notice
        assert f"{source.rooms} rooms" in notice
