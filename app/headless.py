"""Commands without a window: they import no graphics library."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from app.editor.file_actions import load_document, usable_mesh
from app.editor.pose_export import check_free, poses_to_save
from app.model.document import Document
from app.model.handles import Pose
from app.model.schema import SessionError
from app.worker.memory import check_memory
from solver import Deformer
from solver.mesh.mesh import pose_paths
from solver.mesh.statistics import MeshStatistics, mesh_statistics
from solver.types import FloatArray

POLYGON_NAMES = {3: "triangles", 4: "quads"}
# These are named even where a file has none.
USUAL_EXTRAS = ("texture coordinates", "normals", "objects", "groups")


@dataclass(frozen=True)
class Wish:
    """What `deform` takes in place of what a session says.

    rigid: the level.  pose: the name of a kept pose in place of the current one.
    poses: whether all kept poses are saved, too.
    exact: without a coarse mesh for the frames, however large the mesh is.
    """

    rigid: int | None = None
    pose: str | None = None
    poses: bool = False
    exact: bool = False


def deform(mesh: Path, session: Path, output: Path, wish: Wish) -> None:
    """Pose `mesh` as `session` says, but for what is wished for, and save it. Raises SolverError.

    Kept poses become morph targets of a format that has them, else a file each beside `output`;
    a file that is there already is not replaced.
    """
    document = load_document(mesh, session)
    if wish.rigid is not None:
        document.change("rigid", wish.rigid)
    if wish.exact:
        document.change("coarse", False)
    if wish.pose is not None:
        document.change("pose", _kept(document, wish.pose))
    shapes: dict[str, Pose] = {}
    if wish.poses:
        shapes = poses_to_save(document, output)
        check_free(map(Path, pose_paths(output, shapes).values()), {})
    posed = poser(document)
    X = posed(document.pose)
    document.mesh.save(output, X, {name: posed(pose) for name, pose in shapes.items()})


def poser(document: Document) -> Callable[[Pose], FloatArray]:
    """What gives positions (n, 3) with every handle where a pose has it. Raises SolverError."""
    rest, keys = document.rest_positions, document.bound_keys
    if not keys:
        return lambda pose: rest
    check_memory(len(rest), document.coarse_count)
    deformer = Deformer.of(rest, document.mesh.faces, document.setup())
    return lambda pose: deformer.pose(list(pose.stacked(keys)), rigid=document.rigid)


def _kept(document: Document, name: str) -> Pose:
    poses = {kept.name: kept.pose for kept in document.poses}
    if name not in poses:
        known = f"one of {', '.join(map(repr, poses))}" if poses else "none, for none is kept"
        raise SessionError(f"unknown pose {name!r}, expected {known}")
    return poses[name]


def info(path: Path) -> str:
    """What a mesh file holds and what is unusual about it, as text. Raises SolverError."""
    counts = mesh_statistics(usable_mesh(path))
    lines = [f"{path}", *_surface_lines(counts), *_extra_lines(counts), *_odd_lines(counts)]
    return "\n".join(lines)


def _surface_lines(counts: MeshStatistics) -> list[str]:
    polygons = ", ".join(
        f"{number:,} {POLYGON_NAMES.get(size, f'{size}-gons')}"
        for size, number in sorted(counts.polygon_sizes.items())
    )
    size = " x ".join(f"{b - a:.4g}" for a, b in zip(counts.lower, counts.upper, strict=True))
    return [
        _line("vertices", f"{counts.vertices:,}"),
        _line("faces", polygons),
        _line("triangles solved", f"{counts.triangles:,}"),
        _line("components", f"{counts.components:,}"),
        _line("pieces, seams welded", f"{counts.pieces:,}"),
        _line("size", f"{size}, diagonal {counts.diagonal:.4g}"),
    ]


def _extra_lines(counts: MeshStatistics) -> list[str]:
    extras = {**dict.fromkeys(USUAL_EXTRAS, 0), **counts.extras}
    return [_line(name, f"{number:,}") for name, number in extras.items()]


def _odd_lines(counts: MeshStatistics) -> list[str]:
    """What may surprise; all of it loads and deforms."""
    lines = [_line("boundary", f"{counts.boundary_edges:,} edges, {counts.boundary_loops:,} loops")]
    odd = ("non_manifold_edges", "degenerate_triangles", "duplicate_faces", "isolated_vertices")
    return lines + [_line(_words(name), f"{getattr(counts, name):,}") for name in odd]


def _words(name: str) -> str:
    return name.replace("_", " ").replace("non manifold", "non-manifold")


def _line(name: str, value: str) -> str:
    return f"  {name:<22}{value}"
