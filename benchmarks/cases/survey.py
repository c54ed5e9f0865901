"""The survey's two deformations with its published results. [Botsch & Sorkine 2008]"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from benchmarks.cases.case import Case
from solver import load_mesh

#: Where its data are by default: `bs08/` beside other meshes that are no part of the project.
MESHES = Path(__file__).resolve().parents[3] / "shared" / "meshes"
PRIMO = "PriMo (nonlinear reference)"
PUBLISHED = {
    PRIMO: "01-{}-primo.off",
    "linear thin shell": "02-{}-linear_shell.off",
    "gradient editing": "03-{}-gradient_editing.off",
    "Laplacian editing": "04-{}-laplacian_editing.off",
    "rotation-invariant coordinates": "05-{}-rotation_invariant.off",
}
TITLES = {"cylinder": "cylinder, bend 120", "bar": "bar, twist 135"}


def survey_case(folder: Path, name: str) -> Case:
    """folder: with the survey's files.  name: one of TITLES."""
    mesh = load_mesh(folder / f"00-{name}-original.off")
    status = np.loadtxt(folder / f"{name}.sel", comments="#").astype(np.int64)
    T = np.loadtxt(folder / f"{name}.def", comments="#").reshape(4, 4)
    known = {key: load_mesh(folder / f.format(name)).vertices for key, f in PUBLISHED.items()}
    fixed, handle = np.flatnonzero(status == 0), np.flatnonzero(status == 2)
    title = f"survey's {TITLES[name]}"
    return Case(title, mesh.vertices, mesh.faces, fixed, [handle], [T], published=known)
