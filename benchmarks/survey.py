"""This method on the survey's own data [Botsch & Sorkine 2008], beside its published results.

`python -m benchmarks.survey [FOLDER]`: FOLDER holds `bs08/`, by default ../shared/meshes.
"""

from __future__ import annotations

import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from benchmarks.timing import table
from solver import Deformer, fundamental_forms, load_mesh
from solver.types import FloatArray, IntArray

DEFAULT = Path(__file__).resolve().parents[2] / "shared" / "meshes"
PUBLISHED = {
    "PriMo (nonlinear reference)": "01-{}-primo.off",
    "linear thin shell": "02-{}-linear_shell.off",
    "gradient editing": "03-{}-gradient_editing.off",
    "Laplacian editing": "04-{}-laplacian_editing.off",
    "rotation-invariant coordinates": "05-{}-rotation_invariant.off",
}
CASES = {"cylinder": "cylinder, bend 120", "bar": "bar, twist 135"}
LEVELS = (0, 1)


@dataclass(frozen=True)
class Case:
    """One deformation of the survey, and how to judge a result X of it."""

    V: FloatArray
    F: IntArray
    status: IntArray  # 0 fixed, 1 free, 2 handle
    T: FloatArray
    reference: FloatArray

    @classmethod
    def load(cls, folder: Path, name: str) -> Case:
        mesh = load_mesh(folder / f"00-{name}-original.off")
        status = np.loadtxt(folder / f"{name}.sel", comments="#").astype(np.int64)
        T = np.loadtxt(folder / f"{name}.def", comments="#").reshape(4, 4)
        reference = load_mesh(folder / f"01-{name}-primo.off").vertices
        return cls(mesh.vertices, mesh.faces, status, T, reference)

    def deform(self) -> list[FloatArray]:
        """Ours, at each level of `rigid`."""
        fixed, handle = np.flatnonzero(self.status == 0), np.flatnonzero(self.status == 2)
        deformer = Deformer(self.V, self.F, fixed, [handle])
        return [deformer.pose([self.T], rigid) for rigid in LEVELS]

    def figures(self, X: FloatArray) -> str:
        """Edge-strain rms / volume ratio / rms distance to PriMo in bounding-box diagonals."""
        edges = fundamental_forms(self.V, self.F).edges
        edges = edges[(self.status[edges] == 1).any(axis=1)]
        rest, now = (np.linalg.norm(Y[edges[:, 1]] - Y[edges[:, 0]], axis=1) for Y in (self.V, X))
        strain = np.sqrt(np.mean((now / rest - 1) ** 2))
        ratio = volume(X, self.F) / volume(self.V, self.F)
        away = np.sqrt(((X - self.reference) ** 2).sum(axis=1).mean())
        return f"{strain:.3f} / {ratio:.3f} / {away / np.linalg.norm(np.ptp(self.V, axis=0)):.3f}"


def volume(X: FloatArray, F: IntArray) -> float:
    a, b, c = X[F[:, 0]], X[F[:, 1]], X[F[:, 2]]
    return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)


def main(folder: Path) -> None:
    data = folder / "bs08"
    if not data.is_dir():
        print(f"The survey's data are not in {data}: nothing to compare.")
        return
    columns = []
    for name in CASES:
        case = Case.load(data, name)
        published = [load_mesh(data / file.format(name)).vertices for file in PUBLISHED.values()]
        columns.append([case.figures(X) for X in (*published, *case.deform())])
    names = [*PUBLISHED, *(f"this method, rigid {rigid}" for rigid in LEVELS)]
    print("Edge-strain rms / volume ratio / rms distance to PriMo in bounding-box diagonals\n")
    print(table(["", *CASES.values()], list(zip(names, *columns, strict=True))))


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else DEFAULT)
