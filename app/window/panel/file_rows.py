"""The rows of the panel that open and save files."""

from __future__ import annotations

import polyscope.imgui as psim

from app.editor import commands as c
from app.editor.editor import Editor
from app.editor.file_actions import default_export_path, default_session_path, open_command
from app.window.file_dialogs import FileDialogs
from app.window.panel.widgets import (
    REST_OF_LINE,
    disabled,
    shares,
    short_path,
    shortened,
    typed_path,
)
from app.window.scaling import scaled
from app.window.shortcuts import WindowAction

PATH_FIELD = psim.ImGuiInputTextFlags_EnterReturnsTrue | psim.ImGuiInputTextFlags_AutoSelectAll
RECENT_WIDTH = 420.0  # of the list, which may be wider than the panel
# Each does it where it was done before, or asks; the second always asks.
BUTTONS = (("Save session", "Save as...", "save"), ("Export mesh", "Export as...", "export"))


class FileRows:
    """Buttons that open dialogs; where there are none, fields, and what is typed into them."""

    def __init__(self, dialogs: FileDialogs) -> None:
        self._dialogs = dialogs
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
        """What was pressed goes into `asked`."""
        if self._dialogs.available:
            self._buttons(editor, asked)
        else:
            self._fields(editor, asked)
            psim.SetNextItemWidth(REST_OF_LINE[0])
            _recent(editor, asked)
        self._used = ""

    def _buttons(self, editor: Editor, asked: list[c.Command]) -> None:
        for label, size in shares("Open...", "recent"):
            if label == "recent":
                psim.SetNextItemWidth(size[0])
                _recent(editor, asked)
            elif psim.Button(label, size):
                asked.append(WindowAction("open"))
        for label, asking, name in BUTTONS:
            known = self._dialogs.known(name, editor)
            tips = "Asks for a name" if known is None else str(known), f"{label} under another name"
            actions = name, f"{name} as"
            for (text, size), tip, action in zip(shares(label, asking), tips, actions, strict=True):
                if psim.Button(text, size):
                    asked.append(WindowAction(action))
                psim.SetItemTooltip(tip)

    def _fields(self, editor: Editor, asked: list[c.Command]) -> None:
        if self._used == "open":
            psim.SetKeyboardFocusHere()
        self._open, go = _row("Open", "drop a file or type", self._open)
        if go and self._open.strip():
            asked.append(open_command(typed_path(self._open)))
        proposed = self._session or short_path(default_session_path(editor))
        self._session, go = _row("Save session", "session (.json)", proposed)
        if go or self._used == "save":
            asked.append(c.SaveSession(typed_path(self._session)))
        proposed = self._export or short_path(default_export_path(editor))
        self._export, go = _row("Export mesh", "deformed mesh", proposed)
        if go or self._used == "export":
            asked.append(c.Export(typed_path(self._export)))
        if self._used == "export poses":
            asked.append(c.ExportPoses(typed_path(self._export), editor.blend.between))


def _recent(editor: Editor, asked: list[c.Command]) -> None:
    """The files opened or saved last, as a list that folds out."""
    paths = editor.recent.paths
    with disabled(not paths):
        if not psim.BeginCombo("##recent", "Recent"):
            return
        for number, path in enumerate(paths):
            name = shortened(f"{path.parent.name}/{path.name}", scaled(RECENT_WIDTH))
            if psim.Selectable(f"{name}##{number}"):
                asked.append(open_command(path))
            psim.SetItemTooltip(str(path))
        psim.EndCombo()


def _row(label: str, hint: str, text: str) -> tuple[str, bool]:
    """The text in the field now, and whether its button or Enter was pressed."""
    entered, text = psim.InputTextWithHint(f"##{label}", hint, text, PATH_FIELD)
    if psim.IsItemHovered() and text:
        psim.SetTooltip(text)
    psim.SameLine()
    pressed = psim.Button(label, REST_OF_LINE)
    return text, bool(pressed or entered)
