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


def test_their_pictures_are_one_picture_shifted(ready: Person) -> None:
    """From wherever the camera is: so seen from one side, and as large."""
    ready.do(c.SetLooks(beside=True))
    twin = ready.editor.scene().twin
    assert twin is not None
    rng = np.random.default_rng(0)
    for side in ("front", "left", "top"):
        ready.do(c.ViewFrom(side))
        camera = ready.editor.viewpoint.camera
        camera = camera.placed(camera.position + rng.uniform(-3, 3, size=3))
        T = twin.place(camera)
        here = camera.project(twin.positions)
        shift = camera.project(moved(T, twin.positions)) - here
        np.testing.assert_allclose(shift, np.broadcast_to(shift[0], shift.shape), atol=1e-6)
        assert shift[0, 1] == pytest.approx(0)
        middle = moved(T, twin.middle[None])[0]
        np.testing.assert_allclose(middle, twin.middle - twin.away * camera.right, atol=1e-9)
    for close in (twin.middle, twin.middle + camera.forward):
        T = twin.place(camera.placed(close))
        assert np.isfinite(T).all()
        assert np.linalg.det(T[:3, :3]) == pytest.approx(1)
