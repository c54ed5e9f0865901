"""Where files go by default, and which are remembered."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from app.bundled import is_bundled, writable
from app.model.session.files import SUFFIX
from app.workspace.workspace import Workspace
from solver.errors import SolverError


def default_session_path(work: Workspace) -> Path:
    """The session that was opened or saved, else one beside the mesh."""
    return writable(work.session_path or work.document.path.with_suffix(SUFFIX))


def default_export_path(work: Workspace) -> Path:
    """Where the last export went, else where the program was told, or one beside the mesh.

    The latter in the format of the mesh where that keeps what else its file holds.
    """
    if work.exported is not None:
        return work.exported
    mesh = work.document.path
    suffix = ".obj" if work.document.mesh.source is None else mesh.suffix
    return work.export_path or writable(mesh.with_name(f"{mesh.stem}-deformed{suffix}"))


@contextmanager
def recent(work: Workspace, path: Path) -> Iterator[None]:
    """A file that could be used is among the recent ones, one that is gone no longer is."""
    try:
        yield
    except (SolverError, OSError):
        if not path.exists():
            work.recent.drop(path)
        raise
    if not is_bundled(path):
        work.recent.add(path)
