"""Twist every mesh given (or those that come with the program) by the same rule, file by file."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

from app.bundled import ASSETS
from solver import Deformer, SolverError, load_mesh
from solver.types import FloatArray


def twist(V: FloatArray, degrees: float, axis: int) -> FloatArray:
    """The rotation about the line along `axis` through the middle of V, (4, 4)."""
    angle, (i, j) = np.radians(degrees), ((axis + 1) % 3, (axis + 2) % 3)
    T = np.eye(4)
    T[[i, j], [i, j]] = np.cos(angle)
    T[j, i], T[i, j] = np.sin(angle), -np.sin(angle)
    centre = V.mean(axis=0)
    T[:3, 3] = centre - T[:3, :3] @ centre
    return T


def main(output: Path, *files: str) -> None:
    for path in map(Path, files or sorted(map(str, ASSETS.glob("*.obj")))):
        try:
            mesh = load_mesh(path)
            V = mesh.vertices
            axis = int(np.ptp(V, axis=0).argmax())  # the longest
            along = (V[:, axis] - V[:, axis].min()) / np.ptp(V[:, axis])
            near, far = np.flatnonzero(along < 0.1), np.flatnonzero(along > 0.9)
            deformer = Deformer(V, mesh.faces, fixed=near, handles=[far])
            mesh.save(output / path.name, deformer.pose([twist(V, 60, axis)], rigid=1))
        except SolverError as error:  # one bad file does not end the batch
            print(f"{path.name}: skipped, {error}")
        else:
            print(f"{path.name}: {len(V):,} vertices, {len(far):,} of them turned")


if __name__ == "__main__":
    main(Path(sys.argv[1]), *sys.argv[2:])
