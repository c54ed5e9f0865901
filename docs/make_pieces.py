"""Makes the pictures of pieces.md and prints its numbers: `python -m docs.make_pieces`."""

from __future__ import annotations

import time
from dataclasses import dataclass
from pathlib import Path

import igl
import numpy as np
from scipy.spatial import cKDTree

from app.bundled import ASSETS
from app.graphics import loading
from app.scene.scene import Scene
from app.scene.shading import shaded
from app.viewpoint.camera import FIELD_OF_VIEW, Camera
from assets.generator.elbow import softness
from assets.generator.figure import ARM_DEPTH, ARM_HEIGHT, ELBOW, WRIST
from solver import Deformer, load_mesh
from solver.geometry.bounding_box import diagonal
from solver.geometry.rotations import nearest_rotations
from solver.mesh.mesh import Mesh
from solver.types import BoolArray, FloatArray, IntArray

IMAGES = Path(__file__).resolve().parent / "images"
SIZE = (480, 480)
PLACES, WAYS = ("head", "elbow"), {"apart": False, "follow": True}
PICTURES = tuple(f"pieces-{place}-{way}.png" for place in PLACES for way in ("rest", *WAYS))
# By a word of the part's name.
COLORS = {
    "body": (0.82, 0.64, 0.53),
    "shirt": (0.62, 0.72, 0.82),
    "trousers": (0.26, 0.31, 0.42),
    "hair": (0.30, 0.20, 0.14),
    "lock": (0.36, 0.24, 0.17),
    "brow": (0.30, 0.20, 0.14),
    "cuff": (0.90, 0.90, 0.92),
    "collar": (0.90, 0.90, 0.92),
    "belt": (0.25, 0.15, 0.10),
    "shoe": (0.20, 0.14, 0.12),
    "eye": (0.97, 0.97, 0.97),
    "iris": (0.15, 0.30, 0.45),
    "nail": (0.90, 0.50, 0.50),
    "button": (0.95, 0.85, 0.55),
    "buckle": (0.90, 0.75, 0.30),
}


@dataclass(frozen=True, eq=False)
class Turn:
    """A handle that turns about a place. fixed, handle: (n,). axis: of the world."""

    name: str
    fixed: BoolArray
    handle: BoolArray
    softness: FloatArray
    axis: int
    degrees: float
    place: tuple[float, float, float]
    camera: Camera

    @property
    def transform(self) -> FloatArray:
        """(4, 4), about `place`."""
        c, s = np.cos(np.radians(self.degrees)), np.sin(np.radians(self.degrees))
        i, j = (self.axis + 1) % 3, (self.axis + 2) % 3
        T = np.eye(4)
        T[[i, i, j, j], [i, j, i, j]] = c, -s, s, c
        T[:3, 3] = self.place - T[:3, :3] @ self.place
        return T


def part_of(mesh: Mesh) -> tuple[list[str], IntArray]:
    """Names, and (n,) the number of each vertex's."""
    assert mesh.groups is not None
    number = np.zeros(len(mesh.vertices), dtype=np.int64)
    number[mesh.outlines.corners] = np.repeat(mesh.groups.of_polygon, mesh.outlines.sizes)
    return list(mesh.groups.names), number


def turns(mesh: Mesh) -> list[Turn]:
    """The head to its left, the hand up."""
    V = mesh.vertices
    names, part = part_of(mesh)
    body = part == names.index("body")
    head = Camera.look_at((0.18, 1.70, 0.72), (0.0, 1.64, 0.0), FIELD_OF_VIEW, SIZE)
    arm = Camera.look_at((0.40, 1.62, 1.25), (0.36, 1.50, 0.0), FIELD_OF_VIEW, SIZE)
    neck, elbow = (0.0, 1.6, -0.01), (ELBOW, ARM_HEIGHT, ARM_DEPTH)
    trunk, above, hand = V[:, 1] < 1.46, V[:, 1] > 1.6, V[:, 0] > WRIST
    none, soft = np.zeros(len(V)), softness(V)
    return [
        Turn("head", body & trunk, body & above, none, 1, 40.0, neck, head),
        Turn("elbow", body & (V[:, 0] < 0.25), hand, soft, 2, 90.0, elbow, arm),
    ]


def pose(mesh: Mesh, turn: Turn, attach: bool) -> FloatArray:
    """(n, 3) at level 4; says what it cost."""
    start = time.perf_counter()
    deformer = Deformer(
        mesh.vertices,
        mesh.faces,
        np.flatnonzero(turn.fixed),
        [np.flatnonzero(turn.handle)],
        softness=turn.softness,
        attach=attach,
    )
    bound = time.perf_counter()
    X = deformer.pose([turn.transform], rigid=4)
    posed = time.perf_counter()
    print(f"{turn.name}, attach={attach}: bind {bound - start:.2f} s, pose {posed - bound:.2f} s")
    return X


def apart(mesh: Mesh, X: FloatArray, skin: IntArray) -> FloatArray:
    """(n,) how much farther a vertex is from the one of the skin that was closest, in diagonals."""
    V = mesh.vertices
    before, at = cKDTree(V[skin]).query(V)
    after = np.linalg.norm(X - X[skin[at]], axis=1)
    return np.asarray(np.abs(after - before) / diagonal(V))


def change_of_shape(P: FloatArray, Q: FloatArray) -> float:
    """Root mean square of what no rigid motion explains, in diagonals of the piece."""
    P, Q = P - P.mean(axis=0), Q - Q.mean(axis=0)
    R = nearest_rotations((Q.T @ P)[None])[0]
    return float(np.sqrt(((Q - P @ R.T) ** 2).sum(axis=1).mean()) / diagonal(P))


def under(mesh: Mesh, X: FloatArray, skin: BoolArray, worn: BoolArray) -> float:
    """The share of some vertices that lie under the skin."""
    faces = mesh.faces[skin[mesh.faces[:, 0]]]
    signed = igl.signed_distance(X[worn], X, faces, igl.SIGNED_DISTANCE_TYPE_PSEUDONORMAL)[0]
    return float(np.mean(signed < 0))


def report(mesh: Mesh, X: FloatArray) -> None:
    """How many pieces have left the skin, and how much the small ones have changed shape."""
    V = mesh.vertices
    names, part = part_of(mesh)
    pieces = {name: part == k for k, name in enumerate(names)}
    skin = pieces.pop("body")
    gap = apart(mesh, X, np.flatnonzero(skin))
    gaps = {name: gap[mine].max() for name, mine in pieces.items()}
    left = [name for name in gaps if gaps[name] > 0.01]
    print(f"  left the skin: {len(left)} of {len(pieces)}: {', '.join(left)}")
    print(f"  largest change of distance: {100 * max(gaps.values()):.2f} % of the diagonal")
    small = [mine for mine in pieces.values() if diagonal(V[mine]) < 0.03 * diagonal(V)]
    bent = max(change_of_shape(V[mine], X[mine]) for mine in small)
    print(f"  change of shape of {len(small)} small pieces: {100 * bent:.3f} %")
    print(f"  shirt under the skin: {100 * under(mesh, X, skin, pieces['shirt']):.1f} %")


def main() -> None:
    with loading():
        from app.window.drawing.view import View
        from app.window.opening import open_offscreen
    mesh = load_mesh(ASSETS / "dressed.obj")
    names, part = part_of(mesh)
    tint = [next(COLORS[word] for word in name.split() if word in COLORS) for name in names]
    colors = np.array(tint)[part]
    open_offscreen(SIZE)
    view, surface = View(), shaded(mesh, hard=False)

    def draw(name: str, X: FloatArray, camera: Camera) -> None:
        view.show(Scene(surface, X, colors))
        view.look(camera)
        view.picture(IMAGES / f"pieces-{name}.png")

    for turn in turns(mesh):
        draw(f"{turn.name}-rest", mesh.vertices, turn.camera)
        for word, attach in WAYS.items():
            X = pose(mesh, turn, attach)
            report(mesh, X)
            draw(f"{turn.name}-{word}", X, turn.camera)


if __name__ == "__main__":
    main()
