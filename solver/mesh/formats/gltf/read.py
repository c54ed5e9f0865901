"""Reading glTF: the surface that the default scene shows, and all that saving must keep."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass

import numpy as np

from solver.errors import MeshError
from solver.mesh.formats.colours import from_light, rgba
from solver.mesh.formats.format import FileContent, Groups
from solver.mesh.formats.gltf.accessors import MOST_ELEMENTS, read_floats
from solver.mesh.formats.gltf.container import Gltf, open_gltf
from solver.mesh.formats.gltf.part import Part
from solver.mesh.formats.gltf.primitives import has_triangles, target_count, triangles
from solver.mesh.formats.gltf.scene import (
    nodes_with_meshes,
    placement,
    world_transforms,
)
from solver.mesh.formats.gltf.schema import Json
from solver.mesh.formats.gltf.smoothing import read_smoothing
from solver.mesh.polygons import Polygons
from solver.mesh.progress import Progress, silent
from solver.types import FloatArray, IntArray

_COMPRESSION = {
    "KHR_draco_mesh_compression": "Draco",
    "EXT_meshopt_compression": "meshopt",
    "KHR_meshopt_compression": "meshopt",
}


@dataclass(frozen=True, eq=False)
class GltfSource:
    """A glTF file and the parts of its surface, for writing it back."""

    gltf: Gltf
    parts: tuple[Part, ...]

    def colours(self) -> FloatArray:
        """(n, 4) of the vertices; white where a mesh has none, or not one for each."""
        result = np.ones((self.parts[-1].vertices.stop, 4))
        for part in self.parts:
            primitives = self.gltf.json["meshes"][part.mesh]["primitives"]
            used = (primitives[i]["attributes"].get("COLOR_0") for i in part.primitives)
            number = next((number for number in used if number is not None), None)
            kind = None if number is None else self.gltf.json["accessors"][number]["type"]
            if number is not None and kind in ("VEC3", "VEC4"):
                with suppress(MeshError), np.errstate(invalid="ignore"):
                    values = read_floats(self.gltf, number, kind)
                    if len(values) == part.count:
                        result[part.vertices] = from_light(rgba(values))
        return result


def read_gltf(data: bytes, name: str, progress: Progress = silent) -> FileContent:
    """Vertices and triangles of a GLB or .gltf, with a GltfSource. Raises MeshError in one line.

    Every mesh stands where the first node that shows it puts it: under the transforms of nodes,
    skinned by the joints as they stand, shaped by the default weights of its morph targets.
    Vertices are in the order in which nodes and primitives first show them; primitives of a mesh
    that share an accessor share its vertices. Points and lines are left out.
    """
    gltf = open_gltf(data, name)
    _refuse_compression(gltf)
    shown = nodes_with_meshes(gltf)
    first: dict[int, int] = {}
    for node in shown:
        first.setdefault(gltf.json["nodes"][node]["mesh"], node)
    _refuse_excess(gltf, list(first))
    # Files of any numbers come in; what overflows is refused as positions.
    with np.errstate(all="ignore"):
        reader = _Reader(gltf, world_transforms(gltf))
        for done, node in enumerate(first.values()):
            progress(done / len(first))
            reader.add(node)
        faces = np.concatenate([np.empty((0, 3), np.int64), *reader.faces])
        if not len(faces):
            raise gltf.error("no triangles, expected a scene that shows at least one")
        smoothing = read_smoothing(gltf, reader.parts, faces)
    extras = _extras(gltf, list(first), len(shown) - len(first))
    source = GltfSource(gltf, tuple(reader.parts))
    vertices, polygons = np.concatenate(reader.vertices), Polygons.from_array(faces)
    colours = source.colours if "colours" in extras else None
    return FileContent(vertices, polygons, extras, source, reader.groups(), colours, smoothing)


class _Reader:
    """Collects the parts of a surface, node by node."""

    def __init__(self, gltf: Gltf, world: FloatArray) -> None:
        self.gltf = gltf
        self.world = world
        self.parts: list[Part] = []
        self.vertices: list[FloatArray] = []
        self.faces: list[IntArray] = []
        self._vertex_count = self._triangle_count = 0

    def add(self, node: int) -> None:
        """Append what the mesh of a node shows."""
        mesh = self.gltf.json["nodes"][node]["mesh"]
        sharing: dict[int, list[int]] = {}
        for i, primitive in enumerate(self.gltf.json["meshes"][mesh]["primitives"]):
            if has_triangles(primitive):
                sharing.setdefault(primitive["attributes"]["POSITION"], []).append(i)
        for position, primitives in sharing.items():
            self._add_part(node, mesh, position, primitives)

    def groups(self) -> Groups:
        """Triangles by the node that shows them."""
        places: dict[int, int] = {}
        numbers = [places.setdefault(part.node, len(places)) for part in self.parts]
        sizes = [sum(s.stop - s.start for s in part.triangles) for part in self.parts]
        return Groups(tuple(map(self._node_name, places)), np.repeat(numbers, sizes))

    def _add_part(self, node: int, mesh: int, position: int, primitives: list[int]) -> None:
        gltf = self.gltf
        entries = [gltf.json["meshes"][mesh]["primitives"][i] for i in primitives]
        place = placement(gltf, node, entries[0], self.world)
        local = read_floats(gltf, position, "VEC3") + self._morphed(node, entries[0])
        V = place.apply(local)
        bad = np.flatnonzero(~np.isfinite(V).all(axis=1))
        if bad.size:
            raise gltf.error(f"accessor {position}, vertex {bad[0]}: expected finite coordinates")
        slices = []
        for i, primitive in zip(primitives, entries, strict=True):
            faces = triangles(gltf, primitive, len(V), f"meshes[{mesh}].primitives[{i}]")
            faces = faces[:, [0, 2, 1]] if place.mirrors else faces
            slices.append(slice(self._triangle_count, self._triangle_count + len(faces)))
            self._triangle_count += len(faces)
            self.faces.append(faces + self._vertex_count)
        start, count = self._vertex_count, len(V)
        self.parts.append(
            Part(node, mesh, tuple(primitives), position, start, count, tuple(slices), place.linear)
        )
        self.vertices.append(V)
        self._vertex_count += count

    def _morphed(self, node: int, primitive: Json) -> FloatArray:
        """What the default weights of morph targets add to the positions."""
        entry = self.gltf.json["nodes"][node]
        weights = entry.get("weights", self.gltf.json["meshes"][entry["mesh"]].get("weights", []))
        count = self.gltf.json["accessors"][primitive["attributes"]["POSITION"]]["count"]
        total = np.zeros(3)
        for weight, target in zip(weights, primitive.get("targets", []), strict=False):
            if weight and "POSITION" in target:
                offsets = read_floats(self.gltf, target["POSITION"], "VEC3")
                if len(offsets) != count:
                    raise self.gltf.error(f"a morph target of {len(offsets)} for {count} vertices")
                total = total + weight * offsets
        return total

    def _node_name(self, node: int) -> str:
        entry = self.gltf.json["nodes"][node]
        mesh = entry["mesh"]
        name = entry.get("name") or self.gltf.json["meshes"][mesh].get("name")
        return name or f"mesh {mesh}"


def _refuse_compression(gltf: Gltf) -> None:
    required = set(gltf.json.get("extensionsRequired", []))
    for extension, words in _COMPRESSION.items():
        if extension in required:
            raise gltf.error(
                f"compressed by {words} ({extension}), which cannot be read; "
                "export it without compression"
            )


def _refuse_excess(gltf: Gltf, meshes: list[int]) -> None:
    """Accessors may share their bytes, so a short file can ask for any number of vertices."""
    accessors = gltf.entries("accessors")
    named = {
        (mesh, number)
        for mesh in meshes
        for primitive in filter(has_triangles, gltf.json["meshes"][mesh]["primitives"])
        for number in (primitive["attributes"]["POSITION"], primitive.get("indices"))
        if number is not None
    }
    total = sum(accessors[number]["count"] for _, number in named)
    if total > MOST_ELEMENTS:
        raise gltf.error(f"{total} vertices and indices, expected {MOST_ELEMENTS} or less")


def _extras(gltf: Gltf, meshes: list[int], instances: int) -> dict[str, int]:
    """What the file holds beyond its surface; rare things only where there are some."""
    entries = [gltf.json["meshes"][mesh] for mesh in meshes]
    shown = [p for entry in entries for p in entry["primitives"]]
    usual = {
        "texture coordinates": _elements(gltf, shown, "TEXCOORD_"),
        "normals": _elements(gltf, shown, "NORMAL"),
        "groups": len(meshes),
        "materials": len(gltf.entries("materials")),
        "images": len(gltf.entries("images")),
    }
    rare = {
        "skins": len(gltf.entries("skins")),
        "colours": _elements(gltf, shown, "COLOR_"),
        "animations": len(gltf.entries("animations")),
        "morph targets": sum(map(target_count, entries)),
        "instances left out": instances,
        "primitives left out": len(shown) - len(list(filter(has_triangles, shown))),
    }
    return usual | {words: number for words, number in rare.items() if number}


def _elements(gltf: Gltf, primitives: list[dict[str, dict[str, int]]], prefix: str) -> int:
    """Elements of all accessors that an attribute of that name has."""
    used: Iterator[int] = (
        number
        for primitive in primitives
        for key, number in primitive["attributes"].items()
        if key.startswith(prefix)
    )
    return sum(gltf.json["accessors"][number]["count"] for number in set(used))
