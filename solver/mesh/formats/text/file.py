"""A text file whose lines end in one way, and errors that name a line."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

from solver.errors import MeshError
from solver.mesh.formats.text.blocks import Block, blocks
from solver.mesh.progress import Progress, silent

_BYTE_ORDER_MARK = b"\xef\xbb\xbf"
_LONE_RETURN = re.compile(rb"\r(?!\n)")
# A backslash joins a line and the next, unless a comment holds it or the line gives names: some end
# in one, as folders do, and the face below would be lost. At the end of a file it joins nothing.
_NAMING = rb"[ \t]*(?:[og]|usemtl|mtllib|usemap|maplib|shadow_obj|trace_obj|call|csh)[ \t]"
_CONTINUED = re.compile(rb"^(?!%b)([^#\n]*)(\\[ \t]*(?:\r?\n|\Z))" % _NAMING, re.MULTILINE)


class Flaw(NamedTuple):
    """What is wrong with the line at byte `at`; of several the one with the least rank is told."""

    rank: int
    at: int
    message: str


class TextFile:
    """`data` is the file, every byte in its place, but for these which are blanks instead: a byte
    order mark, and what continues a line. Every line ends in a line feed.
    """

    def __init__(self, name: str, original: bytes, continued: bool = False) -> None:
        self._name, self._original = name, original
        data = original
        if data.startswith(_BYTE_ORDER_MARK):
            data = b"   " + data[3:]
        if b"\r" in data:
            data = _LONE_RETURN.sub(b"\n", data)
        if continued and b"\\" in data:
            data = _CONTINUED.sub(lambda found: found[1] + b" " * len(found[2]), data)
        self.data = data

    def blocks(
        self, start: int = 0, comments: bool = False, progress: Progress = silent
    ) -> Iterator[Block]:
        """The text from byte `start` on; with comments, without what follows a `#`."""
        return blocks(self.data, start, comments, progress)

    def error(self, flaw: Flaw) -> MeshError:
        """An error about a line, quoting it."""
        start = self.data.rfind(b"\n", 0, flaw.at) + 1
        stop = self.data.find(b"\n", flaw.at) + 1 or len(self.data)
        number = 1 + len(self._original[:start].splitlines())
        line = self._original[start:stop]
        line = line if start else line.removeprefix(_BYTE_ORDER_MARK)
        quote = line.decode("utf-8", "replace").strip()
        quote = quote if len(quote) <= 60 else quote[:57] + "..."
        return MeshError(f"{self._name}, line {number}: {flaw.message}, got {quote!r}")


def check_text(name: str, data: bytes, kind: str) -> None:
    """Raises MeshError where the file is no text."""
    if not data or data.isspace():
        raise MeshError(f"{name}: the file is empty, expected {kind}")
    if b"\0" in data:
        raise MeshError(f"{name}: the file holds binary data, expected {kind}")
