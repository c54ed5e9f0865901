"""The files that belong to the open document: they may be replaced without asking."""

from __future__ import annotations

from pathlib import Path

FileState = tuple[int, int]  # when it was written, in ns, and how long it is


class OwnFiles:
    """What was written of a document, and the session it was read from, as each was left."""

    def __init__(self) -> None:
        self._left: dict[Path, FileState] = {}

    def add(self, path: Path) -> None:
        """This file is as the document has it."""
        self._left[path.resolve()] = _state(path)

    def forget(self, path: Path) -> None:
        """It is as somebody else has it."""
        self._left.pop(path.resolve(), None)

    def knows(self, path: Path) -> bool:
        """Whether it was one of them, whatever became of it."""
        return path.resolve() in self._left

    def may_replace(self, path: Path) -> bool:
        """Whether nothing is there, or one of them as it was left."""
        return not path.exists() or self._left.get(path.resolve()) == _state(path)


def _state(path: Path) -> FileState:
    found = path.stat()
    return found.st_mtime_ns, found.st_size
