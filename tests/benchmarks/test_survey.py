"""The two cases of the survey [Botsch & Sorkine 2008] with their published results."""

from __future__ import annotations

import numpy as np
import pytest

from solver import Deformer, load_mesh
from solver.measure.distortion import Distortion
from tests.solver import shapes

# Edge-strain rms at rigid 0 and 1.
EXPECTED = {"cylinder": (0.268, 0.142), "bar": (0.235, 0.077)}


@pytest.mark.parametrize("name", EXPECTED)
def test_edge_strain_is_that_of_the_method(name: str) -> None:
    mesh = load_mesh(shapes.shared(f"bs08/00-{name}-original.off"))
    V, F = mesh.vertices, mesh.faces
    status = np.loadtxt(shapes.shared(f"bs08/{name}.sel"), comments="#").astype(int)
    T = np.loadtxt(shapes.shared(f"bs08/{name}.def"), comments="#").reshape(4, 4)
    distortion = Distortion(V, F)
    deformer = Deformer(V, F, np.flatnonzero(status == 0), [np.flatnonzero(status == 2)])
    for rigid, expected in enumerate(EXPECTED[name]):
        strain = distortion.strain(deformer.pose([T], rigid), status == 1).rms
        assert strain == pytest.approx(expected, rel=0.05)
