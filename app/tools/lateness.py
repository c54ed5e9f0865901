"""What becomes of a drag that is over before the solver's bind has come."""

from __future__ import annotations

from collections.abc import Callable, Collection

from app.model.handles import Pose
from app.workspace.workspace import Workspace

FOLLOWS = "The solver is still binding: the surface follows when it is done"


def follow_late(
    work: Workspace, keys: Collection[int], pose: Callable[[], Pose] | None = None
) -> None:
    """Say that the surface has yet to follow the last entry of the history.

    pose: what the entry makes of the pose, which can be told once handles `keys` are bound.
    """
    tell_early(work, FOLLOWS)
    if pose is not None:
        work.late.owe(work.history.top, keys, pose)


def tell_early(work: Workspace, text: str) -> None:
    """Say this; or why no bind will come, where the last one failed."""
    error = work.surface.bind_error
    work.say(error or text, "error" if error else "info")
