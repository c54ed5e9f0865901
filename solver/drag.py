"""A drag with a memory: each frame goes on from the one before."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import ArrayLike
from scipy.spatial.transform import Rotation

from solver.bound_surface import BoundSurface
from solver.coarse_surface import CoarseSurface
from solver.errors import ConstraintError
from solver.geometry.bounding_box import diagonal
from solver.geometry.motions import motion
from solver.geometry.procrustes import decided
from solver.geometry.screws import blended
from solver.limits import HIGHEST_LEVEL
from solver.types import FloatArray

# In radians: further than this no handle turns at once, so that the surface goes the same way.
STRIDE = np.radians(30.0)
# The least lever of a handle that `orient` turns, in diagonals: around a small handle, too, the
# surface keeps the pace of the hand.
LEVER = 0.1


class Drag:
    """Poses of a Deformer one after the other, each continued from the last: `Deformer.drag`.

    What is remembered are the rotations of the last answer's triangles. From there rounds start in
    place of the linear frames, which do not tell how often a handle went round: a bar that is
    twisted by 360 degrees shows them, and small moves of a handle make small moves of the surface.
    The answers depend on the way, and on nothing else: the same moves give the same answers.

    >>> import solver
    >>> V = [[0, 0, 0], [1, 0, 0], [2, 0, 0], [0, 1, 0], [1, 1, 0], [2, 1, 0]]  # two squares
    >>> F = [[0, 1, 4], [0, 4, 3], [1, 2, 5], [1, 5, 4]]
    >>> deformer = solver.Deformer(V, F, fixed=[0, 3], handles=[[2, 5]])
    >>> drag = deformer.drag()
    """

    def __init__(self, bound: BoundSurface | CoarseSurface) -> None:
        self._bound = bound
        self._transforms: list[FloatArray] = []
        self._rotations: FloatArray | None = None

    def move(self, transforms: Sequence[ArrayLike], rigid: int = 4) -> FloatArray:
        """X, (n, 3), for one transform (4, 4) a handle, as `Deformer.pose`, gone on to.

        The first is what `pose` says. Then rigid k makes k - 1 rounds, one at least, from the
        rotations before, turned on with what holds them; where a handle turns by more than STRIDE,
        in several steps along its screw. At rigid 0 the surface is linear in the transforms: no
        rounds, nothing to remember, and what was remembered is kept. Raises ConstraintError.

        >>> T = np.eye(4)
        >>> T[:3, 3] = [0.5, 0, 0]
        >>> np.array_equal(drag.move([T]), deformer.pose([T], rigid=4))
        True
        """
        level = as_level(rigid)
        if level == 0:
            return self._bound.posed(transforms, 0)
        for T in self._way(transforms):
            X, self._rotations = self._bound.continued(T, level, self._rotations)
            self._transforms = T
        return X

    def orient(
        self,
        handle: int,
        grabbed: ArrayLike,
        target: ArrayLike,
        transforms: Sequence[ArrayLike],
    ) -> FloatArray:
        """T, (4, 4), so that rest point `grabbed` reaches `target`: on from `transforms[handle]`.

        It turns towards the rotation of least energy (see Deformer.orient), which swings round
        where the target passes behind the pivot; but by no more than takes the handle's farthest
        point as far as the target has come. So none of its points goes farther than twice that,
        and a target that stays leaves it alone. Raises ConstraintError.

        >>> lifted = drag.orient(0, [2, 0.5, 0], [1.5, 0.5, 1], [np.eye(4)])
        >>> (lifted @ [2, 0.5, 0, 1]).round(9)
        array([1.5, 0.5, 1. , 1. ])
        >>> np.allclose(drag.orient(0, [2, 0.5, 0], [1.5, 0.5, 1], [lifted]), lifted)
        True
        """
        best = self._bound.drag_model.orient(handle, grabbed, target, transforms)
        p, q = (np.asarray(point, dtype=np.float64) for point in (grabbed, target))
        now = np.asarray(transforms[handle], dtype=np.float64)
        R = decided(now[:3, :3].T)
        step = float(np.linalg.norm(q - now[:3, :3] @ p - now[:3, 3]))
        R = _towards(R, best[:3, :3], step / self._lever(handle, p))
        return motion(R, q - p, p)

    def _lever(self, handle: int, point: FloatArray) -> float:
        """How far the handle reaches from one of its points (3,), at least LEVER."""
        embedding, hard = self._bound.embedding, self._bound.setup.handles
        if handle < len(hard):
            held = embedding.shown[hard[handle]]
        else:
            held = embedding.vertices[self._bound.grab_weights[handle - len(hard)] > 0]
        reach = float(np.linalg.norm(held - point, axis=1).max(initial=0.0))
        return max(reach, LEVER * diagonal(embedding.shown))

    def _way(self, transforms: Sequence[ArrayLike]) -> Iterator[list[FloatArray]]:
        """Transforms from those of the last answer to these, which are the last."""
        self._bound.drag_model.steps(transforms)  # raises what is wrong with them
        after = [np.array(T, dtype=np.float64) for T in transforms]
        before = self._transforms or after
        turn = max((_angle(A, B) for A, B in zip(before, after, strict=True)), default=0.0)
        count = max(int(np.ceil(turn / STRIDE - 1e-9)), 1)
        for share in np.arange(1, count) / count:
            yield [blended(A, B, share) for A, B in zip(before, after, strict=True)]
        yield after


def _angle(A: FloatArray, B: FloatArray) -> float:
    """Between the rotations nearest to two affine maps (4, 4), in radians."""
    turn = decided(B[:3, :3].T) @ decided(A[:3, :3].T).T
    return float(np.linalg.norm(Rotation.from_matrix(turn).as_rotvec()))


def _towards(R: FloatArray, best: FloatArray, most: float) -> FloatArray:
    """From one rotation (3, 3) towards another, by so many radians at most."""
    turn = Rotation.from_matrix(best @ R.T).as_rotvec()
    angle = float(np.linalg.norm(turn))
    if angle <= most:
        return best
    return np.asarray(Rotation.from_rotvec(most / angle * turn).as_matrix() @ R)


def as_level(rigid: int) -> int:
    """`rigid` as it was given, where it is a level. Raises ConstraintError."""
    whole = isinstance(rigid, int | np.integer) and not isinstance(rigid, bool)
    if not (whole and 0 <= rigid <= HIGHEST_LEVEL):
        raise ConstraintError(f"rigid must be an integer from 0 to {HIGHEST_LEVEL}, got {rigid!r}")
    return int(rigid)
