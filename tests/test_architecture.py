"""Rules of the whole tree: which room may import which."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
# Rooms from the ground up: each may import from those above it in this list, and from its own.
LAYERS = (
    "solver.errors solver.types solver.limits solver.nesting solver.arrays solver.storage",
    "solver.factor",
    "solver.geometry",
    "solver.forms",
    "solver.mesh solver.softness solver.measure",
    "solver.setup",
    "solver.surface",
    "solver.linear",
    "solver.rigid",
    "solver.coarse",
    "solver.learning",
    "solver.bound_surface",
    "solver.coarse_surface",
    "solver.drag",
    "solver.deformer",
    "solver",
    "app app.bundled app.graphics app.latest",
    "app.model",
    "app.worker",
    "app.viewpoint",
    "app.selection app.scene",
    "app.pointing app.live",
    "app.workspace",
    "app.unsaved",
    "app.tools",
    "app.editor app.dialogs",
    "app.window",
    "app.headless app.learning app.figures app.demo",
    "app.__main__",
)
LEVEL = {room: level for level, rooms in enumerate(LAYERS) for room in rooms.split()}
PATHS = [path for part in ("solver", "app") for path in (ROOT / part).rglob("*.py")]
MODULES = {
    ".".join(path.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__"): path
    for path in PATHS
}


def room_of(name: str) -> str:
    """The entry of the table that a module belongs to: the longest that begins its name."""
    return max((room for room in LEVEL if f"{name}.".startswith(f"{room}.")), key=len)


def imports(name: str) -> dict[str, bool]:
    """The dotted names that a module imports, and whether it cannot be loaded without them."""
    found: dict[str, bool] = {}
    tree = ast.parse(MODULES[name].read_text(encoding="utf-8"))
    for node in ast.walk(tree):
        if isinstance(node, ast.Import | ast.ImportFrom):
            source = f"{node.module}." if isinstance(node, ast.ImportFrom) else ""
            found |= {f"{source}{alias.name}": node in tree.body for alias in node.names}
    # "from a.b import c" names the module a.b, unless c is one itself.
    return {n if n in MODULES else n.rpartition(".")[0] or n: at for n, at in found.items()}


def loaded(name: str) -> set[str]:
    """The modules that have to be loaded before one: what it imports, and packages on the way."""
    direct = {n for n, at in imports(name).items() if at and n in MODULES} - {name}
    packages = {
        ".".join(parts[:length])
        for parts in (n.split(".") for n in direct)
        for length in range(1, len(parts))
    }
    return direct | {p for p in packages if not f"{name}.".startswith(f"{p}.")}


@pytest.mark.parametrize("name", sorted(MODULES))
def test_imports_go_down_and_only_the_window_knows_the_graphics_library(name: str) -> None:
    own = {other for other in imports(name) if other in MODULES}
    assert not {other for other in own if LEVEL[room_of(other)] > LEVEL[room_of(name)]}
    assert room_of(name) == "app.window" or "polyscope" not in {
        n.split(".")[0] for n in imports(name)
    }


def test_nothing_imports_itself_and_what_needs_no_window_loads_none() -> None:
    needs = {module: loaded(module) for module in MODULES}
    for start in MODULES:
        reached, todo = set[str](), list(needs[start])
        while todo:
            name = todo.pop()
            todo += [] if name in reached else needs[name]
            reached.add(name)
        assert start not in reached
        if start in ("app.editor.editor", "app.headless", "app.demo", "app.figures"):
            assert "app.window" not in set(map(room_of, reached))
