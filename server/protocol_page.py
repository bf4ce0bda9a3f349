"""The protocol's page of the docs, generated: ``python -m server.protocol_page``."""

from __future__ import annotations

import inspect
import sys

import msgspec.inspect as schema

from server import protocol
from server.generated import ROOT, write_or_check
from server.schema import FieldSchema, StructSchema, constants, members, structs
from server.typescript import type_text

PATH = ROOT / "docs" / "protocol.md"
HEAD = "<!-- Generated from server/protocol.py by `python -m server.protocol_page`. -->\n# Protocol"
SECTIONS = {
    "ClientMessage": "Page to server",
    "ServerMessage": "Server to page",
    "FrameHeader": "Headers of binary frames, server to page",
}
BOUNDS = {
    "gt": "> {}", "ge": "≥ {}", "lt": "< {}", "le": "≤ {}",
    "min_length": "at least {} long", "max_length": "at most {} long", "pattern": "`{}`",
}  # fmt: skip


def protocol_page() -> str:
    """The text of docs/protocol.md."""
    by_name = {struct.name: struct for struct in structs()}
    parts = [HEAD, inspect.cleandoc(protocol.__doc__ or "").replace("``", "`"), _limits()]
    for union, title in SECTIONS.items():
        messages = [by_name.pop(member.__name__) for member in members(union)]
        parts += [f"## {title}", *map(_section, messages)]
    parts += ["## Parts of messages", *map(_section, by_name.values())]
    return "\n\n".join(parts) + "\n"


def _limits() -> str:
    rows = [f"| `{name}` | {value} |" for name, value in constants().items()]
    return "\n".join(["## Limits and close codes", "", "| Name | Value |", "|---|---|", *rows])


def _section(struct: StructSchema) -> str:
    title = f"### {struct.name}" + (f" — `{struct.tag}`" if struct.tag else "")
    rows = [_row(field) for field in struct.fields]
    table = ["", "| Field | Type | Limits | Meaning |", "|---|---|---|---|", *rows] if rows else []
    return "\n".join([title, "", struct.doc.replace("``", "`"), *table])


def _row(field: FieldSchema) -> str:
    kind = type_text(field.type).replace("|", "\\|")
    cells = f"`{field.name}`{' (optional)' if field.optional else ''}", f"`{kind}`"
    doc = " ".join(field.doc.replace("``", "`").split())
    return f"| {cells[0]} | {cells[1]} | {_bounds(field.type)} | {doc} |"


def _bounds(kind: schema.Type) -> str:
    """The limits of a type, and those of its items."""
    own = [
        text.format(value)
        for name, text in BOUNDS.items()
        if (value := getattr(kind, name, None)) is not None
    ]
    match kind:
        case schema.TupleType():
            inner = {_bounds(item) for item in kind.item_types}
        case schema.VarTupleType():
            inner = {_bounds(kind.item_type)}
        case schema.UnionType():
            return ", ".join(filter(None, map(_bounds, kind.types)))
        case _:
            inner = set()
    return ", ".join(own + [f"each {text}" for text in sorted(inner) if text])


if __name__ == "__main__":
    sys.exit(write_or_check(PATH, protocol_page(), command="server.protocol_page"))
