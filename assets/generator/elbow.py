"""The session that opens ready to drag: a hand to hold, a soft elbow, a fixed body."""

from __future__ import annotations

import json

import numpy as np

from app.model.session.writing import FORMAT, VERSION
from assets.generator.figure import ELBOW, WRIST
from solver.geometry.bounding_box import diagonal
from solver.softness.falloff import falloff
from solver.types import BoolArray, FloatArray, IntArray

FIXED_BELOW = 0.25
SOFT_REACH = 0.08
"""Distance from the elbow to the end of the soft band, in bounding-box diagonals."""


def softness(V: FloatArray) -> FloatArray:
    """1 at the +x elbow, 0 outside its band, C1 between; rounded to 4 decimals."""
    reach = SOFT_REACH * diagonal(V)
    return np.round(falloff((V[:, 0] - ELBOW) / reach), 4) + 0.0


def session_text(
    mesh_name: str, V: FloatArray, F: IntArray, fixable: BoolArray | None = None
) -> str:
    """A session file for the figure, one line for each list.

    fixable: (n,) which vertices may be fixed; what is worn follows. None for all.
    """
    body = V[:, 0] < FIXED_BELOW
    entries = {
        "format": FORMAT,
        "version": VERSION,
        "mesh": {"path": mesh_name, "vertices": len(V), "faces": len(F)},
        "fixed": np.flatnonzero(body if fixable is None else body & fixable).tolist(),
        "handles": [
            {
                "name": "hand",
                "vertices": np.flatnonzero(V[:, 0] > WRIST).tolist(),
                "transform": np.eye(4, dtype=int).tolist(),
            }
        ],
        "softness": softness(V).tolist(),
        "material": "hinge",
        "settings": {"bending_length": 0.01, "orientation": True, "rigid": 1},
    }
    lines = ",\n ".join(f'"{key}": {json.dumps(value)}' for key, value in entries.items())
    return "{" + lines + "}\n"
