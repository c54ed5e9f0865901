"""What a drag owes that was over before the solver's bind had come."""

from __future__ import annotations

from collections.abc import Callable, Collection
from dataclasses import dataclass

from app.live.live_surface import LiveSurface
from app.model.document import Document
from app.model.handles import Pose
from app.model.history import Entry, Gesture, History


@dataclass(eq=False)
class Debt:
    """One handle or several of a drag. paid: the pose with what they lacked, None before that."""

    entry: Entry
    keys: Collection[int]
    pose: Callable[[], Pose]
    paid: Pose | None = None


class Late:
    """Handles that were let go of where they are, and find their rotation or place afterwards.

    debt: what is owed now.
    """

    def __init__(self) -> None:
        self.debt: Debt | None = None

    def owe(self, entry: Entry | None, keys: Collection[int], pose: Callable[[], Pose]) -> None:
        """Ask for `pose` once a bind knows handles `keys`; it belongs to the last entry."""
        self.debt = None if entry is None else Debt(entry, keys, pose)

    def pay(self, document: Document, history: History, surface: LiveSurface) -> bool:
        """Change the pose and its entry, if the bind is there; whether that was done.

        Never where anything was done or undone since. Raises SolverError.
        """
        debt = self.debt
        if debt is None or history.top is not debt.entry or history.undone:
            self.debt = None
            return False
        if not all(map(surface.holds, debt.keys)):
            return False
        self.debt = None
        gesture = Gesture(document)
        gesture.change("pose", debt.pose())
        history.amend(gesture.finish(debt.entry.label))
        debt.paid = document.pose
        return True
