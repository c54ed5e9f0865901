"""Which dialog a key or button opens, and the command that its answer becomes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from app.bundled import ASSETS
from app.dialogs.dialogs import Dialogs
from app.dialogs.question import Answer, Kind, Question
from app.editor import commands as c
from app.editor.editor import Editor
from app.editor.file_actions import (
    default_export_path,
    default_session_path,
    open_command,
    spare_mesh,
)
from app.window.film import TakeFilm, default_film_path
from app.window.film_files import FILMS
from solver.mesh.formats.table import FORMATS

MESHES = Kind("Meshes", tuple(FORMATS))
SESSIONS = Kind("Sessions", (".json",))
EXPORTS = "export", "export poses"  # both go where the last one went
FILM_NAMES = "turntable", "record"
BOTH = Kind("Meshes and sessions", (*FORMATS, ".json"))
FILM = Kind("Films", tuple(FILMS))


class FileDialogs:
    """Opens, saves and exports as a person says in a dialog, or where they said it before."""

    def __init__(self, dialogs: Dialogs) -> None:
        self._dialogs = dialogs
        self._exported: Path | None = None

    @property
    def available(self) -> bool:
        """Whether there are dialogs."""
        return self._dialogs.available

    def forget(self) -> None:
        """Another document is open: none has been exported, and no dialog is about the last."""
        self._exported = None
        self._dialogs.close()

    def act(self, name: str, editor: Editor) -> c.Command | None:
        """What "open", "save", "save as", "export", "export as", "export poses" and the names of
        films ask for.

        None where a dialog was opened to find out. Raises DialogError.
        """
        known = self.known(name, editor)
        if known is not None:
            return _command(name, known, editor)
        self._dialogs.ask(QUESTIONS[name.removesuffix(" as")](editor))
        return None

    def known(self, name: str, editor: Editor) -> Path | None:
        """Where a file goes without being asked for; None where that has not been said yet."""
        if name in EXPORTS:
            return self._exported or editor.export_path
        session = editor.session_path
        if name != "save" or session is None or session.resolve().is_relative_to(ASSETS):
            return None
        return session

    def poll(self, editor: Editor) -> c.Command | None:
        """The command of an answer, once. Raises DialogError or CommandError."""
        answer = self._dialogs.poll()
        if answer is None or answer.path is None:
            return None
        purpose, path = answer.question.purpose, _complete(answer, answer.path)
        if purpose in EXPORTS:
            spare_mesh(editor, path)
            self._exported = path
        return _command(purpose, path, editor)

    def close(self) -> None:
        """End the dialog that is open."""
        self._dialogs.close()


def _open(editor: Editor) -> Question:
    mesh = editor.document.path
    folder = Path.cwd() if mesh.resolve().is_relative_to(ASSETS) else mesh.parent
    return Question("open", "Open", folder, (BOTH, MESHES, SESSIONS))


def _save(editor: Editor) -> Question:
    return Question("save", "Save session as", default_session_path(editor), (SESSIONS,))


def _export(editor: Editor) -> Question:
    return Question("export", "Export mesh as", default_export_path(editor), (MESHES,))


def _export_poses(editor: Editor) -> Question:
    return replace(_export(editor), purpose="export poses")


def _turntable(editor: Editor) -> Question:
    path = default_film_path(editor.document.path, "turntable")
    return Question("turntable", "Save a turntable as", path, (FILM,))


def _record(editor: Editor) -> Question:
    path = default_film_path(editor.document.path, "recording")
    return Question("record", "Record to", path, (FILM,))


QUESTIONS: dict[str, Callable[[Editor], Question]] = {
    "open": _open,
    "save": _save,
    "export": _export,
    "export poses": _export_poses,
    "turntable": _turntable,
    "record": _record,
}


def _command(name: str, path: Path, editor: Editor) -> c.Command:
    if name == "open":
        return open_command(path)
    if name in FILM_NAMES:
        return TakeFilm(name, path)
    if name == "export poses":
        return c.ExportPoses(path, editor.blend.between)
    return c.SaveSession(path) if name == "save" else c.Export(path)


def _complete(answer: Answer, path: Path) -> Path:
    """With the suffix that was proposed, where the person typed none or there is but one.

    The dialog then asked about another name: what is there is not replaced.
    """
    suffixes = {suffix for kind in answer.question.kinds for suffix in kind.suffixes}
    told = path.suffix if len(suffixes) > 1 else path.suffix.lower() in suffixes
    if not answer.question.saves or told:
        return path
    whole = path.with_name(path.name + answer.question.path.suffix)
    if whole.exists():
        raise c.CommandError(f"{whole} is there already; choose it by its whole name to replace it")
    return whole
