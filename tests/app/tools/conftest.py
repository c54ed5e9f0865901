from __future__ import annotations

import pytest

from solver import Mesh
from tests.app.person import Person, sheet


@pytest.fixture
def person() -> Person:
    """A sheet of 30 x 20 and the softness brush with a radius of 4."""
    made = Person(Mesh.from_arrays(*sheet(30, 20)))
    made.use("softness", 4)
    return made
