"""Parts of a glTF surface: the vertices of a mesh where a node shows them."""

from __future__ import annotations

from dataclasses import dataclass

from solver.types import FloatArray


@dataclass(frozen=True, eq=False)
class Part:
    """Vertices that some primitives of a mesh share, where a node shows them.

    primitives: their numbers in the mesh.  position: the accessor of the vertices.
    start, count: which vertices of the surface.  triangles: those of each primitive.
    linear: (3, 3) or (count, 3, 3) what the scene does to differences of positions.
    """

    node: int
    mesh: int
    primitives: tuple[int, ...]
    position: int
    start: int
    count: int
    triangles: tuple[slice, ...]
    linear: FloatArray

    @property
    def vertices(self) -> slice:
        """Which vertices of the surface."""
        return slice(self.start, self.start + self.count)
