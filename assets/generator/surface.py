"""From an implicit solid to an even triangle mesh: marching cubes, remeshing, relaxation."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import gpytoolbox  # type: ignore[import-untyped, import-not-found]
import numpy as np
from skimage.measure import marching_cubes

from assets.generator.implicit import Field, project
from assets.generator.relaxation import relax
from solver.types import FloatArray, IntArray

BLOCK = 4


def polygonise(
    field: Field, low: Sequence[float], high: Sequence[float], spacing: float
) -> tuple[FloatArray, IntArray]:
    """Marching cubes of the zero level in a box; normals point outward.

    A coarse pass finds the blocks near the surface, so that only those are sampled finely.
    """
    origin = np.asarray(low, dtype=float)
    counts = np.ceil((np.asarray(high) - origin) / (spacing * BLOCK)).astype(int)
    blocks = np.stack(np.unravel_index(np.arange(counts.prod()), counts), axis=1)
    middle = origin + spacing * (BLOCK * blocks + (BLOCK - 1) / 2)
    values = field(middle).reshape(counts)
    for axis in range(3):
        values = values.repeat(BLOCK, axis=axis)
    near = np.flatnonzero(np.abs(values) < 3 * BLOCK * spacing)
    index = np.stack(np.unravel_index(near, values.shape), axis=1)
    values.ravel()[near] = field(origin + spacing * index)
    V, F, _, _ = marching_cubes(  # type: ignore[no-untyped-call]
        values, 0.0, gradient_direction="descent"
    )
    return origin + spacing * V.astype(float), F.astype(np.int64)


@dataclass(frozen=True)
class Enlargement:
    """A change of coordinates that makes a limb larger beyond a place on its axis.

    Scale 1 before `start` (distance from the origin along `axis`), `scale` beyond `end`, smooth
    between; `centre` is where the limb's axis crosses the other two coordinates. Remeshing in
    enlarged space gives small parts small triangles.
    """

    axis: int
    centre: tuple[float, float]
    start: float
    end: float
    scale: float

    def forward(self, p: FloatArray) -> FloatArray:
        place, stretched, scale = self._tables()
        t = np.abs(p[:, self.axis])
        return self._move(p, np.interp(t, place, stretched), np.interp(t, place, scale))

    def backward(self, q: FloatArray) -> FloatArray:
        place, stretched, scale = self._tables()
        t = np.interp(np.abs(q[:, self.axis]), stretched, place)
        return self._move(q, t, 1 / np.interp(t, place, scale))

    def _move(self, p: FloatArray, along: FloatArray, factor: FloatArray) -> FloatArray:
        others = [i for i in range(3) if i != self.axis]
        q = np.empty_like(p)
        q[:, self.axis] = np.sign(p[:, self.axis]) * along
        q[:, others] = self.centre + factor[:, None] * (p[:, others] - self.centre)
        return q

    def _tables(self) -> tuple[FloatArray, FloatArray, FloatArray]:
        place = np.linspace(0, 3, 12001)
        w = np.clip((place - self.start) / (self.end - self.start), 0, 1)
        scale = 1 + (self.scale - 1) * w * w * (3 - 2 * w)
        stretched = np.concatenate(([0.0], np.cumsum((scale[1:] + scale[:-1]) / 2) * place[1]))
        return place, stretched, scale


def remesh(
    field: Field, V: FloatArray, F: IntArray, edge: float, detail: Sequence[Enlargement]
) -> tuple[FloatArray, IntArray]:
    """Isotropic triangles of edge length `edge`, smaller in the parts that `detail` enlarges.

    Botsch and Kobbelt, "A remeshing approach to multiresolution modeling", 2004.
    """
    for part in detail:
        V = part.forward(V)
    V, F = gpytoolbox.remesh_botsch(V, F, i=20, h=edge, project=True)
    for part in reversed(detail):
        V = part.backward(V)
    return relax(field, project(field, V), F), F.astype(np.int64)
