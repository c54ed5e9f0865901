"""The surface as it is shaded: joined over seams, parted along hard edges."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from app.editor import commands as c
from app.scene.shading import Shaded, shaded
from solver.mesh.mesh import Mesh, load_mesh
from solver.types import FloatArray
from tests.app.person import Person, slab
from tests.solver import shapes

CUBE = """
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 0 0 1
v 1 0 1
v 1 1 1
v 0 1 1
f 4 3 2 1
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
"""


def cube(folder: Path, first: str = "") -> Mesh:
    path = folder / "cube.obj"
    path.write_text(first + CUBE)
    return load_mesh(path)


def normals(mesh: Mesh, drawn: Shaded) -> FloatArray:
    """(p, k, 3) at the corners, of smooth shading as it is done from what is drawn."""
    polygons = np.asarray(drawn.polygons)
    P = drawn.of(mesh.vertices)[polygons]
    face = np.cross(P[:, 2] - P[:, 0], P[:, -1] - P[:, 1])
    total = np.zeros((int(polygons.max()) + 1, 3))
    for corner in polygons.T:
        np.add.at(total, corner, face)
    return np.asarray((total / np.linalg.norm(total, axis=1, keepdims=True))[polygons])


def in_place(mesh: Mesh, drawn: Shaded) -> bool:
    polygons = np.asarray(drawn.polygons)
    return np.array_equal(drawn.of(mesh.vertices)[polygons], mesh.vertices[mesh.polygons])


def test_a_mesh_without_seams_and_edges_is_drawn_as_it_is() -> None:
    mesh = slab(4, 3, 0.5)
    for hard in (False, True):
        drawn = shaded(mesh, hard)
        assert drawn.polygons is mesh.polygons
        assert drawn.of(mesh.vertices) is mesh.vertices, "nothing is copied in a frame"


def test_hard_edges_have_the_normals_of_their_faces(tmp_path: Path) -> None:
    mesh = cube(tmp_path, "s off\n")
    hard, smooth = shaded(mesh, hard=True), shaded(mesh, hard=False)
    assert in_place(mesh, hard)
    assert in_place(mesh, smooth)
    assert len(hard.of(mesh.vertices)) == 24
    assert np.abs(normals(mesh, hard)).max(axis=2).min() == 1, "each along an axis"
    np.testing.assert_allclose(np.abs(normals(mesh, smooth)), np.sqrt(1 / 3))


def test_seams_are_not_seen() -> None:
    """A tube cut open has the normals of the whole one."""
    V, F = shapes.grid(9, 5)
    angle = V[:, 0] / 8 * 2 * np.pi
    rolled = np.column_stack([np.cos(angle), V[:, 1], np.sin(angle)])
    rolled[V[:, 0] == 8, 0::2] = [1, 0]
    mesh = Mesh.from_arrays(rolled, F)
    drawn = shaded(mesh, hard=True)
    assert in_place(mesh, drawn)
    assert len(drawn.of(mesh.vertices)) == len(V) - 5
    left, right = (normals(mesh, drawn)[mesh.faces == v] for v in (0, 8))
    assert len(left)
    assert (left == left[0]).all()
    np.testing.assert_array_equal(right, np.tile(left[0], (len(right), 1)))


def test_what_is_hidden_is_not_drawn(tmp_path: Path) -> None:
    mesh = cube(tmp_path, "s off\n")
    seen = np.array([True, False, True, False, False, False])
    drawn = shaded(mesh, hard=True, seen=seen)
    assert isinstance(drawn.polygons, np.ndarray)
    np.testing.assert_array_equal(
        drawn.of(mesh.vertices)[drawn.polygons], mesh.vertices[np.asarray(mesh.polygons)[seen]]
    )


def test_the_file_decides_until_the_person_does(tmp_path: Path) -> None:
    person = Person(cube(tmp_path, "s off\n"))
    corners = []
    for shading in ("", "smooth", "file", "flat"):
        if shading:
            person.do(c.SetLooks(shading=shading))
        corners.append(len(person.editor.scene().shaded.of(person.editor.positions)))
    assert corners == [24, 8, 24, 8]
    assert person.editor.scene().shaded is person.editor.scene().shaded
    person.do(c.SetLooks(shading="wet"))
    message = person.editor.message
    assert message is not None
    assert message.text == "unknown shading 'wet', expected one of smooth, flat, file"
    assert person.editor.looks.shading == "flat"
