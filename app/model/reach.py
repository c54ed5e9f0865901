"""How far handles may go: as far as the solver takes them, see solver.linear.reach."""

from __future__ import annotations

from app.model.document import Document
from app.model.handles import Pose
from solver.geometry.bounding_box import diagonal, middle
from solver.linear.reach import check_map, shift_of
from solver.types import FloatArray


class Reach:
    """The size of a document's rest shape, and with it whether a transform is one of a pose."""

    def __init__(self, document: Document) -> None:
        used = document.rest_positions[document.mesh.pieces >= 0]
        self._centre, self._diagonal = middle(used), diagonal(used)

    def check(self, T: FloatArray, what: str) -> None:
        """Raises ConstraintError naming `what` where T (4, 4) stretches or goes too far."""
        check_map(T[:3, :3], shift_of(T, self._centre, self._diagonal), what)

    def check_pose(self, document: Document, pose: Pose) -> None:
        """The same for all handles of a pose, by their names."""
        for key, T in pose.transforms.items():
            handle = document.find(key)
            self.check(T, handle.name if handle else "what is grabbed")
