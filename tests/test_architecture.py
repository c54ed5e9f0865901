"""Rules of the whole tree: which part may import which."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
WINDOW = {"app.view", "app.panel", "app.input", "app.main"}
GRAPHICS = {"polyscope", "imgui"}


def modules() -> dict[str, Path]:
    files = [path for part in ("solver", "app") for path in (ROOT / part).rglob("*.py")]
    return {name_of(path): path for path in files}


def part_of_window(name: str) -> bool:
    return name in WINDOW or name.rpartition(".")[0] in WINDOW


def name_of(path: Path) -> str:
    return ".".join(path.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__")


def imports(path: Path, everywhere: bool = True) -> Iterator[str]:
    """Every dotted name a file imports; everywhere False: only when it is itself imported."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    for node in ast.walk(tree) if everywhere else tree.body:
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{path}: imports here are absolute"
            yield from (f"{node.module}.{alias.name}" for alias in node.names)


def dependencies(name: str, path: Path, known: dict[str, Path]) -> set[str]:
    """The project's modules that are imported when this one is."""
    found = set()
    for imported in imports(path, everywhere=False):
        target = imported if imported in known else imported.rpartition(".")[0]
        if target in known:
            found.add(target)
    return found - {name}


@pytest.mark.parametrize("name", sorted(modules()))
def test_only_the_window_knows_the_graphics_library(name: str) -> None:
    roots = {imported.split(".")[0] for imported in imports(modules()[name])}
    assert part_of_window(name) or not roots & GRAPHICS


@pytest.mark.parametrize("name", sorted(n for n in modules() if n.split(".")[0] == "solver"))
def test_the_solver_knows_nothing_of_the_application(name: str) -> None:
    roots = {imported.split(".")[0] for imported in imports(modules()[name])}
    assert "app" not in roots


def test_what_works_without_a_window_never_loads_one() -> None:
    known = modules()
    reached, todo = set(), ["app.editor"]
    while todo:
        name = todo.pop()
        if name not in reached:
            reached.add(name)
            todo += dependencies(name, known[name], known)
    assert "solver.deform" in reached
    assert not any(map(part_of_window, reached))


def test_no_module_imports_itself_in_a_circle() -> None:
    known = modules()
    graph = {name: dependencies(name, path, known) for name, path in known.items()}
    try:
        assert set(TopologicalSorter(graph).static_order()) >= set(known)
    except CycleError as error:
        pytest.fail(f"circular imports: {' -> '.join(error.args[1])}")
