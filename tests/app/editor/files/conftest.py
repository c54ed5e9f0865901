from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from solver import load_mesh
from tests.app.person import Person, slab


@pytest.fixture
def opened(tmp_path: Path) -> Iterator[Person]:
    """The bar, opened from bar.obj, its left end fixed, its right end a handle."""
    mesh = slab(20, 4, 2.0)
    mesh.save(tmp_path / "bar.obj", mesh.vertices)
    person = Person(load_mesh(tmp_path / "bar.obj"), tmp_path / "bar.obj")
    person.ready_bar()
    yield person
    person.editor.close()
