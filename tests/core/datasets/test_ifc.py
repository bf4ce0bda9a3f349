"""Building models that ifcopenshell wrote become scenes."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from math import cos, pi, sin
from pathlib import Path
from typing import Any, Literal

import ifcopenshell
import ifcopenshell.guid
import pytest
from shapely import Polygon

from scenegen_core.datasets.formats import format_of, read_scenes
from scenegen_core.datasets.labels import categories_of
from scenegen_core.datasets.remarks import Remark, Skipped, UnknownLabel
from scenegen_core.errors import DataError
from scenegen_core.scene.files import read_scene, write_scene
from scenegen_core.scene.model import PAPER_CATEGORIES, Scene

Plan = Sequence[tuple[float, float]]

LIVING: Plan = [(0, 0), (4, 0), (4, 3), (0, 3)]
BEDROOM: Plan = [(4.2, 0), (7, 0), (7, 3), (4.2, 3)]


class Model:
    """A building in millimetres with elements that are upright prisms; given in metres."""

    def __init__(self, schema: Literal["IFC2X3", "IFC4"] = "IFC4") -> None:
        self.file: Any = ifcopenshell.file(schema=schema)
        origin = self.file.createIfcCartesianPoint((0.0, 0.0, 0.0))
        self.upright = self.file.createIfcAxis2Placement3D(origin)
        self.context = self.file.createIfcGeometricRepresentationContext(
            None, "Model", 3, 1e-5, self.upright
        )
        unit = self.file.createIfcSIUnit(None, "LENGTHUNIT", "MILLI", "METRE")
        self.file.create_entity(
            "IfcProject",
            GlobalId=ifcopenshell.guid.new(),
            RepresentationContexts=[self.context],
            UnitsInContext=self.file.createIfcUnitAssignment([unit]),
        )

    def add(
        self,
        kind: str,
        plan: Plan,
        height: float,
        at: tuple[float, float, float] = (0, 0, 0),
        *,
        turn: float = 0,
        **fields: Any,
    ) -> Any:
        """An element whose own axes are put somewhere, turned by radians about z."""
        return self.file.create_entity(
            kind,
            GlobalId=ifcopenshell.guid.new(),
            ObjectPlacement=self._placement(at, turn),
            Representation=self._prism(plan, height) if plan else None,
            **fields,
        )

    def write(self, path: Path) -> Path:
        path.write_text(self.file.to_string())
        return path

    def _placement(self, at: tuple[float, float, float], turn: float) -> Any:
        place = self.file.createIfcAxis2Placement3D(
            self.file.createIfcCartesianPoint(tuple(1000.0 * value for value in at)),
            self.file.createIfcDirection((0.0, 0.0, 1.0)),
            self.file.createIfcDirection((cos(turn), sin(turn), 0.0)),
        )
        return self.file.createIfcLocalPlacement(None, place)

    def _prism(self, plan: Plan, height: float) -> Any:
        points = [
            self.file.createIfcCartesianPoint((1000.0 * x, 1000.0 * y)) for x, y in (*plan, plan[0])
        ]
        line = self.file.createIfcPolyline(points)
        area = self.file.createIfcArbitraryClosedProfileDef("AREA", None, line)
        up = self.file.createIfcDirection((0.0, 0.0, 1.0))
        solid = self.file.createIfcExtrudedAreaSolid(area, self.upright, up, 1000.0 * height)
        shape = self.file.createIfcShapeRepresentation(self.context, "Body", "SweptSolid", [solid])
        return self.file.createIfcProductDefinitionShape(None, None, [shape])


def block(depth: float, width: float) -> Plan:
    """The plan of a thing round its own origin: width along its x, depth along its y."""
    x, y = width / 2, depth / 2
    return [(-x, -y), (x, -y), (x, y), (-x, y)]


@pytest.fixture
def model() -> Model:
    """A flat of two rooms on the second floor, 3 m above the ground."""
    model = Model()
    model.add("IfcSpace", LIVING, 2.5, (0, 0, 3), Name="001", LongName="Living room")
    model.add("IfcSpace", BEDROOM, 2.5, (0, 0, 3), Name="Bedroom")
    return model


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return tmp_path / "flat.ifc"


def read(path: Path, remarks: list[Remark] | None = None) -> list[Scene]:
    """The rooms of a model; what is said about it goes to ``remarks``, or must be nothing."""
    said: list[Remark] = []
    assert format_of(path).name == "ifc"
    scenes = list(read_scenes(path, said.append))
    if remarks is None:
        assert said == []
    else:
        remarks += said
    return scenes


def test_spaces_are_rooms_in_metres_with_their_floors_at_zero(model: Model, path: Path) -> None:
    living, bedroom = read(model.write(path))
    assert Polygon(living.room.corners).equals(Polygon(LIVING))
    assert Polygon(living.room.corners).exterior.is_ccw
    assert living.room.height == pytest.approx(2.5)
    assert (living.room.room_type, bedroom.room.room_type) == ("Living room", "Bedroom")
    space = model.file.by_type("IfcSpace")[0]
    assert (living.id, living.source) == (f"flat/{space.GlobalId}", "ifc")


def test_a_space_can_have_any_plan_and_placement(path: Path) -> None:
    model = Model()
    corner = [(0, 0), (4, 0), (4, 1), (2, 1), (2, 3), (0, 3)]
    model.add("IfcSpace", corner, 2.5, (1, 2, 0), turn=pi / 2)
    (scene,) = read(model.write(path))
    expected = Polygon([(1 - y, 2 + x) for x, y in corner])
    assert Polygon(scene.room.corners).symmetric_difference(expected).area < 1e-6


@pytest.mark.parametrize("turn", [0, 0.5, pi / 2, -2.0])
def test_furniture_has_the_box_of_its_own_axes(model: Model, path: Path, turn: float) -> None:
    sofa = model.add(
        "IfcFurniture", block(0.9, 2.0), 0.8, (1.5, 1.5, 3), turn=turn,
        Name="Sofa:3 seats", PredefinedType="SOFA",
    )  # fmt: skip
    (box,) = read(model.write(path))[0].boxes
    assert (box.id, box.category, box.label) == (sofa.GlobalId, "Sofa", "Sofa:3 seats")
    assert box.center == pytest.approx((1.5, 1.5, 0.4))
    assert box.size == pytest.approx((0.9, 2.0, 0.8))
    ahead = turn - pi / 2  # along its own -y
    assert (cos(box.heading), sin(box.heading)) == pytest.approx((cos(ahead), sin(ahead)))
    assert not box.front_known


def test_furniture_goes_to_the_space_that_contains_its_center(model: Model, path: Path) -> None:
    model.add("IfcFurniture", block(0.5, 0.5), 0.9, (1, 1, 3), PredefinedType="CHAIR")
    model.add("IfcFurniture", block(2.0, 1.6), 0.5, (5.5, 1, 3), PredefinedType="BED")
    living, bedroom = read(model.write(path))
    assert [box.category for box in living.boxes] == ["Chair"]
    assert [box.category for box in bedroom.boxes] == ["Bed"]


def test_storeys_are_kept_apart(model: Model, path: Path) -> None:
    model.add("IfcSpace", LIVING, 2.5, (0, 0, 0), LongName="Shop")
    model.add("IfcFurniture", block(0.5, 0.5), 0.9, (1, 1, 0), PredefinedType="CHAIR")
    model.add("IfcFurniture", block(0.3, 0.3), 0.4, (1, 1, 3.8), PredefinedType="SHELF")
    model.add("IfcDoor", [(0, -0.05), (0.9, -0.05), (0.9, 0.05), (0, 0.05)], 2, (1, 0, 3))
    shop, living, _ = read(model.write(path))
    assert [(box.category, box.bottom) for box in shop.boxes] == [("Chair", 0)]
    assert [(box.category, box.bottom) for box in living.boxes] == [("Storage", 0.8)]
    assert (len(shop.room.doors), len(living.room.doors)) == (0, 1)


def test_a_door_leads_to_both_rooms_and_a_window_to_one(model: Model, path: Path) -> None:
    leaf = [(0, -0.1), (0.9, -0.1), (0.9, 0.1), (0, 0.1)]
    model.add("IfcDoor", leaf, 2.0, (4.1, 1, 3), turn=pi / 2, Name="Door")
    pane = [(0, -0.1), (1.2, -0.1), (1.2, 0.1), (0, 0.1)]
    model.add("IfcWindow", pane, 1.2, (1, 3.1, 3.9), Name="Window")
    living, bedroom = read(model.write(path))
    for scene, x in ((living, 4), (bedroom, 4.2)):
        (opening,) = scene.room.doors
        assert sorted([opening.start, opening.end]) == [(x, 1), (x, 1.9)]
        assert (opening.bottom, opening.top) == pytest.approx((0, 2))
    (opening,) = living.room.windows
    assert sorted([opening.start, opening.end]) == [(1, 3), (2.2, 3)]
    assert (opening.bottom, opening.top) == pytest.approx((0.9, 2.1))


def test_the_coordinates_of_a_survey_are_brought_near(path: Path) -> None:
    model = Model()
    model.add("IfcSpace", LIVING, 2.5, (2_600_000, 1_200_000, 2400))
    at = (2_600_001, 1_200_001, 2400)
    model.add("IfcFurniture", block(0.5, 0.5), 0.9, at, PredefinedType="CHAIR")
    (scene,) = read(model.write(path))
    assert Polygon(scene.room.corners).symmetric_difference(Polygon(LIVING)).area < 1e-3
    assert scene.boxes[0].center == pytest.approx((1, 1, 0.45), abs=1e-3)


@pytest.mark.parametrize(
    ("fields", "category"),
    [
        ({"PredefinedType": "TABLE", "Name": "Chair"}, "Table"),
        ({"PredefinedType": "USERDEFINED", "ObjectType": "TV stand", "Name": "x"}, "Storage"),
        ({"Name": "Table lamp:white:123"}, "Decor"),
        ({"Name": "Bookshelf_2x4"}, "Storage"),
        ({"Name": "Armchairs"}, "Chair"),
    ],
)
def test_the_type_goes_before_the_names_and_the_last_word_says_what_it_is(
    model: Model, path: Path, fields: dict[str, Any], category: str
) -> None:
    model.add("IfcFurniture", block(0.5, 0.5), 0.9, (1, 1, 3), **fields)
    assert [box.category for box in read(model.write(path))[0].boxes] == [category]


def test_fixtures_count_and_outlets_do_not(model: Model, path: Path) -> None:
    model.add("IfcSanitaryTerminal", block(0.5, 0.4), 0.4, (1, 1, 3), PredefinedType="TOILETPAN")
    model.add("IfcOutlet", block(0.05, 0.1), 0.1, (2, 1, 3), Name="Socket")
    assert [box.category for box in read(model.write(path))[0].boxes] == ["Other"]


def test_older_schemas_are_read_too(path: Path) -> None:
    model = Model("IFC2X3")
    model.add("IfcSpace", LIVING, 2.5)
    model.add("IfcFurnishingElement", block(2.0, 1.6), 0.5, (1, 1.5, 0), Name="Double bed")
    (scene,) = read(model.write(path))
    assert [box.category for box in scene.boxes] == ["Bed"]


def test_an_unknown_name_is_other_and_said(model: Model, path: Path) -> None:
    said: list[Remark] = []
    model.add("IfcFurniture", block(0.5, 0.5), 0.9, (1, 1, 3), Name="Spaceship")
    (box,) = read(model.write(path), said)[0].boxes
    assert (box.category, box.label) == ("Other", "Spaceship")
    assert said == [UnknownLabel(path, "ifc", "Spaceship")]


@pytest.mark.parametrize(
    ("kind", "plan", "at", "what", "reason"),
    [
        ("IfcFurniture", [], (1, 1, 3), "IfcFurniture 'Chair'", "no usable shape"),
        ("IfcFurniture", block(1, 1), (9, 9, 3), "object", "stands in no room"),
        ("IfcDoor", block(0.1, 0.9), (2, 1.5, 3), "opening", "in no wall"),
        ("IfcSpace", [], (0, 0, 3), "IfcSpace 'Chair'", "no usable shape"),
        ("IfcSpace", block(0.2, 0.2), (0, 0, 3), "IfcSpace 'Chair'", "of floor"),
    ],
)
def test_what_is_broken_is_named_and_left_out(
    model: Model,
    path: Path,
    kind: str,
    plan: Plan,
    at: tuple[float, float, float],
    what: str,
    reason: str,
) -> None:
    said: list[Remark] = []
    model.add("IfcFurniture", block(0.5, 0.5), 0.9, (1, 1, 3), Name="Bed")
    model.add(kind, plan, 0.9, at, Name="Chair")
    living, _ = read(model.write(path), said)
    assert [box.category for box in living.boxes] == ["Bed"]
    (skipped,) = said
    assert isinstance(skipped, Skipped)
    assert what in skipped.what
    assert reason in skipped.reason


def test_a_model_is_a_scene_file(model: Model, path: Path) -> None:
    model.add("IfcFurniture", block(0.5, 0.5), 0.9, (1, 1, 3), turn=0.3, Name="Armchair")
    for scene in read(model.write(path)):
        assert read_scene(write_scene(scene)) == scene


def test_a_model_without_spaces_is_refused_with_what_to_do(path: Path) -> None:
    with pytest.raises(DataError, match="export it with its rooms"):
        read(Model().write(path))


def test_a_model_of_an_unknown_schema_is_refused_with_what_to_do(model: Model, path: Path) -> None:
    model.write(path)
    path.write_text(path.read_text().replace("'IFC4'", "'IFC9'"))
    with pytest.raises(DataError, match="export it again"):
        read(path)


def test_without_the_package_the_message_says_what_to_install(
    model: Model, path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "ifcopenshell", None)
    with pytest.raises(DataError, match=r'pip install "scenegen\[ifc\]"'):
        read(model.write(path))


def test_the_reviewed_labels_lead_to_the_papers_categories() -> None:
    named = {category for category in categories_of("ifc").values() if category}
    assert named <= {category.name for category in PAPER_CATEGORIES}
