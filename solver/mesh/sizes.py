"""Whether a mesh can be opened to be deformed. Files of any numbers are read and written."""

from __future__ import annotations

import numpy as np

from solver.arrays import extent
from solver.errors import MeshError
from solver.limits import LARGEST_SHOWN, SMALLEST_SHOWN
from solver.types import FloatArray, IntArray


def check_sizes(V: FloatArray, used: IntArray, name: str) -> None:
    """Raises MeshError naming what `name` says unless a surface can be solved and shown.

    V: (n, 3).  used: (k,) the vertices of its faces.
    """
    large = np.flatnonzero(~(np.abs(V) <= LARGEST_SHOWN).all(axis=1))
    if large.size:
        raise MeshError(
            f"{name}, vertex {large[0]}: expected coordinates up to {LARGEST_SHOWN:.0e}, "
            f"got {V[large[0]].tolist()}"
        )
    size = extent(V, used)
    if size < SMALLEST_SHOWN:
        what = "all faces lie in one point" if size == 0 else f"the surface is {size:.3g} large"
        raise MeshError(f"{name}: {what}, expected a size of {SMALLEST_SHOWN:.0e} or more")
