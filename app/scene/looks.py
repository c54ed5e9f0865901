"""How the surface is drawn: its edges, its shading, its rest shape beside it."""

from __future__ import annotations

from dataclasses import dataclass

SHADINGS = SMOOTH, FLAT, FILE = "smooth", "flat", "file"


@dataclass(frozen=True)
class Looks:
    """edges: those of the polygons are drawn.

    shading: one of SHADINGS. "file" has the hard edges that the file asks for, and is smooth where
    it asks for none.
    rest: the rest shape is seen as a ghost.  beside: it stands beside the surface.
    """

    edges: bool = False
    shading: str = FILE
    rest: bool = False
    beside: bool = False


PLAIN = Looks()
