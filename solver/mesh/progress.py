"""How far a long task has come, told while it runs."""

from __future__ import annotations

from collections.abc import Callable

# Takes fractions of the task from 0 to 1, growing; may raise to cancel it.
Progress = Callable[[float], None]

_STEP = 1 / 12


def silent(fraction: float) -> None:
    """Tells nobody."""


def portion(progress: Progress, start: float, stop: float) -> Progress:
    """Of a part of the task, which takes it from `start` to `stop`."""
    return lambda fraction: progress(start + (stop - start) * fraction)


def in_steps(progress: Progress) -> Progress:
    """Told a dozen times, however often the task says where it is; the end is always told."""
    told = 0.0

    def tell(fraction: float) -> None:
        nonlocal told
        if fraction >= min(told + _STEP, 1.0) and told < 1.0:
            told = fraction
            progress(fraction)

    return tell
