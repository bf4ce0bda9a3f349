"""Sample rooms beside the page."""

from __future__ import annotations

from pathlib import Path

import pytest

from server.protocol import RoomInfo
from server.rooms import sample_rooms

SQUARE = b"""{"format": "scenegen.scene", "version": 1, "name": "Study",
"room": {"corners": [[0, 0], [3, 0], [3, 4], [0, 4]]}}"""


def test_samples_come_before_scans_with_their_floor_area(tmp_path: Path) -> None:
    (tmp_path / "rooms" / "scans").mkdir(parents=True)
    (tmp_path / "rooms" / "scans" / "attic.json").write_bytes(SQUARE)
    (tmp_path / "rooms" / "study.json").write_bytes(SQUARE)
    assert [room.info for room in sample_rooms(tmp_path).values()] == [
        RoomInfo(id="study", name="Study", kind="sample", boxes=0, area=12.0),
        RoomInfo(id="attic", name="Study", kind="scan", boxes=0, area=12.0),
    ]


def test_a_broken_file_is_left_out_and_named(
    tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    (tmp_path / "rooms").mkdir()
    (tmp_path / "rooms" / "broken.json").write_bytes(SQUARE[:40])
    (tmp_path / "rooms" / "study.json").write_bytes(SQUARE)
    assert list(sample_rooms(tmp_path)) == ["study"]
    assert "broken.json" in caplog.text


def test_a_page_without_rooms_has_none(tmp_path: Path) -> None:
    assert sample_rooms(tmp_path) == {}
