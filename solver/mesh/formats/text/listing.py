"""Lines of text for points and polygons. One call formats them all."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from numpy.typing import NDArray

from solver.mesh.polygons import Polygons
from solver.types import FloatArray


def point_lines(head: bytes, points: FloatArray, colours: NDArray[Any] | None = None) -> bytes:
    """A line for each of (n, 3) points: `head`, then the shortest texts that read back the same.

    colours: (n, k), what stands behind each.
    """
    if colours is None:
        return (head + b"%a %a %a\n") * len(points) % tuple(points.ravel().tolist())
    line = head + b"%a %a %a" + b" %a" * colours.shape[1] + b"\n"
    rows = zip(points.tolist(), colours.tolist(), strict=True)
    return line * len(points) % tuple(number for row in rows for part in row for number in part)


def polygon_lines(head: Callable[[int], bytes], polygons: Polygons) -> bytes:
    """A line for each polygon: the head that belongs to its size, then its corners."""
    sizes = polygons.sizes.tolist()
    line = {size: head(size) + b" %d" * size + b"\n" for size in set(sizes)}
    return b"".join(map(line.__getitem__, sizes)) % tuple(polygons.corners.tolist())
