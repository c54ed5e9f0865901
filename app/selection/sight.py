"""Which vertices of a surface are seen: those that nothing lies before, by a depth buffer."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.ndimage import minimum_filter

from app.viewpoint.camera import Camera
from solver.types import BoolArray, FloatArray, IntArray

CELL = 2.0  # pixels a side
# Samples of a triangle are at most so many cells apart, so that each cell whose middle it covers
# holds one.
SPACING = 0.7
DIAGONAL = 1.5  # of a box, at most, in its longer sides
LONGEST = 16.0  # cells: longer triangles are split first, and what is out of the picture left out
# A vertex may lie so many cells' fall of its steepest triangle behind what is nearest around it,
# and so many widths of a cell at the most: the bottom of a valley is not hidden by its sides.
FALL, MOST = 1.0, 2.0
ROUNDING = 1e-6


@dataclass(frozen=True, eq=False)
class _Grid:
    """A rectangle of the picture in cells. low: (2,) its corner in pixels. shape: columns, rows."""

    low: FloatArray
    shape: tuple[int, int]

    @classmethod
    def around(cls, pixels: FloatArray) -> _Grid:
        """Two cells more on every side, which the filter looks at."""
        low = np.floor(pixels.min(axis=0) / CELL) * CELL - 2 * CELL
        columns, rows = ((pixels.max(axis=0) - low) // CELL + 3).astype(int)
        return cls(low, (int(columns), int(rows)))

    def cell(self, places: FloatArray) -> IntArray:
        """(k,) the flat number of the cell at places (2, k), counted in cells; -1 outside."""
        column, row = np.floor(places).astype(np.int64)
        within = (column >= 0) & (column < self.shape[0]) & (row >= 0) & (row < self.shape[1])
        return np.where(within, column * self.shape[1] + row, -1)


def in_sight(
    camera: Camera,
    positions: FloatArray,
    faces: IntArray,
    vertices: IntArray,
    solid: BoolArray,
) -> BoolArray:
    """(k,) which of some vertices of the surface (positions (n, 3), faces (m, 3)) are seen.

    All of them lie in the picture.  solid: (n,) the vertices of closed pieces, which are hidden
    where they turn away. Hidden is also what lies behind all that is nearest in the cells around
    it, by more than the surface itself falls away there. Beside an edge that hides something,
    what lies up to two cells behind that edge counts as seen.
    """
    if len(vertices) == 0:
        return np.zeros(0, dtype=bool)
    pixels = camera.project(positions)
    nearness = 1.0 / np.maximum((positions - camera.position) @ camera.forward, 1e-300)
    grid = _Grid.around(pixels[vertices])
    # Seen in perspective, the inverse of the depth is linear across a triangle.
    screen = np.stack([*((pixels - grid.low) / CELL).T, nearness])
    corners, near = _overlapping(screen, faces, grid)
    towards, slope = _slopes(corners)
    before = towards | ~solid[near[:, 0]]
    nearest = minimum_filter(_nearest(corners[:, :, before], grid), size=3, mode="nearest").ravel()
    nearest = nearest[grid.cell(screen[:2, vertices])]
    fall, facing = np.zeros(len(positions)), np.zeros(len(positions), dtype=bool)
    for corner in near[before].T:
        np.maximum.at(fall, corner, slope[before])
        facing[corner] = True
    own, fall, facing = nearness[vertices], fall[vertices], facing[vertices]
    cell_width = CELL * camera.units_per_pixel(camera.position + camera.forward)
    behind = nearest - own
    hidden = behind > np.minimum(FALL * fall, MOST * cell_width * own)
    return facing & ~(hidden & (behind > ROUNDING * own))


def _overlapping(screen: FloatArray, faces: IntArray, grid: _Grid) -> tuple[FloatArray, IntArray]:
    """The triangles whose boxes meet the grid, as corners (3 axes, 3 corners, m) and as faces.

    None that reaches behind the camera, where there are no pixels.
    """
    corners = np.stack([np.take(along, faces.T) for along in screen])
    meets = _meets(corners, grid)
    return np.ascontiguousarray(corners[:, :, meets]), faces[meets]


def _meets(corners: FloatArray, grid: _Grid) -> BoolArray:
    low, high = _boxes(corners)
    shape = np.array(grid.shape)[:, None]
    return np.asarray(((high >= 0) & (low < shape)).all(axis=0))


def _boxes(corners: FloatArray) -> tuple[FloatArray, FloatArray]:
    """(2, m) and (2, m): the least and the largest column and row. Faster than along an axis."""
    a, b, c = corners[:2].swapaxes(0, 1)
    return np.minimum(np.minimum(a, b), c), np.maximum(np.maximum(a, b), c)


def _slopes(corners: FloatArray) -> tuple[BoolArray, FloatArray]:
    """(m,) which triangles face the camera, and by how much their nearness changes in a cell."""
    (ax, bx, cx), (ay, by, cy), (an, bn, cn) = corners
    ux, uy, un, vx, vy, vn = bx - ax, by - ay, bn - an, cx - ax, cy - ay, cn - an
    area = ux * vy - uy * vx
    with np.errstate(divide="ignore", invalid="ignore"):
        slope = np.hypot(un * vy - vn * uy, vn * ux - un * vx) / np.abs(area)
    return area < 0, np.nan_to_num(slope)  # y runs down


def _nearest(corners: FloatArray, grid: _Grid) -> FloatArray:
    """(columns, rows) the largest nearness of the triangles in each cell, 0 where none is."""
    nearest = np.zeros(grid.shape[0] * grid.shape[1])
    while corners.shape[2]:
        low, high = _boxes(corners)
        size = np.maximum(*(high - low))
        short = size <= LONGEST
        _sample(corners[:, :, short], size[short], grid, nearest)
        corners = _split(corners[:, :, ~short])
        corners = corners[:, :, _meets(corners, grid)]
    return nearest.reshape(grid.shape)


def _split(corners: FloatArray) -> FloatArray:
    """(3, 3, 4m) each triangle as four of half its size."""
    a, b, c = corners.swapaxes(0, 1)
    ab, bc, ca = (a + b) / 2, (b + c) / 2, (c + a) / 2
    parts = [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    return np.concatenate([np.stack(part, axis=1) for part in parts], axis=2)


def _sample(corners: FloatArray, size: FloatArray, grid: _Grid, nearest: FloatArray) -> None:
    """Put evenly spread points of short triangles of some sizes (m,) into the cells."""
    steps = np.ceil(np.maximum(DIAGONAL * size / SPACING, 1.0)).astype(int)
    for count in np.unique(steps):
        x, y, nearness = (_lattice(int(count)) @ corners[:, :, steps == count]).reshape(3, -1)
        cell = grid.cell(np.stack([x, y]))
        within = cell >= 0
        np.maximum.at(nearest, cell[within], nearness[within])


def _lattice(count: int) -> FloatArray:
    """(k, 3) barycentric weights: of the middle for 1, else of a lattice of `count` steps."""
    if count == 1:
        return np.full((1, 3), 1 / 3)
    i, j = np.indices((count + 1, count + 1)).reshape(2, -1)
    i, j = i[i + j <= count], j[i + j <= count]
    return np.column_stack([i, j, count - i - j]) / count
