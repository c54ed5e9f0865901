"""What tests of exact placing do and look at."""

from __future__ import annotations

import numpy as np

from app.editor import commands as c
from app.scene.overlay import Outline
from app.tools.gizmo.shape import RADIUS
from solver.types import FloatArray
from tests.app.person import Person, state

# The person looks from above: the ring about z is a circle, x to the right, y up.
BESIDE = np.array([12.0, 9.0, 0.0])


def pivot(person: Person) -> FloatArray:
    found = person.editor.pivot
    assert found is not None
    return found


def at(person: Person, radii: float, degrees: float) -> FloatArray:
    """A point of the pivot's height, so many radii of the gizmo's rings away from it."""
    person.frame(BESIDE)  # so that the camera is the person's
    reach = radii * RADIUS * person.editor.viewpoint.camera.units_per_pixel(pivot(person))
    angle = np.radians(degrees)
    return pivot(person) + reach * np.array([np.cos(angle), np.sin(angle), 0])


def type_in(person: Person, keys: str) -> None:
    for key in keys:
        person.frame(BESIDE, typed=key)


def label(person: Person) -> str:
    (found,) = person.editor.cursor.labels
    return found.text


def lines(person: Person) -> tuple[Outline, ...]:
    return person.editor.cursor.outlines


def check_one_entry(person: Person, before: tuple[object, ...], count: int, name: str) -> None:
    """What was done is one step, and undone exactly."""
    history = person.editor.history
    assert [entry.label for entry in history.done[count:]] == [name]
    person.do(c.Undo())
    assert state(person.editor.document) == before
