"""Lines of text for points and polygons. One call formats thousands of them.

Not all: it holds the global lock, without which a window does not draw.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import chain
from typing import Any

import numpy as np
from numpy.typing import NDArray

from solver.mesh.polygons import Polygons
from solver.types import FloatArray

PIECE = 4096  # lines in a call


def point_lines(head: bytes, points: FloatArray, colours: NDArray[Any] | None = None) -> bytes:
    """A line for each of (n, 3) points: `head`, then the shortest texts that read back the same.

    colours: (n, k), what stands behind each.
    """
    columns = points.shape[1] + (0 if colours is None else colours.shape[1])
    line = head + b" ".join([b"%a"] * columns) + b"\n"

    def piece(start: int) -> bytes:
        rows = points[start : start + PIECE].tolist()
        if colours is not None:
            extra = colours[start : start + PIECE].tolist()
            rows = [row + more for row, more in zip(rows, extra, strict=True)]
        return line * len(rows) % tuple(chain.from_iterable(rows))

    return b"".join(piece(start) for start in range(0, len(points), PIECE))


def polygon_lines(head: Callable[[int], bytes], polygons: Polygons) -> bytes:
    """A line for each polygon: the head that belongs to its size, then its corners."""
    sizes, corners = polygons.sizes, polygons.corners
    line = {size: head(size) + b" %d" * size + b"\n" for size in np.unique(sizes).tolist()}
    first = np.concatenate([[0], np.cumsum(sizes)])
    lines = []
    for start in range(0, len(sizes), PIECE):
        piece = sizes[start : start + PIECE].tolist()
        own = corners[first[start] : first[start + len(piece)]].tolist()
        lines.append(b"".join(map(line.__getitem__, piece)) % tuple(own))
    return b"".join(lines)
