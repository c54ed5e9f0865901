"""Lines of text for points and polygons. One call formats them all."""

from __future__ import annotations

from collections.abc import Callable

from solver.mesh.polygons import Polygons
from solver.types import FloatArray


def point_lines(head: bytes, points: FloatArray) -> bytes:
    """A line for each of (n, 3) points: `head`, then the shortest texts that read back the same."""
    return (head + b"%a %a %a\n") * len(points) % tuple(points.ravel().tolist())


def polygon_lines(head: Callable[[int], bytes], polygons: Polygons) -> bytes:
    """A line for each polygon: the head that belongs to its size, then its corners."""
    sizes = polygons.sizes.tolist()
    line = {size: head(size) + b" %d" * size + b"\n" for size in set(sizes)}
    return b"".join(map(line.__getitem__, sizes)) % tuple(polygons.corners.tolist())
