"""Numbers in the narrower type of a file."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import DTypeLike, NDArray

from solver.errors import MeshError
from solver.types import FloatArray


def narrowed(values: FloatArray, kind: DTypeLike) -> NDArray[Any]:
    """Values in a float type. Raises MeshError where a finite one would become infinite."""
    with np.errstate(over="ignore", invalid="ignore"):
        data = values.astype(kind)
    if (np.isinf(data) & np.isfinite(values)).any():
        largest = np.nanmax(np.abs(values))
        raise MeshError(f"coordinates up to {largest:.3g} do not fit {np.dtype(kind).name}")
    return data
