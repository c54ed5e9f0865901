"""Softness from examples without a window: the command `learn`."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path

from app.editor.files.actions import load_document
from app.editor.lesson import lesson, posed_vertices
from app.model.outputs import check_outputs
from app.model.session.writing import write_session
from solver import learn_softness


def learn(
    mesh: Path, posed: Sequence[Path], session: Path | None, output: Path, force: bool = False
) -> None:
    """Learn softness from meshes `posed` and write it, with all else of `session`, to `output`.

    What the session holds stays held, see `lesson`. Files that are there are replaced only with
    `force`, and never one of those that are read. Raises SolverError.
    """
    check_outputs([output], force, [mesh, *posed, *([session] if session else [])])
    document = load_document(mesh, session)
    poses = [posed_vertices(path, document.mesh, mesh) for path in posed]
    progress = _tell if sys.stderr.isatty() else None
    softness = learn_softness(**lesson(document, poses), progress=progress)
    document.change("softness", softness)
    write_session(output, document)


def _tell(fraction: float) -> None:
    print(f"\rlearning {fraction:4.0%}", end="\n" if fraction == 1.0 else "", file=sys.stderr)
