"""What the window remembers of a person: its size, that of the interface, recent files."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import polyscope as ps

from app.bundled import is_bundled
from app.editor.editor import Editor
from app.model.preferences import PreferencesFile
from app.telling import tell
from app.window.opening import open_window
from app.window.scaling import set_scale
from app.workspace.recent import Recent

SMALLEST_WINDOW = 300  # pixels: a window that is folded away says it has fewer


class Remembered:
    """Connects the preferences with the window. file: of the preferences."""

    def __init__(self, file: PreferencesFile) -> None:
        self.file = file
        self._screen = 1.0
        self._editor: Editor | None = None
        self._told = ""

    def open_window(self) -> None:
        """As large as it was. Raises GraphicsError."""
        values = self.file.values
        self._screen = open_window(values.interface_scale, values.window)

    def attach(self, editor: Editor) -> None:
        """An editor whose files are to be remembered, and who is told what is wrong."""
        self._editor = editor
        editor.recent = Recent(map(Path, self.file.values.recent), self._keep_recent)
        opened = editor.session_path or editor.document.path
        if not is_bundled(opened):
            editor.recent.add(opened)
        self._tell()

    def set_interface(self, scale: float | None) -> None:
        """How large the interface is drawn; None: as the screen asks."""
        self._change(interface_scale=scale)
        set_scale(self._screen if scale is None else scale)

    def keep_window(self) -> None:
        """The next window opens as large as this one."""
        size = ps.get_window_size()
        if min(size) >= SMALLEST_WINDOW:
            self._change(window=tuple(size))

    def _keep_recent(self, paths: tuple[Path, ...]) -> None:
        self._change(recent=tuple(map(str, paths)))

    def _change(self, **changes: Any) -> None:
        self.file.change(**changes)
        self._tell()

    def _tell(self) -> None:
        """Once, that preferences are not read or kept."""
        if self.file.fault and self.file.fault != self._told:
            self._told = self.file.fault
            tell(self._told, error=True)
            if self._editor is not None:
                self._editor.say(self._told, "error")
