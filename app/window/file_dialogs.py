"""Which dialog a key or button opens, and the command that its answer becomes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from app.bundled import is_bundled
from app.dialogs.dialogs import Dialogs
from app.dialogs.question import Answer, Kind, Question
from app.editor import commands as c
from app.editor.editor import Editor
from app.editor.files.actions import open_command
from app.editor.files.paths import default_export_path, default_session_path
from app.editor.files.replacing import is_open_mesh
from app.model.session.files import SUFFIX, session_name
from app.window.films.files import FILMS
from app.window.films.film import TakeFilm, default_film_path
from solver.mesh.formats.table import FORMATS

MESHES = Kind("Meshes", tuple(FORMATS))
SESSIONS = Kind("Sessions", (SUFFIX,))
EXPORTS = "export", "export poses"  # both go where the last one went
POSED: dict[str, Callable[[Path], c.Command]] = {
    "learn": lambda path: c.LearnSoftness((path,)),
    "add pose": c.AddPose,
}
FILM_NAMES = "turntable", "record"
BOTH = Kind("Meshes and sessions", (*FORMATS, SUFFIX))
FILM = Kind("Films", tuple(FILMS))


class FileDialogs:
    """Opens, saves and exports as a person says in a dialog, or where they said it before."""

    def __init__(self, dialogs: Dialogs) -> None:
        self._dialogs = dialogs

    @property
    def available(self) -> bool:
        """Whether there are dialogs."""
        return self._dialogs.available

    @property
    def asking(self) -> bool:
        """Whether a dialog is open."""
        return self._dialogs.open

    def forget(self) -> None:
        """Another document is open, and no dialog is about the last."""
        self._dialogs.close()

    def act(self, name: str, editor: Editor) -> c.Command | None:
        """What a name of QUESTIONS, or "save as" or "export as", asks for.

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
            return editor.exported or editor.export_path
        session = editor.session_path
        if name != "save" or session is None or is_bundled(session):
            return None
        return session

    def poll(self, editor: Editor) -> c.Command | None:
        """The command of an answer, once. Raises DialogError.

        The dialog has asked whether to replace a file, but not what it is: the mesh that is open
        is asked about once more, and so is a file whose name was completed here.
        """
        answer = self._dialogs.poll()
        if answer is None or answer.path is None:
            return None
        purpose, path = answer.question.purpose, _complete(answer, answer.path)
        asked = path == answer.path and not is_open_mesh(editor, path)
        return _command(purpose, path, editor, asked)

    def close(self) -> None:
        """End the dialog that is open."""
        self._dialogs.close()


def _open(editor: Editor) -> Question:
    return Question("open", "Open", _folder(editor), (BOTH, MESHES, SESSIONS))


def _learn(editor: Editor) -> Question:
    return Question("learn", "Learn softness from a pose", _folder(editor), (MESHES,))


def _add_pose(editor: Editor) -> Question:
    return Question("add pose", "Add a pose from a mesh", _folder(editor), (MESHES,))


def _folder(editor: Editor) -> Path:
    """Where the mesh lies, which may have others beside it."""
    mesh = editor.document.path
    return Path.cwd() if is_bundled(mesh) else mesh.parent


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
    "learn": _learn,
    "add pose": _add_pose,
    "save": _save,
    "export": _export,
    "export poses": _export_poses,
    "turntable": _turntable,
    "record": _record,
}


def _command(name: str, path: Path, editor: Editor, asked: bool = False) -> c.Command:
    """asked: whether the person has agreed to replace what is there."""
    if name == "open":
        return open_command(path)
    if name in POSED:
        return POSED[name](path)
    if name in FILM_NAMES:
        return TakeFilm(name, path, asked)
    if name == "export poses":
        return c.ExportPoses(path, editor.blend.between, asked)
    return c.SaveSession(path, asked) if name == "save" else c.Export(path, asked)


def _complete(answer: Answer, path: Path) -> Path:
    """With the suffix of sessions, or that of the mesh that was proposed where none was typed."""
    if answer.question.purpose == "save":
        return session_name(path)
    if not answer.question.saves or path.suffix:
        return path
    return path.with_name(path.name + answer.question.path.suffix)
