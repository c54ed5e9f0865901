"""The files that were opened or saved last."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import Path

COUNT = 10


class Recent:
    """Paths of meshes and sessions, the last one first, none twice."""

    def __init__(
        self, paths: Iterable[Path] = (), keep: Callable[[tuple[Path, ...]], None] | None = None
    ) -> None:
        """keep: told of every change."""
        self.paths = tuple(paths)[:COUNT]
        self._keep = keep

    def add(self, path: Path) -> None:
        """This file was opened or saved."""
        path = path.resolve()
        self._set((path, *(other for other in self.paths if other != path))[:COUNT])

    def drop(self, path: Path) -> None:
        """This file is not there any more."""
        self._set(tuple(other for other in self.paths if other != path.resolve()))

    def _set(self, paths: tuple[Path, ...]) -> None:
        if paths != self.paths:
            self.paths = paths
            if self._keep is not None:
                self._keep(paths)
