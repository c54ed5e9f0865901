"""What a person is in the middle of, what was before it, and what is said to them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal, Protocol

from app.model.history import Entry
from app.viewpoint.events import Input
from app.workspace.chosen import Choice


@dataclass(frozen=True)
class Message:
    """A line for the person. number: grows, so that the window can tell a new one."""

    text: str
    kind: Literal["info", "error"]
    number: int


@dataclass(frozen=True)
class Moment:
    """top: the last entry of the history.  choice: of handles."""

    top: Entry | None
    choice: Choice


class Interaction(Protocol):
    """A stroke or a drag in progress. drags: whether it moves handles."""

    drags: ClassVar[bool]

    def move(self, frame: Input) -> None:
        """The cursor is now there."""

    def finish(self) -> None:
        """Keep it, as one entry of the history."""

    def cancel(self) -> None:
        """Restore what was before."""


class HeldPress:
    """An Interaction that holds the mouse until its button is up: what the press did is done."""

    drags: ClassVar[bool] = False

    def move(self, frame: Input) -> None:
        """Nothing follows the cursor."""

    def finish(self) -> None:
        """Nothing is left to do."""

    def cancel(self) -> None:
        """Nothing to take back."""
