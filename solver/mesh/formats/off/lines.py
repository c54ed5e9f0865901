"""The lines of an OFF file: a header, vertices, faces."""

from __future__ import annotations

import re
from collections.abc import Iterator

from solver.mesh.formats.text.file import Flaw, TextFile
from solver.mesh.formats.text.lines import LineQueue, Lines
from solver.mesh.progress import Progress, silent

# What the letters say comes in the other order: after the position a normal, a colour and texture
# coordinates.
_KEYWORD = re.compile(rb"(ST)?(C)?(N)?OFF")


class OffLines:
    """An OFF file and what its header says; its vertices and then its faces are taken once.

    vertex_count, face_count: how many lines of each should follow.
    has_texture, has_colours, has_normals: what the line of a vertex holds beyond its position.
    Raises MeshError where the header is none.
    """

    def __init__(self, name: str, data: bytes, progress: Progress = silent) -> None:
        self.text = TextFile(name, data)
        self._queue = LineQueue(self.text.blocks(comments=True, progress=progress))
        words, at = self._next_line()
        keyword = _KEYWORD.fullmatch(words[0]) if words else None
        if keyword is None:
            raise self.text.error(Flaw(0, at, "expected an OFF file that starts with 'OFF'"))
        present = (letters is not None for letters in keyword.groups())
        self.has_texture, self.has_colours, self.has_normals = present
        counts = words[1:]
        # The counts may follow the keyword on its line.
        if not counts:
            counts, below = self._next_line()
            at = below if counts else at
        self.vertex_count, self.face_count = _counts(counts)
        if min(self.vertex_count, self.face_count) < 0:
            raise self.text.error(Flaw(0, at, "expected the numbers of vertices and faces"))

    def vertices(self) -> Iterator[Lines]:
        return self._queue.take(self.vertex_count)

    def faces(self) -> Iterator[Lines]:
        return self._queue.take(self.face_count)

    def _next_line(self) -> tuple[list[bytes], int]:
        """The words of the next line that has any, and where it starts."""
        for line in self._queue.take(1):
            return line.words(0), int(line.places[0])
        return [], 0


def _counts(words: list[bytes]) -> tuple[int, int]:
    """Vertices and faces, negative where the words do not say."""
    try:
        n, m = map(int, words[:2])
    except ValueError:
        return -1, -1
    return n, m
