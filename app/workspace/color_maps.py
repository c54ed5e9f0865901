"""What the surface is coloured by, as (n, 3) RGB in [0, 1]: the paper's figures use viridis."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from app.model.handles import FIXED, FREE
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


# Free, fixed, the active handle, those selected with it, the other handles.
FREE_COLOR, FIXED_COLOR, ACTIVE_COLOR, OTHER_COLOR = viridis([0.5, 0.0, 1.0, 0.86])
SELECTED_COLOR = viridis([0.93])[0]
SOFT_COLOR = viridis([0.75])[0]


def role_colors(work: Workspace) -> FloatArray:
    """Fixed dark purple, free teal, the active handle yellow, the others ever greener."""
    document = work.document
    palette = np.tile(OTHER_COLOR, (max(int(document.role.max()), FIXED) + 1, 1))
    palette[[FREE, FIXED]] = FREE_COLOR, FIXED_COLOR
    for number, handle in enumerate(work.selected):
        if handle.key < len(palette):
            palette[handle.key] = SELECTED_COLOR if number else ACTIVE_COLOR
    return np.asarray(palette[document.role])


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
