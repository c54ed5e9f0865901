"""Names that nothing has yet."""

from __future__ import annotations

import itertools
from collections.abc import Iterable


def free_name(stem: str, taken: Iterable[str], first: int = 1) -> str:
    """`stem` with the first number behind it, from `first` up, that is not taken.

    >>> from app.model.names import free_name
    >>> free_name("pose", ["pose 1", "fist"])
    'pose 2'
    """
    known = set(taken)
    names = (f"{stem} {number}" for number in itertools.count(first))
    return next(name for name in names if name not in known)
