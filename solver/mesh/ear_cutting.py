"""Triangles of one polygon with very many corners, where clipping ears one by one takes minutes."""

from __future__ import annotations

import mapbox_earcut
import numpy as np

from solver.types import FloatArray, IntArray


def cut_ears(p: FloatArray) -> IntArray:
    """Split a polygon of k corners in the plane, (k, 2), into triangles (k - 2, 3) of corners.

    Counter-clockwise. Corners that lie on a straight stretch divide the triangle that has it.
    A polygon that crosses itself has no ears all around: it becomes a fan about its first corner.
    """
    k = len(p)
    # Corners that come back to the same places again and again are searched for pairs, in vain.
    if 2 * len(np.unique(p[:, 0] + 1j * p[:, 1])) > k:
        cut = mapbox_earcut.triangulate_float64(p, np.array([k], dtype=np.uint32))
        triangles = _divided(np.sort(cut.reshape(-1, 3).astype(np.int64), axis=1), k)
        if triangles is not None:
            return triangles
    return np.column_stack([np.zeros(k - 2, np.int64), np.arange(1, k - 1), np.arange(2, k)])


def _divided(triangles: IntArray, k: int) -> IntArray | None:
    """With the corners that were left out put back into the sides of the outline.

    triangles: rows ascending, which keeps the polygon's own sense. None where their sides are not
    the outline of the corners that they have.
    """
    kept = np.unique(triangles)
    if len(kept) == k:
        return triangles if _is_outline(triangles, kept) else None
    if len(kept) < 3 or not _is_outline(triangles, kept):
        return None
    found = {(a, b): row for row, t in enumerate(triangles.tolist()) for a, b in _sides(t)}
    result = triangles.tolist()
    for a, b in zip(kept.tolist(), np.roll(kept, -1).tolist(), strict=True):
        between = [i % k for i in range(a + 1, b if b > a else b + k)]
        row = found.get((min(a, b), max(a, b)))
        for corner in between:
            assert row is not None
            # The triangle with the side a b becomes one with a corner, and one with corner b.
            apex = next(c for c in result[row] if c not in (a, b))
            result[row] = sorted((a, corner, apex))
            result.append(sorted((corner, b, apex)))
            for side in _sides(result[-1]):
                found[side] = len(result) - 1
            a, row = corner, len(result) - 1
    return np.array(result, dtype=np.int64)


def _sides(t: list[int]) -> list[tuple[int, int]]:
    return [(t[0], t[1]), (t[1], t[2]), (t[0], t[2])]


def _is_outline(triangles: IntArray, kept: IntArray) -> bool:
    """Whether there are as many triangles as the corners ask for, and each side of the outline is
    one triangle's and every other side two triangles'."""
    if len(triangles) != len(kept) - 2:
        return False
    low, middle, high = triangles.T
    size = kept[-1] + 1
    ends = np.concatenate([low * size + middle, middle * size + high, low * size + high])
    sides, count = np.unique(ends, return_counts=True)
    outline = np.append(kept[:-1] * size + kept[1:], kept[0] * size + kept[-1])
    return bool((count <= 2).all()) and np.array_equal(sides[count == 1], np.sort(outline))
