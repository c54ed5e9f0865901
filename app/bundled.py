"""The meshes that come with the program."""

from __future__ import annotations

from pathlib import Path

ASSETS = Path(__file__).resolve().parent.parent / "assets"
DEFAULT_MESH = ASSETS / "mannequin.obj"
DEFAULT_SESSION = ASSETS / "mannequin-elbow.json"


def writable(path: Path) -> Path:
    """`path`, but in the working directory where it lies among the program's own files."""
    return Path.cwd() / path.name if path.resolve().is_relative_to(ASSETS) else path
