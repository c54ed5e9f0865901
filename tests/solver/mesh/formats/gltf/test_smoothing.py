"""Hard edges of glTF files: vertices in one place with normals of their own."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from solver.types import FloatArray

from .scenes import TURN, F, P, Scene, trs

SOUP = P[F].reshape(-1, 3)  # every triangle of the strip with vertices of its own
TILTED = np.array([[0.0, 0.6, 0.8]])
FLAT = np.array([[0.0, 0.0, 1.0]])
SIDEWAYS = np.array([[1.0, 0.0, 0.0]])  # of one corner: no triangle of its own would be flat
HALF = np.vstack([SIDEWAYS, *5 * [TILTED]])
HALVES = np.vstack([HALF, *6 * [FLAT]])  # an edge in the middle
MATRIX = trs([3, 1, 2], TURN, [1, 5, -0.5])


def soup(scene: Scene, normals: FloatArray | None, rows: slice = slice(None)) -> dict[str, int]:
    attributes = {"POSITION": scene.positions(SOUP[rows])}
    return attributes if normals is None else attributes | {"NORMAL": scene.accessor(normals)}


@pytest.mark.parametrize(
    ("normals", "hard"),
    [(None, False), (HALVES, True), (np.tile(FLAT, (12, 1)), False), (HALVES[:5], False)],
)
def test_normals_part_what_positions_join(
    tmp_path: Path, normals: FloatArray | None, hard: bool
) -> None:
    """None, in two directions, in one; fewer than there are vertices say nothing."""
    scene = Scene()
    scene.node(mesh=scene.mesh({"attributes": soup(scene, normals)}))
    mesh = scene.load(tmp_path)
    assert mesh.welded.max() + 1 == len(P)
    assert (mesh.smooth_corners is not None) == hard
    if mesh.smooth_corners is not None:
        numbers = mesh.smooth_corners.reshape(4, 3)
        assert not set(numbers[:2].ravel()) & set(numbers[2:].ravel())
        assert len(np.unique(numbers)) == len(P) + 2


def test_normals_of_two_nodes_are_compared_in_the_scene(tmp_path: Path) -> None:
    """One half stands as it is, the other where a matrix turns, stretches and mirrors it."""
    scene = Scene()
    scene.node(mesh=scene.mesh({"attributes": soup(scene, HALF, slice(0, 6))}))
    linear = MATRIX[:3, :3]
    back = np.linalg.solve(linear, (SOUP[6:] - MATRIX[:3, 3]).T).T
    for normal, hard in ((TILTED, False), (FLAT, True)):
        primitive = {"POSITION": scene.positions(back), "NORMAL": 0}
        primitive["NORMAL"] = scene.accessor(np.tile(normal @ linear, (6, 1)))
        scene.json["nodes"] = scene.json["nodes"][:1]
        scene.node(mesh=scene.mesh({"attributes": primitive}), matrix=MATRIX.T.ravel().tolist())
        mesh = scene.load(tmp_path)
        # Positions of two float32 accessors are not one place to the last digit.
        mesh.vertices.setflags(write=True)
        mesh.vertices[:] = SOUP
        assert (mesh.smooth_corners is not None) == hard


def test_normals_that_cannot_be_read_are_no_reason_to_refuse_a_file(tmp_path: Path) -> None:
    scene = Scene()
    attributes = soup(scene, None) | {"NORMAL": scene.accessor(np.zeros(12))}  # a number each
    scene.node(mesh=scene.mesh({"attributes": attributes}))
    mesh = scene.load(tmp_path)
    assert (len(mesh.faces), mesh.smooth_corners) == (4, None)
