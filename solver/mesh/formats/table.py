"""Every mesh file format, by suffix.

A new format is a module beside this one with its read and its write, and a row here.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path

from solver.errors import MeshError
from solver.mesh.formats.format import Format
from solver.mesh.formats.gltf.read import GltfSource, read_gltf
from solver.mesh.formats.gltf.saving.write import write_glb, write_gltf
from solver.mesh.formats.obj.read import ObjSource, read_obj
from solver.mesh.formats.obj.write import write_obj
from solver.mesh.formats.off.read import OffSource, read_off
from solver.mesh.formats.off.write import write_off
from solver.mesh.formats.ply.read import PlySource, read_ply
from solver.mesh.formats.ply.write import write_ply
from solver.mesh.formats.stl import read_stl, write_stl
from solver.mesh.formats.stl_source import StlSource

_COLOURS = frozenset({"colours"})
_GLTF = _COLOURS | {"normals", "objects", "groups"}

FORMATS: Mapping[str, Format] = {
    ".obj": Format(read_obj, write_obj, ObjSource, _COLOURS),
    ".off": Format(read_off, write_off, OffSource, _COLOURS),
    ".ply": Format(read_ply, write_ply, PlySource, _COLOURS),
    ".stl": Format(read_stl, write_stl, StlSource, only_triangles=True),
    ".glb": Format(read_gltf, write_glb, GltfSource, _GLTF, only_triangles=True, keeps_poses=True),
    ".gltf": Format(
        read_gltf, write_gltf, GltfSource, _GLTF, only_triangles=True, keeps_poses=True
    ),
}


def format_of(path: str | os.PathLike[str]) -> Format:
    """The format that the suffix of a path names. Raises MeshError for another one."""
    suffix = Path(path).suffix.lower()
    if suffix not in FORMATS:
        known = ", ".join(FORMATS)
        raise MeshError(f"{os.fspath(path)}: unknown mesh format {suffix!r}, expected {known}")
    return FORMATS[suffix]
