"""What becomes of unsaved work: kept in time, asked about at both ends of a window."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

from app.editor import commands as c
from app.editor.editor import Editor
from app.telling import tell
from app.unsaved.keeper import Keeper
from app.unsaved.places import clean_up
from app.window.file_dialogs import FileDialogs
from app.window.unsaved.leaving import LEAVING, Leaving
from app.window.unsaved.offers import OFFERS, Offers
from solver.errors import SolverError
from solver.storage import remove_orphans

QUESTIONS = (*LEAVING, *OFFERS)


class UnsavedWork:
    """Of one window. `steps` are to be done once a frame, each may raise a SolverError."""

    def __init__(self, editor: Editor, files: FileDialogs, seconds: float) -> None:
        """seconds: how long changes go unkept."""
        self._editor = editor
        self._keeper = Keeper(editor, seconds)
        self._leaving = Leaving(editor, self._keeper, files)
        self._offers = Offers(editor)
        self._kept: Path | None = None  # where the work of the last document is
        editor.leaving = self._keep_last
        self.steps: tuple[Callable[[], None], ...] = (
            *(self._leaving.step, self._offers.step, self._keeper.step),
        )

    def offer(self) -> None:
        """Ask about what windows before this one left, and tidy up behind them."""
        clean_up()
        for path in (self._editor.document.path, self._editor.session_path):
            if path is not None:
                remove_orphans(path.parent)
        self._offers.look()

    @contextmanager
    def around(self, command: c.Command) -> Iterator[None]:
        """While a command is carried out: nothing is lost where it opens another document."""
        self._kept, before = None, self._editor.document
        yield
        if self._editor.document is before:
            if self._editor.question is None:
                self._offers.failed(command)
            return
        going_on = self._offers.gone_on_with(command)
        self._keeper.follow(going_on)
        if self._kept is not None:
            self._editor.say(f"Unsaved work is kept in {self._kept}")
        if going_on is None:
            self._offers.look(self._editor.document.path)

    def _keep_last(self) -> None:
        """Another document is about to be shown. Raises FileError: it is not, then."""
        self._kept = self._keeper.keep()

    def act(self, name: str) -> c.Command | None:
        """What an answer asks for, one of QUESTIONS; the command that it needs.

        Raises DialogError or OSError.
        """
        return (self._leaving if name in LEAVING else self._offers).act(name)

    @property
    def ended(self) -> bool:
        """Whether the window is to close."""
        return self._leaving.ended

    def leave(self) -> None:
        """A person wants to close the window. Raises SolverError."""
        self._leaving.request()

    def hurry(self) -> None:
        """Something went wrong: keep what there is as soon as can be."""
        self._keeper.hurry()

    def keep(self) -> None:
        """Keep for the next start what was not saved."""
        try:
            kept = self._keeper.keep()
        except SolverError as error:
            tell(str(error), error=True)
        else:
            if kept is not None:
                tell(f"unsaved work is offered at the next start; it is kept in {kept}")

    def close(self) -> None:
        """Keep it, and leave it to the next start."""
        with ExitStack() as ends:
            ends.callback(self._keeper.close)
            ends.callback(self._offers.close)
            self.keep()
