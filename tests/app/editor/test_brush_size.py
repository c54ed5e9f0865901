"""How large the brush is: the wheel, each tool's own size, the same size on screen."""

from __future__ import annotations

import numpy as np
import pytest

from app.editor import commands as c
from solver import Mesh
from tests.app.person import Person, sheet


@pytest.fixture
def person() -> Person:
    made = Person(Mesh.from_arrays(*sheet(60, 40)), eye=(0, 0, 40))
    made.use("fixed", 3.0)
    return made


def test_the_wheel_with_ctrl_resizes_the_brush_and_leaves_the_camera(person: Person) -> None:
    editor = person.editor
    person.frame([30, 20, 0])
    camera, radius = editor.viewpoint.camera, editor.brush.radius
    person.frame([30, 20, 0], wheel=2.0, ctrl=True)
    assert editor.brush.radius > radius
    person.frame([30, 20, 0], wheel=-2.0, ctrl=True)
    assert editor.brush.radius == pytest.approx(radius)
    assert np.array_equal(editor.viewpoint.camera.position, camera.position)
    person.frame([30, 20, 0], wheel=2.0)
    assert editor.brush.radius == pytest.approx(radius)
    assert not np.array_equal(editor.viewpoint.camera.position, camera.position)
    person.use("drag")
    person.frame([30, 20, 0], wheel=2.0, ctrl=True)
    assert editor.brush.radius == pytest.approx(radius)


def test_each_tool_keeps_its_own_size(person: Person) -> None:
    editor, mine = person.editor, person.editor.brush.radius
    person.use("softness")
    assert editor.brush.radius == mine, "a tool begins with the size of the one before"
    person.do(c.SetBrush(radius=0.2))
    person.use("fixed")
    assert editor.brush.radius == mine
    person.use("navigate")
    person.use("softness")
    assert editor.brush.radius == 0.2


def painted(person: Person) -> int:
    """How many vertices a dab in the middle takes."""
    person.stroke([30, 20, 0])
    count = int(person.editor.document.role.astype(bool).sum())
    person.do(c.Undo())
    return count


def test_a_brush_of_one_size_on_screen_paints_less_from_near_by(person: Person) -> None:
    person.use("fixed", 8.0)
    person.frame([30, 20, 0])
    before = painted(person)
    # Measured otherwise, the brush stays as large as it is where the view turns.
    person.do(c.SetBrush(on_screen=True))
    assert painted(person) == before
    person.eye = person.centre + [0, 0, 20]
    assert 0.2 * before < painted(person) < 0.32 * before
    person.frame([30, 20, 0])
    near = painted(person)
    person.do(c.SetBrush(on_screen=False))
    assert painted(person) == near
    person.eye = person.centre + [0, 0, 40]
    assert painted(person) == near


def test_the_other_tools_brushes_are_measured_otherwise_too(person: Person) -> None:
    person.use("handle", 1.5)
    person.frame([30, 20, 0])
    person.do(c.SetBrush(on_screen=True))
    person.use("fixed")
    place = np.array([30.0, 20.0, 0.0]), person.editor.viewpoint.camera
    assert person.editor.brush_radius(*place) == pytest.approx(3.0)
    person.use("handle")
    assert person.editor.brush_radius(*place) == pytest.approx(1.5)
