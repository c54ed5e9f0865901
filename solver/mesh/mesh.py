"""The Mesh: polygons and their triangles, from a file or arrays, saved with new positions."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from solver.errors import MeshError
from solver.geometry.welding import weld_pieces
from solver.mesh.formats.format import (
    Colours,
    DeformedSurface,
    FileContent,
    Groups,
    Smoothing,
)
from solver.mesh.formats.table import format_of
from solver.mesh.polygons import Polygons, triangulate
from solver.mesh.pose_files import pose_paths
from solver.mesh.progress import Progress, in_steps, portion, silent
from solver.mesh.smoothing import all_flat, smooth_corners
from solver.storage import read_bytes, write_atomically
from solver.types import FloatArray, IntArray


@dataclass(frozen=True, eq=False)
class Mesh:
    """A surface: `vertices` (n, 3) float64 in file order, `faces` (m, 3) int64 triangles.

    Arrays are read-only. `outlines` are the polygons of the file, `triangle_corners` (m, 3) their
    corners that each triangle takes: `faces == outlines.corners[triangle_corners]`. `extras` counts
    what else the file holds, in plain words; `source` is what its format keeps of that to save it.
    `groups` and `colours` (a function) are as in `FileContent`, None where the file has none.

    >>> import solver
    >>> mesh = solver.Mesh.from_arrays([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2, 3]])
    >>> mesh.vertices.shape, mesh.faces.shape, mesh.polygons.tolist()
    ((4, 3), (2, 3), [[0, 1, 2, 3]])
    """

    vertices: FloatArray
    outlines: Polygons
    triangle_corners: IntArray
    faces: IntArray
    extras: Mapping[str, int]
    source: object
    groups: Groups | None = None
    colours: Colours | None = None
    smoothing: Smoothing | None = None

    @classmethod
    def from_arrays(cls, V: ArrayLike, F: ArrayLike) -> Mesh:
        """A mesh of triangles (m, 3) or quads (m, 4) over (n, 3) finite positions.

        Raises MeshError where the arrays do not describe one.

        >>> solver.Mesh.from_arrays([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 3]])
        Traceback (most recent call last):
        solver.errors.MeshError: face 0 names vertex 3, but they go from 0 to 2
        """
        vertices = _positions(V)
        faces = np.asarray(F)
        if faces.ndim != 2 or faces.shape[1] not in (3, 4):
            raise MeshError(f"faces must be (m, 3) or (m, 4), got {faces.shape}")
        if faces.dtype.kind not in "iu":
            raise MeshError(f"faces must be whole numbers, got {faces.dtype}")
        polygons = Polygons.from_array(faces.astype(np.int64))
        wrong = np.flatnonzero((polygons.corners < 0) | (polygons.corners >= len(vertices)))
        if wrong.size:
            face, vertex = wrong[0] // faces.shape[1], polygons.corners[wrong[0]]
            last = len(vertices) - 1
            raise MeshError(f"face {face} names vertex {vertex}, but they go from 0 to {last}")
        return _build(FileContent(vertices, polygons), "the mesh")

    @property
    def pieces(self) -> IntArray:
        """(n,) the number of the connected piece of each vertex, seams welded, -1 for a vertex
        that no face uses."""
        return self._welded_pieces[1]

    @property
    def welded(self) -> IntArray:
        """(n,) the number of the vertex that each becomes once seams are welded."""
        return self._welded_pieces[0]

    @cached_property
    def _welded_pieces(self) -> tuple[IntArray, IntArray]:
        return weld_pieces(self.vertices, self.faces)

    @cached_property
    def flat(self) -> bool:
        """Whether the file has every edge hard."""
        return self.smoothing is not None and all_flat(self.smoothing, self.outlines.sizes)

    @cached_property
    def smooth_corners(self) -> IntArray | None:
        """(sum,) a number for each corner of `outlines`: corners that the file shades as one have
        the same. None where no edge is hard, and `welded` says as much, or where all are."""
        if self.smoothing is None or self.flat:
            return None
        return smooth_corners(self.smoothing, self.welded[self.outlines.corners])

    @cached_property
    def polygons(self) -> IntArray | list[list[int]]:
        """The faces of the file for display: (p, k) where all have k corners, else lists."""
        return self.outlines.rows()

    def save(
        self,
        path: str | os.PathLike[str],
        X: ArrayLike,
        poses: Mapping[str, ArrayLike] | None = None,
        progress: Progress | None = None,
    ) -> None:
        """Write the mesh with positions X (n, 3), in the format of the path's suffix.

        A file saved in the format of its source keeps all else in it: an OBJ every byte but the
        coordinates of `v` lines that moved and of `vn` lines that turned; a PLY, OFF or STL so too,
        in the type of its numbers; a GLB or glTF everything but positions, normals and tangents.
        Other formats keep the polygons (STL, GLB: triangles) and, but for STL, colours of vertices;
        `left_out` tells the rest.
        poses: positions (n, 3) by name. They become morph targets of a GLB or glTF, and beside any
        other file, say out.obj, a file each: out-fist.obj.
        progress: called a dozen times with growing fractions, 1 at the end. Where it raises, saving
        stops: no file is left half written.
        Raises MeshError for positions, names or the suffix, FileError where a file cannot be
        written.

        >>> mesh.save("large.ply", 10 * mesh.vertices)
        >>> solver.load_mesh("large.ply").vertices.max()
        np.float64(10.0)
        """
        file_format, name = format_of(path), os.fspath(path)
        surface = DeformedSurface(
            self.vertices,
            self._positions(X),
            self.outlines,
            self.triangle_corners,
            self.source,
            name,
            poses={pose: self._positions(Y) for pose, Y in (poses or {}).items()},
            groups=self.groups,
            colours=self.colours,
        )
        files = {name: surface}
        for pose, file in pose_paths(name, surface.poses).items():
            files[file] = replace(surface, positions=surface.poses[pose], path=file)
        tell = in_steps(progress or silent)
        for done, (file, content) in enumerate(files.items()):
            here = portion(tell, done / len(files), (done + 0.9) / len(files))
            write_atomically(file, file_format.write(replace(content, progress=here)))
            tell((done + 1) / len(files))

    def left_out(self, path: str | os.PathLike[str]) -> str:
        """What a file saved at `path` does not keep of the mesh, in words; empty if it keeps all.

        Raises MeshError for the suffix.

        >>> import solver
        >>> corners = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
        >>> quad = solver.Mesh.from_arrays(corners, [[0, 1, 2, 3]])
        >>> quad.left_out("out.stl")
        'STL keeps no polygons (1 quad became triangles)'
        >>> quad.left_out("out.ply")
        ''
        """
        lost = format_of(path).left_out(self.source, self.extras, self.outlines)
        name = Path(path).suffix[1:].upper()
        return f"{name} keeps no {', '.join(lost)}" if lost else ""

    def _positions(self, X: ArrayLike) -> FloatArray:
        positions = _positions(X)
        if positions.shape != self.vertices.shape:
            expected = self.vertices.shape
            raise MeshError(f"positions must be {expected}, got {positions.shape}")
        return positions


def load_mesh(path: str | os.PathLike[str], progress: Progress | None = None) -> Mesh:
    """Read a mesh file; its suffix says in which format of `formats.table`.

    progress: called a dozen times with growing fractions, 1 at the end. Where it raises, reading
    stops.
    Raises FileError where the file cannot be read and MeshError, in one line that names the place,
    where it does not hold a surface.

    >>> import solver
    >>> with open("square.obj", "w") as file:
    ...     _ = file.write("v 0 0 0\\nv 1 0 0\\nv 1 1 0\\nv 0 1 0\\nf 1 2 3 4\\n")
    >>> solver.load_mesh("square.obj").faces.tolist()
    [[0, 1, 2], [0, 2, 3]]
    """
    file_format, name = format_of(path), os.fspath(path)
    tell = in_steps(progress or silent)
    data = read_bytes(path)
    mesh = _build(file_format.read(data, name, portion(tell, 0.05, 0.85)), name)
    tell(1.0)
    return mesh


def _build(content: FileContent, name: str) -> Mesh:
    vertices, polygons = content.vertices, content.polygons
    if not len(polygons.sizes):
        raise MeshError(f"{name}: no faces, expected at least one")
    corners = triangulate(vertices, polygons)
    faces = polygons.corners[corners]
    for array in (vertices, polygons.sizes, polygons.corners, corners, faces):
        _lock(array)
    kept = content.extras, content.source, content.groups, content.colours, content.smoothing
    return Mesh(vertices, polygons, corners, faces, *kept)


def _positions(X: ArrayLike) -> FloatArray:
    """A copy as (n, 3) float64."""
    try:
        positions = np.array(X, dtype=np.float64, order="C")
    except (TypeError, ValueError) as error:
        raise MeshError(f"positions must be (n, 3) numbers, got {type(X).__name__}") from error
    if positions.ndim != 2 or positions.shape[1] != 3:
        raise MeshError(f"positions must be (n, 3), got {positions.shape}")
    bad = np.flatnonzero(~np.isfinite(positions).all(axis=1))
    if bad.size:
        raise MeshError(
            f"positions must be finite, got {positions[bad[0]].tolist()} at vertex {bad[0]}"
        )
    return positions


def _lock(array: NDArray[Any]) -> None:
    array.setflags(write=False)
