"""What the slider between two poses leads from and to, and how far it is."""

from __future__ import annotations

from dataclasses import dataclass

from app.model.handles import Pose
from app.model.poses import REST


@dataclass(frozen=True)
class Blend:
    """start, end: keys of kept poses, or REST.  share: of the way, 0 to 1, last slid to.

    pose: what came of that, None before the first time.
    between: how many shapes an export has between one kept pose and the next.
    """

    start: int = REST
    end: int = REST
    share: float = 0.0
    pose: Pose | None = None
    between: int = 0
