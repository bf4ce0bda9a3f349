"""The messages of ``protocol.py`` as data: what the generators of types and of docs read."""

from __future__ import annotations

import ast
import inspect
import textwrap
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal, get_args, get_origin

import msgspec.inspect as schema
from msgspec import Struct

from scenegen_core.scene import files
from server import protocol

UNIONS = ("ClientMessage", "ServerMessage", "FrameHeader")


@dataclass(frozen=True)
class FieldSchema:
    """A field of a message."""

    name: str
    type: schema.Type
    optional: bool
    """True when the server leaves it out where it has its default."""
    doc: str


@dataclass(frozen=True)
class StructSchema:
    """A message, or a part of one."""

    name: str
    tag: str | None
    """The value of ``type``; None for parts of messages."""
    doc: str
    fields: tuple[FieldSchema, ...]


def structs() -> tuple[StructSchema, ...]:
    """All messages and their parts: records of scene files first, then in order of definition."""
    found: dict[type, schema.StructType] = {}
    for union in UNIONS:
        for member in members(union):
            for struct in _structs_in(schema.type_info(member)):
                found.setdefault(struct.cls, struct)
    return tuple(_struct_schema(found[cls]) for cls in sorted(found, key=_place))


def members(union: str) -> tuple[type[Struct], ...]:
    """The messages of a union of the protocol, in order."""
    return get_args(getattr(protocol, union))


def constants() -> dict[str, int | str]:
    """The limits and close codes that the page must know."""
    limits: dict[str, int | str] = {
        name: value
        for name, value in vars(protocol).items()
        if name.isupper() and isinstance(value, int | str)
    }
    return limits | {"MAX_BOXES": files.MAX_BOXES, "MAX_CORNERS": files.MAX_CORNERS}


def named_literals() -> dict[frozenset[object], str]:
    """The names of the protocol's literal types, by their values."""
    return {
        frozenset(get_args(value)): name
        for name, value in vars(protocol).items()
        if get_origin(value) is Literal
    }


def _structs_in(kind: schema.Type) -> Iterator[schema.StructType]:
    """The struct types that a type is made of, itself included."""
    match kind:
        case schema.StructType():
            yield kind
            parts = [field.type for field in kind.fields]
        case schema.TupleType():
            parts = list(kind.item_types)
        case schema.VarTupleType():
            parts = [kind.item_type]
        case schema.DictType():
            parts = [kind.value_type]
        case schema.UnionType():
            parts = list(kind.types)
        case _:
            parts = []
    for part in parts:
        yield from _structs_in(part)


def _place(cls: type) -> tuple[bool, int]:
    return cls.__module__ == protocol.__name__, inspect.getsourcelines(cls)[1]


def _struct_schema(struct: schema.StructType) -> StructSchema:
    docs = _field_docs(struct.cls)
    omits = struct.cls.__struct_config__.omit_defaults
    return StructSchema(
        name=struct.cls.__name__,
        tag=None if struct.tag is None else str(struct.tag),
        doc=inspect.cleandoc(struct.cls.__doc__ or ""),
        fields=tuple(
            FieldSchema(
                name=field.encode_name,
                type=field.type,
                optional=omits and not field.required,
                doc=docs.get(field.name, ""),
            )
            for field in struct.fields
        ),
    )


def _field_docs(cls: type) -> dict[str, str]:
    """The strings that follow the fields in the source of a struct."""
    body = ast.parse(textwrap.dedent(inspect.getsource(cls))).body[0]
    assert isinstance(body, ast.ClassDef)
    docs = {}
    for field, after in zip(body.body, body.body[1:], strict=False):
        match field, after:
            case ast.AnnAssign(target=ast.Name(id=name)), ast.Expr(value=ast.Constant(str(doc))):
                docs[name] = inspect.cleandoc(doc)
            case _:
                pass
    return docs
