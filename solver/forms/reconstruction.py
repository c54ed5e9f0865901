"""A surface from its fundamental forms and a seed. [Wang, Liu & Tong 2012]"""

from __future__ import annotations

import numpy as np
import scipy.sparse as sp
from numpy.typing import ArrayLike

from solver.arrays import as_faces, as_floats
from solver.errors import MeshError
from solver.factor import factorize
from solver.forms.fundamental_forms import FundamentalForms
from solver.forms.residuals import reconstruction_residuals
from solver.geometry.cotangent_weights import heron
from solver.geometry.topology import Topology
from solver.limits import LARGEST_COORDINATE, SMALLEST_SIZE
from solver.types import FloatArray

# Exact forms have zero energy whatever the weights. For forms that fit no surface this balances
# bending against stretching as the Deformer's default does.
BENDING_LENGTH = 0.01
REFINEMENTS = 3


def reconstruct(
    F: ArrayLike,
    forms: FundamentalForms,
    seed_face: int = 0,
    seed_frame: ArrayLike | None = None,
    seed_position: ArrayLike | None = None,
) -> FloatArray:
    """X, (n, 3): argmin l^2 E_f + E_x with one orthonormal frame and one position held.

    F: (m, 3) triangles.  forms: their lengths and dihedral angles; nothing else of the surface
    is used.  seed_frame: (3, 3) orthonormal columns (first edge, normal x first edge, normal) of
    triangle `seed_face`, the identity by default.  seed_position: (3,) of that triangle's first
    vertex, the origin by default.
    Raises MeshError where the forms do not belong to F or F is not one surface joined by edges.

    >>> import solver
    >>> F = [[0, 1, 2], [1, 0, 3]]
    >>> forms = solver.fundamental_forms([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, -1, 0]], F)
    >>> forms.dihedral_angles[0] = np.pi / 2  # fold the flat square along its diagonal
    >>> solver.reconstruct(F, forms)[3].round(9) + 0.0
    array([ 0.,  0., -1.])
    """
    faces = as_faces(F, np.iinfo(np.int64).max)  # the faces say how many vertices there are
    topology = Topology(faces, int(faces.max()) + 1)
    _check(topology, forms, seed_face)
    frame, position = _seed(seed_frame, seed_position)
    n = topology.vertex_count
    # Solved in units of the surface's size: positions and frames are then of one magnitude.
    size = np.sqrt(heron(forms.lengths[topology.half_edge_edge]).sum())
    if not size > 0:
        raise MeshError("the forms' triangles must have an area, got none")
    scaled = FundamentalForms(forms.edges, forms.lengths / size, forms.dihedral_angles)
    D, w = reconstruction_residuals(topology, scaled, BENDING_LENGTH)
    seeds = np.array([faces[seed_face, 0], *(n + 3 * seed_face + np.arange(3))])
    U = np.zeros((D.shape[1], 3))
    U[seeds[1:]] = frame.T
    free = np.delete(np.arange(len(U)), seeds)
    D_free = D.tocsc()[:, free]
    normal = D_free.T * w
    factor = factorize(sp.csc_array(normal @ D_free))
    # One seed steers the whole surface, so rounding grows along it; refining removes it. The
    # residual D U keeps the accuracy that the normal equations, squaring the condition, lose.
    for _ in range(1 + REFINEMENTS):
        U[free] -= factor.solve(normal @ (D @ U))
    return size * U[:n] + position


def _seed(frame: ArrayLike | None, position: ArrayLike | None) -> tuple[FloatArray, FloatArray]:
    f = np.eye(3) if frame is None else as_floats(frame, "seed_frame", MeshError)
    p = np.zeros(3) if position is None else as_floats(position, "seed_position", MeshError)
    if f.shape != (3, 3) or p.shape != (3,):
        raise MeshError(
            f"the seed must be a (3, 3) frame and a (3,) position, got {f.shape} and {p.shape}"
        )
    return f, p


def _check(topology: Topology, forms: FundamentalForms, seed_face: int) -> None:
    if not np.array_equal(forms.edges, topology.edges):
        raise MeshError(
            f"the forms have {len(forms.edges)} edges that are not the {len(topology.edges)} "
            "edges of the faces, in lexicographic order"
        )
    for name in ("lengths", "dihedral_angles"):
        shape = np.shape(getattr(forms, name))
        if shape != (len(topology.edges),):
            raise MeshError(f"the forms' {name} must be ({len(topology.edges)},), got {shape}")
    lengths = np.asarray(forms.lengths, dtype=np.float64)
    longest = lengths.max(initial=0.0)
    if not (lengths >= 0).all() or not SMALLEST_SIZE <= longest <= LARGEST_COORDINATE:
        raise MeshError(
            f"the forms' lengths must be positive, the longest from {SMALLEST_SIZE:.0e} to "
            f"{LARGEST_COORDINATE:.0e}, got {lengths.min(initial=0.0):.3g} to {longest:.3g}"
        )
    if not 0 <= seed_face < len(topology.faces):
        raise MeshError(f"seed_face must be 0 to {len(topology.faces) - 1}, got {seed_face}")
    pieces = topology.face_component.max() + 1
    if pieces > 1 or len(np.unique(topology.faces)) < topology.vertex_count:
        raise MeshError(
            f"forms determine one surface joined by edges, got {pieces} pieces and "
            f"{topology.vertex_count - len(np.unique(topology.faces))} unreferenced vertices"
        )
