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
    "contract": {"model"},
    "store": {"model"},
    "net": {"net", "model", "contract", "store"},
    "views": {"views", "model", TYPES, "contract", "three"},
    "xr": {"xr", "views", "model", TYPES, "contract", "store", "three"},
    "ui": {"ui", "model", TYPES, "contract", "store", "styles", "lit"},
}
"""Folders and modules of web/src; what wires them together (main, services) may import all."""
IMPORT = re.compile(r"""(?:\bfrom|\bimport)\s*\(?\s*["']([^"']+)["']""")
COMMENT = re.compile(r"/\*.*?\*/|^\s*//.*?$", re.DOTALL | re.MULTILINE)
BROWSER = re.compile(r"\b(?:document|window|navigator|localStorage|WebSocket)\s*(?:\.\s*\w|\()")


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
    layer = path.removesuffix(".ts").split("/", 1)[0]
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
WEB = ROOT / "web/src"
WEB_MODULES = {
    path.relative_to(WEB).as_posix(): path
    for layer in WEB_MAY_IMPORT
    for path in sorted([*WEB.glob(f"{layer}.ts"), *WEB.glob(f"{layer}/**/*.ts")])
    if not path.name.endswith((".test.ts", ".gen.ts"))
}


@pytest.mark.parametrize("module", CORE_MODULES)
def test_a_module_of_the_core_imports_only_from_the_layers_below(module: str) -> None:
    assert core_violations(CORE_MODULES[module].read_text(), module) == []


@pytest.mark.parametrize("name", WEB_MODULES)
def test_a_module_of_the_page_imports_only_what_its_folder_may(name: str) -> None:
    assert web_violations(WEB_MODULES[name].read_text(), name) == []


def test_the_protocol_knows_only_the_records_of_scenes() -> None:
    imports = python_imports((ROOT / "server/protocol.py").read_text(), "server.protocol")
    own = {name.rpartition(".")[0] for name in imports if name.startswith(("scenegen", "server"))}
    assert own == {"scenegen_core.scene.files"}


def test_the_logic_of_a_session_knows_no_sockets() -> None:
    imports = python_imports((ROOT / "server/session.py").read_text(), "server.session")
    assert SOCKETS.isdisjoint(name.partition(".")[0] for name in imports)


def test_the_model_of_the_page_never_touches_the_browser() -> None:
    for name, path in WEB_MODULES.items():
        if name.startswith("model/"):
            assert BROWSER.findall(COMMENT.sub("", path.read_text())) == [], name


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
        ('import { Vector3 } from "three";', "ui/panel.ts"),
        ('import type { Connection } from "./net/connection";', "contract.ts"),
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
        ('import type { Assets } from "../contract";', "views/boxes.ts"),
        ('import { repeat } from "lit/directives/repeat.js";', "ui/panel.ts"),
        ('// import { x } from "three";\nimport { reduce } from "./reduce";', "model/state.ts"),
    ],
)
def test_an_import_along_the_order_of_the_page_passes(source: str, path: str) -> None:
    assert web_violations(source, path) == []


def test_touching_the_browser_is_found() -> None:
    assert BROWSER.search("const width = window.innerWidth;") is not None
