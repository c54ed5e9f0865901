"""One figure: a pose, its colours, what it shows in words and in numbers."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np

from app.figures.arm import Arm
from app.figures.measures import Numbers
from app.workspace.color_maps import FIXED_COLOR, FREE_COLOR, HANDLE_COLORS, viridis
from solver.types import BoolArray, FloatArray

CameraName = Literal["figure", "arm", "elbow"]


@dataclass(frozen=True, eq=False)
class Figure:
    """What is drawn and what is said about it.

    number: as in the paper, "13a" and so on where it has none.  title: of a few words.
    caption: sentences with the numbers of this run.  settings: how the pose was made.
    X: (n, 3).  colors: (n, 3) RGB.  pins: (n,) vertices that get a dot.
    """

    number: str
    title: str
    caption: str
    X: FloatArray
    colors: FloatArray
    camera: CameraName
    numbers: Numbers = field(default_factory=dict)
    settings: dict[str, Any] = field(default_factory=dict)
    pins: BoolArray | None = None

    @property
    def picture(self) -> str:
        """File name of its picture."""
        return f"figure-{self.number}.png"


def plain(arm: Arm) -> FloatArray:
    """(n, 3): one colour, nothing is held."""
    return np.tile(FREE_COLOR, (len(arm.V), 1))


def regions(arm: Arm, handle: bool = True) -> FloatArray:
    """(n, 3): fixed dark purple, the hand bright yellow if it is a handle, free teal."""
    colors = plain(arm)
    colors[arm.fixed] = FIXED_COLOR
    if handle:
        colors[arm.hand] = HANDLE_COLORS[0]
    return colors


def soft(arm: Arm, step: bool = False) -> FloatArray:
    """(n, 3): softness, dark purple where rigid or held, bright yellow where softest."""
    return viridis(arm.softness(arm.V[:, 0], step))
