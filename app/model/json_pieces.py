"""JSON written bit by bit, so that between two bits a window can go on."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

COUNT = 1024  # numbers or rows in a piece: about a millisecond


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
        part = array[first : first + COUNT].tolist()
        yield start + json.dumps(part, allow_nan=False)[1:-1]
        start = ", "
    yield "[]" if start == "[" else "]"
