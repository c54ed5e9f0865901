"""Names that no file has yet."""

from __future__ import annotations

from pathlib import Path

from app.model.free_path import free_path


def test_the_first_that_is_free(tmp_path: Path) -> None:
    for name in ("a.b.png", "a.b-2.png", "a.b-3.png"):
        assert free_path(tmp_path / "a.b.png") == tmp_path / name
        (tmp_path / name).touch()
    (tmp_path / "a.b-2.png").unlink()
    assert free_path(tmp_path / "a.b.png") == tmp_path / "a.b-2.png"
