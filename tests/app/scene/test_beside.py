"""Before and after: the rest shape beside the surface."""

from __future__ import annotations

import numpy as np
import pytest

from app.editor import commands as c
from solver.geometry.motions import moved
from tests.app.person import Person, state


@pytest.mark.parametrize("side", ["front", "left", "top"])
def test_the_rest_shape_stands_beside_the_surface_and_both_are_seen(
    ready: Person, side: str
) -> None:
    editor = ready.editor
    before = state(editor.document)
    ready.do(c.SetLooks(beside=True), c.ViewFrom(side))
    twin, camera = editor.scene().twin, editor.viewpoint.camera
    assert twin is not None
    assert editor.scene().twin is twin
    assert editor.scene(rest=True).twin is None
    np.testing.assert_array_equal(twin.positions, editor.document.rest_positions)
    left = camera.project(moved(twin.place(camera), twin.positions))
    right = camera.project(editor.positions)
    assert left[:, 0].max() < right[:, 0].min()
    both = np.vstack([left, right])
    assert both[:, 0].min() > editor.viewpoint.inset
    assert (both > 0).all()
    assert (both < camera.size).all()
    middle = 0.5 * (editor.positions.min(axis=0) + editor.positions.max(axis=0))
    np.testing.assert_allclose(editor.viewpoint.pivot, middle)
    ready.do(c.SetLooks(beside=False))
    assert editor.scene().twin is None
    alone = editor.viewpoint.camera.project(editor.positions)
    assert np.ptp(alone, axis=0).max() > 1.5 * np.ptp(right, axis=0).max()
    assert state(editor.document) == before


def test_both_are_seen_from_one_side(ready: Person) -> None:
    """From wherever the camera is, the way to a vertex of the one is that to the other, turned."""
    ready.do(c.SetLooks(beside=True))
    twin = ready.editor.scene().twin
    assert twin is not None
    rng = np.random.default_rng(0)
    for _ in range(5):
        camera = ready.editor.viewpoint.camera
        before = twin.middle - rng.uniform(30, 90) * camera.forward
        camera = camera.placed(before + rng.uniform(-5, 5, size=3))
        T = twin.place(camera)
        np.testing.assert_allclose(T[:3, :3] @ camera.up, camera.up, atol=1e-12)
        here, there = twin.positions - camera.position, moved(T, twin.positions) - camera.position
        np.testing.assert_allclose(there, here @ T[:3, :3].T, atol=1e-9)
        arc = np.linalg.norm(moved(T, twin.middle[None])[0] - twin.middle)
        assert 0.85 * twin.away < arc <= twin.away
    near = twin.place(ready.editor.viewpoint.camera.placed(twin.middle))
    assert np.degrees(np.arccos((np.trace(near[:3, :3]) - 1) / 2)) == pytest.approx(90)
