"""Softness as the tests of its brush look at it."""

from __future__ import annotations

import numpy as np

from app.editor import commands as c
from solver.geometry.laplacian import cotangent_laplacian
from solver.types import FloatArray, IntArray
from tests.app.person import Person

MIDDLE = [15.0, 10.0, 0.0]


def softness(person: Person) -> FloatArray:
    return person.editor.document.softness.copy()


def at(person: Person, point: list[float]) -> int:
    away = person.editor.document.mesh.vertices - point
    return int(np.linalg.norm(away, axis=1).argmin())


def pins(person: Person) -> IntArray:
    return np.flatnonzero(person.editor.document.pinned)


def dirichlet(person: Person) -> float:
    mesh, s = person.editor.document.mesh, person.editor.document.softness
    return float(s @ (cotangent_laplacian(mesh.vertices, mesh.faces) @ s))


def dab(person: Person, value: float, *points: list[float]) -> None:
    person.do(c.SetBrush(mode="set", value=value))
    for point in points:
        person.stroke(point)
