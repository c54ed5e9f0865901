"""Cotangent weights that do not break on right angles, obtuse angles or slivers."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from solver.geometry.topology import FacePairs
from solver.types import FloatArray, IntArray

REGULAR = 1.0 / np.sqrt(3.0)  # cotangent of the 60 degree angle of a regular triangle
# Regular grids have zero cotangents and scans negative ones: both would make the energy
# singular or indefinite. Needles would drown everything else in rounding.
SMALLEST = 1e-3 * REGULAR
LARGEST = 1e3 * REGULAR
# Twice the area, relative to the squared longest edge, below which angles are noise.
DEGENERATE = 1e-12


def half_edge_cotangents(lengths: FloatArray) -> FloatArray:
    """Cotangent of the angle opposite each half-edge, (m, 3), unclamped.

    lengths: (m, 3) edge lengths opposite each corner. Only lengths are used, so that the
    weights belong to the first fundamental form. A triangle without area has no angles and is
    given those of a regular one.
    """
    squares = lengths**2
    double_area = 2.0 * heron(lengths)
    flat = double_area <= DEGENERATE * squares.max(axis=1)
    rising = squares.sum(axis=1, keepdims=True) - 2.0 * squares  # b^2 + c^2 - a^2
    with np.errstate(divide="ignore", invalid="ignore"):
        cotangents = rising / (2.0 * double_area[:, None])
    cotangents[flat] = REGULAR
    return cotangents


def heron(lengths: FloatArray) -> FloatArray:
    """Area of each triangle from its three edge lengths, (m,). [Kahan 2014: stable for needles]"""
    c, b, a = np.sort(lengths, axis=1).T
    squared = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c))
    area: FloatArray = 0.25 * np.sqrt(np.maximum(squared, 0.0))
    return area


def stretching_weights(cotangents: FloatArray) -> FloatArray:
    """w_eT, (m, 3): the cotangent opposite each half-edge, clamped to positive values."""
    return np.clip(cotangents, SMALLEST, LARGEST)


def bending_weights(
    cotangents: FloatArray,
    first: tuple[IntArray, IntArray],
    second: tuple[IntArray, IntArray],
) -> FloatArray:
    """w_e = (cot alpha + cot beta) / 2 of each two neighbours, (p,), bounded from below.

    w_e is at least the reciprocal of the sum of a triangle's three cotangents (the mean of the
    two triangles'), which for regular triangles is w_e itself. Without a bound the halves of a
    right-angled grid's square would share one frame, while the gradients of x in them differ
    by the curvature times an edge: a cost of bending that neither l nor a gain could lower.

    first, second: (triangle, half-edge) indices of the two sides.
    """
    mean = 0.5 * (cotangents[first] + cotangents[second])
    total = cotangents.sum(axis=1)
    bound = 2.0 / (total[first[0]] + total[second[0]])
    return np.clip(np.maximum(mean, bound), SMALLEST, LARGEST)


def typical_edge(lengths: FloatArray) -> float:
    """h: the median over triangles of their root mean square edge, from lengths (m, 3).

    The median, because a few large triangles, a floor under a figure, must not count for all.
    """
    return float(np.sqrt(np.median((lengths**2).mean(axis=1)))) if len(lengths) else 0.0


@dataclass(frozen=True)
class ElementWeights:
    """Weights of the two energies.

    stretching: (m, 3) w_eT of each half-edge, times sigma_e.
    bending: (q,) w_e^-1 of each of the topology's links, times beta_e and l^2; divided by k - 1
        on an edge with k triangles, see FacePairs.partners.
    """

    stretching: FloatArray
    bending: FloatArray


def rest_weights(half_edge_lengths: FloatArray, pairs: FacePairs) -> ElementWeights:
    """The rigid weights of half-edges and pairs, from edge lengths (m, 3) alone; l = 1."""
    cotangents = half_edge_cotangents(half_edge_lengths)
    first, second = (pairs.first, pairs.half_first), (pairs.second, pairs.half_second)
    w = bending_weights(cotangents, first, second)
    return ElementWeights(stretching_weights(cotangents), 1.0 / (w * pairs.partners))
