"""The editor that a window begins with, and what it asks first."""

from __future__ import annotations

from pathlib import Path

from app.editor import commands as c
from app.editor.editor import Editor
from app.editor.files.actions import load_document
from app.editor.files.opening import Beside, sessions_beside, to_carry, to_continue, unusable
from app.model.session.carrying import MeshChanged
from app.worker.client import Worker
from solver.mesh.progress import Progress


def open_editor(
    mesh: Path | None,
    session: Path | None,
    worker: Worker,
    export: Path | None = None,
    progress: Progress | None = None,
) -> Editor:
    """A mesh, a session, or a session on another mesh; see load_document for what is raised.

    A mesh that has a session beside it is open, and the editor asks whether to continue that. So
    is the mesh of a session that has changed since, and the editor asks how to carry it over.
    """
    try:
        document = load_document(mesh, session, progress)
    except MeshChanged as changed:
        assert session is not None
        editor = Editor(load_document(changed.path, None, progress), worker, None, export)
        editor.ask(to_carry(changed, c.OpenSession(session, changed.path)))
        return editor
    editor = Editor(document, worker, session, export)
    beside = sessions_beside(document.path) if session is None else Beside()
    if beside.sessions:
        editor.ask(to_continue(beside.sessions, document.path, opened=True))
    elif beside.fault is not None:
        editor.say(unusable(beside.fault), "error")
    return editor
