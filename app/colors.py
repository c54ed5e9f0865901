"""What the surface is coloured by, as (n, 3) RGB in [0, 1]: the paper's figures use viridis."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike

from app.document import FIRST_HANDLE, Document, Handle
from solver.types import FloatArray

# Viridis at 0, 1/16, ..., 1. [van der Walt & Smith 2015, CC0]
_VIRIDIS = np.array(
    [
        (0.267, 0.005, 0.329),
        (0.282, 0.095, 0.417),
        (0.279, 0.175, 0.483),
        (0.259, 0.251, 0.524),
        (0.230, 0.321, 0.545),
        (0.200, 0.386, 0.555),
        (0.173, 0.447, 0.558),
        (0.150, 0.506, 0.557),
        (0.128, 0.565, 0.551),
        (0.120, 0.624, 0.534),
        (0.155, 0.682, 0.503),
        (0.241, 0.737, 0.455),
        (0.363, 0.787, 0.387),
        (0.508, 0.829, 0.299),
        (0.669, 0.862, 0.195),
        (0.836, 0.886, 0.102),
        (0.993, 0.906, 0.144),
    ]
)


def viridis(values: ArrayLike) -> FloatArray:
    """RGB of values (k,) in [0, 1], (k, 3): dark purple to yellow."""
    at = np.linspace(0, 1, len(_VIRIDIS))
    s = np.asarray(values, dtype=np.float64)
    return np.column_stack([np.interp(s, at, channel) for channel in _VIRIDIS.T])


# Free, fixed, the active handle, the other handles.
FREE_COLOR, FIXED_COLOR, ACTIVE_COLOR, OTHER_COLOR = viridis([0.5, 0.0, 1.0, 0.86])
SOFT_COLOR = viridis([0.75])[0]


def role_colors(document: Document, active: Handle | None) -> FloatArray:
    """Fixed dark purple, free teal, the active handle yellow, the others a greener yellow."""
    palette = np.tile(OTHER_COLOR, (FIRST_HANDLE + len(document.handles), 1))
    palette[:FIRST_HANDLE] = FREE_COLOR, FIXED_COLOR
    if active is not None:
        palette[document.role_of(active.key)] = ACTIVE_COLOR
    return np.asarray(palette[document.role])


def softness_colors(document: Document, active: Handle | None) -> FloatArray:
    """Rigid dark purple, fully soft yellow."""
    return viridis(document.softness)


MAPS: dict[str, Callable[[Document, Handle | None], FloatArray]] = {
    "roles": role_colors,
    "softness": softness_colors,
}
