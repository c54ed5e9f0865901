"""What the committed meshes and the default session promise to those who open them."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path
from typing import Any

import igl
import numpy as np
import pytest

from assets.generator import elbow, figure, objtext, primitives, quads
from assets.generator.implicit import gradient
from solver.geometry.topology import components
from solver.measure.volume import volume
from solver.types import BoolArray, FloatArray, IntArray

ASSETS = Path(__file__).resolve().parents[2] / "assets"
COUNTS = {"mannequin": 10_000, "arm": 4_000, "bar": 2_500, "cylinder": 3_000, "bumpy_plane": 3_000}
CLOSED = ["mannequin", "arm", "bar", "cylinder", "dog"]
SMOOTH = ["mannequin", "arm"]


def read_text(text: str) -> tuple[FloatArray, IntArray]:
    """Positions and faces of OBJ text whose faces all have the same number of corners."""
    rows = [line.split() for line in text.splitlines()]
    V = [row[1:] for row in rows if row and row[0] == "v"]
    F = [[int(c.split("/")[0]) - 1 for c in row[1:]] for row in rows if row and row[0] == "f"]
    return np.array(V, dtype=np.float64), np.array(F, dtype=np.int64)


@cache
def mesh(name: str) -> tuple[FloatArray, IntArray]:
    return read_text((ASSETS / f"{name}.obj").read_text(encoding="ascii"))


@cache
def session() -> dict[str, Any]:
    loaded: dict[str, Any] = json.loads((ASSETS / "mannequin-elbow.json").read_text())
    return loaded


def half_edges(F: IntArray) -> IntArray:
    return np.stack((F, np.roll(F, -1, axis=1)), axis=-1).reshape(-1, 2)


def pieces(n: int, ends: IntArray) -> tuple[int, IntArray]:
    """How many connected pieces the edges `ends` make of n vertices, and that of each vertex."""
    piece = components(ends, n)
    return piece.max() + 1, piece


def solid_volume(V: FloatArray, F: IntArray) -> float:
    """Inside closed faces (m, k): each is a fan of triangles."""
    return volume(V, np.concatenate([F[:, [0, i, i + 1]] for i in range(1, F.shape[1] - 1)]))


def roles() -> tuple[BoolArray, BoolArray]:
    """Masks of the session's fixed and handle vertices."""
    fixed, hand = np.zeros((2, len(mesh("mannequin")[0])), dtype=bool)
    fixed[session()["fixed"]] = True
    hand[session()["handles"][0]["vertices"]] = True
    return fixed, hand


@pytest.mark.parametrize("name", CLOSED)
def test_closed_and_oriented_outward_without_tunnels(name: str) -> None:
    V, F = mesh(name)
    directed = half_edges(F)
    unique = {tuple(e) for e in directed.tolist()}
    assert len(unique) == len(directed), "two faces run along one edge in one direction"
    assert unique == {(b, a) for a, b in unique}, "an edge has no partner"
    assert len(V) - len(directed) // 2 + len(F) == 2
    assert solid_volume(V, F) > 0


@pytest.mark.parametrize("name", [*COUNTS, "dog"])
def test_one_component_that_uses_every_vertex_once(name: str) -> None:
    V, F = mesh(name)
    assert pieces(len(V), half_edges(F))[0] == 1
    assert len(np.unique(V, axis=0)) == len(V)


@pytest.mark.parametrize(("name", "vertices"), COUNTS.items())
def test_triangles_in_the_expected_number(name: str, vertices: int) -> None:
    V, F = mesh(name)
    assert F.shape[1] == 3
    assert 0.85 * vertices < len(V) < 1.15 * vertices


@pytest.mark.parametrize("name", [*COUNTS])
def test_no_thin_triangles(name: str) -> None:
    V, F = mesh(name)
    assert np.degrees(igl.internal_angles(V, F).min()) > 25


@pytest.mark.parametrize("name", [*SMOOTH, "cylinder"])
def test_hardly_any_negative_cotangent_weight(name: str) -> None:
    L = igl.cotmatrix(*mesh(name)).tocoo()
    assert np.mean(L.data[L.row != L.col] < -1e-9) < 0.001


def test_the_sheet_has_one_border_and_bumps_up() -> None:
    V, F = mesh("bumpy_plane")
    directed = {tuple(e) for e in half_edges(F).tolist()}
    border = np.array([e for e in directed if e[::-1] not in directed])
    number, _ = pieces(len(V), border)
    assert number == len(V) - len(np.unique(border)) + 1
    assert np.abs(V[border, 1]).max() < 1e-6
    assert igl.per_face_normals(V, F, np.zeros(3))[:, 1].min() > 0.5


def test_the_figure_stands_upright_with_arms_out() -> None:
    V, _ = mesh("mannequin")
    low, high = V.min(axis=0), V.max(axis=0)
    assert low[1] == pytest.approx(0, abs=0.005)
    assert high[1] == pytest.approx(1.8, abs=0.02)
    assert high[0] - low[0] == pytest.approx(1.9, abs=0.1)
    feet = V[V[:, 1] < 0.05]
    assert feet[:, 2].max() > 1.5 * -feet[:, 2].min(), "toes point to +z"


def test_the_figure_lies_on_its_implicit_surface_and_so_does_its_mirror_image() -> None:
    V, _ = mesh("mannequin")
    field = figure.body()
    for side in (1, -1):
        p = V * [side, 1, 1]
        distance = field(p) / np.linalg.norm(gradient(field, p), axis=1)
        assert np.abs(distance).max() < 1e-5


def test_the_arm_is_round_at_the_elbow() -> None:
    V, _ = mesh("mannequin")
    ring = V[np.abs(V[:, 0] - figure.ELBOW) < 0.01, 1:]
    radius = np.linalg.norm(ring - [figure.ARM_HEIGHT, figure.ARM_DEPTH], axis=1)
    assert radius.min() > 0.04
    assert radius.max() < 0.055


@pytest.mark.parametrize("name", ["bar", "cylinder", "bumpy_plane"])
def test_a_primitive_is_what_its_program_makes(name: str) -> None:
    V, F = getattr(primitives, name)()
    np.testing.assert_allclose(mesh(name)[0], V, atol=2e-6)
    np.testing.assert_array_equal(mesh(name)[1], F)


def test_solids_have_the_volume_of_their_formula() -> None:
    assert solid_volume(*mesh("bar")) == pytest.approx(4 * 0.5**2, rel=1e-6)
    assert solid_volume(*mesh("cylinder")) == pytest.approx(4 * np.pi * 0.5**2, rel=0.01)


def test_the_dog_is_quads_with_uvs_normals_groups_and_materials() -> None:
    text = (ASSETS / "dog.obj").read_text(encoding="ascii")
    rows = [line.split() for line in text.splitlines()]
    by_tag = {
        tag: [row[1:] for row in rows if row[0] == tag] for tag in ("vt", "vn", "g", "usemtl")
    }
    corners = np.array([[c.split("/") for c in r[1:]] for r in rows if r[0] == "f"], dtype=int)
    assert corners.shape[1:] == (4, 3)
    for column, tag in ((1, "vt"), (2, "vn")):
        used = np.unique(corners[..., column])
        np.testing.assert_array_equal(used, 1 + np.arange(len(by_tag[tag])))
    uv = np.array(by_tag["vt"], dtype=float)
    assert uv.min() >= 0
    assert uv.max() <= 1
    np.testing.assert_allclose(
        np.linalg.norm(np.array(by_tag["vn"], dtype=float), axis=1), 1, atol=2e-6
    )
    assert len({row[0] for row in by_tag["g"]}) == 5
    assert len({row[0] for row in by_tag["usemtl"]}) == 2
    assert sum(row[0] == "#" for row in rows) > 2


def test_the_dog_has_normals_that_point_outward_and_uvs_that_are_not_mirrored() -> None:
    dog = quads.dog()
    N = quads.vertex_normals(dog.V, dog.Q)
    assert solid_volume(dog.V + 0.001 * N, dog.Q) > solid_volume(dog.V, dog.Q)
    a, b = dog.uv[:, 2] - dog.uv[:, 0], dog.uv[:, 3] - dog.uv[:, 1]
    assert (a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]).min() > 0


def test_obj_text_reads_back() -> None:
    V, F = primitives.cylinder(rings=2)
    text = objtext.triangle_text("a cylinder", V, F)
    assert text.startswith("# a cylinder\n")
    W, G = read_text(text)
    np.testing.assert_allclose(W, V, atol=5.1e-7)
    np.testing.assert_array_equal(G, F)


def test_the_session_is_for_the_mannequin_and_has_the_agreed_keys() -> None:
    V, F = mesh("mannequin")
    data = session()
    assert set(data) == {
        *("format", "version", "mesh", "fixed", "handles", "softness", "material", "settings")
    }
    assert (data["format"], data["version"]) == ("surface-deformation-session", 1)
    assert data["mesh"] == {"path": "mannequin.obj", "vertices": len(V), "faces": len(F)}
    assert data["material"] == "hinge"
    assert data["settings"] == {"bending_length": 0.01, "orientation": True, "rigid": 1}
    (hand,) = data["handles"]
    assert set(hand) == {"name", "vertices", "transform"}
    assert hand["name"] == "hand"
    np.testing.assert_array_equal(hand["transform"], np.eye(4))


def test_the_session_is_the_one_its_program_makes() -> None:
    text = elbow.session_text("mannequin.obj", *mesh("mannequin"))
    again = json.loads(text)
    np.testing.assert_allclose(again.pop("softness"), session()["softness"], atol=1.01e-4)
    assert again == {key: value for key, value in session().items() if key != "softness"}


def test_every_vertex_has_one_role_at_most() -> None:
    n = len(mesh("mannequin")[0])
    both = session()["fixed"] + session()["handles"][0]["vertices"]
    assert len(set(both)) == len(both)
    assert min(both) >= 0
    assert max(both) < n


def test_the_free_arm_is_one_piece_between_body_and_hand() -> None:
    V, F = mesh("mannequin")
    fixed, hand = roles()
    free = ~(fixed | hand)
    ends = half_edges(F)
    assert not (fixed[ends[:, 0]] & hand[ends[:, 1]]).any()
    for part in (fixed, hand, free):
        inside = ends[part[ends].all(axis=1)]
        assert len(np.unique(pieces(len(V), inside)[1][part])) == 1
    assert (free[ends[:, 0]] & hand[ends[:, 1]]).any()
    assert (free[ends[:, 0]] & fixed[ends[:, 1]]).any()
    assert V[free | hand, 0].min() > figure.SHOULDER


def test_softness_peaks_at_the_elbow_and_fades_smoothly_before_body_and_hand() -> None:
    V, F = mesh("mannequin")
    s = np.array(session()["softness"])
    fixed, hand = roles()
    assert s.shape == (len(V),)
    assert s.min() == 0
    assert 0.99 < s.max() <= 1
    assert V[s.argmax(), 0] == pytest.approx(figure.ELBOW, abs=0.02)
    assert not s[fixed | hand].any()
    steep = np.linalg.norm((igl.grad(V, F) @ s).reshape(3, -1), axis=0)
    rim = (s[F] > 0).any(axis=1) & (s[F] < 0.02).all(axis=1)
    assert rim.any()
    assert steep[rim].max() < 0.4 * steep.max()
