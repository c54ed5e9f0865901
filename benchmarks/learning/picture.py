"""Pictures of learned softness and of poses, drawn without a window."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.cases.animals import Animal
from solver.geometry.cross_products import area_vectors
from solver.types import FloatArray, IntArray

LIGHT = np.array([0.45, 0.8, 0.4])
GREY = np.array([0.75, 0.78, 0.82])


def draw(
    animal: Animal,
    learned: Mapping[str, FloatArray],
    shapes: Mapping[str, Mapping[int, FloatArray]],
    folder: Path,
) -> bool:
    """Write NAME-softness.png and NAME-pose.png; False where matplotlib is missing.

    The pose is the unseen one on which uniform softness is worst.
    """
    try:
        import matplotlib
    except ImportError:
        return False
    matplotlib.use("agg")
    folder.mkdir(exist_ok=True)
    color = matplotlib.colormaps["viridis"]
    maps = {f"learned, {name}": color(s[animal.F].mean(axis=1)) for name, s in learned.items()}
    panels = [(name, animal.V, colors[:, :3]) for name, colors in maps.items()]
    _save(animal.F, panels, folder / f"{animal.name}-softness.png")
    uniform = next(found for name, found in shapes.items() if "uniform" in name)
    unseen = range(1, len(animal.poses), 2)
    worst = max(unseen, key=lambda number: animal.away(number, uniform[number]))
    chosen = [("the pose itself", animal.poses[worst])]
    chosen += [(name, found[worst]) for name, found in shapes.items()]
    grey = np.tile(GREY, (len(animal.F), 1))
    _save(animal.F, [(name, X, grey) for name, X in chosen], folder / f"{animal.name}-pose.png")
    return True


def _save(F: IntArray, panels: list[tuple[str, FloatArray, FloatArray]], path: Path) -> None:
    """One panel for each (title, positions, colours (m, 3)), four in a row at most."""
    from matplotlib import pyplot

    columns = min(len(panels), 4)
    rows = -(-len(panels) // columns)
    figure, axes = pyplot.subplots(rows, columns, figsize=(3 * columns, 2.4 * rows), squeeze=False)
    for axis in axes.ravel():
        axis.set_axis_off()
    for axis, (title, X, colors) in zip(axes.ravel(), panels, strict=False):
        axis.set_title(title, fontsize=8)
        _paint(axis, X, F, colors)
    figure.tight_layout()
    figure.savefig(path, dpi=110, metadata={"Software": None})
    pyplot.close(figure)


def _paint(axis: Any, X: FloatArray, F: IntArray, colors: FloatArray) -> None:
    """The surface from its side (x towards the eye), farther triangles first."""
    from matplotlib.collections import PolyCollection

    normals = area_vectors(X, F)
    normals /= np.maximum(np.linalg.norm(normals, axis=1), np.finfo(float).tiny)[:, None]
    shade = 0.35 + 0.65 * np.clip(normals @ LIGHT, 0, 1)
    facing = np.flatnonzero(normals[:, 0] > 0)
    order = facing[np.argsort(X[F[facing], 0].mean(axis=1))]
    shown = -X[F[order], 2], X[F[order], 1]
    polygons = PolyCollection(
        list(np.stack(shown, axis=2)),
        facecolors=np.clip(colors[order] * shade[order, None], 0, 1),
        edgecolors="face",
        linewidths=0.2,
    )
    axis.add_collection(polygons)
    axis.autoscale()
    axis.set_aspect("equal")
