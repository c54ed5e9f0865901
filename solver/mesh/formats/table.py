"""Every mesh file format, by suffix.

A new format is a module beside this one with its read and its write, and a row here.
"""

from __future__ import annotations

from collections.abc import Mapping

from solver.mesh.formats.format import Format
from solver.mesh.formats.gltf.read import read_gltf
from solver.mesh.formats.gltf.saving.write import write_glb, write_gltf
from solver.mesh.formats.obj.read import read_obj
from solver.mesh.formats.obj.write import write_obj
from solver.mesh.formats.off.read import read_off
from solver.mesh.formats.off.write import write_off
from solver.mesh.formats.ply.read import read_ply
from solver.mesh.formats.ply.write import write_ply
from solver.mesh.formats.stl import read_stl, write_stl

FORMATS: Mapping[str, Format] = {
    ".obj": Format(read_obj, write_obj),
    ".off": Format(read_off, write_off),
    ".ply": Format(read_ply, write_ply),
    ".stl": Format(read_stl, write_stl),
    ".glb": Format(read_gltf, write_glb, keeps_poses=True),
    ".gltf": Format(read_gltf, write_gltf, keeps_poses=True),
}
