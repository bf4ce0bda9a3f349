"""TypeScript types of the wire, generated from ``protocol.py``: ``python -m server.typescript``."""

from __future__ import annotations

import json
import sys

import msgspec.inspect as schema

from server.generated import ROOT, write_or_check
from server.schema import (
    UNIONS,
    FieldSchema,
    StructSchema,
    constants,
    members,
    named_literals,
    structs,
)

PATH = ROOT / "web" / "src" / "net" / "protocol.gen.ts"
HEAD = """\
// Generated from server/protocol.py by `python -m server.typescript`. Do not edit.
// Core frame: metres, z up, headings in radians anticlockwise from +x.
"""

SCALARS: dict[type[schema.Type], str] = {
    schema.IntType: "number",
    schema.FloatType: "number",
    schema.StrType: "string",
    schema.BoolType: "boolean",
    schema.NoneType: "null",
}


def typescript() -> str:
    """The text of the generated file."""
    parts = [
        HEAD,
        "\n".join(f"export const {name} = {_json(value)};" for name, value in constants().items()),
        "\n".join(
            f"export type {name} = {_literals(values)};"
            for values, name in named_literals().items()
        ),
        *map(_interface, structs()),
        *(f"export type {union} =\n{_union(union)};" for union in UNIONS),
    ]
    return "\n\n".join(part.strip("\n") for part in parts) + "\n"


def type_text(kind: schema.Type) -> str:
    """A type of the protocol in TypeScript; TypeError if it has no counterpart."""
    match kind:
        case schema.LiteralType():
            values = frozenset(kind.values)
            text = named_literals().get(values) or _literals(values)
        case schema.StructType():
            text = kind.cls.__name__
        case schema.UnionType():
            text = " | ".join(map(type_text, kind.types))
        case schema.TupleType():
            text = f"readonly [{', '.join(map(type_text, kind.item_types))}]"
        case schema.VarTupleType():
            text = f"readonly {_item(kind.item_type)}[]"
        case schema.DictType():
            text = f"Readonly<Record<string, {type_text(kind.value_type)}>>"
        case _ if type(kind) in SCALARS:
            text = SCALARS[type(kind)]
        case _:
            raise TypeError(f"{kind} has no TypeScript type; give the message a simpler field")
    return text


def _item(kind: schema.Type) -> str:
    text = type_text(kind)
    return f"({text})" if " " in text else text


def _interface(struct: StructSchema) -> str:
    lines = [_comment(struct.doc, ""), f"export interface {struct.name} {{"]
    if struct.tag is not None:
        lines.append(f"  readonly type: {_json(struct.tag)};")
    for field in struct.fields:
        lines += [_comment(field.doc, "  ")] if field.doc else []
        lines.append(f"  {_field(field)}")
    return "\n".join([*lines, "}"])


def _field(field: FieldSchema) -> str:
    return f"readonly {field.name}{'?' if field.optional else ''}: {type_text(field.type)};"


def _comment(doc: str, indent: str) -> str:
    lines = doc.replace("``", "`").replace("None", "null").splitlines()
    if len(lines) == 1:
        return f"{indent}/** {lines[0]} */"
    body = "\n".join(f"{indent} * {line}".rstrip() for line in lines)
    return f"{indent}/**\n{body}\n{indent} */"


def _union(union: str) -> str:
    return "\n".join(f"  | {member.__name__}" for member in members(union))


def _literals(values: frozenset[object]) -> str:
    return " | ".join(sorted(map(_json, values)))


def _json(value: object) -> str:
    return json.dumps(value, ensure_ascii=False)


if __name__ == "__main__":
    sys.exit(write_or_check(PATH, typescript(), command="server.typescript"))
