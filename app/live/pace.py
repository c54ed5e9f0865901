"""How a drag is shown: at its rigid level where a frame can afford it, else linearly."""

from __future__ import annotations

FRAME_BUDGET = 0.030  # seconds a rigid level may take for a drag to begin with it
SLACK = 1.5  # budgets that it may take before a drag that has begun with it gives it up


class Pace:
    """What the levels of one bind cost, and what that means for the drag under way.

    dragging: whether one is.  linear: whether it is shown at level 0, which it then stays at.
    """

    def __init__(self) -> None:
        self.dragging = False
        self.linear = False
        self.forget()

    def forget(self) -> None:
        """Another bind is in use: its costs are not known yet."""
        self._cost: dict[int, float] = {}

    def learn(self, level: int, seconds: float) -> None:
        """What a pose at a level took."""
        self._cost[level] = seconds

    def cost(self, level: int) -> float:
        """Seconds of the last pose at a level, 0 if there was none."""
        return self._cost.get(level, 0.0)

    def choose(self, level: int, dragging: bool, binding: bool) -> None:
        """Decide how a drag is shown, once a frame. It may turn to level 0, and stays there.

        binding: a bind is under way, so that no rigid level can be had.
        """
        limit = FRAME_BUDGET * (SLACK if self.dragging else 1.0)
        slow = binding or self.cost(level) > limit
        self.linear = dragging and (self.linear or slow)
        self.dragging = dragging

    @property
    def slow(self) -> bool:
        """Whether some rigid level takes longer than a frame."""
        return max(self._cost.values(), default=0.0) > FRAME_BUDGET
