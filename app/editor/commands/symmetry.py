"""What can be asked of the mirror."""

from __future__ import annotations

from dataclasses import dataclass

from app.editor.commands.command import Command


@dataclass(frozen=True)
class SetSymmetry(Command):
    """Mirror across a plane: "found" in the mesh, across "x", "y" or "z", or "off"."""

    name: str


@dataclass(frozen=True)
class ToggleSymmetry(Command):
    """Mirror across the plane found in the mesh, or stop mirroring."""


@dataclass(frozen=True)
class MirrorPose(Command):
    """Exchange the poses of the two sides."""


@dataclass(frozen=True)
class MirrorRegions(Command):
    """Paint on the other side what is painted on the side of the active handle."""
