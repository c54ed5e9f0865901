"""Asks whether unsaved work that was kept is to be gone on with."""

from __future__ import annotations

from datetime import datetime
from pathlib import Path

from app.editor import commands as c
from app.editor.editor import Editor
from app.editor.question import Answer, Question
from app.unsaved.places import Kept, kept_work
from app.window.shortcuts import WindowAction

OFFERS = "continue unsaved", "discard unsaved", "leave unsaved"
LABELS = "Continue", "Discard", "Later"


class Offers:
    """The work that this window asks about, one question at a time, the last work first.

    No other window can ask about it meanwhile.
    """

    def __init__(self, editor: Editor) -> None:
        self._editor = editor
        self._found: list[Kept] = []

    def look(self, mesh: Path | None = None) -> None:
        """Begin to ask about all that is kept, that of the mesh that is open first.

        mesh: only about work on this.
        """
        self.close()
        opened = self._editor.document.path.resolve()
        for kept in kept_work():
            if mesh is None or kept.mesh == mesh.resolve():
                self._found.append(kept)
            else:
                kept.lock.release()
        self._found.sort(key=lambda kept: kept.mesh != opened)

    def step(self) -> None:
        """Once a frame: ask, unless something else is asked."""
        if self._found and self._editor.question is None:
            self._editor.ask(question_about(self._found[0], len(self._found)))

    def act(self, name: str) -> c.Command | None:
        """One of OFFERS; the command that it needs. Raises OSError."""
        if name == "continue unsaved" and self._found:
            return c.ContinueWork(self._found[0].path)
        if name == "discard unsaved" and self._found:
            self._found.pop(0).dismiss()
        else:
            self.close()
        return None

    def gone_on_with(self, command: c.Command) -> Kept | None:
        """The work that a command has opened, None for another command; nothing more is asked."""
        if not isinstance(command, c.ContinueWork):
            return None
        taken = next((kept for kept in self._found if kept.path == command.path), None)
        self._found = [kept for kept in self._found if kept is not taken]
        self.close()
        return taken

    def failed(self, command: c.Command) -> None:
        """It opened nothing: the work stays for the next start."""
        if isinstance(command, c.ContinueWork):
            self.close()

    def close(self) -> None:
        """Leave the rest to the next start."""
        found, self._found = self._found, []
        for kept in found:
            kept.lock.release()


def question_about(kept: Kept, count: int = 1) -> Question:
    """count: how many there are to ask about, with this one."""
    at = datetime.fromtimestamp(kept.at)
    when = f"{at.day} {at:%B %Y, %H:%M}"
    lines = [f"Unsaved work on {kept.mesh.name} of {when} ({kept.unsaved['holds']}).", ""]
    if kept.mesh.exists():
        lines.append(str(kept.mesh))
    else:
        lines.append(f"Its mesh is gone: {kept.mesh}. It can be gone on with when it is back.")
    if count > 1:
        lines.append(f"There is more of it: {count - 1}.")
    answers = (
        Answer(label, WindowAction(name)) for label, name in zip(LABELS, OFFERS, strict=True)
    )
    return Question("\n".join(lines), tuple(answers))
