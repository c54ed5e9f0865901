"""Asks questions by dialogs, one at a time, while the window goes on."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

from app.dialogs.programs import Program
from app.dialogs.question import Answer, Question
from solver.errors import SolverError

CHOSEN, CANCELLED = 0, 1


class DialogError(SolverError):
    """A dialog could not be shown."""


class Dialogs:
    """The dialogs of one program. None: there are no dialogs."""

    def __init__(self, program: Program | None) -> None:
        self._program = program
        self._question: Question | None = None
        self._process: subprocess.Popen[bytes] | None = None

    @property
    def available(self) -> bool:
        """Whether there are any."""
        return self._program is not None

    @property
    def open(self) -> bool:
        """Whether one is, or its answer has not been polled."""
        return self._process is not None

    def ask(self, question: Question) -> None:
        """Show a dialog; not while another one is open. Raises DialogError."""
        if self._program is None or self._process is not None:
            return
        try:
            self._process = subprocess.Popen(
                self._program(question),
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.DEVNULL,
                creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0),
            )
        except OSError as error:
            raise self._failed(error) from error
        self._question = question

    def poll(self) -> Answer | None:
        """What was answered, once; None as long as nothing was. Raises DialogError.

        Where a dialog cannot be shown there are none from then on.
        """
        process, question = self._process, self._question
        if process is None or question is None or process.poll() is None:
            return None
        assert process.stdout is not None
        with process.stdout as stream:
            chosen = os.fsdecode(stream.read()).strip("\r\n")
        code = process.returncode
        self.close()
        if code not in (CHOSEN, CANCELLED):
            raise self._failed(f"its program ended with {code}")
        return Answer(question, Path(chosen) if chosen and code == CHOSEN else None)

    def close(self) -> None:
        """End the dialog that is open."""
        process, self._process, self._question = self._process, None, None
        if process is None:
            return
        if process.poll() is None:
            process.kill()
            process.wait()
        for stream in (process.stdin, process.stdout):
            if stream is not None:
                stream.close()

    def _failed(self, reason: object) -> DialogError:
        self._program = None
        return DialogError(f"no dialog can be shown ({reason}); type the path instead")
