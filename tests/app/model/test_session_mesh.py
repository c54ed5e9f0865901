"""What a session knows of its mesh, and files of before it knew anything."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from app.model.document import Document
from app.model.handles import FIXED
from app.model.schema import SessionError
from app.model.session.carrying import by_nearest
from app.model.session.mesh import farthest, mesh_change, read_places
from app.model.session.reading import read_session, to_document
from app.model.session.writing import write_session
from solver import Material, Mesh
from solver.geometry.motions import motion, rotation
from solver.types import FloatArray, IntArray
from tests.app.person import slab

STORED = Path(__file__).with_name("stored") / "version-1.json"


def saved(surface: Mesh, folder: Path, **changes: Any) -> Path:
    """A session on a mesh with one fixed vertex, some of its keys changed."""
    document, path = Document(surface, folder / "box.obj"), folder / "box.json"
    document.change("role", FIXED, np.array([3]))
    write_session(path, document)
    path.write_text(json.dumps(json.loads(path.read_text()) | changes))
    return path


def test_version_1_as_it_was_first_written_is_read_for_ever() -> None:
    """The file was written before sessions knew their mesh. Never change it."""
    session = read_session(STORED)
    document = to_document(session, slab(2, 2, 1.0), STORED.with_name("box.obj"))
    assert mesh_change(session.data, document.mesh) is None
    hand, foot, pin = document.handles
    assert [(h.name, h.pin) for h in (hand, foot, pin)] == [
        ("hand", False),
        ("foot", False),
        ("pin 1", True),
    ]
    assert document.fixed.tolist() == [0, 3, 6]
    assert [document.vertices_of(h.key).tolist() for h in (hand, foot, pin)] == [[2, 5], [8], [11]]
    T = motion(rotation([0, 1, 0], 30), [0.5, 0.25, 1.0])
    np.testing.assert_array_equal(document.pose.of(hand.key), T)
    kick, stand = document.poses
    assert (kick.name, stand.name) == ("kick", "stand")
    np.testing.assert_array_equal(kick.pose.of(foot.key), T)
    assert stand.pose.at_rest
    np.testing.assert_array_equal(document.rest_positions, document.mesh.vertices * 2.0)
    np.testing.assert_array_equal(document.softness, np.linspace(0, 1, 18))
    assert document.material == Material(0.3, 0.6)
    assert (document.bending_length, document.orientation) == (0.05, False)
    assert (document.rigid, document.attach, document.coarse) == (3, [0], 12)


CHANGES: dict[str | None, Callable[[FloatArray, IntArray], tuple[FloatArray, IntArray]]] = {
    None: lambda V, F: (V, F),
    "joined": lambda V, F: (V, F[::-1]),
    "moved": lambda V, F: (V * 1.001, F),
    "other": lambda V, F: (V[::-1], len(V) - 1 - F),
}


@pytest.mark.parametrize("change", list(CHANGES))
def test_a_session_knows_what_became_of_its_mesh(change: str | None, tmp_path: Path) -> None:
    mesh = slab(3, 2, 1.0)
    session = read_session(saved(mesh, tmp_path))
    V, F = CHANGES[change](mesh.vertices, mesh.faces)
    assert mesh_change(session.data, Mesh.from_arrays(V, F)) == change


def test_zero_has_no_sign_and_doubles_that_a_file_of_singles_rounds_are_the_same(
    tmp_path: Path,
) -> None:
    mesh = slab(3, 2, 1.0)
    V: FloatArray = mesh.vertices / 3.0
    session = read_session(saved(Mesh.from_arrays(V, mesh.faces), tmp_path))
    signed = np.where(V == 0.0, -0.0, V)
    for same in (signed, V.astype(np.float32).astype(np.float64)):
        assert mesh_change(session.data, Mesh.from_arrays(same, mesh.faces)) is None


@pytest.mark.parametrize("flat", [False, True])
def test_places_come_back_to_a_65535th_of_the_size(flat: bool, tmp_path: Path) -> None:
    mesh = slab(7, 5, 1.0)
    V: FloatArray = mesh.vertices * [3.0, 0.0 if flat else 1.0, 1e-3] + [1e3, -7.0, 0.1]
    moved = Mesh.from_arrays(V, mesh.faces)
    data = read_session(saved(moved, tmp_path)).data
    size = np.ptp(V, axis=0)
    assert (abs(read_places(data["places"]) - V) <= size / 65535 * 0.51 + 1e-12).all()
    far = farthest(data, moved)
    assert far is not None
    assert far < 2e-5


def test_where_nothing_is_painted_no_places_are_kept(tmp_path: Path) -> None:
    document = Document(slab(2, 2, 1.0), tmp_path / "box.obj")
    write_session(tmp_path / "box.json", document)
    data = read_session(tmp_path / "box.json").data
    assert "places" not in data
    assert farthest(data, document.mesh) is None


def test_places_take_eight_letters_a_vertex(tmp_path: Path) -> None:
    mesh = slab(40, 40, 1.0)
    text = json.loads(saved(mesh, tmp_path).read_text())["places"]["points"]
    assert len(text) == 8 * len(mesh.vertices)


POINTS = {"low": [0, 0, 0], "high": [1, 1, 1], "points": "AAAAAAAA"}
WRONG = [
    ({"mesh": {"path": "box.obj", "hash": "ab"}}, "mesh.hash: expected an object"),
    ({"mesh": {"path": "box.obj", "hash": {"faces": "a"}}}, "mesh.hash.vertices: missing"),
    (
        {"mesh": {"path": "box.obj", "hash": {"faces": "a", "vertices": 3}}},
        "mesh.hash.vertices: expected a text",
    ),
    ({"places": []}, "places: expected an object"),
    ({"places": {**POINTS, "low": [0, 0]}}, "places.low: expected three numbers"),
    ({"places": {**POINTS, "points": 7}}, "places.points: expected three numbers of 16 bits"),
    ({"places": {**POINTS, "points": "AAAA"}}, "places.points: expected three numbers of 16"),
    ({"places": {**POINTS, "points": "AAAA?AAA"}}, "places.points: expected three numbers of 16"),
    ({"places": {**POINTS, "scale": 1}}, "places.scale: unknown key"),
]


@pytest.mark.parametrize(("changes", "text"), WRONG, ids=[text for _, text in WRONG])
def test_what_is_wrong_is_refused_by_name(
    changes: dict[str, Any], text: str, tmp_path: Path
) -> None:
    path = saved(slab(2, 2, 1.0), tmp_path, **changes)
    with pytest.raises(SessionError) as caught:
        read_session(path)
    assert str(caught.value).startswith(f"{path}: {text}")


@pytest.mark.parametrize(
    ("changes", "text"),
    [
        ({"places": POINTS}, "places: expected three or more, got 1"),
        ({"fixed": [18]}, "fixed[0]: expected 0 to 17, got 18"),
        ({"softness": [0.5]}, "softness: expected 18 numbers, one a vertex, got 1"),
    ],
)
def test_what_does_not_fit_its_own_places_is_not_carried(
    changes: dict[str, Any], text: str, tmp_path: Path
) -> None:
    session = read_session(saved(slab(2, 2, 1.0), tmp_path, **changes))
    with pytest.raises(SessionError) as caught:
        by_nearest(session, slab(3, 3, 1.0), tmp_path / "box.obj")
    assert str(caught.value).startswith(f"{session.path}: {text}")


def test_roles_are_carried_to_the_nearest(tmp_path: Path) -> None:
    mesh = slab(3, 2, 1.0)
    order: IntArray = np.random.default_rng(0).permutation(len(mesh.vertices))
    session = read_session(saved(mesh, tmp_path))
    other = Mesh.from_arrays(mesh.vertices[order], np.argsort(order)[mesh.faces])
    document = by_nearest(session, other, tmp_path / "box.obj")
    assert document.fixed.tolist() == np.flatnonzero(order == 3).tolist()
