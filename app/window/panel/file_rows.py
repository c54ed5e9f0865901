"""The rows of the panel that open and save files."""

from __future__ import annotations

from pathlib import Path

import polyscope.imgui as psim

from app.editor import commands as c
from app.editor.editor import Editor
from app.editor.files.actions import open_command
from app.editor.files.paths import default_export_path, default_session_path
from app.model.session.files import session_name
from app.telling import readable
from app.window.file_dialogs import POSED, FileDialogs
from app.window.panel.widgets import (
    REST_OF_LINE,
    disabled,
    shares,
    short_path,
    shortened,
    text_field,
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
        self._session, self._export = _PathField(), _PathField()
        self._posed = dict.fromkeys(POSED, "")
        self._used = ""

    def use(self, name: str) -> None:
        """As if a row had been used: "open", "learn" and "add pose" go to their fields,
        "save" and "export" do it.

        "export poses" does it where "export" would.
        """
        self._used = name

    @property
    def used(self) -> bool:
        """Whether they have to be drawn, for `use` to come true."""
        return bool(self._used)

    def forget(self) -> None:
        """Another document is open: propose its own paths again."""
        self._session, self._export = _PathField(), _PathField()

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
                psim.SetItemTooltip(readable(tip))

    def _fields(self, editor: Editor, asked: list[c.Command]) -> None:
        if self._used == "open":
            psim.SetKeyboardFocusHere()
        self._open, go = _row("Open", "drop a file or type", self._open)
        if go and self._open.strip():
            asked.append(open_command(typed_path(self._open)))
        for name, label in (("learn", "Learn from"), ("add pose", "Add pose")):
            if self._used == name:
                psim.SetKeyboardFocusHere()
            self._posed[name], go = _row(label, "the mesh in a pose", self._posed[name])
            if go and self._posed[name].strip():
                asked.append(POSED[name](typed_path(self._posed[name])))
        proposed = default_session_path(editor)
        session, go = self._session.draw("Save session", "session (.json)", proposed)
        if go or self._used == "save":
            asked.append(c.SaveSession(session_name(typed_path(session))))
        proposed = default_export_path(editor)
        mesh, go = self._export.draw("Export mesh", "deformed mesh", proposed)
        if go or self._used == "export":
            asked.append(c.Export(typed_path(mesh)))
        if self._used == "export poses":
            asked.append(c.ExportPoses(typed_path(mesh), editor.blend.between))


class _PathField:
    """A row with a path that a person may type over, until another one is proposed."""

    def __init__(self) -> None:
        self._proposed: Path | None = None
        self._text = ""

    def draw(self, label: str, hint: str, proposed: Path) -> tuple[str, bool]:
        """As _row, but that an empty text stands for what is proposed."""
        if proposed != self._proposed or not self._text:
            self._proposed, self._text = proposed, short_path(proposed)
        self._text, go = _row(label, hint, self._text)
        return self._text, go


def _recent(editor: Editor, asked: list[c.Command]) -> None:
    """The files opened or saved last, as a list that folds out."""
    paths = editor.recent.paths
    with disabled(not paths):
        if not psim.BeginCombo("##recent", "Recent"):
            return
        for number, path in enumerate(paths):
            name = readable(f"{path.parent.name}/{path.name}")
            name = shortened(name, scaled(RECENT_WIDTH))
            if psim.Selectable(f"{name}##{number}"):
                asked.append(open_command(path))
            psim.SetItemTooltip(readable(str(path)))
        psim.EndCombo()


def _row(label: str, hint: str, text: str) -> tuple[str, bool]:
    """The text in the field now, and whether its button or Enter was pressed."""
    entered, text = text_field(f"##{label}", text, hint, PATH_FIELD)
    if psim.IsItemHovered() and text:
        psim.SetTooltip(readable(text))
    psim.SameLine()
    pressed = psim.Button(label, REST_OF_LINE)
    return text, bool(pressed or entered)
