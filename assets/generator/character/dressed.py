"""The dressed figure: many pieces with seams, as a character leaves a modelling program."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from assets.generator import figure
from assets.generator.character.clothes import clothes
from assets.generator.character.details import details
from assets.generator.character.seams import Part, cut_part
from assets.generator.elbow import session_text
from solver.types import FloatArray, IntArray

BODY = "body"


def dressed(V: FloatArray, F: IntArray) -> list[Part]:
    """The parts of the figure, its body with mesh (V, F) first."""
    field = figure.body()
    return [cut_part(BODY, "skin", V, F), *clothes(field, V, F), *details(field)]


def dressed_session(mesh_name: str, parts: Sequence[Part]) -> str:
    """As the mannequin's, with the body fixed alone: what is worn follows."""
    counts = [len(part.V) for part in parts]
    first = np.cumsum([0, *counts[:-1]])
    F = np.concatenate([part.F + start for part, start in zip(parts, first, strict=True)])
    body = np.repeat([part.name == BODY for part in parts], counts)
    return session_text(mesh_name, np.concatenate([part.V for part in parts]), F, body)
