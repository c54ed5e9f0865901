"""Reading a file can be taken back, and the window be closed meanwhile."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from app.workspace.tasks import Cancelled
from solver import load_mesh
from tests.app.person import slab

pytest.importorskip("polyscope")

from app.window import progress_frames  # needs the graphics library
from app.window.progress_frames import ProgressFrames


class Screen:
    """In place of the graphics library: draws frames for nobody. closes: after how many."""

    def __init__(self, closes: int | None = None, escapes: int | None = None) -> None:
        self.frames = 0
        self.ImGuiKey_Escape = 0
        self._closes, self._escapes = closes, escapes
        self._draw: Callable[[], object] = lambda: None

    def set_user_callback(self, draw: Callable[[], object]) -> None:
        self._draw = draw

    def frame_tick(self) -> None:
        self.frames += 1
        self._draw()

    def window_requests_close(self) -> bool:
        return self.frames == self._closes

    def IsKeyPressed(self, key: int) -> bool:
        return self.frames == self._escapes


@pytest.mark.parametrize("end", ["closes", "escapes", None])
def test_reading_stops_when_the_window_is_closed_or_escape_is_pressed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, end: str | None
) -> None:
    mesh = slab(20, 20, 2.0)
    mesh.save(tmp_path / "a.obj", mesh.vertices)
    screen = Screen(**({end: 1} if end else {}))
    for name in ("ps", "psim"):
        monkeypatch.setattr(progress_frames, name, screen)
    monkeypatch.setattr(progress_frames, "overlay", lambda *arguments, **more: None)
    monkeypatch.setattr(progress_frames, "PAUSE", 0.0)
    told = ProgressFrames("Loading ...", lambda: None)
    if end is None:
        assert len(load_mesh(tmp_path / "a.obj", told).vertices) == len(mesh.vertices)
        assert screen.frames > 1
        return
    with pytest.raises(Cancelled, match="loading was cancelled"):
        load_mesh(tmp_path / "a.obj", told)
    assert screen.frames == 1
