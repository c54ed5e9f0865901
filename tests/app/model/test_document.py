"""What a document asks of the solver."""

from __future__ import annotations

from pathlib import Path

import pytest

from app.model import settings
from app.model.document import Document
from tests.app.person import slab


def test_large_meshes_have_frames_on_a_coarse_one_unless_a_person_says_otherwise(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    document = Document(slab(20, 4, 2.0), Path("mesh.obj"))
    assert document.setup().coarse is None
    document.change("coarse", 50)
    assert document.setup().coarse == 50
    monkeypatch.setattr(settings, "LARGE", 100)
    document.change("coarse", True)
    assert document.setup().coarse == settings.COARSE
    document.change("coarse", False)
    assert document.setup().coarse is None
