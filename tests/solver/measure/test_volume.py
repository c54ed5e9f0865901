"""Volumes of solids with a formula, closed and capped."""

from __future__ import annotations

import numpy as np
import pytest

from solver.geometry.motions import moved, rotation_about
from solver.measure.volume import CappedSolid, volume
from tests.solver import shapes

TURN = rotation_about([1, 2, 3], 70, [4, 0, 1])


def test_a_box_has_the_product_of_its_sides() -> None:
    V, F = shapes.bar(10, 3)
    assert volume(V, F) == pytest.approx(90)
    assert volume(moved(TURN, V), F) == pytest.approx(90)
    assert volume(V, F[:, ::-1]) == pytest.approx(-90)


def test_a_tube_is_capped_at_both_ends() -> None:
    V, F = shapes.tube(24, 12, radius=1.0, length=8.0)
    section = 6 * np.sin(np.pi / 6)  # of a regular polygon of 12 corners
    solid = CappedSolid(F, len(V))
    assert solid.volume(V) == pytest.approx(8 * section)
    assert solid.volume(moved(TURN, V)) == pytest.approx(8 * section)
    assert solid.volume(V * [2, 1, 1]) == pytest.approx(16 * section)


def test_nothing_is_added_to_a_closed_surface() -> None:
    V, F = shapes.sphere()
    assert CappedSolid(F, len(V)).volume(V) == volume(V, F)
