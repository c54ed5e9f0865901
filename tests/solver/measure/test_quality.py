"""Laws of the measures of quality: strain, bending, volume and broken triangles."""

from __future__ import annotations

import numpy as np

from solver.geometry.motions import motion, moved, rotation
from solver.measure.quality import broken_triangles, quality
from tests.solver import shapes


def test_a_rigid_motion_is_no_deformation() -> None:
    V, F = shapes.sphere()
    X = moved(motion(rotation([1, 2, 3], 70), [3, 2, 1]), V)
    m = quality(V, F, np.ones(len(V), dtype=bool), X)
    np.testing.assert_allclose([m.strain, m.dihedral, m.volume - 1], 0, atol=1e-7)
    assert m.broken == 0


def test_scaling_is_strain_and_volume_alone() -> None:
    V, F = shapes.sphere()
    m = quality(V, F, np.ones(len(V), dtype=bool), 2 * V)
    np.testing.assert_allclose([m.strain, m.dihedral, m.volume], [1, 0, 8], atol=1e-7)


def test_collapsed_and_inverted_triangles_are_counted() -> None:
    V, F = shapes.grid(6, 6)
    free = np.ones(len(V), dtype=bool)
    inverted, collapsed = V.copy(), V.copy()
    inverted[14] += [3, 0, 0]
    collapsed[14] = collapsed[15]
    assert broken_triangles(V, F, free, V) == 0
    assert broken_triangles(V, F, free, inverted) > 0
    assert broken_triangles(V, F, free, collapsed) == 2
    assert broken_triangles(V, F, ~free, inverted) == 0
