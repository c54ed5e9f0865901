"""Points and normals in the lines of a text file: three numbers each."""

from __future__ import annotations

import numpy as np

from solver.mesh.formats.text.blocks import numbers
from solver.mesh.formats.text.file import Flaw
from solver.mesh.formats.text.lines import Lines, first_failing
from solver.types import FloatArray


def read_points(lines: Lines, skip: int) -> FloatArray:
    """(l, 3) words skip .. skip+2 of each line. Raises ValueError where they are no numbers."""
    if (lines.count < skip + 3).any():
        raise ValueError("a line is too short")
    first = lines.first + skip
    return numbers(lines.block.joined(first, first + 2)).reshape(-1, 3)


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


def read_normals(lines: Lines, skip: int) -> FloatArray:
    """(l, 3) as `read_points` reads them, NaN for lines without three finite numbers."""
    try:
        normals = read_points(lines, skip)
    except ValueError:
        normals = np.concatenate([_normal(lines[i : i + 1], skip) for i in range(len(lines))])
    normals[~np.isfinite(normals).all(axis=1)] = np.nan
    return normals


def _normal(line: Lines, skip: int) -> FloatArray:
    try:
        return read_points(line, skip)
    except ValueError:
        return np.full((1, 3), np.nan)
