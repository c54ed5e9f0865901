"""JSON written bit by bit, so that between two bits a window can go on."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

COUNT = 512  # numbers or rows in a piece: less than a millisecond


def json_pieces(value: Any) -> Iterator[str]:
    """The text that json.dumps gives, in pieces; arrays and iterators are lists.

    Raises ValueError for what is not finite.
    """
    if isinstance(value, Mapping):
        start = "{"
        for key, item in value.items():
            yield f"{start}{json.dumps(key)}: "
            yield from json_pieces(item)
            start = ", "
        yield "{}" if start == "{" else "}"
    elif isinstance(value, Iterator):
        start = "["
        for item in value:
            yield start
            yield from json_pieces(item)
            start = ", "
        yield "[]" if start == "[" else "]"
    elif isinstance(value, np.ndarray):
        yield from _array_pieces(value)
    else:
        yield json.dumps(value, allow_nan=False)


def _array_pieces(array: np.ndarray[Any, Any]) -> Iterator[str]:
    start = "["
    for first in range(0, len(array), COUNT):
        yield start + _listed(array[first : first + COUNT])
        start = ", "
    yield "[]" if start == "[" else "]"


def _listed(array: np.ndarray[Any, Any]) -> str:
    """The items of a list. Rows become no lists of their own: those would call the collector."""
    texts = json.dumps(array.ravel().tolist(), allow_nan=False)[1:-1]
    if array.ndim == 1:
        return texts
    rows = zip(*[iter(texts.split(", "))] * array.shape[1], strict=True)
    return f"[{'], ['.join(map(', '.join, rows))}]"
