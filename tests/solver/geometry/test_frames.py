"""Laws of the orthonormal frames of triangles."""

from __future__ import annotations

import numpy as np
import pytest

from solver.geometry.frames import triangle_frames
from tests.solver import shapes


def test_the_axes_are_orthonormal_along_the_first_edge_and_the_normal() -> None:
    V, F = shapes.bumpy_plane()
    axes = triangle_frames(V[F]).axes
    gram = axes.transpose(0, 2, 1) @ axes
    np.testing.assert_allclose(gram, np.tile(np.eye(3), (len(F), 1, 1)), atol=1e-12)
    assert (np.linalg.det(axes) > 0).all()
    edge, other = V[F[:, 1]] - V[F[:, 0]], V[F[:, 2]] - V[F[:, 0]]
    along = np.einsum("ij,ij->i", axes[:, :, 0], edge)
    np.testing.assert_allclose(along, np.linalg.norm(edge, axis=1), rtol=1e-12)
    for across in (edge, other):
        np.testing.assert_allclose(np.einsum("ij,ij->i", axes[:, :, 2], across), 0, atol=1e-12)


def test_frames_turn_with_their_triangles() -> None:
    V, F = shapes.sphere()
    R = shapes.random_rotation(np.random.default_rng(0))
    before, after = triangle_frames(V[F]), triangle_frames((V @ R.T + [3.0, -1.0, 2.0])[F])
    np.testing.assert_allclose(after.axes, R @ before.axes, atol=1e-12)
    shares = [found.areas / found.areas.sum() for found in (after, before)]
    np.testing.assert_allclose(shares[0], shares[1], rtol=1e-12)


@pytest.mark.parametrize("scale", [1e-250, 1e-9, 1.0, 1e9, 1e250])
def test_no_size_leaves_the_range_of_numbers(scale: float) -> None:
    P = np.array([[[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 0, 0], [0, 3, 0], [0, 0, 1.0]]])
    line = np.array([[[0, 0, 0], [1, 1, 1], [3, 3, 3.0]]])
    found = triangle_frames(scale * np.concatenate([P, line]))
    np.testing.assert_allclose(found.areas[1] / found.areas[0], 3)
    np.testing.assert_allclose(found.axes[:2], [np.eye(3), np.eye(3)[:, [1, 2, 0]]], atol=1e-15)
    assert found.degenerate.tolist() == [False, False, True]
