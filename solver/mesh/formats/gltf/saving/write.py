"""Writing glTF: a deformed copy of the file that was read, or a plain one."""

from __future__ import annotations

from pathlib import Path

from solver.mesh.formats.format import DeformedSurface
from solver.mesh.formats.gltf.read import GltfSource
from solver.mesh.formats.gltf.saving.deform import DeformedPart, deform
from solver.mesh.formats.gltf.saving.edit import Edit
from solver.mesh.formats.gltf.saving.pack import has_all_buffers, take_in_images, to_glb, to_gltf
from solver.mesh.formats.gltf.saving.plain import plain_surface
from solver.mesh.formats.gltf.saving.targets import add_poses


def write_glb(surface: DeformedSurface) -> bytes:
    """The file that was read, or a plain one, as a GLB; see `write_gltf`."""
    return _write(surface, binary=True)


def write_gltf(surface: DeformedSurface) -> bytes:
    """The file that was read with new positions, normals, tangents and morph targets for poses.

    Everything else in it stays. Data that something else shares, or that is not float32, is left
    alone: what was deformed gets float32 data of its own. A file saved beside its source in the
    same container goes on naming the files there; any other takes images and buffers in.
    A surface that comes from elsewhere becomes triangles with smooth normals, a node for each of
    its groups.
    """
    return _write(surface, binary=False)


def _write(surface: DeformedSurface, binary: bool) -> bytes:
    if not isinstance(surface.source, GltfSource):
        surface = plain_surface(surface)
    source = surface.source
    assert isinstance(source, GltfSource)
    gltf, X = source.gltf, surface.positions
    edit = Edit(gltf)
    shapes = [DeformedPart(gltf, part, surface) for part in source.parts]
    for shape in shapes:
        deform(edit, shape, surface.rest, X)
    add_poses(edit, shapes, X, surface.poses)
    same_container = binary == gltf.is_binary
    beside = same_container and Path(surface.path).resolve().parent == gltf.folder
    if not beside:
        take_in_images(edit)
    if gltf.data and same_container and not edit.changed and (beside or has_all_buffers(gltf)):
        return gltf.data
    finished = edit.finished()
    return to_glb(finished, beside) if binary else to_gltf(finished, beside)
