"""What the commands that read and write files do. FILE_ACTIONS is their table."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from app.bundled import ASSETS, writable
from app.editor import commands as c
from app.editor.action import Actions
from app.model.document import Document
from app.model.session import read_session, to_document, write_session
from app.model.settings import affordable_level
from app.workspace.workspace import Workspace
from solver import load_mesh
from solver.errors import SolverError
from solver.mesh.mesh import Mesh
from solver.mesh.progress import Progress
from solver.mesh.sizes import check_sizes


def open_mesh(work: Workspace, command: c.OpenMesh) -> None:
    with _recent(work, command.path):
        work.adopt(load_document(command.path, None, work.progress))
    _announce(work, command.path)


def open_session(work: Workspace, command: c.OpenSession) -> None:
    with _recent(work, command.path):
        work.adopt(load_document(None, command.path, work.progress), command.path)
    _announce(work, command.path)


def load_document(
    mesh: Path | None, session: Path | None, progress: Progress | None = None
) -> Document:
    """A mesh as it is, the document of a session, or that of a session on another mesh file.

    progress: see load_mesh. Raises FileError, MeshError or SessionError.
    """
    if session is None:
        assert mesh is not None
        document = Document(usable_mesh(mesh, progress), mesh)
        document.change("rigid", affordable_level(len(document.role)))
        return document
    described = read_session(session)
    path = mesh or described.mesh_path
    return to_document(described, usable_mesh(path, progress), path)


def usable_mesh(path: Path, progress: Progress | None = None) -> Mesh:
    """A mesh that can be deformed. Raises FileError or MeshError, see load_mesh."""
    mesh = load_mesh(path, progress)
    check_sizes(mesh.vertices, mesh.faces, str(path))
    return mesh


def open_command(path: Path) -> c.OpenMesh | c.OpenSession:
    """What opens a file of unknown kind: sessions are *.json."""
    return c.OpenSession(path) if path.suffix.lower() == ".json" else c.OpenMesh(path)


def save_session(work: Workspace, command: c.SaveSession) -> None:
    path = command.path or default_session_path(work)
    spare_mesh(work, path)
    with _recent(work, path):
        write_session(path, work.document)
    work.session_path = path
    work.history.mark_saved()
    work.say(f"Saved {path}")


def export(work: Workspace, command: c.Export) -> None:
    path = command.path or default_export_path(work)
    spare_mesh(work, path)
    work.surface.settle(work.document)
    with _recent(work, path):
        work.document.mesh.save(path, work.positions, progress=work.progress)
    work.say(f"Exported {path}")


def default_session_path(work: Workspace) -> Path:
    """The session that was opened or saved, else one beside the mesh."""
    return writable(work.session_path or work.document.path.with_suffix(".json"))


def default_export_path(work: Workspace) -> Path:
    """The one the program was started with, else one beside the mesh.

    In the format of the mesh where that keeps what else its file holds.
    """
    mesh = work.document.path
    suffix = ".obj" if work.document.mesh.source is None else mesh.suffix
    return work.export_path or writable(mesh.with_name(f"{mesh.stem}-deformed{suffix}"))


@contextmanager
def _recent(work: Workspace, path: Path) -> Iterator[None]:
    """A file that could be used is among the recent ones, one that is gone no longer is."""
    try:
        yield
    except (SolverError, OSError):
        if not path.exists():
            work.recent.drop(path)
        raise
    if not path.resolve().is_relative_to(ASSETS):
        work.recent.add(path)


def _announce(work: Workspace, path: Path) -> None:
    work.say(f"Opened {path.name}: {len(work.document.role):,} vertices")


def spare_mesh(work: Workspace, path: Path) -> None:
    """Raise CommandError if saving to `path` would replace the mesh that is open."""
    mesh = work.document.path
    if path.resolve() == mesh.resolve() or (
        path.exists() and mesh.exists() and path.samefile(mesh)
    ):
        raise c.CommandError(f"{path} is the mesh that is open; expected another name")


FILE_ACTIONS: Actions = {
    c.OpenMesh: open_mesh,
    c.OpenSession: open_session,
    c.SaveSession: save_session,
    c.Export: export,
}
