"""Lines of a text file as tokens and numbers, with errors that name the line."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from solver.errors import MeshError
from solver.types import FloatArray


@dataclass(frozen=True)
class Text:
    """The lines of one file: `lines` as they are, `bare` without what is no content.

    Rows are split again and again, never kept: lists by the hundred thousand keep Python's garbage
    collector busy for longer than the splitting.
    """

    name: str
    lines: list[bytes]
    bare: list[bytes]

    def error(self, line: int, message: str) -> MeshError:
        """An error about line number `line` (from 0), quoting the line."""
        return line_error(self.name, line + 1, self.lines[line], message)


def line_error(name: str, number: int, line: bytes, message: str) -> MeshError:
    """An error about line `number` (from 1), quoting the line."""
    quote = line.decode("utf-8", "replace").strip()
    quote = quote if len(quote) <= 60 else quote[:57] + "..."
    return MeshError(f"{name}, line {number}: {message}, got {quote!r}")


def check_text(name: str, data: bytes, kind: str) -> None:
    """Raises MeshError where the file is no text."""
    if not data or data.isspace():
        raise MeshError(f"{name}: the file is empty, expected {kind}")
    if b"\0" in data:
        raise MeshError(f"{name}: the file holds binary data, expected {kind}")


def split_lines(name: str, data: bytes, kind: str) -> list[bytes]:
    """The lines of a text file, endings kept. Raises MeshError where the file is no text."""
    check_text(name, data, kind)
    return data.splitlines(keepends=True)


def points(text: Text, at: Sequence[int], start: int) -> FloatArray:
    """Tokens start .. start+2 of the lines `at` as (n, 3) finite coordinates."""
    stop = start + 3
    try:
        tokens = [token for i in at for token in text.bare[i].split()[start:stop]]
        result = np.array(list(map(float, tokens)), dtype=np.float64)
    except ValueError:
        result = np.empty(0)
    if result.size != 3 * len(at):
        bad = next(i for i in at if not is_point(text.bare[i].split()[start:stop]))
        raise text.error(bad, "expected three numbers x y z")
    result = result.reshape(-1, 3)
    infinite = np.flatnonzero(~np.isfinite(result).all(axis=1))
    if infinite.size:
        raise text.error(at[int(infinite[0])], "expected finite coordinates")
    return result


def is_point(tokens: list[bytes]) -> bool:
    """Whether the tokens are three numbers."""
    try:
        return len([float(token) for token in tokens]) == 3
    except ValueError:
        return False
