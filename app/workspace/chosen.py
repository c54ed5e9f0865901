"""Which handle is painted, and which ones are placed together."""

from __future__ import annotations

from dataclasses import dataclass

from app.model.document import Document
from app.model.handles import Handle


@dataclass(frozen=True)
class Choice:
    """active, selected: the keys of handles, which may be gone by now."""

    active: int | None
    selected: frozenset[int] = frozenset()


class ChosenHandles:
    """What a person chose among the handles of a document. choice: it, to be kept and restored."""

    def __init__(self, document: Document) -> None:
        self._document = document
        self.choice = Choice(document.handles[0].key if document.handles else None)

    @property
    def active(self) -> Handle | None:
        """The handle the handle brush paints: the one chosen, else the last; None without any."""
        handles = self._document.handles
        return self._document.find(self.choice.active) or (handles[-1] if handles else None)

    def activate(self, key: int, alone: bool = True) -> None:
        """Choose the active handle.

        alone: select no other; else a selection that holds it stays.
        """
        selected = self.choice.selected
        self.choice = Choice(key, selected if key in selected and not alone else frozenset())

    @property
    def selected(self) -> tuple[Handle, ...]:
        """The handles that are placed together, the active one first."""
        active, keys = self.active, self.choice.selected
        if active is None:
            return ()
        others = (handle for handle in self._document.handles if handle.key in keys)
        return (active, *(handle for handle in others if handle != active))

    def select(self, key: int) -> None:
        """Add a handle to the selection, and make it the active one; or take it out.

        The last one stays selected.
        """
        keys = [handle.key for handle in self.selected]
        if key not in keys:
            keys.insert(0, key)
        elif len(keys) > 1:
            keys.remove(key)
        self.choice = Choice(keys[0], frozenset(keys))
