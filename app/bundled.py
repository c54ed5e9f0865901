"""The meshes that come with the program."""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path

ASSETS = Path(__file__).resolve().parent.parent / "assets"
DEFAULT_MESH = ASSETS / "mannequin.obj"
DEFAULT_SESSION = ASSETS / "mannequin-elbow.json"


def is_bundled(path: Path) -> bool:
    """Whether a file comes with the program. May be asked in every frame."""
    return _is_bundled(path.absolute())


@lru_cache(maxsize=64)
def _is_bundled(path: Path) -> bool:
    return path.resolve().is_relative_to(ASSETS)


def writable(path: Path) -> Path:
    """`path`, but in the working directory where it lies among the program's own files."""
    return Path.cwd() / path.name if is_bundled(path) else path
