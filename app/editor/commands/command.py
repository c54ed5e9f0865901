"""What a command is."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from solver.errors import SolverError


class CommandError(SolverError):
    """A command asks for something that there is not, or that must not be done."""


@dataclass(frozen=True)
class Command:
    """interrupts: whether a stroke or drag in progress ends before the command is carried out.

    notice: what the window says while it carries out a command that takes its time, else empty.
    """

    interrupts: ClassVar[bool] = True
    notice: ClassVar[str] = ""
