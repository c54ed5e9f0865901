"""Softness learned from poses: the material map of which the equilibria come nearest to them."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import ArrayLike
from scipy.optimize import minimize

from solver.arrays import as_faces, as_vertices
from solver.geometry.topology import Topology
from solver.learning.examples import as_poses, check_motion, placed, resized
from solver.learning.objective import Objective
from solver.learning.rigid_parts import find_parts
from solver.learning.surface import LearningSurface
from solver.setup import Setup
from solver.softness.material import Material, resolve_material
from solver.surface.embedding import embed
from solver.types import FloatArray

# L-BFGS-B: steps at most, and when to end: a step that gains less than this share of J.
STEPS, GAIN = 40, 1e-5
# Where it starts. At 0 and at 1 the bounds would hold half of the directions.
START = 0.1
# J is small in diagonals; L-BFGS-B's first step is as long as the gradient.
UNIT = 3e4


class _Stopped(Exception):
    """Learning was asked to end with what it has."""


def learn_softness(
    V: ArrayLike,
    F: ArrayLike,
    poses: Sequence[ArrayLike],
    fixed: ArrayLike | None = None,
    handles: Sequence[ArrayLike] | None = None,
    material: str | Material = "hinge",
    progress: Callable[[float], bool | None] | None = None,
) -> FloatArray:
    """Softness, (n,) in [0, 1], with which the surface takes the shapes of examples.

    Handles are put where a pose has them, and the softness sought with which the equilibrium at
    the levels of `rigid` comes nearest to the rest of it, in the mean over poses, smooth and small
    where they say nothing: see `objective`. On a simplified surface, by adjoint gradients and
    L-BFGS-B.

    V, F: the mesh at rest.  poses: (n, 3) each, the same vertices in other shapes, of any size and
    in any place.  fixed, handles: vertices as for a Deformer; None to have parts found that move
    rigidly: the largest is fixed, ends of limbs are handles.
    progress: told how much is done, from 0 to 1; where it returns True learning ends with the best
        so far, where it raises it is cancelled.
    Raises MeshError (poses that do not fit, or without motion), ConstraintError or MaterialError.
    [docs/animals.md; Popa, Julius & Sheffer 2006]

    >>> import solver
    >>> x, y = np.meshgrid(np.arange(9.0), np.arange(2.0))
    >>> V = np.column_stack([x.ravel(), y.ravel(), np.zeros(18)])
    >>> quads = [[i, i + 1, i + 10, i + 9] for i in range(8)]
    >>> F = solver.Mesh.from_arrays(V, quads).faces
    >>> angle = np.radians(60)  # a sheet that is folded in its middle
    >>> over = np.clip(V[:, 0] - 4, 0, None)
    >>> folded = V.copy()
    >>> folded[:, 0] += over * (np.cos(angle) - 1)
    >>> folded[:, 2] = over * np.sin(angle)
    >>> s = solver.learn_softness(V, F, [folded], fixed=[0, 1, 9, 10], handles=[[7, 8, 16, 17]])
    >>> s[4] == s.max() > 0.9, s[2] < 0.5 > s[6]
    (np.True_, np.True_)
    """
    V = as_vertices(V)
    F = as_faces(F, len(V))
    known = resolve_material(material)
    surface = LearningSurface(embed(V, F))
    edges = Topology(F, len(V)).edges
    shapes = [resized(X, V, edges) for X in as_poses(poses, V)]
    if fixed is None or handles is None:
        fixed, handles = find_parts(surface, shapes, fixed, handles)
    setup = Setup(fixed, handles, material=known)
    still = setup.fixed if len(setup.fixed) else np.arange(len(V))
    setup.groups(len(V))
    shapes = [placed(X, V, still) for X in shapes]
    check_motion(shapes, V)
    objective = Objective(surface.rest, surface.setup(setup), [surface.pose(X) for X in shapes])
    return surface.softness(_minimised(objective, len(surface.rest.points), progress))


def _minimised(
    objective: Objective, size: int, progress: Callable[[float], bool | None] | None
) -> FloatArray:
    """The best softness (size,) that L-BFGS-B finds, or has found when it is stopped."""
    best, least, done = np.full(size, START), np.inf, 0

    def value(s: FloatArray) -> tuple[float, FloatArray]:
        nonlocal best, least
        J, slope = objective(s)
        if least > J:
            best, least = s.copy(), J
        return UNIT * J, UNIT * slope

    def tell(_: FloatArray) -> None:
        nonlocal done
        done += 1
        if progress is not None and progress(min(done / STEPS, 1.0)):
            raise _Stopped

    options = {"maxiter": STEPS, "ftol": GAIN}
    bounds = [(0.0, 1.0)] * size
    try:
        minimize(
            value, best, jac=True, bounds=bounds, callback=tell, options=options, method="L-BFGS-B"
        )
    except _Stopped:
        return best
    if progress is not None and done < STEPS:
        progress(1.0)
    return best
