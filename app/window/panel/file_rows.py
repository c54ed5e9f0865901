"""The rows of the panel that open and save files."""

from __future__ import annotations

from pathlib import Path

import polyscope.imgui as psim

from app.editor import commands as c
from app.editor.editor import Editor
from app.editor.file_actions import default_export_path, default_session_path, open_command
from app.window.panel.widgets import REST_OF_LINE

PATH_FIELD = psim.ImGuiInputTextFlags_EnterReturnsTrue | psim.ImGuiInputTextFlags_AutoSelectAll


class FileRows:
    """Holds what a person is typing into the path fields."""

    def __init__(self) -> None:
        self._open = ""
        self._session: str | None = None
        self._export: str | None = None
        self._used = ""

    def use(self, name: str) -> None:
        """As if a row had been used: "open" goes to its field, "save" and "export" do it.

        "export poses" does it where "export" would.
        """
        self._used = name

    def forget(self) -> None:
        """Another document is open: propose its own paths again."""
        self._session = self._export = None

    def draw(self, editor: Editor, asked: list[c.Command]) -> None:
        """The three rows; what was pressed goes into `asked`."""
        psim.SeparatorText("Files")
        if self._used == "open":
            psim.SetKeyboardFocusHere()
        self._open, go = _row("Open", "drop a file or type", self._open)
        if go and self._open.strip():
            asked.append(open_command(_path(self._open)))
        proposed = self._session or _short(default_session_path(editor))
        self._session, go = _row("Save session", "session (.json)", proposed)
        if go or self._used == "save":
            asked.append(c.SaveSession(_path(self._session)))
        proposed = self._export or _short(default_export_path(editor))
        self._export, go = _row("Export mesh", "deformed mesh", proposed)
        if go or self._used == "export":
            asked.append(c.Export(_path(self._export)))
        if self._used == "export poses":
            asked.append(c.ExportPoses(_path(self._export), editor.blend.between))
        self._used = ""


def _row(label: str, hint: str, text: str) -> tuple[str, bool]:
    """The text in the field now, and whether its button or Enter was pressed."""
    entered, text = psim.InputTextWithHint(f"##{label}", hint, text, PATH_FIELD)
    if psim.IsItemHovered() and text:
        psim.SetTooltip(text)
    psim.SameLine()
    pressed = psim.Button(label, REST_OF_LINE)
    return text, bool(pressed or entered)


def _path(text: str) -> Path:
    return Path(text.strip()).expanduser()


def _short(path: Path) -> str:
    """Relative to the working directory where it lies below."""
    try:
        return str(path.resolve().relative_to(Path.cwd()))
    except ValueError:
        return str(path)
