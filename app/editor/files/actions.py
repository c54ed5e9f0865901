"""What the commands that read and write files do. FILE_ACTIONS is their table."""

from __future__ import annotations

from pathlib import Path

from app.editor import commands as c
from app.editor.action import Actions
from app.editor.files.elsewhere import or_elsewhere
from app.editor.files.mesh_saving import MeshSaving
from app.editor.files.opening import (
    Beside,
    carried_over,
    sessions_beside,
    to_carry,
    to_continue,
    unusable,
)
from app.editor.files.paths import default_export_path, default_session_path, recent
from app.editor.files.replacing import ask_before, check_session_file, whole
from app.editor.question import Asks
from app.editor.solved import settled, solved
from app.model.document import Document
from app.model.handles import Pose
from app.model.session.carrying import MeshChanged, on_mesh
from app.model.session.files import SUFFIX
from app.model.session.mesh import Carry
from app.model.session.reading import read_session
from app.model.session.writing import write_session
from app.model.settings import affordable_level
from app.unsaved.places import read_unsaved
from app.worker.errand import Snapshot
from app.workspace.tasks import Steps
from app.workspace.workspace import Workspace
from solver import load_mesh
from solver.mesh.mesh import Mesh
from solver.mesh.progress import Progress
from solver.mesh.sizes import check_sizes


def open_mesh(work: Workspace, command: c.OpenMesh) -> None:
    beside = Beside() if command.fresh else sessions_beside(command.path)
    if beside.sessions:
        raise Asks(to_continue(beside.sessions, command.path))
    with recent(work, command.path):
        work.adopt(load_document(command.path, None, work.progress))
    _announce(work, command.path)
    if beside.fault is not None:
        work.say(unusable(beside.fault), "error")


def open_session(work: Workspace, command: c.OpenSession) -> None:
    with recent(work, command.path):
        try:
            document = load_document(command.mesh, command.path, work.progress, command.carry)
        except MeshChanged as changed:
            raise Asks(to_carry(changed, command)) from changed
        work.adopt(document, command.path)
    _announce(work, command.path)
    if command.carry is not None:
        work.own.forget(command.path)  # it still holds what was painted on the other mesh
        work.say(carried_over(document))


def continue_work(work: Workspace, command: c.ContinueWork) -> None:
    """No file holds it: it is unsaved from the start."""
    unsaved = read_unsaved(command.path)
    path = command.mesh or Path(unsaved["mesh"])
    try:
        document = load_document(path, command.path, work.progress, command.carry)
    except MeshChanged as changed:
        raise Asks(to_carry(changed, command)) from changed
    work.adopt(document)
    work.session_path = Path(unsaved["session"]) if "session" in unsaved else None
    if work.session_path is not None and not _newer(work.session_path, command.path):
        work.own.add(work.session_path)
    work.history.mark_unsaved()
    work.say(f"Unsaved work on {whole(path)}" if command.carry is None else carried_over(document))


def _newer(path: Path, other: Path) -> bool:
    """Whether a file was written after the other, or is gone."""
    return not path.exists() or path.stat().st_mtime > other.stat().st_mtime


def load_document(
    mesh: Path | None,
    session: Path | None,
    progress: Progress | None = None,
    carry: Carry | None = None,
) -> Document:
    """A mesh as it is, the document of a session, or that of a session on another mesh file.

    progress: see load_mesh.  carry: how a session gets onto a mesh that has changed.
    Raises FileError, MeshError or SessionError; where the mesh has changed, MeshChanged.
    """
    if session is None:
        assert mesh is not None
        document = Document(usable_mesh(mesh, progress), mesh)
        document.change("rigid", affordable_level(len(document.role)))
        return document
    described = read_session(session)
    path = mesh or described.mesh_path
    return on_mesh(described, usable_mesh(path, progress), path, carry)


def usable_mesh(path: Path, progress: Progress | None = None) -> Mesh:
    """A mesh that can be deformed. Raises FileError or MeshError, see load_mesh."""
    mesh = load_mesh(path, progress)
    check_sizes(mesh.vertices, mesh.faces, str(path))
    return mesh


def open_command(path: Path) -> c.OpenMesh | c.OpenSession:
    """What opens a file of unknown kind: sessions are *.json."""
    return c.OpenSession(path) if path.suffix.lower() == SUFFIX else c.OpenMesh(path)


def save_session(work: Workspace, command: c.SaveSession) -> None:
    path = command.path or default_session_path(work)
    check_session_file(work, path)
    ask_before(work, command, path, lambda file: [file])
    with or_elsewhere(command, path), recent(work, path):
        write_session(path, work.document)
    work.own.add(path)
    work.session_path = path
    work.history.mark_saved()
    work.say(f"Saved {whole(path)}")


def export(work: Workspace, command: c.Export) -> None:
    path = command.path or default_export_path(work)
    saving = MeshSaving(work, command, path, lambda file: [file], work.document.mesh, work.own)
    saving.begin(_export(saving, settled(work)))


def _export(saving: MeshSaving, shape: Steps[tuple[Snapshot, Pose]]) -> Steps[None]:
    positions = yield from solved(saving.work, (yield from shape)[0])
    yield from saving.steps(positions)
    saving.work.say(saving.done)


def _announce(work: Workspace, path: Path) -> None:
    work.say(f"Opened {whole(path)}: {len(work.document.role):,} vertices")


FILE_ACTIONS: Actions = {
    c.OpenMesh: open_mesh,
    c.OpenSession: open_session,
    c.ContinueWork: continue_work,
    c.SaveSession: save_session,
    c.Export: export,
}
