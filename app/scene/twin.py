"""Another shape of the surface beside it: before and after."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from app.viewpoint.camera import Camera
from solver.types import FloatArray

ASIDE = 1.2  # diagonals between the two: what is bent over hardly reaches the other
NEAREST = 0.05  # of the way between them: seen from closer, the twin is far out of sight


@dataclass(frozen=True, eq=False)
class Twin:
    """Another shape of the surface, that stands to the left of it for whoever looks.

    positions: (n, 3) as if it stood where the surface does.  middle: (3,) of them.
    away: how far from there it is to stand, in world units.
    """

    positions: FloatArray
    middle: FloatArray
    away: float

    def place(self, camera: Camera) -> FloatArray:
        """(4, 4) how it is moved: so that its picture is the same, only shifted.

        Merely moved aside, it would be seen from another side; turned about the camera, it would
        have another size.
        """
        share = self.away / max(float(camera.depth(self.middle)), NEAREST * self.away)
        T = np.eye(4)
        T[:3, :3] -= share * np.outer(camera.right, camera.forward)
        T[:3, 3] = share * (camera.position @ camera.forward) * camera.right
        return T
