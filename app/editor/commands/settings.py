"""The numbers and switches of the solver."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from app.editor.commands.command import Command
from solver.softness.material import Material


@dataclass(frozen=True)
class SetMaterial(Command):
    material: str | Material


@dataclass(frozen=True)
class SetSetting(Command):
    """One of document.SETTINGS."""

    name: str
    value: Any
