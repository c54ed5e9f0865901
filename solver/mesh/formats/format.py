"""What a mesh file format is: a function that reads bytes and one that writes them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from solver.mesh.polygons import Polygons
from solver.mesh.progress import Progress, silent
from solver.types import BoolArray, FloatArray, IntArray

Colours = Callable[[], FloatArray]


@dataclass(frozen=True, eq=False)
class Groups:
    """Named parts of a file: `of_polygon` (p,) is the place in `names` of each, -1 for none."""

    names: tuple[str, ...]
    of_polygon: IntArray


@dataclass(frozen=True, eq=False)
class Smoothing:
    """What a file says of where its surface is smooth and where it has hard edges.

    alike: (sum,) of each polygon corner. Corners in one place that have the same number are smooth
    together; -1 where the file says nothing. A number below k names one of normals (k, 3), and
    nearly equal normals count as the same.
    """

    alike: IntArray
    normals: FloatArray


@dataclass(frozen=True, eq=False)
class FileContent:
    """What a mesh file holds.

    vertices: (n, 3) float64 in file order.  polygons: the faces over them.
    extras: what else is in it that saving keeps, in plain words, and how many of each.
    source: what its format needs to write that back, None where it keeps nothing.
    groups: the polygons by the objects or nodes that they belong to, None where it names none.
    colours: reads those of the vertices, (n, 4) as in `colours`, None where it has none.
    smoothing: None where it says nothing of that.
    """

    vertices: FloatArray
    polygons: Polygons
    extras: Mapping[str, int] = field(default_factory=dict)
    source: object = None
    groups: Groups | None = None
    colours: Colours | None = None
    smoothing: Smoothing | None = None


@dataclass(frozen=True, eq=False)
class DeformedSurface:
    """What is to be written: a surface at rest and deformed, and the file it came from.

    rest, positions: (n, 3) before and after.  polygons: its faces.  triangle_corners: (m, 3) the
    corners of `polygons` that each triangle takes.
    source: of the file the surface was read from. A format knows its own and ignores any other.
    path: where it is to be written.  poses: positions (n, 3) by name, for formats that keep them.
    progress: told how much of it is written.  groups: of its polygons, None where it has none.
    colours: as in FileContent.
    """

    rest: FloatArray
    positions: FloatArray
    polygons: Polygons
    triangle_corners: IntArray
    source: object = None
    path: str = ""
    poses: Mapping[str, FloatArray] = field(default_factory=dict)
    progress: Progress = silent
    groups: Groups | None = None
    colours: Colours | None = None

    @cached_property
    def triangles(self) -> IntArray:
        """(m, 3) vertices of each triangle."""
        return self.polygons.corners[self.triangle_corners]

    @property
    def polygon_of_triangle(self) -> IntArray:
        """(m,) the polygon that each triangle is a part of."""
        ends = np.cumsum(self.polygons.sizes)
        return np.searchsorted(ends, self.triangle_corners[:, 0], side="right")

    @property
    def moved(self) -> BoolArray:
        """(n,) which vertices are no longer where they were."""
        return np.asarray((self.rest != self.positions).any(axis=1))


@dataclass(frozen=True)
class Format:
    """One file format.

    read: from the bytes of a file and its path. Raises MeshError, in one line that starts with the
    path and names the place, where they do not hold a surface.
    It tells its progress from 0 to 1.
    write: to the bytes of a file.
    source: the type of what it keeps of a file of its own, and writes back.
    holds: which extras a file has that is written from another format.
    only_triangles: whether larger polygons are cut.
    keeps_poses: whether one file holds poses beside the surface; else each is a file of its own.
    """

    read: Callable[[bytes, str, Progress], FileContent]
    write: Callable[[DeformedSurface], bytes]
    source: type
    holds: frozenset[str] = frozenset()
    only_triangles: bool = False
    keeps_poses: bool = False

    def left_out(self, source: object, extras: Mapping[str, int], polygons: Polygons) -> list[str]:
        """What a file of this format does not keep of a surface, in plain words."""
        if isinstance(source, self.source):
            return []
        lost = [
            words.removesuffix(" left out")
            for words, count in extras.items()
            if count and words not in self.holds
        ]
        large = polygons.sizes[polygons.sizes > 3]
        if len(large) and self.only_triangles:
            kind = "quad" if (large == 4).all() else "polygon"
            number = f"{len(large):,} {kind}{'s' * (len(large) > 1)}"
            lost.append(f"polygons ({number} became triangles)")
        return lost
