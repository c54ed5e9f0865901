"""Hard edges: which corners of polygons a file shades as one."""

from __future__ import annotations

import numpy as np

from solver.geometry.topology import components
from solver.mesh.formats.format import Smoothing
from solver.types import BoolArray, FloatArray, IntArray

# Normals are compared in cells of this size, a degree, so that digits lost in a file do not matter.
_CELL = 1 / 64
# Two numbers nearer than a quarter of a cell are parted by one of four shifted grids at most, two
# normals by three of them: there is one in which they share a cell.
_SHIFTS = np.arange(4) / 4


def all_flat(smoothing: Smoothing, sizes: IntArray) -> bool:
    """Whether no polygon is smooth with another: each has one normal, or a group of its own.

    sizes: (p,) how many corners each polygon has.
    """
    alike, normals = smoothing.alike, smoothing.normals
    first = np.repeat(alike[np.cumsum(sizes) - sizes], sizes)
    if (alike < 0).any() or (alike == alike[0]).all():  # one for all is there for form's sake
        return False
    named = (alike < len(normals)) & (first < len(normals))
    differ = named & (alike != first)
    apart = _unit(normals[alike[differ]]) - _unit(normals[first[differ]])
    if (alike != first)[~named].any() or np.abs(apart).max(initial=0.0) > _CELL / 4:
        return False
    return bool((np.bincount(alike)[alike] <= np.repeat(sizes, sizes))[~named].all())


def smooth_corners(smoothing: Smoothing, place: IntArray) -> IntArray | None:
    """(sum,) the number of the smooth vertex of each corner; None where places are such vertices.

    place: (sum,) of each corner; one that is smooth keeps its number.
    """
    alike, count = smoothing.alike, int(place.max(initial=-1)) + 1
    one = np.full(count, -1)
    one[place] = alike
    mixed = np.zeros(count, dtype=bool)
    mixed[place[alike != one[place]]] = True
    at = np.flatnonzero(mixed[place])
    if not at.size:
        return None
    span = int(alike.max()) + 2
    pairs, pair_of = np.unique(place[at] * span + alike[at] + 1, return_inverse=True)
    where, kind = np.divmod(pairs, span)
    number = _numbers(where, _merged(where, kind - 1, smoothing.normals), count)
    if number.max() < count:
        return None
    result = place.copy()
    result[at] = number[pair_of]
    return result


def _merged(place: IntArray, kind: IntArray, normals: FloatArray) -> IntArray:
    """(k,) a number for each pair of a place and what is said there: the same where that is one."""
    named = np.flatnonzero((kind >= 0) & (kind < len(normals)))
    cells = _unit(normals[kind[named]]) / _CELL
    links = []
    for shift in _SHIFTS:
        x, y, z = (np.floor(cells + shift).astype(np.int64) + 128).T  # each in eight bits
        keys = (((place[named] << 8 | x) << 8 | y) << 8) | z
        order = np.argsort(keys, kind="stable")
        same = np.flatnonzero(np.diff(keys[order]) == 0)
        links.append(named[np.column_stack([order[same], order[same + 1]])])
    return components(np.concatenate(links), len(place))


def _numbers(place: IntArray, merged: IntArray, count: int) -> IntArray:
    """(k,) a vertex for each: the first of a place is the place's own, others are new."""
    _, first = np.unique(merged, return_index=True)
    own = _first_of_each(place[first])
    number = place[first]
    number[~own] = count + np.arange(np.count_nonzero(~own))
    return number[merged]


def _first_of_each(values: IntArray) -> BoolArray:
    """(k,) whether a value appears for the first time."""
    result = np.zeros(len(values), dtype=bool)
    result[np.unique(values, return_index=True)[1]] = True
    return result


def _unit(vectors: FloatArray) -> FloatArray:
    """Unreadable ones and those without length become zero."""
    size = np.linalg.norm(vectors, axis=1, keepdims=True)
    return np.divide(
        vectors, size, out=np.zeros_like(vectors), where=np.isfinite(size) & (size > 0)
    )
