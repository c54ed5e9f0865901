"""Numbers in the type of a file, which may be narrower, and back."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import DTypeLike, NDArray

from solver.errors import MeshError
from solver.types import FloatArray


def widened(values: NDArray[Any]) -> FloatArray:
    """Numbers of a file as float64; one that is none of any kind stays so, without a warning."""
    with np.errstate(invalid="ignore"):
        return values.astype(np.float64)


def narrowed(values: FloatArray, kind: DTypeLike) -> NDArray[Any]:
    """Values in a float type. Raises MeshError where a finite one would become infinite."""
    with np.errstate(over="ignore", invalid="ignore"):
        data = values.astype(kind)
    if (np.isinf(data) & np.isfinite(values)).any():
        largest = np.nanmax(np.abs(values))
        raise MeshError(f"coordinates up to {largest:.3g} do not fit {np.dtype(kind).name}")
    return data
