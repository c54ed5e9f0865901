"""How a press of the tools that mark vertices marks them."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Marking:
    """shape: a name in marking_shapes.SHAPES, what a press begins.

    through: whether a lasso or a box also takes what lies behind the surface that is seen.
    """

    shape: str = "brush"
    through: bool = False
