"""A slider of the material under a posed surface: every bind is shown."""

from __future__ import annotations

import dataclasses

import numpy as np

from app.editor import commands as c
from solver import Material
from tests.app.person import Person


def test_every_bind_of_a_slide_is_shown_and_the_slide_is_one_entry(ready: Person) -> None:
    ready.use("softness", 3)
    ready.stroke([10, 2, 0])
    ready.use("drag")
    ready.stroke([19, 2, 0], [12, 8, 0])
    ready.editor.settle()
    entries, shown = len(ready.editor.history.done), ready.editor.positions
    for gain in np.geomspace(0.08, 0.01, 5):
        ready.frame(None, "d")
        ready.do(c.SetMaterial(Material(float(gain), 1.0)))
        assert np.abs(ready.editor.positions - shown).max() > 1e-5
        shown = ready.editor.positions
    ready.frame(None, "r")
    assert len(ready.editor.history.done) == entries + 1


def test_a_bind_comes_with_the_pose_that_was_asked_for(ready: Person) -> None:
    ready.stroke([19, 2, 0], [12, 8, 0])
    ready.do(c.SetSetting("bending_length", 0.03))
    bound = ready.editor.surface.bound
    assert bound is not None
    assert bound.pose is not None
    assert ready.editor.positions is bound.pose.positions
    ready.do(c.ResetPose(), c.SetSetting("bending_length", 0.02))
    bound = ready.editor.surface.bound
    assert bound is not None
    assert bound.pose is None
    assert dataclasses.is_dataclass(bound)
