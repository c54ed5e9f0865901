"""Points, normals and colours in the lines of a text file: so many numbers each."""

from __future__ import annotations

import numpy as np

from solver.mesh.formats.text.blocks import numbers
from solver.mesh.formats.text.file import Flaw
from solver.mesh.formats.text.lines import Lines, first_failing
from solver.types import FloatArray


def read_points(lines: Lines, skip: int, width: int = 3) -> FloatArray:
    """(l, width) the words of each line from `skip` on. Raises ValueError if one is no number."""
    if (lines.count < skip + width).any():
        raise ValueError("a line is too short")
    first = lines.first + skip
    return numbers(lines.block.joined(first, first + (width - 1))).reshape(-1, width)


def finite_points(lines: Lines, skip: int) -> tuple[FloatArray, list[Flaw]]:
    """The points, and what is wrong with the first line that has none: none where there is one."""
    try:
        points = read_points(lines, skip)
    except ValueError:
        bad = first_failing(lines, lambda some: read_points(some, skip))
        return np.empty((0, 3)), [Flaw(0, int(lines.places[bad]), "expected three numbers x y z")]
    infinite = np.flatnonzero(~np.isfinite(points).all(axis=1))[:1]
    places = lines.places[infinite].tolist()
    return points, [Flaw(1, at, "expected finite coordinates") for at in places]


def read_any(lines: Lines, skip: int, width: int = 3) -> FloatArray:
    """As `read_points` reads them, NaN for lines without so many finite numbers."""
    try:
        found = read_points(lines, skip, width)
    except ValueError:
        rows = [_row(lines[i : i + 1], skip, width) for i in range(len(lines))]
        found = np.concatenate([np.empty((0, width)), *rows])
    found[~np.isfinite(found).all(axis=1)] = np.nan
    return found


def _row(line: Lines, skip: int, width: int) -> FloatArray:
    try:
        return read_points(line, skip, width)
    except ValueError:
        return np.full((1, width), np.nan)
