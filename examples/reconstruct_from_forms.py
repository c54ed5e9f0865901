"""Surfaces from edge lengths and dihedral angles alone: one rebuilt, one rolled up from a sheet."""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path

import numpy as np

from app.bundled import ASSETS
from solver import Mesh, fundamental_forms, load_mesh, reconstruct

CELLS = 24


def flat_sheet() -> Mesh:
    """Squares of the xy plane, `CELLS` by 12."""
    x, y = np.meshgrid(np.arange(CELLS + 1.0), np.arange(13.0))
    index = np.arange(x.size).reshape(x.shape)
    corners = index[:-1, :-1], index[:-1, 1:], index[1:, 1:], index[1:, :-1]
    V = np.column_stack([x.ravel(), y.ravel(), np.zeros(x.size)])
    return Mesh.from_arrays(V, np.column_stack([corner.ravel() for corner in corners]))


def main(output: Path) -> None:
    mesh = load_mesh(ASSETS / "bumpy_plane.obj")
    forms = fundamental_forms(mesh.vertices, mesh.faces)
    X = reconstruct(mesh.faces, forms)  # the same surface, somewhere else in space
    mesh.save(output / "rebuilt.obj", X)
    again = fundamental_forms(X, mesh.faces)
    print(f"rebuilt: lengths to {abs(again.lengths / forms.lengths - 1).max():.0e}")

    sheet = flat_sheet()
    flat = fundamental_forms(sheet.vertices, sheet.faces)
    one, other = sheet.vertices[flat.edges, 0].T
    # Every crease along y turns by the same angle, everything else stays as it is in the plane.
    angles = np.where(one == other, 2 * np.pi / CELLS, flat.dihedral_angles)
    tube = reconstruct(sheet.faces, replace(flat, dihedral_angles=angles))
    sheet.save(output / "tube.obj", tube)
    x = sheet.vertices[:, 0]
    print(f"rolled up: the ends meet to {abs(tube[x == 0] - tube[x == CELLS]).max():.0e}")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
