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

VERTICES = "".join(f"v {x} {y} {z}\n" for z in (0, 1) for y in (0, 1) for x in (0, 1))
SIDES = ((3, 4, 2, 1), (5, 6, 8, 7), (1, 2, 6, 5), (2, 4, 8, 6), (4, 3, 7, 8), (3, 1, 5, 7))


def cube(folder: Path) -> Mesh:
    """Of triangles, the two of each side smooth together."""
    lines = [VERTICES]
    for number, side in enumerate(SIDES, start=1):
        lines.append("s {0}\nf {1} {2} {3}\nf {1} {3} {4}\n".format(number, *side))
    return load(folder, "".join(lines))


def load(folder: Path, text: str) -> Mesh:
    path = folder / "cube.obj"
    path.write_text(text)
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
    mesh = cube(tmp_path)
    hard, smooth = shaded(mesh, hard=True), shaded(mesh, hard=False)
    assert in_place(mesh, hard)
    assert in_place(mesh, smooth)
    assert len(hard.of(mesh.vertices)) == 24
    assert np.abs(normals(mesh, hard)).max(axis=2).min() == 1, "each along an axis"
    assert np.abs(normals(mesh, smooth)).max() < 0.95


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
    mesh = cube(tmp_path)
    seen = np.arange(12) % 5 == 0
    drawn = shaded(mesh, hard=True, seen=seen)
    assert isinstance(drawn.polygons, np.ndarray)
    np.testing.assert_array_equal(
        drawn.of(mesh.vertices)[drawn.polygons], mesh.vertices[np.asarray(mesh.polygons)[seen]]
    )


def test_the_file_decides_until_the_person_does(tmp_path: Path) -> None:
    person = Person(cube(tmp_path))
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


def test_what_is_flat_in_the_file_is_shaded_flat_without_more_vertices(tmp_path: Path) -> None:
    faces = "".join("f {} {} {} {}\n".format(*side) for side in SIDES)
    person = Person(load(tmp_path, VERTICES + "s off\n" + faces))
    seen = []
    for shading in ("file", "smooth"):
        person.do(c.SetLooks(shading=shading))
        scene = person.editor.scene()
        seen.append((scene.looks.shading, len(scene.shaded.of(scene.positions))))
    assert seen == [("flat", 8), ("smooth", 8)]
