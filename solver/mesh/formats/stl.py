"""STL files: a soup of triangles, as text or binary, in float32."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from solver.errors import MeshError
from solver.mesh.formats.format import DeformedSurface, FileContent
from solver.mesh.formats.narrowing import check_distinct, narrowed, widened
from solver.mesh.formats.stl_source import HEAD, RECORD, StlSource
from solver.mesh.formats.text.file import TextFile, check_text
from solver.mesh.formats.text.lines import Lines
from solver.mesh.formats.text.points import finite_points
from solver.mesh.polygons import Polygons
from solver.mesh.progress import Progress, silent
from solver.types import FloatArray, IntArray


def read_stl(data: bytes, name: str, progress: Progress = silent) -> FileContent:
    """Vertices and triangles, with an StlSource; corners in exactly one place are one vertex.

    Raises MeshError saying what was expected.
    """
    if not data:
        raise MeshError(f"{name}: the file is empty, expected an STL mesh")
    is_text = data.lstrip()[:5].lower() == b"solid" and b"facet" in data
    corners = _read_text(data, name, progress) if is_text else _read_binary(data, name)
    V, faces = _weld(corners)
    attributes = 0 if is_text else int(np.count_nonzero(_records(data)["attribute"]))
    extras = {"triangle attributes": attributes} if attributes else {}
    return FileContent(V, Polygons.from_array(faces), extras, StlSource(data, is_text))


def write_stl(surface: DeformedSurface) -> bytes:
    """The file that was read with new corners and normals, or a binary one of the triangles.

    A binary file rounds to float32. MeshError for what is beyond, and for vertices that would
    become one.
    """
    if isinstance(surface.source, StlSource):
        return surface.source.rewritten(surface)
    X, triangles = surface.positions, surface.triangles
    stored = narrowed(X, "<f4")
    check_distinct(X, stored, triangles, surface.path)
    corners = X[triangles]
    records = np.zeros(len(corners), dtype=RECORD)
    records["corners"] = stored[triangles]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    length = np.linalg.norm(normal, axis=1, keepdims=True)
    records["normal"] = normal / np.where(length > 0, length, 1)
    return bytes(80) + np.uint32(len(corners)).tobytes() + records.tobytes()


def _read_binary(data: bytes, name: str) -> FloatArray:
    count = _count(data)
    if count == 0 or len(data) < HEAD + count * RECORD.itemsize:
        raise MeshError(
            f"{name}: not an STL mesh, or cut short: {len(data)} bytes, "
            f"expected {HEAD + max(count, 1) * RECORD.itemsize} or more"
        )
    corners = widened(_records(data)["corners"])
    bad = np.flatnonzero(~np.isfinite(corners).all(axis=(1, 2)))
    if bad.size:
        raise MeshError(f"{name}, triangle {bad[0] + 1}: expected finite coordinates")
    return corners.reshape(-1, 3)


def _count(data: bytes) -> int:
    return int(np.frombuffer(data, "<u4", 1, 80)[0]) if len(data) >= HEAD else 0


def _records(data: bytes) -> NDArray[Any]:
    return np.frombuffer(data, RECORD, _count(data), HEAD)


def _read_text(data: bytes, name: str, progress: Progress) -> FloatArray:
    check_text(name, data, "an STL mesh")
    blocks = TextFile(name, data.lower()).blocks(progress=progress)
    parts, flaws, counts = [], [], {word: 0 for word in (b"vertex", b"facet", b"endsolid")}
    for lines in map(Lines.of, blocks):
        found = {word: lines.beginning_with(word) for word in counts}
        counts = {word: counts[word] + len(found[word]) for word in counts}
        points, wrong = finite_points(found[b"vertex"], 1)
        parts.append(points)
        flaws += wrong
    if counts[b"vertex"] != 3 * counts[b"facet"] or not counts[b"endsolid"]:
        raise MeshError(
            f"{name}: the file ends early, got {counts[b'vertex']} vertices for "
            f"{counts[b'facet']} facets, expected three each and 'endsolid'"
        )
    if flaws:
        raise TextFile(name, data).error(min(flaws))
    return np.concatenate(parts)


def _weld(corners: FloatArray) -> tuple[FloatArray, IntArray]:
    """(3 m, 3) corners -> vertices in the order they first appear, and triangles."""
    # Adding zero makes -0.0 and 0.0 the same place.
    place = corners + 0.0
    order = np.lexsort(place.T)
    place = place[order]
    differs = np.ones(len(place), dtype=bool)
    differs[1:] = (place[1:] != place[:-1]).any(axis=1)
    # The sort is stable: of corners in one place the first comes first.
    first = order[differs]
    by_appearance = np.argsort(first)
    rank = np.empty(len(first), dtype=np.int64)
    rank[by_appearance] = np.arange(len(first))
    vertex = np.empty(len(corners), dtype=np.int64)
    vertex[order] = rank[np.cumsum(differs) - 1]
    return corners[first[by_appearance]], vertex.reshape(-1, 3)
