"""What softness is learned from: a document, and files that have its mesh in other poses."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from app.model.document import Document
from solver import Mesh, MeshError, learn_softness, load_mesh
from solver.mesh.progress import Progress
from solver.types import FloatArray


def posed_vertices(path: Path, mesh: Mesh, name: Path) -> FloatArray:
    """The positions of a mesh file with the polygons of `mesh`, which is called `name`.

    Raises SolverError.
    """
    posed = load_mesh(path)
    found, expected = len(posed.vertices), len(mesh.vertices)
    if found != expected:
        raise MeshError(f"{path}: {found} vertices, expected {expected}, as {name} has")
    found_faces, faces = posed.outlines, mesh.outlines
    same = np.array_equal(found_faces.sizes, faces.sizes)
    if not (same and np.array_equal(found_faces.corners, faces.corners)):
        raise MeshError(f"{path}: its faces are not those of {name}")
    return posed.vertices


def lesson(document: Document, poses: Sequence[FloatArray]) -> dict[str, Any]:
    """What softness is learned from: the arguments of learn_softness but for its progress.

    What the document holds is held; where nothing is fixed, or no handle has vertices, parts that
    move rigidly stand in.
    """
    setup = document.setup()
    return {
        "V": document.rest_positions,
        "F": document.mesh.faces,
        "poses": poses,
        "fixed": setup.fixed if len(setup.fixed) else None,
        "handles": setup.handles or None,
        "material": setup.material,
    }


def learned(given: dict[str, Any], tell: Progress) -> FloatArray:
    """The softness of a lesson, (n,), as `apart` wants it. Raises SolverError."""
    return learn_softness(**given, progress=tell)
