"""A coarser surface for the frames: edges collapsed evenly. [Garland & Heckbert 1997]"""

from __future__ import annotations

import threading
from dataclasses import dataclass

import fast_simplification
import numpy as np
from scipy.spatial import cKDTree

from solver.coarse.closest import NearbySurface
from solver.geometry.bounding_box import diagonal
from solver.geometry.topology import Topology
from solver.types import BoolArray, FloatArray, IntArray

# A piece is not simplified below this many vertices.
SMALLEST_PIECE = 48
# Quadrics keep few vertices where a surface is flat, which then cannot bend. Displaced by this
# share of an edge, every region is about equally rough, and edges collapse evenly.
ROUGHNESS = 0.1
# How fast the package lets the error grow: the slower, the more evenly edges collapse.
GROWTH = 4.0
# The count of triangles that belongs to a count of vertices is found in a few steps.
ATTEMPTS = 6
# A simplified piece that lost more than the rest to flaps is taken as it was.
MOST = 0.9
# Neighbours count as folded where the cosine between their normals is below.
FOLDED = -0.2
# The package keeps its mesh in variables of its own.
_ONE_AT_A_TIME = threading.Lock()


@dataclass(frozen=True, eq=False)
class Simplification:
    """A coarse surface and where the fine one went.

    vertices, faces: (c, 3) and (k, 3) of the coarse surface.
    cell: (n,) the coarse vertex that each fine one collapsed into; -1 where no triangle uses it.
    """

    vertices: FloatArray
    faces: IntArray
    cell: IntArray


def simplify(V: FloatArray, topology: Topology, count: int) -> Simplification:
    """The surface with vertices V (n, 3) and at most `count` of them, where its pieces allow that.

    Each connected piece is simplified by itself, so that none is lost or joined to another, to
    its share of the vertices but not below SMALLEST_PIECE. Boundaries are kept.
    """
    F, component = topology.faces, topology.vertex_component
    used = np.bincount(F.ravel(), minlength=len(V)) > 0
    size = np.bincount(component[used], minlength=component.max() + 1)
    own_faces = _members(component[F[:, 0]], len(size))
    own_vertices = _members(np.where(used, component, len(size)), len(size))
    cell = np.full(len(V), -1)
    number = np.empty(len(V), dtype=np.int64)
    vertices, faces, total = [], [], 0
    for rows, own, allowed in zip(own_faces, own_vertices, _shares(size, count), strict=True):
        if len(rows) == 0:
            continue
        piece = F[rows]
        number[own] = np.arange(len(own))
        P, T, goes = _simplified_piece(V[own], number[piece], int(allowed))
        cell[own] = goes + total
        vertices.append(P)
        faces.append(T + total)
        total += len(P)
    return Simplification(np.concatenate(vertices), np.concatenate(faces), cell)


def _members(piece: IntArray, count: int) -> list[IntArray]:
    """Of each of `count` pieces where its number stands in `piece`, in order."""
    order = np.argsort(piece, kind="stable")
    return np.split(order, np.cumsum(np.bincount(piece, minlength=count)[:count]))[:count]


def _shares(size: IntArray, count: int) -> IntArray:
    """How many vertices each piece may keep: in proportion, small ones at least their minimum."""
    least = np.minimum(size, SMALLEST_PIECE)
    kept = least.copy()
    large = size > least
    while large.any():
        rate = (count - least[~large].sum()) / size[large].sum()
        short = large & (rate * size < least)
        if not short.any():
            kept[large] = np.minimum(np.floor(rate * size[large]), size[large])
            break
        large &= ~short
    return kept


def _simplified_piece(
    V: FloatArray, F: IntArray, count: int
) -> tuple[FloatArray, IntArray, IntArray]:
    """Vertices, triangles and cells of one connected piece; itself where that fails."""
    same = V, F, np.arange(len(V))
    if count >= len(V):
        return same
    topology = Topology(F, len(V))
    P, T, cell = _collapsed(_roughened(V, topology), F, count)
    part = _largest_part(P, T, cell) if len(T) else None
    if part is None:
        return same
    P, T, cell = part
    return _placed(V, topology, T, cell), T, cell


def _largest_part(
    P: FloatArray, T: IntArray, cell: IntArray
) -> tuple[FloatArray, IntArray, IntArray] | None:
    """Without the flaps that came off at edges of more than two triangles; None if much did.

    What went there goes to the nearest vertex of what is left.
    """
    part = Topology(T, len(P)).vertex_component
    kept = np.flatnonzero(part == np.bincount(part).argmax())
    if len(kept) < MOST * len(P):
        return None
    number = np.full(len(P), -1)
    number[kept] = np.arange(len(kept))
    lost = np.flatnonzero(number < 0)
    if len(lost):
        number[lost] = cKDTree(P[kept]).query(P[lost])[1]
        T = T[part[T[:, 0]] == part[kept[0]]]
    cell = number[cell]
    return (P[kept], number[T], cell) if np.bincount(cell, minlength=len(kept)).all() else None


def _collapsed(R: FloatArray, F: IntArray, count: int) -> tuple[FloatArray, IntArray, IntArray]:
    """Edges of the surface R collapsed until at most `count` vertices remain, as far as it goes."""
    P, T, cell = R, F, np.arange(len(R))
    triangles = 2 * count
    for _ in range(ATTEMPTS):
        with _ONE_AT_A_TIME:
            collapses = fast_simplification.simplify(
                P.copy(),
                T.astype(np.int32),
                target_count=min(triangles, len(T)),
                agg=GROWTH,
                return_collapses=True,
            )[2]
            P, T, goes = fast_simplification.replay_simplification(
                P.copy(), T.astype(np.int32), collapses
            )
        T = T.astype(np.int64)
        cell = goes[cell]
        if len(P) <= count or len(T) == 0:
            break
        # With a boundary there are more vertices to a triangle than in a closed surface.
        triangles = int(len(T) * count / len(P))
    return np.asarray(P, dtype=np.float64), T, _mended(R, P, np.asarray(cell, dtype=np.int64))


def _mended(R: FloatArray, P: FloatArray, cell: IntArray) -> IntArray:
    """Cells (n,) in range: a vertex whose last triangle vanished belongs to the nearest vertex."""
    lost = np.flatnonzero((cell < 0) | (cell >= len(P)))
    if len(lost):
        cell[lost] = cKDTree(P).query(R[lost])[1]
    return cell


def _roughened(V: FloatArray, topology: Topology) -> FloatArray:
    """V, at a size of 1, displaced along its normals by random shares of the edges around."""
    F, edges = topology.faces, topology.edges
    lengths = np.linalg.norm(V[edges[:, 1]] - V[edges[:, 0]], axis=1)
    total = np.bincount(edges.ravel(), np.repeat(lengths, 2), len(V))
    around = total / np.bincount(edges.ravel(), minlength=len(V))
    normals = np.zeros_like(V)
    of_faces = _normals(V, F)
    for corner in F.T:
        for axis, values in enumerate(of_faces.T):
            normals[:, axis] += np.bincount(corner, values, len(V))
    normals /= np.maximum(np.linalg.norm(normals, axis=1), np.finfo(float).tiny)[:, None]
    push = ROUGHNESS * around * np.random.default_rng(0).uniform(-1.0, 1.0, len(V))
    return np.asarray((V - V.min(axis=0) + push[:, None] * normals) / (diagonal(V) or 1.0))


def _normals(V: FloatArray, F: IntArray) -> FloatArray:
    """(m, 3) normals, twice the area long."""
    a, b, c = (V[corner] for corner in F.T)
    return np.cross(b - a, c - a)


def _placed(V: FloatArray, topology: Topology, T: IntArray, cell: IntArray) -> FloatArray:
    """(c, 3): each coarse vertex on the fine surface, in the middle of its cell.

    The middle of its boundary, if the cell has some; a member of the cell where triangles would
    fold.
    """
    middle = _means(V, _placing_weights(V, topology, cell), cell)
    distance = ((V - middle[cell]) ** 2).sum(axis=1)
    order = np.lexsort((distance, cell))
    member = order[np.searchsorted(cell[order], np.arange(len(middle)))]
    face, weights = NearbySurface(V, topology.faces).closest_of_few(middle, member)
    placed = np.einsum("ij,ijk->ik", weights, V[topology.faces[face]])
    folded = _folded(placed, T)
    placed[folded] = V[member[folded]]
    return placed


def _placing_weights(V: FloatArray, topology: Topology, cell: IntArray) -> FloatArray:
    """(n,) areas around vertices; in a cell with a part of the boundary, that of the rest is 0."""
    F = topology.faces
    area = np.repeat(np.linalg.norm(_normals(V, F), axis=1), 3)
    weights = np.bincount(F.ravel(), area, len(V)) + np.finfo(float).tiny
    border = np.zeros(len(V), dtype=bool)
    border[topology.edges[topology.valence == 1]] = True
    has_border = np.zeros(len(V), dtype=bool)
    has_border[cell[border]] = True
    weights[has_border[cell] & ~border] = 0.0
    return weights


def _means(V: FloatArray, weights: FloatArray, cell: IntArray) -> FloatArray:
    sums = np.stack([np.bincount(cell, weights * values) for values in V.T], axis=1)
    return np.asarray(sums / np.bincount(cell, weights)[:, None])


def _folded(P: FloatArray, T: IntArray) -> IntArray:
    """The vertices of neighbouring triangles that are folded on each other."""
    pairs = Topology(T, len(P)).pairs
    normals = _normals(P, T)
    length = np.linalg.norm(normals, axis=1)
    cosine = np.einsum("ij,ij->i", normals[pairs.first], normals[pairs.second])
    bad: BoolArray = cosine <= FOLDED * length[pairs.first] * length[pairs.second]
    return np.unique(T[np.concatenate([pairs.first[bad], pairs.second[bad]])])
