"""Softness from examples without a window: the command `learn`."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from app.editor.file_actions import load_document
from app.model.outputs import check_outputs
from app.model.session_writing import write_session
from solver import Mesh, MeshError, learn_softness, load_mesh
from solver.types import FloatArray


def learn(
    mesh: Path, posed: Sequence[Path], session: Path | None, output: Path, force: bool = False
) -> None:
    """Learn softness from meshes `posed` and write it, with all else of `session`, to `output`.

    What the session holds stays held; where nothing is fixed, or no handle has vertices, parts that
    move rigidly stand in. Files that are there are replaced only with `force`, and never one of
    those that are read. Raises SolverError.
    """
    check_outputs([output], force, [mesh, *posed, *([session] if session else [])])
    document = load_document(mesh, session)
    poses = [_pose(path, document.mesh, mesh) for path in posed]
    setup = document.setup()
    softness = learn_softness(
        document.rest_positions,
        document.mesh.faces,
        poses,
        setup.fixed if len(setup.fixed) else None,
        setup.handles or None,
        setup.material,
        _tell if sys.stderr.isatty() else None,
    )
    document.change("softness", softness)
    write_session(output, document)


def _pose(path: Path, mesh: Mesh, name: Path) -> FloatArray:
    """The positions of a mesh file with the same polygons. Raises SolverError."""
    posed = load_mesh(path)
    found, expected = len(posed.vertices), len(mesh.vertices)
    if found != expected:
        raise MeshError(f"{path}: {found} vertices, expected {expected}, as {name} has")
    found_faces, faces = posed.outlines, mesh.outlines
    same = np.array_equal(found_faces.sizes, faces.sizes)
    if not (same and np.array_equal(found_faces.corners, faces.corners)):
        raise MeshError(f"{path}: its faces are not those of {name}")
    return posed.vertices


def _tell(fraction: float) -> None:
    print(f"\rlearning {fraction:4.0%}", end="\n" if fraction == 1.0 else "", file=sys.stderr)
