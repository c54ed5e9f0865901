"""Hard edges: which corners a file shades as one."""

from __future__ import annotations

from itertools import combinations
from pathlib import Path

import numpy as np
import pytest

from solver.mesh.mesh import Mesh, load_mesh
from solver.types import FloatArray, IntArray

# A roof of two squares that meet in the edge 2 3, and a third that goes on smoothly.
POINTS = ((0, 0, 0), (1, 0, 0), (0, 1, 1), (1, 1, 1), (0, 2, 0), (1, 2, 0), (0, 3, -1), (1, 3, -1))
SQUARES = ((1, 2, 4, 3), (3, 4, 6, 5), (5, 6, 8, 7))
RIDGE = {2, 3}


UP = "vn 0 -1 1\nvn 0 1 1\nvn 0 1 1.001\nvn 1 0 0\n"


def text(*faces: str, normals: str = "") -> str:
    return "".join(f"v {x} {y} {z}\n" for x, y, z in POINTS) + normals + "\n".join(faces) + "\n"


def plain(number: int) -> str:
    return "f " + " ".join(map(str, SQUARES[number]))


def with_normals(number: int, *normals: int) -> str:
    pairs = zip(SQUARES[number], normals, strict=True)
    return "f " + " ".join(f"{vertex}//{normal}" for vertex, normal in pairs)


def load(folder: Path, obj: str) -> Mesh:
    (folder / "roof.obj").write_text(obj)
    return load_mesh(folder / "roof.obj")


def parted(mesh: Mesh) -> set[int]:
    """The vertices where some corners are not smooth with others."""
    corners, numbers = mesh.outlines.corners, mesh.smooth_corners
    if numbers is None:
        return set()
    kinds = np.unique(np.column_stack([corners, numbers]), axis=0)
    return {int(v) for v in np.flatnonzero(np.bincount(kinds[:, 0]) > 1)}


@pytest.mark.parametrize(
    ("faces", "expected"),
    [
        ([plain(0), plain(1), plain(2)], set()),
        (["s 1", plain(0), plain(1), plain(2)], set()),
        (["s 1", plain(0), "s 2", plain(1), plain(2)], RIDGE),
        (["s 1", plain(0), plain(1), "s roof # a name", plain(2)], {4, 5}),
        ([plain(0), "s 1", plain(1), plain(2)], RIDGE),
        (["s 3", plain(0), "s", plain(1), "s 3", plain(2)], RIDGE | {4, 5}),
    ],
)
def test_smoothing_groups_part_faces(tmp_path: Path, faces: list[str], expected: set[int]) -> None:
    mesh = load(tmp_path, text(*faces))
    assert parted(mesh) == expected
    assert not mesh.flat


@pytest.mark.parametrize(
    "faces",
    [
        ["s off", plain(0), plain(1), plain(2)],
        ["s 0", plain(0), plain(1), "s 1", plain(2)],
        ["s 1", plain(0), "s 2", plain(1), "s 3", plain(2)],
        ["s 1", *(with_normals(k, k + 1, k + 1, k + 1, k + 1) for k in range(3))],
        [with_normals(0, 2, 3, 3, 2), with_normals(1, 2, 2, 2, 2), "s off", plain(2)],
    ],
)
def test_where_no_face_is_smooth_with_another_all_is_flat(tmp_path: Path, faces: list[str]) -> None:
    """And no vertex has to be parted for it."""
    mesh = load(tmp_path, text(*faces, normals=UP))
    assert mesh.flat
    assert mesh.smooth_corners is None


@pytest.mark.parametrize(
    ("normals", "expected"),
    [
        ([(4, 1, 1, 1), (2, 2, 2, 2), (2, 2, 2, 2)], RIDGE),
        ([(4, 1, 1, 1), (1, 1, 2, 2), (2, 2, 2, 2)], set()),
        ([(4, 1, 1, 1), (2, 2, 2, 2), (3, 3, 3, 3)], RIDGE),  # nearly equal is equal
    ],
)
def test_normals_part_faces_whatever_the_groups_say(
    tmp_path: Path, normals: list[tuple[int, ...]], expected: set[int]
) -> None:
    faces = [with_normals(k, *numbers) for k, numbers in enumerate(normals)]
    for first in ("", "s off", "s 1"):
        assert parted(load(tmp_path, text(first, *faces, normals=UP))) == expected


def test_a_normal_that_cannot_be_read_is_a_direction_of_its_own(tmp_path: Path) -> None:
    faces = [with_normals(0, 1, 1, 1, 1), with_normals(1, 2, 2, 2, 2), plain(2)]
    mesh = load(tmp_path, text(*faces, normals="vn 0 0 x\nvn 0 1 1\n"))
    assert parted(mesh) == RIDGE | {4, 5}


def test_one_normal_for_all_says_nothing(tmp_path: Path) -> None:
    mesh = load(tmp_path, text(*(with_normals(k, 1, 1, 1, 1) for k in range(3)), normals=UP))
    assert not mesh.flat
    assert mesh.smooth_corners is None


def test_seams_are_smooth_where_the_normals_of_both_sides_are(tmp_path: Path) -> None:
    """The roof in three pieces: what is one place is told by its normals."""
    lines, faces = [], []
    for k, square in enumerate(SQUARES):
        lines += ["v {} {} {}".format(*POINTS[v - 1]) for v in square]
        normals = ((4, 1, 1, 1), (2, 2, 2, 2), (3, 3, 3, 3))[k]
        faces.append("f " + " ".join(f"{4 * k + c + 1}//{normals[c]}" for c in range(4)))
    mesh = load(tmp_path, "\n".join([*lines, UP.rstrip(), *faces, ""]))
    numbers = mesh.smooth_corners
    assert numbers is not None
    one = numbers.reshape(3, 4)
    assert len(np.unique(numbers)) == 10, "the ridge has two each, the smooth seam one"
    assert set(one[1, 2:]) == set(one[2, :2])
    assert not set(one[0]) & set(one[1])


def test_alike_is_what_is_alike_whatever_the_order() -> None:
    """Against every two corners of a fan of random normals, near and far, compared one by one."""
    from solver.mesh.formats.format import Smoothing
    from solver.mesh.smoothing import smooth_corners

    rng = np.random.default_rng(3)
    place, direction = np.arange(4000) // 8, rng.integers(0, 3, 4000)
    exact: FloatArray = rng.normal(size=(500, 3, 3))[place, direction]
    exact /= np.linalg.norm(exact, axis=1, keepdims=True)
    normals = 7 * (exact + rng.uniform(-1e-3, 1e-3, exact.shape))
    found = smooth_corners(Smoothing(np.arange(4000), normals), place)
    assert found is not None
    number: IntArray = found.reshape(-1, 8)
    apart = np.linalg.norm(exact.reshape(-1, 8, 1, 3) - exact.reshape(-1, 1, 8, 3), axis=3)
    for a, b in combinations(range(8), 2):
        same, clear = number[:, a] == number[:, b], apart[:, a, b] > 0.05
        assert same[direction.reshape(-1, 8)[:, a] == direction.reshape(-1, 8)[:, b]].all()
        assert not same[clear].any()
    assert np.array_equal(np.unique(found), np.arange(found.max() + 1)), "no number is left out"


def test_arrays_say_nothing_of_edges() -> None:
    mesh = Mesh.from_arrays(np.array(POINTS, dtype=float), np.array(SQUARES) - 1)
    assert mesh.smooth_corners is None
