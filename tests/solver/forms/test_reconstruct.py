"""Lengths and dihedral angles alone give the surface back."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from solver import MeshError, fundamental_forms, load_mesh, reconstruct
from solver.geometry.bounding_box import diagonal
from solver.geometry.frames import triangle_frames
from solver.geometry.motions import motion, moved
from tests.solver import shapes
from tests.solver.forms.test_forms import SURFACES


def error_after_alignment(X: np.ndarray, V: np.ndarray) -> float:
    return float(np.abs(shapes.aligned(X, V) - V).max()) / diagonal(V)


@pytest.mark.parametrize("name", SURFACES)
def test_forms_return_the_surface(name: str) -> None:
    V, F = SURFACES[name]
    X = reconstruct(F, fundamental_forms(V, F))
    assert error_after_alignment(X, V) < 1e-8


def test_errors_do_not_grow_along_a_long_surface() -> None:
    V, F = shapes.grid(400, 2)
    x, y = V[:, 0], V[:, 1]
    coil = np.column_stack(
        [(20 + x / 10) * np.cos(x / 8), (20 + x / 10) * np.sin(x / 8), x / 9 + y]
    )
    for surface in (V, coil):
        assert error_after_alignment(reconstruct(F, fundamental_forms(surface, F)), surface) < 1e-8


@pytest.mark.parametrize("name", ["moomoo.off", "spot.obj", "quadknot.obj", "arm.obj"])
def test_forms_return_the_shared_meshes(name: str) -> None:
    mesh = load_mesh(shapes.shared(name))
    X = reconstruct(mesh.faces, fundamental_forms(mesh.vertices, mesh.faces))
    assert error_after_alignment(X, mesh.vertices) < 1e-8


@pytest.mark.parametrize("name", SURFACES)
def test_the_seed_places_the_surface(name: str) -> None:
    V, F = SURFACES[name]
    rng = np.random.default_rng(1)
    T = motion(shapes.random_rotation(rng), 10 * rng.normal(size=3))
    face = int(rng.integers(len(F)))
    frame = T[:3, :3] @ triangle_frames(V[F]).axes[face]
    corner = moved(T, V[F[face, 0]])
    X = reconstruct(F, fundamental_forms(V, F), face, frame, corner)
    np.testing.assert_allclose(X, moved(T, V), atol=1e-8 * diagonal(V))


def test_without_a_seed_the_first_corner_is_the_origin_and_its_edge_the_first_axis() -> None:
    V, F = shapes.sphere()
    X = reconstruct(F, fundamental_forms(V, F))
    a, b, c = X[F[0]]
    np.testing.assert_allclose(a, 0, atol=1e-12)
    length = float(np.linalg.norm(V[F[0, 1]] - V[F[0, 0]]))
    np.testing.assert_allclose(b, [length, 0.0, 0.0], atol=1e-8)
    assert abs(c[2]) < 1e-8
    assert c[1] > 0


def test_longer_edges_give_a_larger_surface() -> None:
    V, F = shapes.bumpy_plane()
    forms = fundamental_forms(V, F)
    X = reconstruct(F, replace(forms, lengths=1e4 * forms.lengths))
    assert error_after_alignment(X, 1e4 * V) < 1e-8


def test_forms_that_fit_no_surface_give_a_compromise() -> None:
    V, F = shapes.sphere()
    forms = fundamental_forms(V, F)
    noise = np.random.default_rng(2).uniform(0.98, 1.02, len(forms.lengths))
    error = error_after_alignment(reconstruct(F, replace(forms, lengths=noise * forms.lengths)), V)
    assert 1e-6 < error < 0.1


def test_refuses_forms_and_seeds_that_do_not_fit() -> None:
    V, F = shapes.tube(4, 5)
    forms = fundamental_forms(V, F)
    with shapes.refuses(MeshError, "edges of the faces"):
        reconstruct(F[:-1], forms)
    for name in ("lengths", "dihedral_angles"):
        with shapes.refuses(MeshError, f"forms' {name} must be"):
            reconstruct(F, replace(forms, **{name: getattr(forms, name)[:-1]}))
    with shapes.refuses(MeshError, f"seed_face must be 0 to {len(F) - 1}, got {len(F)}"):
        reconstruct(F, forms, seed_face=len(F))
    with shapes.refuses(MeshError, "(3, 3) frame and a (3,) position"):
        reconstruct(F, forms, seed_frame=np.eye(2))
    with shapes.refuses(MeshError, "(3, 3) frame and a (3,) position"):
        reconstruct(F, forms, seed_position=[1, 2])
    with shapes.refuses(MeshError, "seed_frame must be finite"):
        reconstruct(F, forms, seed_frame=np.full((3, 3), np.nan))
    with shapes.refuses(MeshError, "faces must be (m, 3)"):
        reconstruct(np.zeros((0, 3), dtype=int), forms)


def test_refuses_surfaces_that_forms_do_not_determine() -> None:
    V, F = shapes.tetrahedron()
    two = np.vstack([V, V + 5]), np.vstack([F, F + 4])
    with shapes.refuses(MeshError, "got 2 pieces"):
        reconstruct(two[1], fundamental_forms(*two))
    bow_tie = np.vstack([V, V[1:] + 5]), np.vstack([F, np.where(F == 0, 0, F + 3)])
    with shapes.refuses(MeshError, "got 2 pieces"):
        reconstruct(bow_tie[1], fundamental_forms(*bow_tie))
    stray = np.vstack([[[9.0, 9, 9]], V]), F + 1
    with shapes.refuses(MeshError, "1 unreferenced"):
        reconstruct(stray[1], fundamental_forms(*stray))
