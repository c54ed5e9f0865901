"""What another program made of a mesh, and how long it took."""

from __future__ import annotations

from dataclasses import dataclass

from solver.types import FloatArray


@dataclass(frozen=True)
class Result:
    """X: (n, 3).  preprocessing: seconds, once.  deformation: seconds, each time."""

    X: FloatArray
    preprocessing: float
    deformation: float
