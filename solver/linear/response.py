"""How the whole surface and its energy answer to the handles: the basis B and the form Q."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from solver.linear.constraints import Constraints
from solver.linear.grab import Grab, Moments
from solver.linear.rest_surface import RestSurface
from solver.linear.system import System
from solver.types import FloatArray, IntArray


@dataclass(frozen=True)
class Response:
    """A drag without a solve: U(T) = U_rest + B (T - I), E(T) = 1/2 tr (T - I)' Q (T - I).

    The transforms T of all k handles are stacked, four rows each.

    basis: B, (n + 3m, 4k).  form: Q, (4k, 4k).
    """

    basis: FloatArray
    form: FloatArray


def hard_response(rest: RestSurface, constraints: Constraints, system: System) -> Response:
    """Basis and form of the hard handles: four back-substitutions for each."""
    J = rest.affine_rows
    count = len(constraints.handles)
    C = np.zeros((len(J), 4 * count))
    for handle in range(count):
        rows = constraints.row_group == 1 + handle
        C[rows, 4 * handle : 4 * handle + 4] = J[rows]
    B = system.respond(C)
    Q = C.T @ (system.coupling @ B)  # C is zero but on the handles' rows
    return Response(B, 0.5 * (Q + Q.T))


def with_grabs(
    hard: Response, grabs: Sequence[Grab], moments: Moments, rest: RestSurface, free: IntArray
) -> Response:
    """The response with soft handles after the hard ones.

    moments: those of all grabs together. A hard handle's basis loses what would change them.
    """
    hard_count, soft_count = hard.basis.shape[1], 4 * len(grabs)
    wanted = np.zeros((soft_count, soft_count))
    B = np.hstack([hard.basis, np.zeros((len(hard.basis), soft_count))])
    for i, grab in enumerate(grabs):
        block = slice(4 * i, 4 * i + 4)
        wanted[block, block] = grab.moments.T @ rest.affine_rows[free]
        column = slice(hard_count + block.start, hard_count + block.stop)
        B[grab.carried, column] = rest.affine_rows[grab.carried]
    wanted = np.hstack([np.zeros((soft_count, hard_count)), wanted])
    push = wanted - moments.of(B[free])
    B[free] = moments.meet(B[free], wanted)
    Q = push.T @ moments.inverse @ push
    Q[:hard_count, :hard_count] += hard.form
    return Response(B, Q)
