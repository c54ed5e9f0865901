"""Interactions that have the keyboard for themselves: what is typed goes to them."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import ClassVar

from app.scene.overlay import Overlay
from app.viewpoint.events import Input


class Operator(ABC):
    """An Interaction during which no shortcut but Esc is heard.

    drags: see Interaction.  modal: it goes on without a button until Enter or a click accepts it
    and Esc or the secondary button takes it back; else it ends with the button that began it.
    """

    drags: ClassVar[bool] = False
    modal: bool = True

    @abstractmethod
    def move(self, frame: Input) -> None:
        """The cursor is now there."""

    @abstractmethod
    def finish(self) -> None:
        """Keep it, as one entry of the history."""

    @abstractmethod
    def cancel(self) -> None:
        """Restore what was before."""

    @abstractmethod
    def type(self, keys: str) -> None:
        """These were typed, see Input.typed."""

    @abstractmethod
    def overlay(self, frame: Input) -> Overlay:
        """What shows over the scene meanwhile."""
