"""What a deformation changes in a mesh of a glTF file: positions, normals and tangents."""

from __future__ import annotations

from functools import cached_property

import numpy as np

from solver.errors import MeshError
from solver.mesh.formats.format import DeformedSurface
from solver.mesh.formats.gltf.accessors import read_floats
from solver.mesh.formats.gltf.container import Gltf
from solver.mesh.formats.gltf.part import Part
from solver.mesh.formats.gltf.saving.edit import Edit
from solver.mesh.normals import turn_normals
from solver.types import BoolArray, FloatArray, IntArray

# Attributes that turn with the surface, and their types.
_DIRECTIONS = {"NORMAL": "VEC3", "TANGENT": "VEC4"}
# Holds positions in a form of its own, beside accessors for readers that do not know it.
_COMPRESSED = "KHR_draco_mesh_compression"


class DeformedPart:
    """A part of the surface in the space of its mesh, under any positions X (n, 3)."""

    def __init__(self, gltf: Gltf, part: Part, surface: DeformedSurface) -> None:
        self.part = part
        self._gltf = gltf
        self._rest = surface.rest
        self._triangles = surface.triangles
        self._primitives = gltf.json["meshes"][part.mesh]["primitives"]

    def moved(self, before: FloatArray, X: FloatArray) -> BoolArray:
        """(count,) which vertices differ between positions of the surface."""
        own = self.part.vertices
        return np.asarray((before[own] != X[own]).any(axis=1))

    def steps(self, before: FloatArray, X: FloatArray) -> FloatArray:
        """(count, 3) from positions `before` of the surface to X, in the space of the mesh."""
        own = self.part.vertices
        return _times(self._inverse, X[own] - before[own])

    def positions(self, X: FloatArray) -> FloatArray:
        """(count, 3) in the space of the mesh; what did not move keeps its bits."""
        local = read_floats(self._gltf, self.part.position, "VEC3")
        moved = self.moved(self._rest, X)
        local[moved] += self.steps(self._rest, X)[moved]
        return local

    def users(self, attribute: str) -> dict[int, list[int]]:
        """The accessors of an attribute, each with the primitives of the part that use it."""
        result: dict[int, list[int]] = {}
        for i in self.part.primitives:
            number = self._primitives[i]["attributes"].get(attribute)
            if number is not None:
                result.setdefault(number, []).append(i)
        return result

    def directions(
        self, attribute: str, accessor: int, X: FloatArray
    ) -> tuple[FloatArray, BoolArray]:
        """(count, 3 or 4) normals or tangents under X, and which of them turned, (count,).

        None turned where the file does not hold one for every vertex: some exporters write such
        files, and no position depends on them.
        """
        none = np.zeros(self.part.count, dtype=bool)
        try:
            values = read_floats(self._gltf, accessor, _DIRECTIONS[attribute])
        except MeshError:
            return np.zeros((self.part.count, 3)), none
        if len(values) != self.part.count:
            return np.zeros((self.part.count, 3)), none
        # Normals are covectors: the inverse transpose brings them to the scene.
        linear, inverse = self.part.linear, self._inverse
        if attribute == "NORMAL":
            linear, inverse = (np.swapaxes(a, -1, -2) for a in (inverse, linear))
        own = self.part.vertices
        users = self._faces(self.users(attribute)[accessor])
        there, turned = turn_normals(
            _times(linear, values[:, :3]), users, self._rest[own], X[own], users
        )
        before, after = values[turned, :3], _times(inverse, there)[turned]
        size, length = (np.linalg.norm(a, axis=1, keepdims=True) for a in (before, after))
        values[turned, :3] = after * size / np.where(length > 0, length, 1)
        return values, turned

    @cached_property
    def _inverse(self) -> FloatArray:
        linear = self.part.linear
        # A flat or vanished scale: nothing can be written in that direction.
        flat = np.linalg.det(linear) == 0
        return np.asarray(np.linalg.pinv(linear) if flat.any() else np.linalg.inv(linear))

    def _faces(self, primitives: list[int]) -> IntArray:
        """(m, 3) triangles of primitives of the part, by its own vertices."""
        rows = dict(zip(self.part.primitives, self.part.triangles, strict=True))
        faces = [self._triangles[rows[i]] for i in primitives]
        return np.concatenate(faces) - self.part.start


def deform(edit: Edit, shape: DeformedPart, rest: FloatArray, X: FloatArray) -> None:
    """Write positions, normals and tangents of a part as they are under X."""
    moved = shape.moved(rest, X)
    if not moved.any():
        return
    primitives = edit.json["meshes"][shape.part.mesh]["primitives"]

    def write(attribute: str, accessor: int, rows: BoolArray, values: FloatArray) -> None:
        users = shape.users(attribute)[accessor]
        number = edit.replace(accessor, len(users), rows, values)
        for i in users:
            primitives[i]["attributes"][attribute] = number

    write("POSITION", shape.part.position, moved, shape.positions(X))
    for attribute in _DIRECTIONS:
        for accessor in shape.users(attribute):
            values, turned = shape.directions(attribute, accessor, X)
            if turned.any():
                write(attribute, accessor, turned, values)
    for i in shape.part.primitives:
        primitives[i].get("extensions", {}).pop(_COMPRESSED, None)


def _times(linear: FloatArray, vectors: FloatArray) -> FloatArray:
    """(n, 3) vectors, each times the one matrix (3, 3) or its own of (n, 3, 3)."""
    if linear.ndim == 2:
        return vectors @ linear.T
    return np.einsum("nij,nj->ni", linear, vectors)
