"""The handle nearest to the cursor, while the camera rests and other things change."""

from __future__ import annotations

import numpy as np

from app.editor import commands as c
from app.viewpoint.camera import FIELD_OF_VIEW, Camera
from app.viewpoint.events import Input
from app.workspace.nearby import near_handle
from solver.types import FloatArray
from tests.app.person import Person


def near(person: Person, camera: Camera, point: FloatArray) -> int | None:
    """The key of the handle within ten pixels of where a point is seen."""
    ((x, y),) = camera.project(point[None])
    found = near_handle(person.editor, Input((float(x), float(y)), camera), 10.0)
    return None if found is None else found[0]


def test_it_is_found_where_it_is_by_now(ready: Person) -> None:
    editor, key = ready.editor, ready.editor.document.handles[0].key
    camera = Camera.look_at(ready.eye, ready.centre, FIELD_OF_VIEW, (1280, 800))
    nearer = Camera.look_at(ready.eye / 2, ready.centre, FIELD_OF_VIEW, (1280, 800))
    beside, later = np.array([20.4, 2, 0]), np.array([20.4, 8, 0])
    assert near(ready, camera, beside) == key
    assert near(ready, nearer, beside) is None, "ten pixels are less from nearby"
    assert near(ready, camera, later) is None
    ready.do(c.SetPosition(1, 8.0))
    editor.settle()
    assert near(ready, camera, beside) is None
    assert near(ready, camera, later) == key
    ready.do(c.Undo())
    assert near(ready, camera, beside) == key
    editor.show_part(0, False)
    assert near(ready, camera, beside) is None
    editor.show_part(0, True)
    assert near(ready, camera, beside) == key
    ready.do(c.RemoveHandle(key))
    assert near(ready, camera, beside) is None


def test_handles_behind_the_camera_are_near_to_nothing(ready: Person) -> None:
    behind = Camera.look_at([20.4, 2, -30], [20.4, 2, -60], FIELD_OF_VIEW, (1280, 800))
    found = near_handle(ready.editor, Input((640.0, 400.0), behind), 10.0)
    assert found is None
