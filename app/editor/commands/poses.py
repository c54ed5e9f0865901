"""What can be asked of the pose."""

from __future__ import annotations

from dataclasses import dataclass

from app.editor.commands.command import Command


@dataclass(frozen=True)
class ResetPose(Command):
    """Every handle back to rest."""


@dataclass(frozen=True)
class ResetHandle(Command):
    """One handle back to rest."""

    key: int
