"""A value that is computed again only when what it depends on has changed."""

from __future__ import annotations

from collections.abc import Callable
from typing import Generic, TypeVar

T = TypeVar("T")


class Latest(Generic[T]):
    """The value last asked for: the same object until it is asked for with another key."""

    def __init__(self) -> None:
        self._held: tuple[object, T] | None = None

    def __call__(self, key: object, compute: Callable[[], T]) -> T:
        """The value of a key; `compute` makes it, if the last key was another one."""
        if self._held is None or self._held[0] != key:
            self._held = key, compute()
        return self._held[1]
