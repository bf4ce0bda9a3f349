"""Imports run one way: scene, graph, knowledge, placement, evaluation and study, server, web."""

from __future__ import annotations

import ast
import posixpath
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent

CORE_MAY_IMPORT = {
    "errors": set[str](),
    "scene": {"errors"},
    "graph": {"errors", "scene"},
    "knowledge": {"errors", "scene", "graph"},
    "placement": {"errors", "scene", "graph", "knowledge"},
    "datasets": {"errors", "scene"},
    "evaluation": {"errors", "scene", "graph", "knowledge", "placement", "datasets"},
    "study": {"errors", "scene", "graph", "knowledge", "placement"},
    "annotation": {"errors", "scene"},
}
SOCKETS = {"asyncio", "http", "socket", "starlette", "urllib", "uvicorn", "websockets"}

TYPES = "net/protocol.gen"
WEB_MAY_IMPORT = {
    "model": {"model", TYPES},
    "net": {"net", "model"},
    "views": {"views", "model", TYPES, "net/assets", "three"},
    "ui": {"ui", "model", TYPES},
}
IMPORT = re.compile(r"""(?:\bfrom|\bimport)\s*\(?\s*["']([^"']+)["']""")
COMMENT = re.compile(r"/\*.*?\*/|^\s*//.*?$", re.DOTALL | re.MULTILINE)
BROWSER = re.compile(r"\b(?:document|window|navigator|localStorage|WebSocket)\s*[.(]")


def python_imports(source: str, module: str) -> set[str]:
    """Every module that a source file imports, by its full name, at whatever depth."""
    package = module.split(".")[:-1]
    found = set[str]()
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import):
            found.update(alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            above = package[: len(package) - node.level + 1] if node.level else []
            base = ".".join([*above, node.module] if node.module else above)
            found.update(f"{base}.{alias.name}" for alias in node.names)
    return found


def core_violations(source: str, module: str) -> list[str]:
    """What a module of the core imports against the order."""
    layer = module.split(".")[1]
    allowed = CORE_MAY_IMPORT[layer] | {layer}
    wrong = []
    for name in sorted(python_imports(source, module)):
        first, *rest = name.split(".")
        if (first == "scenegen_core" and rest and rest[0] not in allowed) or (
            first in SOCKETS | {"server", "tests"}
        ):
            wrong.append(name)
    return wrong


def web_violations(source: str, path: str) -> list[str]:
    """What a page module imports against the order; ``path`` counts from web/src."""
    layer = path.split("/", 1)[0]
    wrong = []
    for name in IMPORT.findall(COMMENT.sub("", source)):
        target = posixpath.normpath(posixpath.join(posixpath.dirname(path), name))
        target = (target if name.startswith(".") else name).removesuffix(".ts").removesuffix(".js")
        if WEB_MAY_IMPORT[layer].isdisjoint({target, target.split("/", 1)[0]}):
            wrong.append(name)
    return wrong


CORE_MODULES = {
    ".".join(path.relative_to(ROOT).with_suffix("").parts): path
    for path in sorted((ROOT / "scenegen_core").rglob("*.py"))
    if path.parent.name != "scenegen_core" or path.name != "__init__.py"
}
WEB_MODULES = {
    path.relative_to(ROOT / "web/src").as_posix(): path
    for layer in WEB_MAY_IMPORT
    for path in sorted((ROOT / "web/src" / layer).rglob("*.ts"))
    if not path.name.endswith((".test.ts", ".gen.ts"))
}


@pytest.mark.parametrize(("module", "path"), CORE_MODULES.items())
def test_a_module_of_the_core_imports_only_from_the_layers_below(module: str, path: Path) -> None:
    assert core_violations(path.read_text(), module) == []


@pytest.mark.parametrize(("name", "path"), WEB_MODULES.items())
def test_a_module_of_the_page_imports_only_what_its_folder_may(name: str, path: Path) -> None:
    assert web_violations(path.read_text(), name) == []


def test_the_protocol_knows_only_the_records_of_scenes() -> None:
    imports = python_imports((ROOT / "server/protocol.py").read_text(), "server.protocol")
    own = {name.rpartition(".")[0] for name in imports if name.startswith(("scenegen", "server"))}
    assert own == {"scenegen_core.scene.files"}


def test_the_model_of_the_page_never_touches_the_browser() -> None:
    for path in (ROOT / "web/src/model").rglob("*.ts"):
        if not path.name.endswith(".test.ts"):
            assert BROWSER.findall(COMMENT.sub("", path.read_text())) == [], path


@pytest.mark.parametrize(
    ("source", "module"),
    [
        ("from scenegen_core.graph.relations import RELATIONS", "scenegen_core.scene.model"),
        ("from scenegen_core import placement", "scenegen_core.knowledge.density"),
        ("import scenegen_core.evaluation.folds", "scenegen_core.study.design"),
        ("from scenegen_core.graph import relations", "scenegen_core.datasets.rows"),
        ("from ..placement import score", "scenegen_core.graph.relations"),
        ("def late():\n    import server.protocol", "scenegen_core.scene.files"),
        ("import asyncio", "scenegen_core.placement.score"),
    ],
)
def test_an_import_against_the_order_of_the_core_is_found(source: str, module: str) -> None:
    assert len(core_violations(source, module)) == 1


@pytest.mark.parametrize(
    ("source", "path"),
    [
        ('import { Vector3 } from "three";', "model/drawing.ts"),
        ('import { show } from "../views/boxes";', "model/reduce.ts"),
        ('import type { Connection } from "../net/connection";', "model/state.ts"),
        ('import { Outbox } from "../net/outbox";', "views/boxes.ts"),
        ('import {\n  a,\n  b,\n} from "../ui/panel";', "views/boxes.ts"),
        ('const late = await import("../views/room");', "net/connection.ts"),
        ('export { x } from "../views/room";', "ui/panel.ts"),
        ('import "three/addons/controls/OrbitControls.js";', "model/handles.ts"),
    ],
)
def test_an_import_against_the_order_of_the_page_is_found(source: str, path: str) -> None:
    assert len(web_violations(source, path)) == 1


@pytest.mark.parametrize(
    ("source", "path"),
    [
        ('import type { Graph } from "../net/protocol.gen";', "model/state.ts"),
        ('import * as THREE from "three/webgpu";', "views/room.ts"),
        ('import { model } from "../net/assets";', "views/boxes.ts"),
        ('// import { x } from "three";\nimport { reduce } from "./reduce";', "model/state.ts"),
    ],
)
def test_an_import_along_the_order_of_the_page_passes(source: str, path: str) -> None:
    assert web_violations(source, path) == []


def test_touching_the_browser_is_found() -> None:
    assert BROWSER.search("const width = window.innerWidth;") is not None
