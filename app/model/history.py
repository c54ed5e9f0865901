"""Undo and redo. One gesture is one entry, and an entry holds deltas, not copies."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from app.model.document import Document, Edit
from solver.types import IntArray


@dataclass(frozen=True, eq=False)
class Entry:
    """One undo step. `merge`: entries that follow each other with the same text become one."""

    label: str
    edits: tuple[Edit, ...]
    merge: str = ""


class Gesture:
    """Changes that belong together: applied as they come, undone as one."""

    def __init__(self, document: Document) -> None:
        self._document = document
        self._edits: list[Edit] = []

    def change(self, field: str, value: Any, index: IntArray | None = None) -> None:
        """Document.change, remembered."""
        self._edits.append(self._document.change(field, value, index))

    @property
    def started(self) -> bool:
        """Whether anything was changed yet."""
        return bool(self._edits)

    def finish(self, label: str, merge: str = "") -> Entry:
        """The entry for the history."""
        return Entry(label, compact(self._edits), merge)

    def cancel(self) -> None:
        """Restore the document to what it was before the gesture."""
        while self._edits:
            self._document.revert(self._edits.pop())


class History:
    """What was done, what was undone, and whether the last save still holds."""

    def __init__(self) -> None:
        self.done: list[Entry] = []
        self.undone: list[Entry] = []
        self._saved: Entry | None = None
        self._sealed = True

    def record(self, entry: Entry) -> None:
        """Keep a finished gesture, unless it changed nothing. Clears redo."""
        if not entry.edits:
            return
        self.undone.clear()
        if self._merges(entry):
            last = self.done.pop()
            entry = Entry(entry.label, compact([*last.edits, *entry.edits]), entry.merge)
        self._sealed = not entry.merge
        if entry.edits:
            self.done.append(entry)
        else:  # a slider that came back to where it started leaves nothing to undo
            self.seal()

    def amend(self, entry: Entry) -> None:
        """Make the changes of an entry part of the last one, as if they had been made with it."""
        last = self.done.pop()
        self.done.append(Entry(last.label, compact([*last.edits, *entry.edits]), last.merge))

    def retract(self, document: Document, since: Entry | None) -> bool:
        """Take the last entry back for good, if it is the only one made after `since`."""
        before = self.done[-2] if len(self.done) > 1 else None
        only = self.top is not since and before is since
        if only:
            for edit in reversed(self.done.pop().edits):
                document.revert(edit)
            self.seal()
        return only

    def seal(self) -> None:
        """The next entry merges with none before it."""
        self._sealed = True

    def undo(self, document: Document) -> Entry | None:
        """Take the last entry back; None when there is none."""
        return self._step(self.done, self.undone, document)

    def redo(self, document: Document) -> Entry | None:
        """Repeat the entry last undone; None when there is none."""
        return self._step(self.undone, self.done, document)

    def mark_saved(self) -> None:
        """What is on screen is what is on disk."""
        self._saved = self.top
        self.seal()

    def mark_unsaved(self) -> None:
        """No session file holds any of it: not even what there was at first."""
        self._saved = Entry("", ())

    @property
    def dirty(self) -> bool:
        """Whether there are changes that no session file holds."""
        return self.top is not self._saved

    @property
    def top(self) -> Entry | None:
        """The last entry that was not undone, None without any."""
        return self.done[-1] if self.done else None

    def _merges(self, entry: Entry) -> bool:
        last = self.top
        return not self._sealed and last is not None and last.merge == entry.merge != ""

    def _step(self, source: list[Entry], target: list[Entry], document: Document) -> Entry | None:
        self.seal()
        if not source:
            return None
        entry = source.pop()
        target.append(entry)
        if target is self.undone:
            for edit in reversed(entry.edits):
                document.revert(edit)
        else:
            for edit in entry.edits:
                document.apply(edit)
        return entry


def compact(edits: list[Edit]) -> tuple[Edit, ...]:
    """The same change with one edit a field: the first value before, the last value after."""
    merged: list[Edit] = []
    for field in dict.fromkeys(edit.field for edit in edits):
        same = [edit for edit in edits if edit.field == field]
        whole = [edit for edit in same if edit.index is None]
        if whole:
            merged.append(Edit(field, None, whole[0].before, whole[-1].after))
        else:
            merged.append(_compact_indexed(field, same))
    return tuple(edit for edit in merged if _matters(edit))


def _compact_indexed(field: str, edits: list[Edit]) -> Edit:
    index = np.concatenate([edit.index for edit in edits])
    before = np.concatenate([edit.before for edit in edits])
    after = np.concatenate([edit.after for edit in edits])
    unique, first = np.unique(index, return_index=True)
    last = len(index) - 1 - np.unique(index[::-1], return_index=True)[1]
    differs = before[first] != after[last]
    return Edit(field, unique[differs], before[first[differs]], after[last[differs]])


def _matters(edit: Edit) -> bool:
    if edit.index is not None:
        return len(edit.index) > 0
    return edit.before is not edit.after and bool(edit.before != edit.after)
