"""What the surface is coloured by, as (n, 3) RGB in [0, 1]: the paper's figures use viridis."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from app.model.handles import FIRST_HANDLE
from app.workspace.workspace import Workspace
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


# The heat maps: light grey is the rest shape, blue is less than that, red is more.
_BLUE, _GREY, _RED = (0.10, 0.30, 0.72), (0.84, 0.84, 0.83), (0.72, 0.06, 0.10)
_COLD, _WARM = (0.45, 0.65, 0.90), (0.96, 0.62, 0.38)


def viridis(values: ArrayLike) -> FloatArray:
    """RGB of values (k,) in [0, 1], (k, 3): dark purple to yellow."""
    return _blend(values, _VIRIDIS)


def diverging(values: ArrayLike) -> FloatArray:
    """RGB of values (k,) in [0, 1], (k, 3): blue, light grey at 1/2, red."""
    return _blend(values, np.array([_BLUE, _COLD, _GREY, _WARM, _RED]))


def rising(values: ArrayLike) -> FloatArray:
    """RGB of values (k,) in [0, 1], (k, 3): light grey to red."""
    return _blend(values, np.array([_GREY, _WARM, _RED]))


def _blend(values: ArrayLike, stops: FloatArray) -> FloatArray:
    at = np.linspace(0, 1, len(stops))
    s = np.asarray(values, dtype=np.float64)
    return np.column_stack([np.interp(s, at, channel) for channel in stops.T])


FREE_COLOR, FIXED_COLOR = viridis([0.5, 0.0])
SOFT_COLOR = viridis([0.75])[0]
# Handles in turn: all brighter than what is free or fixed, so that no hue alone tells them apart.
HANDLE_COLORS = np.array(
    [
        (0.993, 0.906, 0.144),
        (0.95, 0.57, 0.25),
        (0.94, 0.62, 0.78),
        (0.58, 0.82, 0.97),
        (0.69, 0.88, 0.35),
        (0.86, 0.42, 0.40),
        (0.76, 0.68, 0.94),
        (0.88, 0.80, 0.64),
    ]
)


def handle_color(key: int) -> FloatArray:
    """(3,) of a handle, as long as the mesh is open."""
    return np.asarray(HANDLE_COLORS[(key - FIRST_HANDLE) % len(HANDLE_COLORS)])


def role_colors(work: Workspace) -> FloatArray:
    """Fixed dark purple, free teal, each handle a bright colour of its own."""
    role = work.document.role
    keys = range(FIRST_HANDLE, int(role.max()) + 1)
    palette = np.vstack([FREE_COLOR, FIXED_COLOR, *(handle_color(key) for key in keys)])
    return np.asarray(palette[role])


def softness_colors(work: Workspace) -> FloatArray:
    """Rigid dark purple, fully soft yellow."""
    return viridis(work.document.softness)


@dataclass(frozen=True)
class Scale:
    """What a legend shows: `colors` from `low` to `high`; values beyond take the end's colour.

    factor, unit: from the values to what is written beside the legend.
    """

    colors: Callable[[ArrayLike], FloatArray]
    low: float
    high: float
    factor: float = 1.0
    unit: str = ""

    def __call__(self, values: FloatArray) -> FloatArray:
        """RGB of values (n,), (n, 3)."""
        return self.colors((values - self.low) / (self.high - self.low))

    def text(self, value: float, form: str = "g") -> str:
        """A value as it is written for a person."""
        return f"{self.factor * value:{form}}{self.unit}"


@dataclass(frozen=True)
class ColorMap:
    """One way to colour the surface.

    paint: (n, 3) RGB.  fields: of the document, those that it depends on.
    scale: what its legend shows, None without one.
    measure: what it shows of the shape on screen (heat.MEASURES), None if nothing.
    pins: whether the pinned vertices are marked on it.
    """

    label: str
    paint: Callable[[Workspace], FloatArray]
    fields: tuple[str, ...] = ()
    scale: Scale | None = None
    measure: str | None = None
    pins: bool = False

    def version(self, work: Workspace) -> tuple[object, ...]:
        """Differs whenever what `paint` returns may."""
        revisions = tuple(work.document.revision[field] for field in self.fields)
        if self.measure is not None:
            return (*revisions, work.heat.version)
        return revisions


def _heat(measure: str, label: str, scale: Scale) -> ColorMap:
    return ColorMap(label, lambda work: scale(work.heat.values), (), scale, measure)


MAPS = {
    "roles": ColorMap("Regions", role_colors, ("role",)),
    "softness": ColorMap(
        "Softness", softness_colors, ("softness",), Scale(viridis, 0.0, 1.0), pins=True
    ),
    "strain": _heat("strain", "Strain of edges", Scale(diverging, -0.25, 0.25, 100, " %")),
    "dihedral": _heat(
        "dihedral", "Change of bend", Scale(rising, 0.0, np.pi / 4, 180 / np.pi, "°")
    ),
    "area": _heat("area", "Change of area", Scale(diverging, -0.5, 0.5, 100, " %")),
}
