"""Bend a bar by a quarter turn: what the rigid levels 0, 1 and 4 do to its edge lengths."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

from app.bundled import ASSETS
from solver import Deformer, fundamental_forms, load_mesh
from solver.types import FloatArray


def quarter_turn(pivot: FloatArray) -> FloatArray:
    """The rotation by 90 degrees about the z axis through `pivot`, (4, 4)."""
    T = np.eye(4)
    T[:2, :2] = [[0, -1], [1, 0]]
    T[:3, 3] = pivot - T[:3, :3] @ pivot
    return T


def main(output: Path) -> None:
    mesh = load_mesh(ASSETS / "bar.obj")
    V, F = mesh.vertices, mesh.faces
    x = V[:, 0]
    fixed, end = np.flatnonzero(x < x.min() + 0.4), np.flatnonzero(x > x.max() - 0.4)

    deformer = Deformer(V, F, fixed=fixed, handles=[end])  # factorised once
    T = quarter_turn(V.mean(axis=0))
    rest = fundamental_forms(V, F).lengths
    for level in (0, 1, 4):
        X = deformer.pose([T], rigid=level)
        mesh.save(output / f"bar-{level}.obj", X)
        strain = fundamental_forms(X, F).lengths / rest - 1
        print(f"rigid {level}: rms strain of the edges {np.sqrt((strain**2).mean()):.4f}")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
