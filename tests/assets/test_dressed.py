"""What the dressed figure promises: named parts, seams that weld, clothes on skin, a session."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path

import igl
import numpy as np
import pytest
from scipy.spatial import cKDTree

from app.model.handles import FIXED
from app.model.session.reading import read_session, to_document
from assets.generator import elbow, figure
from assets.generator.character.clothes import SHELLS
from assets.generator.character.details import details
from assets.generator.character.shells import Thickness
from solver import Deformer, load_mesh
from solver.geometry.welding import welded_surface
from solver.mesh.mesh import Mesh
from solver.types import BoolArray, FloatArray, IntArray

ASSETS = Path(__file__).resolve().parents[2] / "assets"
ROUNDED = 1e-5
"""Of a position that the file gives with five decimals."""
NAILS = [f"{finger} nail" for finger in ("thumb", "index", "middle", "ring", "little")]
NAMES = {
    *("body", "shirt", "trousers", "hair", "collar", "belt", "buckle"),
    *(f"lock {k}" for k in range(1, 6)),
    *(f"button {k}" for k in range(1, 7)),
    *(f"{side} {one}" for side in ("left", "right") for one in ("shoe", "cuff", *NAILS)),
    *(f"{side} {one}" for side in ("left", "right") for one in ("eye", "iris", "brow")),
}


@cache
def mesh() -> Mesh:
    return load_mesh(ASSETS / "dressed.obj")


@cache
def parts() -> dict[str, BoolArray]:
    """(n,) masks of vertices by the name of their object."""
    groups, outlines = mesh().groups, mesh().outlines
    assert groups is not None
    number = np.full(len(mesh().vertices), -1)
    number[outlines.corners] = np.repeat(groups.of_polygon, outlines.sizes)
    return {name: number == k for k, name in enumerate(groups.names)}


def surface(name: str) -> tuple[FloatArray, IntArray]:
    """One part without its seams."""
    mask, F = parts()[name], mesh().faces
    number = np.cumsum(mask) - 1
    V, G, _ = welded_surface(mesh().vertices[mask], number[F[mask[F[:, 0]]]])
    return V, G


def test_every_object_is_one_piece_and_has_its_name() -> None:
    assert set(parts()) == NAMES
    pieces = [set(mesh().pieces[mask].tolist()) for mask in parts().values()]
    assert all(len(one) == 1 for one in pieces)
    assert len(set.union(*pieces)) == len(NAMES)


def test_seams_repeat_vertices_that_weld() -> None:
    V, F = mesh().vertices, mesh().faces
    welded = welded_surface(V, F)[0]
    assert len(welded) < 20_000
    assert len(V) - len(welded) > 1_000
    for name in ("body", "shirt"):
        assert len(surface(name)[0]) < parts()[name].sum()


def test_every_vertex_has_a_uv_and_every_object_a_material() -> None:
    rows = [line.split() for line in (ASSETS / "dressed.obj").read_text("ascii").splitlines()]
    uv = np.array([row[1:] for row in rows if row[0] == "vt"], dtype=float)
    assert len(uv) == len(mesh().vertices)
    assert uv.min() >= 0
    assert uv.max() <= 1
    assert all(a == b for row in rows if row[0] == "f" for a, b in (c.split("/") for c in row[1:]))
    assert sum(row[0] == "usemtl" for row in rows) == len(NAMES)


def test_the_body_is_the_mannequin() -> None:
    mannequin = load_mesh(ASSETS / "mannequin.obj")
    V, F = surface("body")
    distance, number = cKDTree(mannequin.vertices).query(V)
    assert distance.max() < ROUNDED
    assert len(V) == len(mannequin.vertices)
    same = {frozenset(face) for face in number[F].tolist()}
    assert same == {frozenset(face) for face in mannequin.faces.tolist()}


@pytest.mark.parametrize(("name", "thickness"), [(one.name, one.thickness) for one in SHELLS])
def test_clothes_lie_above_the_skin_by_their_thickness(name: str, thickness: Thickness) -> None:
    V, _ = surface(name)
    np.testing.assert_allclose(figure.body()(V), thickness(V), atol=2 * ROUNDED)


def test_clothes_have_no_thin_triangles() -> None:
    angles = [np.degrees(igl.internal_angles(*surface(one.name))).min(axis=1) for one in SHELLS]
    assert np.mean(np.concatenate(angles) < 20) < 0.002


def test_small_things_are_what_their_program_makes() -> None:
    made = {part.name: part for part in details(figure.body())}
    assert len(made) == 28
    for name, part in made.items():
        V, _ = surface(name)
        assert cKDTree(part.V).query(V)[0].max() < ROUNDED
        assert cKDTree(V).query(part.V)[0].max() < ROUNDED


def test_the_session_fits_and_holds_skin_and_nails_alone() -> None:
    session = read_session(ASSETS / "dressed-elbow.json")
    document = to_document(session, mesh(), session.mesh_path)
    assert session.mesh_path == ASSETS / "dressed.obj"
    (hand,) = document.handles
    held = {name for name, mask in parts().items() if mask[document.vertices_of(hand.key)].any()}
    assert held == {"body", *(f"left {nail}" for nail in NAILS)}
    assert parts()["body"][document.role == FIXED].all()
    assert document.softness[parts()["shirt"]].max() > 0.99
    assert not document.softness[document.vertices_of(hand.key)].any()


def test_the_session_is_the_one_its_program_makes() -> None:
    found = json.loads((ASSETS / "dressed-elbow.json").read_text("ascii"))
    V, F = mesh().vertices, mesh().faces
    made = json.loads(elbow.session_text("dressed.obj", V, F, parts()["body"]))
    np.testing.assert_allclose(made.pop("softness"), found.pop("softness"), atol=1.01e-4)
    assert made == found


def test_what_is_on_the_head_turns_with_it() -> None:
    V, F = mesh().vertices, mesh().faces
    body = parts()["body"]
    T = np.eye(4)
    angle = np.radians(40)
    T[:3, :3] = [
        [np.cos(angle), 0, np.sin(angle)],
        [0, 1, 0],
        [-np.sin(angle), 0, np.cos(angle)],
    ]
    head, trunk = body & (V[:, 1] > 1.6), body & (V[:, 1] < 1.46)
    deformer = Deformer(V, F, np.flatnonzero(trunk), [np.flatnonzero(head)])
    X = deformer.pose([T], rigid=4)
    on_head = [n for n in NAMES if n.split()[-1] in ("eye", "iris", "brow")]
    on_head += ["hair", *(f"lock {k}" for k in range(1, 6))]
    turned = V @ T[:3, :3].T
    for name in on_head:
        np.testing.assert_allclose(X[parts()[name]], turned[parts()[name]], atol=1e-4)
    for name in ("trousers", "belt", "left shoe"):
        np.testing.assert_allclose(X[parts()[name]], V[parts()[name]], atol=1e-4)
