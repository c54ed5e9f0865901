"""Polygons of very many corners: covered once, every corner used, whatever the outline."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from solver.mesh.ear_clipping import clip_ears
from solver.mesh.polygons import MANY, Polygons, triangulate
from solver.types import FloatArray, IntArray

RANDOM = np.random.default_rng(0)


def circle(k: int) -> FloatArray:
    angle = 2 * np.pi * np.arange(k) / k
    return np.column_stack([np.cos(angle), np.sin(angle)])


def star(k: int) -> FloatArray:
    return circle(k) * RANDOM.uniform(0.2, 1, (k, 1))


def square(k: int) -> FloatArray:
    """Most corners lie on straight stretches."""
    along = np.linspace(0, 1, k // 4, endpoint=False)
    side = np.column_stack([along, 0 * along])
    turned = [side]
    for _ in range(3):
        turned.append(turned[-1] @ [[0, 1], [-1, 0]] + [1, 0])
    return np.concatenate(turned)


def comb(k: int) -> FloatArray:
    teeth = np.column_stack([np.arange(k), np.arange(k) % 2])
    return np.concatenate([teeth, [[k, -5], [-1, -5]]])[::-1]


def twice(k: int) -> FloatArray:
    """Every corner comes two times."""
    return np.repeat(circle(k // 2), 2, axis=0)


def spare(k: int) -> FloatArray:
    """A corner comes back at the end."""
    return np.concatenate([circle(k), circle(k)[-1:]])


def split(p: FloatArray) -> IntArray:
    V = np.column_stack([p, np.zeros(len(p))])
    return triangulate(V, Polygons.from_array(np.arange(len(p))[None]))


def areas(p: FloatArray, triangles: IntArray) -> FloatArray:
    a, b, c = (p[corner] for corner in triangles.T)
    u, v = b - a, c - a
    return np.asarray(0.5 * (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]))


def enclosed(p: FloatArray) -> float:
    q = np.roll(p, -1, axis=0)
    return float(0.5 * (p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]).sum())


@pytest.mark.parametrize("clockwise", [False, True])
@pytest.mark.parametrize("make", [circle, star, square, comb, twice, spare])
@pytest.mark.parametrize("k", [MANY + 4, 3000])
def test_a_polygon_is_covered_once(
    make: Callable[[int], FloatArray], k: int, clockwise: bool
) -> None:
    p = make(k)[:: -1 if clockwise else 1]
    triangles = split(p)
    assert len(triangles) == len(p) - 2
    assert len(np.unique(triangles)) == len(p)
    area, whole = areas(p, triangles), enclosed(p)
    np.testing.assert_allclose(area.sum(), whole)
    np.testing.assert_allclose(np.abs(area).sum(), abs(whole))


def test_corners_on_straight_stretches_get_triangles_with_an_area() -> None:
    p = square(400)
    assert (areas(p, split(p)) > 1e-9).all()


@pytest.mark.parametrize(
    "p",
    [
        RANDOM.random((2000, 2)),
        RANDOM.integers(0, 5, (30_000, 2)).astype(float),
        np.column_stack([np.arange(500.0), np.zeros(500)]),
        np.zeros((500, 2)),
    ],
    ids=["random", "few places", "line", "point"],
)
def test_any_outline_is_split(p: FloatArray) -> None:
    triangles = split(p)
    assert len(triangles) == len(p) - 2
    assert len(np.unique(triangles)) == len(p)
    assert (np.sort(triangles, axis=1)[:, :-1] < np.sort(triangles, axis=1)[:, 1:]).all()


def test_smaller_ones_are_split_as_ever() -> None:
    p = star(MANY)
    P = np.column_stack([p, np.zeros(MANY)])
    np.testing.assert_array_equal(split(p), clip_ears(P[None])[0])


def test_very_many_corners_take_no_time_worth_naming() -> None:
    p = circle(30_000)
    np.testing.assert_allclose(areas(p, split(p)).sum(), enclosed(p))
