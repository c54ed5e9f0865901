"""Discrete fundamental forms: edge lengths and dihedral angles. [Wang, Liu & Tong 2012]

Together with the connectivity they fix a surface up to a rigid motion. Everything else here
(corner angles, edge coordinates, transitions) follows from them alone.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from solver.arrays import as_surface
from solver.geometry.frames import triangle_frames, unit
from solver.geometry.topology import FacePairs, Topology
from solver.types import FloatArray


@dataclass(frozen=True)
class FundamentalForms:
    """First and second discrete fundamental form.

    edges: (e, 2) vertex indices, each pair sorted, in lexicographic order.
    lengths: (e,) in the units of the mesh.
    dihedral_angles: (e,) radians between the normals of the two triangles of an edge: 0 = flat,
        positive = convex (seen from the side the normals point to), NaN where the edge has not
        exactly two triangles.

    >>> import solver
    >>> forms = solver.fundamental_forms([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]])
    >>> forms.lengths.tolist()
    [3.0, 4.0, 5.0]
    """

    edges: np.ndarray
    lengths: FloatArray
    dihedral_angles: FloatArray


def fundamental_forms(V: ArrayLike, F: ArrayLike) -> FundamentalForms:
    """Edge lengths and dihedral angles of the surface (V, F).

    V: (n, 3) positions.  F: (m, 3) triangles.  Raises MeshError for anything else.

    >>> import solver
    >>> V = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, -1]]  # two triangles, a right angle at 0-1
    >>> forms = solver.fundamental_forms(V, [[0, 1, 2], [1, 0, 3]])
    >>> forms.edges[0].tolist(), np.degrees(forms.dihedral_angles[0]).round(9)
    ([0, 1], np.float64(90.0))
    """
    V, F = as_surface(V, F)
    topology = Topology(F, len(V))
    edges = topology.edges
    lengths = np.linalg.norm(V[edges[:, 1]] - V[edges[:, 0]], axis=1)
    angles = np.full(len(edges), np.nan)
    pairs = topology.manifold_pairs
    angles[pairs.edge] = _dihedral_angles(V, topology, pairs)
    return FundamentalForms(edges, lengths, angles)


def corner_points(lengths: FloatArray) -> FloatArray:
    """Corners of each triangle in its orthonormal frame, (m, 3, 2), by the law of cosines.

    lengths: (m, 3) edge lengths opposite each corner. Corner 0 is the origin and corner 1 lies
    on the first axis.
    """
    a, b, c = lengths.T
    with np.errstate(divide="ignore", invalid="ignore"):
        along = np.where(c > 0, (b**2 + c**2 - a**2) / (2 * c), 0.0)
    points = np.zeros((len(lengths), 3, 2))
    points[:, 1, 0] = c
    points[:, 2, 0] = along
    points[:, 2, 1] = np.sqrt(np.maximum(b**2 - along**2, 0.0))
    return points


def transitions(topology: Topology, forms: FundamentalForms, pairs: FacePairs) -> FloatArray:
    """R_ij = Rz(phi_i) Rx(dihedral) Rz(-phi_j), (p, 3, 3), with f_j = f_i R_ij.

    f are the triangles' orthonormal frames. phi is the direction of the shared edge, from its lower
    to its higher vertex, in each of the two.
    """
    points = corner_points(forms.lengths[topology.half_edge_edge])
    phi_first = _edge_direction(points, topology, pairs.first, pairs.half_first)
    phi_second = _edge_direction(points, topology, pairs.second, pairs.half_second)
    forward = topology.half_edge_forward[pairs.first, pairs.half_first]
    dihedral = np.where(forward, 1.0, -1.0) * forms.dihedral_angles[pairs.edge]
    return _rotation_z(phi_first) @ _rotation_x(dihedral) @ _rotation_z(-phi_second)


def _dihedral_angles(V: FloatArray, topology: Topology, pairs: FacePairs) -> FloatArray:
    normals = triangle_frames(V[topology.faces]).axes[:, :, 2]
    one, two = normals[pairs.first], normals[pairs.second]
    edges = topology.edges[pairs.edge]
    along = unit(V[edges[:, 1]] - V[edges[:, 0]])
    forward = topology.half_edge_forward[pairs.first, pairs.half_first]
    sine = np.where(forward, 1.0, -1.0) * np.einsum("ij,ij->i", along, np.cross(one, two))
    return np.arctan2(sine, np.einsum("ij,ij->i", one, two))


def _edge_direction(
    points: FloatArray, topology: Topology, face: np.ndarray, half: np.ndarray
) -> FloatArray:
    direction = points[face, (half + 2) % 3] - points[face, (half + 1) % 3]
    direction = np.where(topology.half_edge_forward[face, half][:, None], direction, -direction)
    angle: FloatArray = np.arctan2(direction[:, 1], direction[:, 0])
    return angle


def _rotation_z(angle: FloatArray) -> FloatArray:
    return _rotation(angle, 0, 1, 2)


def _rotation_x(angle: FloatArray) -> FloatArray:
    return _rotation(angle, 1, 2, 0)


def _rotation(angle: FloatArray, i: int, j: int, axis: int) -> FloatArray:
    R = np.zeros((len(angle), 3, 3))
    R[:, i, i] = R[:, j, j] = np.cos(angle)
    R[:, j, i] = np.sin(angle)
    R[:, i, j] = -R[:, j, i]
    R[:, axis, axis] = 1.0
    return R
