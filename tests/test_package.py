"""What is installed: all that pyproject.toml names is there, and all that runs is named."""

from __future__ import annotations

import tomllib
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest

from app.bundled import ASSETS, DEFAULT_MESH, DEFAULT_SESSION
from tests.app.command import run

ROOT = Path(__file__).resolve().parents[1]
PROJECT: dict[str, Any] = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
SETUPTOOLS = PROJECT["tool"]["setuptools"]


def test_the_command_is_the_command_line_of_the_program() -> None:
    for target in PROJECT["project"]["scripts"].values():
        module, name = target.split(":")
        assert callable(getattr(import_module(module), name))


def test_the_installed_command_speaks_by_its_own_name() -> None:
    program = "import sys; sys.argv[0] = '/bin/surface-deformation'; import app.__main__ as m; "
    done = run("info", "no-such.obj", code=f"{program}sys.exit(m.main())")
    assert done.returncode == 2
    assert done.stderr.startswith("surface-deformation: no-such.obj: ")


def test_dependencies_come_from_the_requirements_files() -> None:
    dynamic = SETUPTOOLS["dynamic"]
    for entry in (dynamic["dependencies"], *dynamic["optional-dependencies"].values()):
        assert (ROOT / entry["file"]).read_text(encoding="utf-8").strip()


@pytest.mark.parametrize("package", ["solver", "app"])
def test_every_folder_of_modules_is_installed(package: str) -> None:
    """A folder without __init__.py works in the tree and is missing where it is installed."""
    for module in (ROOT / package).rglob("*.py"):
        assert (module.parent / "__init__.py").exists(), module
    assert (ROOT / package / "py.typed").exists()
    assert "py.typed" in SETUPTOOLS["package-data"][package]


def test_the_bundled_files_are_installed() -> None:
    assert ASSETS.parent == ROOT
    patterns = SETUPTOOLS["package-data"]["assets"]
    installed = {path for pattern in patterns for path in ASSETS.glob(pattern)}
    assert {DEFAULT_MESH, DEFAULT_SESSION} <= installed
