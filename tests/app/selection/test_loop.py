"""Points inside a loop."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from app.selection.loop import inside_loop
from solver.types import FloatArray

SQUARE = np.array([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]])


def crossings(point: FloatArray, corners: FloatArray) -> int:
    """How many edges of the loop a ray to the right meets, one edge after the other."""
    x, y = point
    count = 0
    for (x0, y0), (x1, y1) in pairwise([*corners, corners[0]]):
        if (y0 <= y) != (y1 <= y):
            count += x0 + (x1 - x0) * (y - y0) / (y1 - y0) > x
    return count


def test_a_square_has_an_inside() -> None:
    points = np.array([[2, 2], [5, 2], [2, -1], [0.1, 3.9], [np.nan, 1]])
    np.testing.assert_array_equal(inside_loop(points, SQUARE), [True, False, False, True, False])
    np.testing.assert_array_equal(inside_loop(points, SQUARE[::-1])[:4], [True, False, False, True])


def test_a_ring_leaves_out_its_hole() -> None:
    """Around the outside, then around the hole, as a hand may draw it."""
    hole = SQUARE[::-1] * 0.5 + 1.0
    ring = np.vstack([SQUARE, SQUARE[:1], hole[3:], hole])
    inside = inside_loop(np.array([[2.0, 2.0], [0.5, 2.0], [3.5, 2.0]]), ring)
    np.testing.assert_array_equal(inside, [False, True, True])


def test_any_loop_is_what_counting_crossings_says() -> None:
    random = np.random.default_rng(3)
    for count in (0, 1, 2, 3, 7, 60):
        corners = random.normal(size=(count, 2))
        points = random.normal(size=(200, 2))
        expected = [count > 0 and crossings(point, corners) % 2 == 1 for point in points]
        np.testing.assert_array_equal(inside_loop(points, corners), expected)
