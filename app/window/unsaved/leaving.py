"""How the window ends: what is unsaved is saved, discarded, or kept for the next start."""

from __future__ import annotations

from app.editor import commands as c
from app.editor.editor import Editor
from app.editor.question import CANCEL, Answer, Question
from app.unsaved.keeper import Keeper
from app.window.file_dialogs import FileDialogs
from app.window.shortcuts import WindowAction

LEAVING = "save and close", "discard and close"


class Leaving:
    """What becomes of a person's wish to close the window. ended: whether it is to close now."""

    def __init__(self, editor: Editor, keeper: Keeper, files: FileDialogs) -> None:
        self._editor, self._keeper, self._files = editor, keeper, files
        self._question: Question | None = None
        self._saving = False
        self.ended = False

    def request(self) -> None:
        """Close, or ask first; whoever wishes it twice has no answer to give, and keeps all."""
        editor = self._editor
        again = self._saving or (self._question is not None and editor.question is self._question)
        editor.finish()
        if again or not (editor.dirty or editor.tasks.now):
            self.ended = True
            return
        self._question = _question(editor)
        editor.ask(self._question)

    def act(self, name: str) -> c.Command | None:
        """One of LEAVING; the command that it needs. Raises DialogError."""
        if name == "discard and close":
            self._keeper.dismiss()
            self.ended = True
            return None
        self._saving = True
        known = self._files.known("save", self._editor)
        if known is not None or not self._files.available:
            return c.SaveSession(known)
        self._files.close()  # one that is open is about something else
        return self._files.act("save", self._editor)

    def step(self) -> None:
        """Once a frame: close when all is saved; where it could not be, the window stays."""
        if self._saving and not self._files.asking and self._editor.question is None:
            self._saving = False
            self.ended = not self._editor.dirty


def _question(editor: Editor) -> Question:
    """What closing the window now would lose, and what is to become of it."""
    task, lines = editor.tasks.now, []
    answers: tuple[Answer, ...] = (Answer("Close", WindowAction("discard and close")), CANCEL)
    if editor.dirty:
        lines.append(f"{editor.document.path.name} has changes that are not saved.")
        answers = (
            Answer("Save", WindowAction("save and close")),
            Answer("Discard", WindowAction("discard and close")),
            CANCEL,
        )
    if task is not None:
        lines.append(f"{task.name} is not finished yet.")
    return Question("\n".join(lines), answers)
