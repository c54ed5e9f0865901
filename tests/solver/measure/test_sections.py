"""Cross-sections of a limb that is bent by a formula."""

from __future__ import annotations

import numpy as np
import pytest

from solver.geometry.topology import Topology
from solver.measure.sections import Limb
from tests.solver import shapes


def test_a_fold_at_one_place_is_found_there() -> None:
    V, F = shapes.tube(80, 24)
    angle = np.radians(90) * np.clip((V[:, 0] - 3) / 2, 0, 1)
    # The axis becomes an arc of 90 degrees between 3 and 5; sections stay circles.
    along = np.clip(V[:, 0], 3, 5)
    reach = 2 / np.radians(90)
    middle = np.column_stack([3 + reach * np.sin(angle), reach * (1 - np.cos(angle)), 0 * angle])
    middle += (V[:, 0] - along)[:, None] * np.column_stack(
        [np.cos(angle), np.sin(angle), 0 * angle]
    )
    X = middle + V[:, 1:2] * np.column_stack([-np.sin(angle), np.cos(angle), 0 * angle])
    X[:, 2] += V[:, 2]
    limb = Limb(V, Topology(F, len(V)).edges, np.linspace(0.3, 7.7, 75))
    whole, half = limb.fold(X, 4, 1.2), limb.fold(X, 4, 0.5)
    assert whole.share == pytest.approx(1, abs=0.02)
    assert half.share == pytest.approx(0.5, abs=0.06)
    assert whole.section == pytest.approx(1, abs=0.02)
