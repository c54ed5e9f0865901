"""Fine positions from rotations at vertices: one Poisson problem. [Sorkine & Alexa 2007]"""

from __future__ import annotations

import numpy as np
import scipy.sparse as sp

from solver.factor import Analysis, Factor, analyse, check_factor
from solver.geometry.cotangent_weights import half_edge_cotangents, stretching_weights
from solver.geometry.topology import HALF_EDGE_END, HALF_EDGE_START, half_edge_vectors
from solver.linear.grab import Moments
from solver.linear.rest_surface import RestSurface
from solver.surface.attachments import Attachments
from solver.types import FloatArray, IntArray


class FineStructure:
    """What one set of constraints settles: unknowns, what counts for them, and the analysis.

    It knows nothing of the material, so that all binds with the same constraints share it.

    free: the vertices to solve for.  vertices: those and all that they depend on.
    faces: the triangles with a free corner.  corners: (a, 3) theirs.  attachments: with a free end.
    ends: (k, 4) theirs. Corners and ends are numbers among `vertices`.
    """

    def __init__(
        self, rest: RestSurface, free: IntArray, attachments: Attachments, order: IntArray | None
    ) -> None:
        """order: of all vertices, such that factors stay sparse."""
        self.rest, self.free = rest, free
        number = np.full(len(rest.vertices), -1)
        number[free] = np.arange(len(free))
        self.faces = np.flatnonzero((number[rest.faces] >= 0).any(axis=1))
        ends = np.column_stack([attachments.vertex, rest.faces[attachments.face]])
        some = np.asarray((number[ends] >= 0).any(axis=1))
        self.attachments = attachments.where(some)
        corners, ends = rest.faces[self.faces], ends[some]
        self.vertices = np.unique(np.concatenate([free, corners.ravel(), ends.ravel()]))
        self.corners = np.searchsorted(self.vertices, corners)
        self.ends = np.searchsorted(self.vertices, ends)
        self.unknowns = np.searchsorted(self.vertices, free)
        if order is not None:
            order = number[order]
            order = order[order >= 0]
        self._order = order
        self._analysis: Analysis | None = None

    def factor(self, A: sp.csr_array) -> Factor:
        """A factor of A over the free vertices. Its pattern is analysed the first time."""
        lower = sp.coo_array(sp.tril(A))
        if self._analysis is None:
            rows, columns = (np.asarray(index, dtype=np.int64) for index in lower.coords)
            self._analysis = analyse(rows, columns, len(self.free), self._order)
        return self._analysis.factor(lower.data)


class FinePoisson:
    """Free positions that suit rotations R_v at the vertices:

        argmin_X 1/2 sum w_eT sigma_e ||x_b - x_a - R_T (p_b - p_a)||^2
            + 1/2 sum over attachments a_b ||x_b - sum lambda_i x_i - R_s (p_b - q)||^2

    with R_T the mean of the three R_v of a triangle, held vertices at their targets and the
    moments of soft handles met.
    """

    def __init__(self, structure: FineStructure, sigma: FloatArray, C: FloatArray) -> None:
        """sigma: (e,) gain of each edge.  C: (free, j) what moments are taken with."""
        self._structure = structure
        rest, faces = structure.rest, structure.faces
        d = half_edge_vectors(rest.points, rest.faces[faces])
        w = stretching_weights(half_edge_cotangents(np.linalg.norm(d, axis=2)))
        w *= sigma[rest.topology.half_edge_edge[faces]]
        self._rows = self._stiffness(w)
        self._turning = self._coupling(w[:, :, None] * d)
        inner = self._rows[:, structure.unknowns]
        self._factor = structure.factor(inner)
        known = rest.points[structure.free].sum(axis=1)
        check_factor(self._factor, known, inner @ known)
        self._conditions = Moments(C, self._factor.solve(C))

    def _stiffness(self, w: FloatArray) -> sp.csr_array:
        """(free, vertices) rows of the matrix, from weights (a, 3) of half-edges."""
        s = self._structure
        a, b = s.corners[:, HALF_EDGE_START].ravel(), s.corners[:, HALF_EDGE_END].ravel()
        v, c = w.ravel(), self._coefficients
        own = s.attachments.weight[:, None, None] * c[:, :, None] * c[:, None, :]
        rows = [a, b, a, b, np.repeat(s.ends, 4, axis=1).ravel()]
        columns = [a, b, b, a, np.tile(s.ends, 4).ravel()]
        values = np.concatenate([v, v, -v, -v, own.ravel()])
        entries = values, (np.concatenate(rows), np.concatenate(columns))
        shape = (len(s.vertices), len(s.vertices))
        return sp.csr_array(sp.coo_array(entries, shape=shape))[s.unknowns]

    def _coupling(self, wd: FloatArray) -> sp.csr_array:
        """(3a + 3k, vertices) how a triangle's or an attachment's rotation pulls at vertices."""
        s = self._structure
        pull = wd[:, HALF_EDGE_END] - wd[:, HALF_EDGE_START]
        arms = s.attachments.weight[:, None] * s.attachments.offset
        joint = -self._coefficients[:, :, None] * arms[:, None]
        triangles = _block_rows(pull, s.corners, len(s.vertices))
        return sp.csr_array(
            sp.vstack([triangles, _block_rows(joint, s.ends, len(s.vertices))], format="csr")
        )

    @property
    def _coefficients(self) -> FloatArray:
        """(k, 4) of the positions in each attachment."""
        return self._structure.attachments.coefficients[:, :4]

    def moments(self, X: FloatArray) -> FloatArray:
        """The moments of positions X (n, 3), which `positions` is to keep."""
        return self._conditions.of(X[self._structure.free])

    def positions(self, X: FloatArray, R: FloatArray, moments: FloatArray) -> FloatArray:
        """X (n, 3) with its free vertices where they suit R, rows (v, 3, 3) of R' at `vertices`."""
        s = self._structure
        X = X.copy()
        X[s.free] = 0.0
        rows = R.reshape(-1, 9)
        sides = (rows[s.corners[:, 0]] + rows[s.corners[:, 1]] + rows[s.corners[:, 2]]) / 3.0
        joints = rows[s.ends[:, 1:]].mean(axis=1)
        frames = np.concatenate([sides, joints]).reshape(-1, 3)
        pull = self._rows @ X[s.vertices] + (self._turning.T @ frames)[s.unknowns]
        X[s.free] = self._conditions.meet(-self._factor.solve(pull), moments)
        return X


def _block_rows(values: FloatArray, columns: IntArray, width: int) -> sp.csr_array:
    """(3k, width): row 3t + i has values[t, :, i] at columns[t], for values (k, s, 3)."""
    count, size = columns.shape
    data = values.transpose(0, 2, 1).ravel()
    ends = np.arange(0, 3 * size * count + 1, size)
    index = np.repeat(columns[:, None], 3, axis=1).ravel()
    return sp.csr_array((data, index, ends), shape=(3 * count, width))
