"""Files of rooms are told apart by what is in them; what is no room is refused in words."""

from __future__ import annotations

import gzip
import json
import logging
import re
import zipfile
from pathlib import Path

import pytest

from scenegen_core.datasets import contents
from scenegen_core.datasets.contents import content, fields_of, lines, member
from scenegen_core.datasets.formats import FORMATS, format_of, read_all, read_scenes
from scenegen_core.datasets.remarks import Remark, Skipped, UnknownLabel, told, usable_boxes
from scenegen_core.errors import DataError
from scenegen_core.scene.model import Box

FIXTURES = Path(__file__).parents[2] / "fixtures"
LIVING_ROOM = FIXTURES / "living_room.json"
ROW = json.dumps(
    {"id": "1", "source": "", "room_type": "", "polygon": [[0, 0], [4, 0], [4, 4]], "objects": []}
)
SAMPLES = {
    "scene": LIVING_ROOM.read_bytes(),
    "rows": f"{ROW}\n{ROW}\n".encode(),
    "quest": b'{"version": 1, "spatialEntities": []}',
    "mruk": b'{"CoordinateSystem": "Unity", "Rooms": [{"UUID": "r", "Anchors": []}]}',
    "roomplan": (FIXTURES / "roomplan_two_stories.json").read_bytes(),
}


@pytest.mark.parametrize("name", SAMPLES)
@pytest.mark.parametrize("packed", [False, True])
def test_a_format_is_told_by_content_whatever_the_file_is_called(
    tmp_path: Path, name: str, *, packed: bool
) -> None:
    odd = tmp_path / "download (3).txt"
    odd.write_bytes(gzip.compress(SAMPLES[name]) if packed else SAMPLES[name])
    assert format_of(odd).name == name
    recognizing = [form.name for form in FORMATS if form.recognizes(contents.Head(odd))]
    assert recognizing == [name]


@pytest.mark.parametrize("name", SAMPLES)
def test_a_mark_at_the_beginning_of_a_text_changes_nothing(tmp_path: Path, name: str) -> None:
    marked = tmp_path / "marked"
    marked.write_bytes(b"\xef\xbb\xbf" + SAMPLES[name])
    assert format_of(marked).name == name


def test_rows_are_known_by_their_first_usable_line(tmp_path: Path) -> None:
    path = tmp_path / "rooms"
    path.write_text(f'{{"broken\n{ROW}\n', encoding="utf-8")
    assert format_of(path).name == "rows"


def test_a_first_row_longer_than_the_beginning_is_read_whole(tmp_path: Path) -> None:
    row = json.loads(ROW)
    row["room_type"] = "long " * contents.START
    path = tmp_path / "rooms"
    path.write_text(f"{json.dumps(row)}\n{ROW}\n", encoding="utf-8")
    assert format_of(path).name == "rows"


@pytest.mark.parametrize("text", [b"", b"hello", b"{}", b"[]", b"[1, 2]", b"\x89PNG\r\n", b"PK"])
def test_what_is_no_room_is_refused(tmp_path: Path, text: bytes) -> None:
    path = tmp_path / "file"
    path.write_bytes(text)
    with pytest.raises(DataError, match=r"is neither a scene file, rows of rooms, .* nor "):
        format_of(path)


def test_json_that_breaks_off_is_called_incomplete(tmp_path: Path) -> None:
    path = tmp_path / "file"
    path.write_bytes(SAMPLES["roomplan"][:5000])
    with pytest.raises(DataError, match="begins as JSON but is none; check that it is complete"):
        format_of(path)


def test_a_file_without_usable_rooms_is_an_error(tmp_path: Path) -> None:
    path = tmp_path / "rooms"
    path.write_text(ROW.replace("[4, 4]", "[8, 0]"), encoding="utf-8")
    said: list[Remark] = []
    with pytest.raises(DataError, match="holds no usable room; choose another file"):
        list(read_scenes(path, said.append))
    assert "line 1" in str(said[0])


def test_an_unusable_file_among_others_is_named_and_left_out(tmp_path: Path) -> None:
    text = tmp_path / "notes.txt"
    text.write_text("hello")
    said: list[Remark] = []
    steps: list[tuple[int, int]] = []
    scenes = list(
        read_all([text, LIVING_ROOM], said.append, progress=lambda *step: steps.append(step))
    )
    assert [scene.id for scene in scenes] == ["drawn"]
    assert [str(remark).count("notes.txt") for remark in said] == [1]
    assert steps == [(1, 2), (2, 2)]


def test_rooms_are_read_when_they_are_asked_for(tmp_path: Path) -> None:
    path = tmp_path / "rooms"
    path.write_text(f"{ROW}\n{{\n", encoding="utf-8")
    said: list[Remark] = []
    next(read_scenes(path, said.append))
    assert said == []


def test_remarks_nobody_asked_for_are_logged(
    tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    path = tmp_path / "rooms"
    path.write_text(f"{ROW}\n{{\n", encoding="utf-8")
    with caplog.at_level(logging.WARNING):
        list(read_scenes(path))
    assert f"Left out: {path}, line 2" in caplog.text


def test_an_unknown_label_is_told_once_with_its_count() -> None:
    unknown = [UnknownLabel(Path("a"), "quest", label) for label in ("X", "Y", "X")]
    assert list(told([*unknown, Skipped(Path("a"), "line 2", "broken")])) == [
        "left out: a, line 2: broken",
        "unknown label, counts as Other: 'X' (quest), 2",
        "unknown label, counts as Other: 'Y' (quest), 1",
    ]


def test_only_boxes_that_a_scene_can_carry_are_kept() -> None:
    size = (1.0, 1.0, 1.0)
    boxes = [
        Box("a", "Table", (0, 0, 0.5), size),
        Box("a", "Table", (1, 0, 0.5), size),
        Box("b", "Table", (5000, 0, 0.5), size),
        Box("c", "Table", (0, 0, 0.5), (1.0, float("nan"), 1.0)),
        Box("d", "Decor", (0, 0, 1.1), size, parent="a"),
        Box("e", "Decor", (0, 0, 1.1), size, parent="b"),
    ]
    said: list[Remark] = []
    kept = usable_boxes(boxes, Path("f"), said.append)
    assert [(box.id, box.parent) for box in kept] == [("a", None), ("d", "a"), ("e", None)]
    assert [remark.what for remark in said if isinstance(remark, Skipped)] == [
        "object 'a'", "object 'b'", "object 'c'",
    ]  # fmt: skip


def test_the_page_about_formats_lists_every_format() -> None:
    page = (Path(__file__).parents[3] / "docs/formats.md").read_text(encoding="utf-8")
    assert re.findall(r"^\| `(\w+)`", page, re.MULTILINE) == [form.name for form in FORMATS]


class TestLimits:
    """Small limits stand for the large ones, so that no test needs gigabytes."""

    def test_a_gzip_bomb_is_refused(self, tmp_path: Path) -> None:
        bomb = tmp_path / "bomb.gz"
        bomb.write_bytes(gzip.compress(b" " * 2_000_000))
        with pytest.raises(DataError, match="larger than 1 MB; split it"):
            content(bomb, 1_000_000)

    def test_a_zip_bomb_is_refused(self, tmp_path: Path) -> None:
        bomb = tmp_path / "bomb.zip"
        with zipfile.ZipFile(bomb, "w", zipfile.ZIP_DEFLATED) as archive:
            archive.writestr("Home.xml", b" " * 2_000_000)
        with pytest.raises(DataError, match=r"Home\.xml in .* is larger than 1 MB"):
            member(bomb, "Home.xml", 1_000_000)

    def test_an_archive_of_very_many_files_is_refused(
        self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.setattr(contents, "MOST_MEMBERS", 3)
        path = tmp_path / "many.zip"
        with zipfile.ZipFile(path, "w") as archive:
            for number in range(4):
                archive.writestr(f"{number}.json", b"{}")
        with pytest.raises(DataError, match="holds more than 3 files"):
            format_of(path)

    def test_a_line_without_end_is_refused(
        self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.setattr(contents, "LONGEST_LINE", 1000)
        path = tmp_path / "rooms"
        path.write_bytes(b"x" * 2000)
        with pytest.raises(DataError, match="A line of"):
            list(lines(path))

    def test_rows_without_end_are_refused(
        self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.setattr(contents, "LARGEST_ROWS", 10_000)
        path = tmp_path / "rooms.gz"
        path.write_bytes(gzip.compress(b"\n" * 20_000))
        with pytest.raises(DataError, match=r"rooms\.gz is larger than"):
            list(lines(path))

    def test_json_that_is_nested_without_end_is_no_room(self, tmp_path: Path) -> None:
        path = tmp_path / "deep"
        path.write_bytes(b'{"a":' * 100_000)
        with pytest.raises(DataError, match="begins as JSON but is none"):
            format_of(path)
        assert fields_of(b"[" * 100_000) == {}

    def test_a_locked_archive_is_named(self, tmp_path: Path) -> None:
        path = tmp_path / "locked.zip"
        with zipfile.ZipFile(path, "w") as archive:
            archive.writestr("room.json", b"{}")
        text = bytearray(path.read_bytes())
        for start in (6, text.index(b"PK\x01\x02") + 8):
            text[start] |= 1  # the bit that says "encrypted"
        path.write_bytes(text)
        with pytest.raises(DataError, match="check that it is complete and not locked"):
            format_of(path)

    def test_a_cut_archive_is_named(self, tmp_path: Path) -> None:
        path = tmp_path / "cut.zip"
        with zipfile.ZipFile(path, "w") as archive:
            archive.writestr("room.json", b"{}" * 1000)
        path.write_bytes(path.read_bytes()[:500])
        with pytest.raises(DataError, match=r"cut\.zip cannot be read"):
            format_of(path)
