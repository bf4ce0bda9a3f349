"""The wire: golden messages, generated files, and what may never travel."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import msgspec
import msgspec.inspect as schema
import pytest

from server import protocol, protocol_page, typescript
from server.generated import is_fresh
from server.schema import UNIONS, members, structs

GOLDEN = Path(__file__).parents[1] / "golden" / "messages"
TYPES = {message.__struct_config__.tag: message for union in UNIONS for message in members(union)}
UNION_OF = {message: union for union in UNIONS for message in members(union)}


def test_every_message_type_has_one_golden_file() -> None:
    assert {path.stem for path in GOLDEN.glob("*.json")} == set(TYPES)


@pytest.mark.parametrize("path", sorted(GOLDEN.glob("*.json")), ids=lambda path: path.stem)
def test_a_golden_message_is_the_same_after_decoding_and_encoding(path: Path) -> None:
    union: Any = getattr(protocol, UNION_OF[TYPES[path.stem]])
    message = msgspec.json.decode(path.read_bytes(), type=union)
    assert type(message) is TYPES[path.stem]
    assert json.loads(msgspec.json.encode(message)) == json.loads(path.read_text())


def test_a_wrong_value_is_refused_with_its_path() -> None:
    text = (GOLDEN / "put_boxes.json").read_text().replace("2.1", "-2.1")
    with pytest.raises(msgspec.ValidationError, match=r"`\$\.boxes\[0\]\.size\[1\]`"):
        msgspec.json.decode(text, type=protocol.ClientMessage)


def test_the_typescript_types_are_fresh() -> None:
    assert is_fresh(typescript.PATH, typescript.typescript())


def test_the_protocol_page_is_fresh() -> None:
    assert is_fresh(protocol_page.PATH, protocol_page.protocol_page())


def test_a_message_becomes_a_typescript_interface() -> None:
    assert (
        "/** Remove a box; removing one that is not there is no error. */\n"
        "export interface RemoveBox {\n"
        '  readonly type: "remove_box";\n'
        "  readonly seq: number;\n"
        "  readonly id: string;\n"
        "}\n"
    ) in typescript.typescript()


def test_no_message_of_the_page_can_carry_an_image() -> None:
    """Numbers, short names and yes or no are all that a page can send: nothing holds pixels."""
    for message in members("ClientMessage"):
        _assert_small(schema.type_info(message), message.__name__)


def _assert_small(kind: schema.Type, path: str) -> None:
    match kind:
        case schema.StructType():
            for field in kind.fields:
                _assert_small(field.type, f"{path}.{field.name}")
        case schema.StrType():
            short = kind.max_length is not None and kind.max_length <= 120
            assert short or kind.pattern == "^[0-9a-f]{32}$", path
        case schema.VarTupleType():
            assert not isinstance(kind.item_type, schema.IntType | schema.FloatType), path
            _assert_small(kind.item_type, f"{path}[]")
        case schema.TupleType():
            assert len(kind.item_types) <= 3, path
            for item in kind.item_types:
                _assert_small(item, f"{path}[]")
        case schema.UnionType():
            for member in kind.types:
                _assert_small(member, path)
        case _:
            numbers = schema.IntType | schema.FloatType | schema.BoolType
            assert isinstance(kind, numbers | schema.NoneType | schema.LiteralType), path


def test_messages_refuse_fields_they_do_not_know() -> None:
    """So that no page can smuggle in more than its messages say."""
    sent = {
        info.name
        for info in structs()
        for kind in [getattr(protocol, info.name, None)]
        if kind is not None and not kind.__struct_config__.forbid_unknown_fields
    }
    received_only = {
        "CategoryInfo", "CatalogueItem", "RoomInfo", "Reason", "Placement", "NoGoodPlace", "Remedy",
        "Elsewhere", "Cost", "Counterfactual", "GraphNode", "GraphEdge",
    }  # fmt: skip
    assert sent == received_only
