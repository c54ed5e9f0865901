"""Commands without a window: they import no graphics library."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from app.editor.files.actions import load_document, usable_mesh
from app.editor.files.pose_export import poses_to_save
from app.model.document import Document
from app.model.handles import Pose
from app.model.outputs import check_outputs
from app.model.schema import SessionError
from app.model.session.carrying import MeshChanged
from app.telling import tell
from app.worker.memory import check_memory
from solver import Deformer
from solver.mesh.pose_files import pose_paths
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
    force: whether files that are there already are replaced.
    """

    rigid: int | None = None
    pose: str | None = None
    poses: bool = False
    exact: bool = False
    force: bool = False


def deform(mesh: Path, session: Path, output: Path, wish: Wish) -> str:
    """Pose `mesh` as `session` says, but for what is wished for, and save it. Raises SolverError.

    Returns what `output` does not keep of the mesh, in words; empty if it keeps all.

    Kept poses become morph targets of a format that has them, else a file each beside `output`.
    `mesh` and `session` are never replaced, other files only where that is wished for.
    """
    check_outputs([output], wish.force, [mesh, session])
    document = _document(mesh, session)
    if wish.rigid is not None:
        document.change("rigid", wish.rigid)
    if wish.exact:
        document.change("coarse", False)
    if wish.pose is not None:
        document.change("pose", _kept(document, wish.pose))
    shapes: dict[str, Pose] = {}
    if wish.poses:
        shapes = poses_to_save(document, output)
        beside = map(Path, pose_paths(output, shapes).values())
        check_outputs(beside, wish.force, [mesh, session])
    posed = poser(document)
    X = posed(document.pose)
    document.mesh.save(output, X, {name: posed(pose) for name, pose in shapes.items()})
    return document.mesh.left_out(output)


def _document(mesh: Path, session: Path) -> Document:
    """As load_document, but on a mesh that has changed by the vertices' numbers, where they hold.

    Then a line on stderr says so.
    """
    try:
        return load_document(mesh, session)
    except MeshChanged as changed:
        if changed.change == "other":
            raise SessionError(
                f"{changed}, and its vertices are others; open {session} in the window "
                "to carry it over"
            ) from changed
        tell(f"note: {changed}; its vertices are told by their numbers", error=True)
        return load_document(mesh, session, carry="numbers")


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


def info(path: Path) -> list[str]:
    """What a mesh file holds and what is unusual about it, as lines. Raises SolverError."""
    counts = mesh_statistics(usable_mesh(path))
    return [f"{path}", *_surface_lines(counts), *_extra_lines(counts), *_odd_lines(counts)]


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
