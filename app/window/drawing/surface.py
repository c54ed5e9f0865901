"""A surface in Polyscope: what differs from before is uploaded, and nothing else."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import polyscope as ps

from app.scene.looks import FLAT, Looks
from app.scene.shading import Shaded
from app.window.scaling import scaled
from solver.types import FloatArray

COLORS = "colors"
EDGE_WIDTH, EDGE_COLOR = 0.6, (0.15, 0.15, 0.2)


@dataclass(frozen=True, eq=False)
class Shape:
    """What a surface is to be. positions, colors: (n, 3) of the vertices of its mesh."""

    shaded: Shaded
    positions: FloatArray
    colors: FloatArray
    looks: Looks


class Surface:
    """The surface of one name, or none."""

    def __init__(self, name: str) -> None:
        self._name = name
        self._mesh: Any = None  # Polyscope has no type hints
        self._shown: Shape | None = None
        self._place: FloatArray = np.eye(4)

    def show(self, shape: Shape) -> None:
        """In place of the one before."""
        before, shaded = self._shown, shape.shaded
        if before is None or shaded is not before.shaded:
            self._register(shape)
            before = shape
        if shape.positions is not before.positions:
            self._mesh.update_vertex_positions(shaded.of(shape.positions))
        if shape.colors is not before.colors:
            colors = self._mesh.get_quantity_buffer(COLORS, "colors")
            colors.update_data(shaded.of(shape.colors))
        if shape.looks.edges != before.looks.edges:  # to set what is set draws all again
            self._mesh.set_edge_width(_edge_width(shape.looks))
        if (shape.looks.shading == FLAT) != (before.looks.shading == FLAT):
            self._mesh.set_smooth_shade(shape.looks.shading != FLAT)
        self._shown = shape

    def put(self, place: FloatArray) -> None:
        """Draw it moved, (4, 4)."""
        if self._mesh is not None and not np.array_equal(place, self._place):
            self._mesh.set_transform(place)
            self._place = place

    def remove(self) -> None:
        """Draw none."""
        if self._mesh is not None:
            self._mesh.remove()
            self._mesh = self._shown = None

    def _register(self, shape: Shape) -> None:
        shaded = shape.shaded
        self._mesh = ps.register_surface_mesh(
            self._name,
            shaded.of(shape.positions),
            shaded.polygons,
            smooth_shade=shape.looks.shading != FLAT,  # each is told: Polyscope keeps what was
            edge_width=_edge_width(shape.looks),  # told of the last one of this name
            material="wax",
        )
        self._mesh.set_back_face_policy("identical")
        self._mesh.set_edge_color(EDGE_COLOR)
        self._mesh.add_color_quantity(COLORS, shaded.of(shape.colors), enabled=True)
        self._place = np.eye(4)


def _edge_width(looks: Looks) -> float:
    return scaled(EDGE_WIDTH) if looks.edges else 0.0
