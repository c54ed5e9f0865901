"""The numbers and switches of the solver that a person can set, with the values each takes."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any

from solver.limits import HIGHEST_LEVEL, LONGEST_BEND, SHORTEST_BEND, within


@dataclass(frozen=True)
class Setting:
    """Its default, and what values it takes.

    written: whether a session says it even where it is the default.
    """

    default: Any
    accepts: Callable[[Any], bool]
    expected: str
    written: bool = True


def is_number(value: Any) -> bool:
    """A finite real number; a boolean is none."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        return False
    try:
        return math.isfinite(value)
    except OverflowError:  # an integer beyond every float
        return False


def is_attach(value: Any) -> bool:
    """True or False for all pieces, or the numbers of those that follow."""
    if isinstance(value, bool):
        return True
    return isinstance(value, list) and all(type(v) is int and v >= 0 for v in value)


# Above so many vertices frames are solved on a coarse mesh of so many, unless a person says other
# things: below, the exact solution binds in less than half a second. [docs/coarse.md]
LARGE, COARSE = 20_000, 5_000


# What the levels of `rigid` are called. The best shape is all but settled. [docs/quality.md]
LEVELS = {"linear": 0, "keeps lengths": 1, "best shape": 4}
# Up to so many vertices, and with coarse frames, the best shape keeps up with the mouse.
QUICK = 10_000


def affordable_level(vertex_count: int) -> int:
    """The level of a new document: the best shape where a frame can afford it."""
    quick = vertex_count <= QUICK or vertex_count > LARGE
    return LEVELS["best shape" if quick else "keeps lengths"]


def is_coarse(value: Any) -> bool:
    """True for what the size of the mesh suggests, False for exact, or a number of vertices."""
    return isinstance(value, bool) or (type(value) is int and value > 0)


def coarse_count(value: bool | int, vertex_count: int) -> int | None:
    """How many vertices frames are solved on, None for all."""
    if isinstance(value, bool):
        return COARSE if value and vertex_count > LARGE else None
    return value


SETTINGS: Mapping[str, Setting] = MappingProxyType(
    {
        "bending_length": Setting(
            0.01,
            lambda v: is_number(v) and within(v, SHORTEST_BEND, LONGEST_BEND),
            f"a number from {SHORTEST_BEND:g} to {LONGEST_BEND:g}",
        ),
        "orientation": Setting(True, lambda v: isinstance(v, bool), "true or false"),
        "rigid": Setting(
            1,
            lambda v: type(v) is int and 0 <= v <= HIGHEST_LEVEL,
            f"an integer from 0 to {HIGHEST_LEVEL}",
        ),
        "attach": Setting(
            True, is_attach, "true, false or a list of the pieces that follow", written=False
        ),
        "coarse": Setting(
            True, is_coarse, "true, false or a number of vertices, 1 or more", written=False
        ),
    }
)
