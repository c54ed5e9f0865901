"""How the surface is drawn: its edges, its shading, its rest shape beside it."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Looks:
    """edges: those of the polygons are drawn.  smooth: shaded over the edges, else flat.

    rest: the rest shape is seen as a ghost.
    """

    edges: bool = False
    smooth: bool = True
    rest: bool = False


PLAIN = Looks()
