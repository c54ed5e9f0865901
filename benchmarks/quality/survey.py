"""This method on the survey's own data [Botsch & Sorkine 2008], beside its published results.

`python -m benchmarks.quality.survey [FOLDER]`: FOLDER holds `bs08/`, by default ../shared/meshes.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

from benchmarks.cases.case import Case
from benchmarks.cases.survey import MESHES, PRIMO, PUBLISHED, TITLES, survey_case
from benchmarks.tables import table
from solver.types import FloatArray

LEVELS = (0, 1)


def column(case: Case) -> list[str]:
    """The published results, then ours at each level of `rigid`."""
    deformer = case.deformer()
    ours = [deformer.pose(case.transforms, rigid) for rigid in LEVELS]
    return [figures(case, X) for X in (*case.published.values(), *ours)]


def figures(case: Case, X: FloatArray) -> str:
    """Edge-strain rms / volume ratio / rms distance to PriMo in bounding-box diagonals."""
    found = case.quality(X)
    away = np.sqrt(((X - case.published[PRIMO]) ** 2).sum(axis=1).mean()) / case.diagonal
    return f"{found.strain:.3f} / {found.volume:.3f} / {away:.3f}"


def main(folder: Path) -> None:
    data = folder / "bs08"
    if not data.is_dir():
        print(f"The survey's data are not in {data}: nothing to compare.")
        return
    columns = [column(survey_case(data, name)) for name in TITLES]
    names = [*PUBLISHED, *(f"this method, rigid {rigid}" for rigid in LEVELS)]
    print("Edge-strain rms / volume ratio / rms distance to PriMo in bounding-box diagonals\n")
    print(table(["", *TITLES.values()], list(zip(names, *columns, strict=True))))


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else MESHES)
