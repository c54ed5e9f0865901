"""What a person is warned of before folding: creases and tears."""

from __future__ import annotations

import numpy as np

from app.bundled import DEFAULT_SESSION
from app.editor import commands as c
from app.editor.editor import Editor
from app.editor.files.actions import load_document
from app.editor.softness_warnings import STEEP, WEAK
from app.model.handles import FIXED
from solver import Material
from tests.app.inline import InlineWorker
from tests.app.person import Person, slab


def default_editor() -> Editor:
    return Editor(load_document(None, DEFAULT_SESSION), InlineWorker(), DEFAULT_SESSION)


def texts(editor: Editor) -> list[str]:
    return [warning.text for warning in editor.warnings]


def test_the_default_session_and_a_stroke_of_the_default_brush_are_fine() -> None:
    editor = default_editor()
    assert not editor.warnings
    person = Person(editor.document.mesh, eye=(0, 0, 6))
    person.use("softness")
    person.stroke([0.3, 1.42, 0.0], [0.5, 1.42, 0.0])
    assert person.editor.document.softness.max() > 0.9
    assert not person.editor.warnings


def test_a_step_warns_of_a_crease_and_one_click_mends_it() -> None:
    editor = default_editor()
    x = editor.document.mesh.vertices[:, 0]
    with editor.edit("step") as gesture:
        gesture.change("softness", (np.abs(x - 0.465) < 0.1).astype(float), np.arange(len(x)))
    assert texts(editor) == [STEEP]
    (warning,) = editor.warnings
    np.testing.assert_allclose(np.abs(x[warning.vertices] - 0.465), 0.1, atol=0.03)
    before = editor.document.softness.copy()
    editor.execute(c.SmoothSoftness(tuple(warning.vertices.tolist())))
    assert not editor.warnings
    changed = editor.document.softness != before
    assert np.abs(np.abs(x[changed] - 0.465) - 0.1).max() < 0.3, "only there"
    editor.execute(c.Undo())
    assert texts(editor) == [STEEP]


def test_a_material_that_gives_way_warns_of_tearing() -> None:
    editor = default_editor()
    for stretching, expected in ((0.1, []), (0.01, [WEAK]), (1.0, [])):
        editor.execute(c.SetMaterial(Material(1.0, stretching)))
        assert texts(editor) == expected


def test_what_cannot_bend_is_not_warned_of() -> None:
    person = Person(slab(20, 4, 2.0))
    with person.editor.edit("fix all") as gesture:
        gesture.change("role", FIXED, np.arange(len(person.editor.document.role)))
    person.use("softness", 0.5)
    person.stroke([10, 2, 0])
    assert not person.editor.warnings
    person.do(c.ClearFixed())
    assert texts(person.editor) == [STEEP]


def test_a_click_on_a_warning_shows_the_place() -> None:
    editor = default_editor()
    x = editor.document.mesh.vertices[:, 0]
    with editor.edit("step") as gesture:
        gesture.change("softness", (np.abs(x - 0.465) < 0.1).astype(float), np.arange(len(x)))
    (warning,) = editor.warnings
    editor.execute(c.FrameVertices(tuple(warning.vertices.tolist())))
    np.testing.assert_allclose(editor.viewpoint.pivot[0], 0.465, atol=0.02)
    pixels = editor.viewpoint.camera.project(editor.positions[warning.vertices])
    assert (pixels > 0).all()
    assert (pixels < editor.viewpoint.camera.size).all()
