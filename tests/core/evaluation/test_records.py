"""The journal: what was done is kept, half a line is not."""

from __future__ import annotations

from pathlib import Path

import msgspec
import pytest

from scenegen_core.errors import DataError
from scenegen_core.evaluation.records import Journal
from tests.core.evaluation.made import SETTINGS, joint, record

ONE = record(1, {"paper": joint(1.0, 0.5)})
TWO = record(2, {"paper": joint(2.0, 0.5)})


def test_a_run_goes_on_with_the_records_of_the_one_before(tmp_path: Path) -> None:
    path = tmp_path / "deep" / "journal.jsonl"
    Journal(path, SETTINGS).add(ONE)
    again = Journal(path, SETTINGS)
    assert again.known == {ONE.case: ONE}
    again.add(TWO)
    assert Journal(path, SETTINGS).known == {ONE.case: ONE, TWO.case: TWO}


def test_half_a_line_at_the_end_is_written_again(tmp_path: Path) -> None:
    path = tmp_path / "journal.jsonl"
    Journal(path, SETTINGS).add(ONE)
    whole = path.read_bytes()
    path.write_bytes(whole + msgspec.json.encode(TWO)[:30])
    Journal(path, SETTINGS).add(TWO)
    assert path.read_bytes() == whole + msgspec.json.encode(TWO) + b"\n"


def test_half_of_the_first_line_is_no_beginning(tmp_path: Path) -> None:
    path = tmp_path / "journal.jsonl"
    path.write_bytes(msgspec.json.encode(SETTINGS)[:20])
    Journal(path, SETTINGS).add(ONE)
    assert Journal(path, SETTINGS).known == {ONE.case: ONE}


def test_records_made_with_other_settings_are_not_mixed_in(tmp_path: Path) -> None:
    path = tmp_path / "journal.jsonl"
    Journal(path, SETTINGS)
    with pytest.raises(DataError, match="other settings; remove it or choose another folder"):
        Journal(path, msgspec.structs.replace(SETTINGS, seed=2))


def test_a_damaged_line_is_named(tmp_path: Path) -> None:
    path = tmp_path / "journal.jsonl"
    Journal(path, SETTINGS).add(ONE)
    path.write_bytes(path.read_bytes() + b"{}\n" + msgspec.json.encode(TWO) + b"\n")
    with pytest.raises(DataError, match=r"Line 3 of .* is damaged"):
        Journal(path, SETTINGS)


def test_another_file_of_that_name_is_left_alone(tmp_path: Path) -> None:
    path = tmp_path / "journal.jsonl"
    path.write_text("Dear diary\n")
    with pytest.raises(DataError, match="not a journal"):
        Journal(path, SETTINGS)
    assert path.read_text() == "Dear diary\n"


def test_a_folder_that_cannot_be_made_is_named(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    with pytest.raises(DataError, match=r"cannot be written .* choose another folder with --out"):
        Journal(tmp_path / "file" / "journal.jsonl", SETTINGS)


def test_without_a_file_records_are_kept_in_memory() -> None:
    journal = Journal(None, SETTINGS)
    journal.add(ONE)
    assert journal.known == {ONE.case: ONE}
