"""Corners of OBJ faces: v, v/vt, v//vn or v/vt/vn."""

from __future__ import annotations

import numpy as np

from solver.mesh.formats.text.blocks import blank, whole_numbers
from solver.types import IntArray

_SLASH = ord("/")


def corner_numbers(text: bytes) -> tuple[IntArray, IntArray]:
    """Vertex and normal of every corner as written, 0 for no normal.

    Raises ValueError or OverflowError where a corner is none.
    """
    if b"/" not in text:
        vertices = whole_numbers(text)
        return vertices, np.zeros_like(vertices)
    try:
        found = whole_numbers(text.replace(b"/", b" "))
    except (ValueError, OverflowError):
        return _one_by_one(text)
    padded = np.frombuffer(b"\n" + text, dtype=np.uint8)
    slash = padded == _SLASH
    outside = blank(padded)
    starts = np.flatnonzero((slash | outside)[:-1] & ~(slash | outside)[1:]) + 1
    opens = ~slash[starts - 1]
    corner = np.cumsum(opens) - 1
    passed = np.cumsum(slash, dtype=np.int32)[starts]
    column = passed - passed[opens][corner]
    if (outside[:-1] & slash[1:]).any() or column.max() > 2:
        return _one_by_one(text)
    normals = np.zeros(int(opens.sum()), dtype=np.int64)
    normals[corner[column == 2]] = found[column == 2]
    return found[opens], normals


def _one_by_one(text: bytes) -> tuple[IntArray, IntArray]:
    """For what exporters write by mistake; a texture coordinate may be anything."""
    words = text.split()
    both = ([_vertex_number(word) for word in words], [_normal_number(word) for word in words])
    vertices, normals = (np.array(column, dtype=np.int64) for column in both)
    return vertices, normals


def _vertex_number(word: bytes) -> int:
    return int(word.split(b"/", 1)[0])


def _normal_number(word: bytes) -> int:
    parts = word.split(b"/", 2)
    # A slash more than the format has is an exporter's slip that changes nothing.
    return int(parts[2].rstrip(b"/") or 0) if len(parts) == 3 else 0
