"""Tables that people read, edit and give back: the same scores, or what is wrong where."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from scenegen_core.errors import KnowledgeError
from scenegen_core.knowledge.choice import BINS, MISSING, Choice, choice_columns
from scenegen_core.knowledge.files import default_knowledge
from scenegen_core.knowledge.knowledge import Knowledge
from scenegen_core.knowledge.reading_tables import read_tables
from scenegen_core.knowledge.writing_tables import write_tables
from scenegen_core.scene.geometry import Floats
from scenegen_core.scene.model import PAPER_CATEGORIES

SHIPPED = default_knowledge()
COLUMNS = choice_columns(PAPER_CATEGORIES)
NEAREST, FACED = (
    next(i for i, c in enumerate(COLUMNS) if (c.relation, c.group, c.part) == key)
    for key in (("W", "", "nearest"), ("N", "TV", "faced"))
)
NAN = float("nan")


@pytest.fixture
def drawn() -> Knowledge:
    """A sofa that likes the walls up to 20 cm, and a TV that it stands in front of there."""
    curves = np.zeros((len(COLUMNS), BINS), dtype=np.float32)
    curves[NEAREST, :15] = 0.75  # the bins below the edge at 0.2 m
    surface = np.zeros((BINS, BINS), dtype=np.float32)
    surface[:15, 1] = 2.0
    surface[15:MISSING, 1] = 0.5
    surface[:, MISSING] = -0.125
    choice = Choice(
        columns=COLUMNS,
        curves=curves,
        pairs=np.array([[NEAREST, FACED]]),
        surfaces=surface[None],
        examples=np.zeros((3, len(COLUMNS)), dtype=np.uint8),
        rooms=("a", "b", "c"),
    )
    return replace(SHIPPED, choices={"Sofa": choice})


def pose(nearest: float, faced: float) -> Floats:
    features = np.full((1, len(COLUMNS)), NAN)
    features[0, [NEAREST, FACED]] = nearest, faced
    return features


def edit(folder: Path, name: str, change: Callable[[list[str]], list[str]]) -> Path:
    path = folder / name
    lines = path.read_text(encoding="utf-8").splitlines()
    path.write_text("\n".join(change(lines)) + "\n", encoding="utf-8")
    return path


def test_a_curve_is_written_as_its_stretches_of_one_value(tmp_path: Path, drawn: Knowledge) -> None:
    write_tables(drawn, tmp_path)
    assert (tmp_path / "sofa-curves.csv").read_text(encoding="utf-8").splitlines() == [
        "relation,group,part,from,to,nats",
        "Walls,,nearest,-inf,0.2,0.75",
        "Walls,,nearest,0.2,inf,0.0",
        "Walls,,nearest,none,none,0.0",
    ]


def test_a_surface_is_written_as_its_rectangles_of_one_value(
    tmp_path: Path, drawn: Knowledge
) -> None:
    write_tables(drawn, tmp_path)
    lines = (tmp_path / "sofa-surfaces.csv").read_text(encoding="utf-8").splitlines()
    assert len(lines) == 1 + 3 * 3
    assert "Walls,,nearest,-inf,0.2,Neighbor,TV,faced,0.5,inf,2.0" in lines
    assert "Walls,,nearest,0.2,inf,Neighbor,TV,faced,0.5,inf,0.5" in lines
    assert "Walls,,nearest,none,none,Neighbor,TV,faced,none,none,-0.125" in lines


def test_tables_that_come_back_give_the_same_scores(tmp_path: Path) -> None:
    write_tables(SHIPPED, tmp_path)
    back = read_tables(SHIPPED, tmp_path)
    assert list(back.choices) == list(SHIPPED.choices)
    rng = np.random.default_rng(0)
    for name, before in SHIPPED.choices.items():
        anywhere = rng.uniform(-0.5, 4, (500, len(before.columns)))
        anywhere[rng.random(anywhere.shape) < 0.2] = NAN
        after = back.choices[name]
        np.testing.assert_array_equal(after.score(anywhere), before.score(anywhere))
        assert after.rooms == before.rooms


def test_surfaces_of_one_pair_come_back_as_their_sum(tmp_path: Path, drawn: Knowledge) -> None:
    one = drawn.choices["Sofa"]
    twice = replace(
        one,
        pairs=np.concatenate([one.pairs, one.pairs]),
        surfaces=np.concatenate([one.surfaces, one.surfaces]),
    )
    write_tables(replace(drawn, choices={"Sofa": twice}), tmp_path)
    back = read_tables(drawn, tmp_path).choices["Sofa"]
    assert back.score(pose(0.1, 1.0)).tolist() == [0.75 + 2 * 2.0]


def test_a_number_changed_by_hand_is_what_the_score_gains(tmp_path: Path, drawn: Knowledge) -> None:
    write_tables(drawn, tmp_path)
    edit(tmp_path, "sofa-curves.csv", lambda rows: [r.replace("0.75", "1.5") for r in rows])
    changed = read_tables(drawn, tmp_path).choices["Sofa"]
    before = drawn.choices["Sofa"]
    assert (changed.score(pose(0.1, 0)) - before.score(pose(0.1, 0))).tolist() == [0.75]
    assert (changed.score(pose(0.3, 0)) - before.score(pose(0.3, 0))).tolist() == [0.0]


def test_what_a_file_does_not_name_adds_nothing(tmp_path: Path, drawn: Knowledge) -> None:
    write_tables(drawn, tmp_path)
    edit(tmp_path, "sofa-curves.csv", lambda rows: rows[:1])
    edit(tmp_path, "sofa-surfaces.csv", lambda rows: rows[:1])
    assert read_tables(drawn, tmp_path).choices["Sofa"].score(pose(0.1, 1.0)).tolist() == [0.0]


def test_a_category_without_a_file_keeps_its_table(tmp_path: Path, drawn: Knowledge) -> None:
    write_tables(drawn, tmp_path)
    (tmp_path / "sofa-surfaces.csv").unlink()
    assert read_tables(drawn, tmp_path).choices["Sofa"].score(pose(0.1, 1.0)).tolist() == [2.75]


def test_a_new_curve_and_a_new_surface_can_be_written_by_hand(
    tmp_path: Path, drawn: Knowledge
) -> None:
    write_tables(drawn, tmp_path)
    curve = [
        "Height,,,-inf,0.2,1",
        "Height,,,0.2,inf,-1",
        "Height,,,none,none,0",
    ]
    faced, none = "Neighbor,TV,faced,-inf,inf", "Neighbor,TV,faced,none,none"
    surface = [
        f"Height,,,{limits},{other},{value}"
        for limits, value in (("-inf,inf", 4), ("none,none", 0))
        for other in (faced, none)
    ]
    edit(tmp_path, "sofa-curves.csv", lambda rows: rows[:1] + curve)
    edit(tmp_path, "sofa-surfaces.csv", lambda rows: rows[:1] + surface)
    features = pose(0.1, 1.0)
    features[0, next(i for i, c in enumerate(COLUMNS) if c.relation == "H")] = 0.0
    assert read_tables(drawn, tmp_path).choices["Sofa"].score(features).tolist() == [1 + 4]


def test_what_a_spreadsheet_does_to_a_file_is_no_harm(tmp_path: Path, drawn: Knowledge) -> None:
    write_tables(drawn, tmp_path)
    path = tmp_path / "sofa-curves.csv"
    text = path.read_text(encoding="utf-8").replace("0.2", "0.20001") + ",,,,,\n"
    path.write_bytes(text.replace("\n", "\r\n").encode("utf-8-sig"))
    assert read_tables(drawn, tmp_path).choices["Sofa"].score(pose(0.1, 1.0)).tolist() == [2.75]


@pytest.mark.parametrize(
    ("row", "becomes", "said"),
    [
        (0, "relation;group;part;from;to;nats", r"line 1: the first line must be relation,group"),
        (1, "Walls,,nearest,-inf,0.2", r"line 2: there are 5 values; give 6"),
        (1, "Wall,,nearest,-inf,0.2,1", r"line 2: there is no relation 'Wall'; write one of Walls"),
        (1, "Walls,Sofa,nearest,-inf,0.2,1", r"line 2: Walls has no group 'Sofa'; write nothing"),
        (1, "Neighbor,Piano,gap,-inf,0.2,1", r"line 2: Neighbor has no group 'Piano'; .*Sofa"),
        (1, "Walls,,closest,-inf,0.2,1", r"line 2: Walls has no part 'closest'; .*nearest"),
        (1, "Walls,,nearest,-inf,0.22,1", r"line 2: '0\.22' is no edge .* 0\.2, 0\.25"),
        (1, "Walls,,nearest,0.2,-inf,1", r"line 2: it goes from 0\.2 to -inf; the lesser comes"),
        (1, "Walls,,nearest,none,0.2,1", r"line 2: 'none' is no edge of this column"),
        (1, "Walls,,nearest,-inf,0.2,much", r"line 2: 'much' is no number of nats"),
        (1, "Walls,,nearest,-inf,0.2,nan", r"line 2: 'nan' is no number of nats"),
        (1, "Walls,,nearest,-inf,0.2,1e9", r"line 2: '1e9' is no number .* from -1000 to 1000"),
        (1, "Walls,,nearest,-inf,0.25,1", r"line 3: an earlier row says what this adds already"),
        (1, "Walls,,nearest,-inf,0.15,1", r"line 2: the curve .* nothing for 0\.15 to 0\.2; add"),
        (3, "", r"line 2: the curve that begins here says nothing for none; add a row"),
        (1, 'Walls,,"nearest,-inf,0.2,1', r" is no table .*save it as CSV"),
    ],
)
def test_a_broken_table_names_file_line_and_what_to_do(
    tmp_path: Path, drawn: Knowledge, row: int, becomes: str, said: str
) -> None:
    write_tables(drawn, tmp_path)
    edit(tmp_path, "sofa-curves.csv", lambda rows: [*rows[:row], becomes, *rows[row + 1 :]])
    with pytest.raises(KnowledgeError, match=rf"sofa-curves\.csv.*{said}"):
        read_tables(drawn, tmp_path)


def test_a_surface_with_a_hole_names_the_rectangle(tmp_path: Path, drawn: Knowledge) -> None:
    write_tables(drawn, tmp_path)
    edit(tmp_path, "sofa-surfaces.csv", lambda rows: rows[:-1])
    with pytest.raises(KnowledgeError, match=r"line 2: the surface .* for none and none; add"):
        read_tables(drawn, tmp_path)


def test_a_surface_of_one_column_is_refused(tmp_path: Path, drawn: Knowledge) -> None:
    write_tables(drawn, tmp_path)
    same = ",".join(["Walls,,nearest,-inf,inf"] * 2) + ",1"
    edit(tmp_path, "sofa-surfaces.csv", lambda rows: [rows[0], same])
    with pytest.raises(KnowledgeError, match=r"line 2: a surface is of two columns"):
        read_tables(drawn, tmp_path)


def test_an_empty_file_is_no_table(tmp_path: Path, drawn: Knowledge) -> None:
    (tmp_path / "sofa-curves.csv").touch()
    with pytest.raises(KnowledgeError, match=r"line 1: the first line must be"):
        read_tables(drawn, tmp_path)


def test_bytes_are_no_table(tmp_path: Path, drawn: Knowledge) -> None:
    (tmp_path / "sofa-curves.csv").write_bytes(b"PK\x03\x04\xff\xfe\n")
    with pytest.raises(KnowledgeError, match=r"is no table .*save it as CSV in UTF-8"):
        read_tables(drawn, tmp_path)


def test_a_table_of_another_category_is_named(tmp_path: Path, drawn: Knowledge) -> None:
    write_tables(drawn, tmp_path)
    (tmp_path / "sofa-curves.csv").rename(tmp_path / "settee-curves.csv")
    with pytest.raises(KnowledgeError, match=r"settee-curves\.csv is no table.*sofa-curves\.csv"):
        read_tables(drawn, tmp_path)


def test_a_folder_without_tables_says_how_to_get_some(tmp_path: Path, drawn: Knowledge) -> None:
    with pytest.raises(KnowledgeError, match=r"no tables in .*scenegen inspect"):
        read_tables(drawn, tmp_path)


def test_knowledge_without_curves_says_how_to_get_some(tmp_path: Path, drawn: Knowledge) -> None:
    write_tables(drawn, tmp_path)
    with pytest.raises(KnowledgeError, match=r"no curves .*without --without-choices"):
        read_tables(replace(drawn, choices={}), tmp_path)
