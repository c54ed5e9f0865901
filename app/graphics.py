"""Whether this machine can draw at all. Knows of no graphics library itself."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from app.signals import interrupts_held
from solver.errors import SolverError


class GraphicsError(SolverError):
    """Nothing can be drawn on this machine."""

    def __init__(self, reason: object) -> None:
        line = str(reason).strip().partition("\n")[0]
        super().__init__(f"nothing can be drawn on this machine ({line})")


@contextmanager
def loading() -> Iterator[None]:
    """Around imports of modules that draw: a missing library becomes a GraphicsError.

    Ctrl+C waits: half loaded, the library crashes when the program ends.
    """
    try:
        with interrupts_held():
            yield
    except ImportError as error:
        if error.name and error.name.split(".")[0] in {"app", "solver"}:
            raise  # one of ours is missing: a mistake in the program, not in the machine
        raise GraphicsError(error) from error
