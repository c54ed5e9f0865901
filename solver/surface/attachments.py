"""What joins the pieces of a surface: energy terms that cost nothing under any affine motion.

    E_a = 1/2 sum over b  a_b ( ||x_b - sum lambda_i x_i - G_s (p_b - q)||^2 + l^2 ||G_t - G_s||^2 )

for vertices b of one piece, q = sum lambda_i p_i the point of another piece that is closest to b,
s its triangle there and t a triangle of b. Without the second term a flat piece would leave its
normal open.
"""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np

from solver.types import BoolArray, FloatArray, IntArray


@dataclass(frozen=True, eq=False)
class Attachments:
    """k terms of E_a, in the units of the positions.

    vertex: b.  own_face: t.  face: s.  barycentric: lambda, (k, 3).  offset: p_b - q, (k, 3).
    weight: a_b.  follower: the number of the piece of b, the smaller of the two.
    """

    vertex: IntArray
    own_face: IntArray
    face: IntArray
    barycentric: FloatArray
    offset: FloatArray
    weight: FloatArray
    follower: IntArray

    @staticmethod
    def none() -> Attachments:
        """No terms."""
        no, empty = np.empty(0, dtype=np.int64), np.empty((0, 3))
        return Attachments(no, no, no, empty, empty, np.empty(0), no)

    def __len__(self) -> int:
        return len(self.vertex)

    def where(self, keep: BoolArray) -> Attachments:
        """The terms of `keep`, (k,)."""
        return Attachments(*(getattr(self, field.name)[keep] for field in fields(self)))

    def rows(self, faces: IntArray, vertex_count: int) -> IntArray:
        """(k, 7) the rows of U in each term's first residual: b, the corners of s, its frame."""
        frame = vertex_count + 3 * self.face[:, None] + np.arange(3)
        return np.column_stack([self.vertex, faces[self.face], frame])

    @property
    def coefficients(self) -> FloatArray:
        """(k, 7) of those rows."""
        return np.column_stack([np.ones(len(self)), -self.barycentric, -self.offset])


def joined(attachments: list[Attachments]) -> Attachments:
    """All terms of several."""
    parts = [Attachments.none(), *attachments]
    names = [field.name for field in fields(Attachments)]
    return Attachments(*(np.concatenate([getattr(p, name) for p in parts]) for name in names))
