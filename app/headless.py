"""Commands without a window: they import no graphics library."""

from __future__ import annotations

from pathlib import Path

from app.editor.file_actions import load_document
from app.model.document import Document
from app.worker.memory import check_memory
from solver import Deformer, load_mesh
from solver.mesh.statistics import MeshStatistics, mesh_statistics
from solver.types import FloatArray

POLYGON_NAMES = {3: "triangles", 4: "quads"}
# These are named even where a file has none.
USUAL_EXTRAS = ("texture coordinates", "normals", "objects", "groups")


def deform(mesh: Path, session: Path, output: Path, rigid: int | None, exact: bool) -> None:
    """Pose `mesh` as `session` says, at level `rigid` if given, and save it. Raises SolverError.

    exact: without a coarse mesh for the frames, however large the mesh is.
    """
    document = load_document(mesh, session)
    if rigid is not None:
        document.change("rigid", rigid)
    if exact:
        document.change("coarse", False)
    document.mesh.save(output, posed(document))


def posed(document: Document) -> FloatArray:
    """Positions (n, 3) with every handle where its transform puts it. Raises SolverError."""
    mesh, keys = document.mesh, document.bound_keys
    if not keys:
        return mesh.vertices
    check_memory(len(mesh.vertices), document.coarse_count)
    deformer = Deformer.of(mesh.vertices, mesh.faces, document.setup())
    return deformer.pose(list(document.pose.stacked(keys)), rigid=document.rigid)


def info(path: Path) -> str:
    """What a mesh file holds and what is unusual about it, as text. Raises SolverError."""
    counts = mesh_statistics(load_mesh(path))
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
