"""What can be asked of the vertices that the tool in the hand marks."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from app.editor.commands.command import Command


@dataclass(frozen=True)
class ChangeMarks(Command):
    """Change which vertices are marked, by one of actions.marks.CHANGES.

    None is taken from another region, and hidden ones stay as they are.
    """

    name: str


@dataclass(frozen=True)
class FindLimbs(Command):
    """Prepare the limbs of the largest part that is seen, before a click asks for one of them."""

    notice: ClassVar[str] = "Looking for limbs ..."
