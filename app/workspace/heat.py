"""Heat maps: how far the surface on screen is from its rest shape, at each vertex and as rms."""

from __future__ import annotations

import time

import numpy as np

from app.latest import Latest
from app.model.document import Document
from app.model.handles import FREE
from solver.measure.distortion import Distortion
from solver.mesh.mesh import Mesh
from solver.types import FloatArray

MEASURES = ("strain", "dihedral", "area")
FRAME_BUDGET = 0.030  # seconds a measure may take to be kept up to date during a drag


class Heat:
    """One measure of the surface on screen, computed again only when it may have changed.

    values: (n,) at the vertices: strain and area relative, dihedral in radians.
    rms: over what has a free vertex: the rest moves rigidly.  version: grows with each change.
    """

    def __init__(self, mesh: Mesh) -> None:
        self._faces = mesh.faces
        self._changes: Latest[Distortion] = Latest()
        self._seconds = dict.fromkeys(MEASURES, 0.0)
        self._shown: tuple[object, ...] = ()
        self.values: FloatArray = np.zeros(len(mesh.vertices))
        self.rms = 0.0
        self.version = 0

    def follow(
        self,
        measure: str | None,
        document: Document,
        positions: FloatArray,
        version: int,
        dragging: bool,
    ) -> None:
        """Measure `positions` (n, 3), known by their version; None for nothing.

        During a drag only if it fits the frame: else the last values stay until it ends.
        """
        wanted = measure, version, document.revision["role"], document.surface_number
        if measure is None or wanted == self._shown:
            return
        same = self._shown[:1] == (measure,)
        if dragging and same and self._seconds[measure] > FRAME_BUDGET:
            return
        change = self._change(document)  # made before the clock runs: a mesh pays for it once
        start = time.perf_counter()
        found = getattr(change, measure)(positions, document.role == FREE)
        self._seconds[measure] = time.perf_counter() - start
        self.values, self.rms = found.vertices, found.rms
        self.version += 1
        self._shown = wanted

    def _change(self, document: Document) -> Distortion:
        return self._changes(
            document.surface_number, lambda: Distortion(document.rest_positions, self._faces)
        )
