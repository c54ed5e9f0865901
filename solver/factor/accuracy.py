"""Whether a factor solves: tried on a right side whose solution is known."""

from __future__ import annotations

import numpy as np

from solver.errors import FactorizationError
from solver.factor.backend import Factor
from solver.types import FloatArray

# Of a diagonal, or of a turn: a tenth of a pixel. A ring of a few triangles around a tube of a
# hundred thousand, held at one end, comes near; other surfaces are at 1e-9 or below.
ACCURATE = 1e-4


def check_factor(factor: Factor, known: FloatArray, image: FloatArray) -> None:
    """Raises FactorizationError where rounding takes the solution too far from `known`.

    known: (n,) of positions in diagonals and of frames.  image: (n,) A known. One
    back-substitution.
    """
    error = np.abs(factor.solve(image[:, None])[:, 0] - known).max(initial=0.0)
    if not error <= ACCURATE:  # also where there are no numbers
        raise FactorizationError(
            f"the surface is solved to {error:.1g} of its diagonal only, expected {ACCURATE:g}: "
            "triangles are too thin, or gains too far apart"
        )
