"""A rebind shares what it can and gives what a new Deformer would."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from solver import Material
from solver.factor import Analysis, analyse
from solver.types import IntArray
from tests.solver.test_deformer import CASES


@pytest.mark.parametrize(
    "changes",
    [
        {"softness": np.linspace(0, 1, 288)},
        {"softness": None},
        {"material": "clay"},
        {"material": Material(0.5, 2)},
        {"bending_length": 0.1},
        {"orientation": False},
        {"fixed": np.arange(30)},
        {"fixed": []},
        {"handles": [np.arange(270, 288), np.arange(150, 160)]},
        {"edge_gains": ([[0, 1], [100, 112]], [0.1, 3.0], [0.5, 2.0])},
        {"softness": np.linspace(0, 1, 288), "bending_length": 0.03, "orientation": False},
    ],
    ids=lambda changes: "+".join(changes),
)
@pytest.mark.parametrize("rigid", [0, 1])
def test_rebinding_equals_building_anew(changes: dict[str, Any], rigid: int) -> None:
    arm = CASES["tube"]
    deformer = arm.deformer()
    before = deformer.pose(arm.posed, rigid)
    if "edge_gains" in changes:
        fresh = arm.deformer(softness=None, **changes)
    else:
        fresh = arm.deformer(**changes)
    other = deformer.rebind(**changes)
    np.testing.assert_allclose(
        other.pose(arm.posed, rigid), fresh.pose(arm.posed, rigid), atol=1e-9
    )
    np.testing.assert_array_equal(deformer.pose(arm.posed, rigid), before)
    back = other.rebind(**{"fixed": arm.fixed, "handles": arm.handles, "softness": arm.softness})
    back = back.rebind(material="hinge", bending_length=0.01, orientation=True)
    np.testing.assert_allclose(back.pose(arm.posed, rigid), before, atol=1e-9)


def test_rebinding_shares_the_analysis_where_the_constraints_are_the_same(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    analysed: list[int] = []

    def recording(rows: IntArray, columns: IntArray, size: int, order: IntArray | None) -> Analysis:
        analysed.append(size)
        return analyse(rows, columns, size, order)

    monkeypatch.setattr("solver.linear.system.analyse", recording)
    deformer = CASES["tube"].deformer()
    assert len(analysed) == 1
    deformer.rebind(softness=None).rebind(bending_length=0.1).rebind(material="clay")
    assert len(analysed) == 1
    deformer.rebind(fixed=[])
    assert len(analysed) == 2


def test_rebinding_refuses_an_option_it_does_not_know() -> None:
    with pytest.raises(TypeError, match="stiffness"):
        CASES["tube"].deformer().rebind(stiffness=1)
