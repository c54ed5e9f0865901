"""Rules of the whole tree: which room may import which."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from graphlib import TopologicalSorter
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
# Rooms from the ground up: each may import from those above it in this list, and from its own.
LAYERS = (
    "solver.errors solver.types solver.arrays solver.storage",
    "solver.factor",
    "solver.geometry",
    "solver.forms",
    "solver.mesh solver.softness solver.measure",
    "solver.setup",
    "solver.surface",
    "solver.linear",
    "solver.rigid",
    "solver.bound_surface",
    "solver.deformer",
    "solver",
    "app app.bundled app.graphics",
    "app.model",
    "app.worker",
    "app.workspace",
    "app.tools",
    "app.editor",
    "app.window",
    "app.headless app.figures app.demo",
    "app.__main__",
)
LEVEL = {room: level for level, rooms in enumerate(LAYERS) for room in rooms.split()}
GRAPHICS = {"polyscope", "imgui"}


def name_of(path: Path) -> str:
    return ".".join(path.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__")


MODULES = {
    name_of(path): path for part in ("solver", "app") for path in (ROOT / part).rglob("*.py")
}


def room_of(name: str) -> str:
    """The entry of the table that a module belongs to: the longest that begins its name."""
    parts = name.split(".")
    names = (".".join(parts[:size]) for size in range(len(parts), 0, -1))
    return next(room for room in names if room in LEVEL)


def imports(name: str) -> Iterator[tuple[str, bool]]:
    """Every dotted name a module imports, and whether it does so when it is itself imported."""
    tree = ast.parse(MODULES[name].read_text(encoding="utf-8"))
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from ((alias.name, node in tree.body) for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{name}: imports here are absolute"
            yield from ((f"{node.module}.{alias.name}", node in tree.body) for alias in node.names)


def dependencies(name: str, at_import: bool = False) -> set[str]:
    """The project's modules that one imports; at_import: only those it cannot do without."""
    found = set()
    for imported, top in imports(name):
        target = imported if imported in MODULES else imported.rpartition(".")[0]
        if target in MODULES and (top or not at_import):
            found.add(target)
    return found - {name}


@pytest.mark.parametrize("name", sorted(MODULES))
def test_imports_go_down_and_only_the_window_knows_the_graphics_library(name: str) -> None:
    above = {other for other in dependencies(name) if LEVEL[room_of(other)] > LEVEL[room_of(name)]}
    assert not above
    roots = {imported.split(".")[0] for imported, _ in imports(name)}
    assert room_of(name) == "app.window" or not roots & GRAPHICS


def test_what_works_without_a_window_never_loads_one() -> None:
    reached, todo = set(), ["app.headless", "app.editor.editor", "app.demo", "app.figures"]
    while todo:
        name = todo.pop()
        if name not in reached:
            reached.add(name)
            todo += dependencies(name, at_import=True)
    assert "solver.deformer" in reached
    assert "app.window" not in set(map(room_of, reached))


def test_no_module_imports_itself_in_a_circle() -> None:
    graph = {name: dependencies(name, at_import=True) for name in MODULES}
    assert set(TopologicalSorter(graph).static_order()) == set(MODULES)
