"""What a person should know before folding: faults of the softness field, in plain words."""

from __future__ import annotations

from dataclasses import dataclass

from app.model.document import Document
from app.model.handles import FREE
from solver.softness.checks import check_softness
from solver.types import IntArray

STEEP = "The soft region ends abruptly: the surface will crease there"
WEAK = "Too soft for the mesh: a fold will tear the surface"


@dataclass(frozen=True, eq=False)
class Warning:
    """A fault in plain words, and the vertices (k,) where it is."""

    text: str
    vertices: IntArray


def softness_warnings(document: Document, edges: IntArray) -> tuple[Warning, ...]:
    """One for each kind of fault; edges: (e, 2) of the mesh."""
    free = document.role == FREE  # what is held as a whole neither creases nor tears
    held = ~(free[edges[:, 0]] | free[edges[:, 1]])
    check = check_softness(edges[~held], document.softness, document.material)
    faults = ((STEEP, check.steep_at), (WEAK, check.weak_at))
    return tuple(Warning(text, vertices) for text, vertices in faults if len(vertices))
