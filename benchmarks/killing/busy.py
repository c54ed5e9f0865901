"""The window, busy: `python -m benchmarks.killing.busy TASK LOG MESH` renames a handle each frame.

TASK: "save" or "export" does that each time, "autosave" leaves it to the program. A line of LOG for
each time that it is done: its number, which is the handle's name, and when (epoch, s).
"""

from __future__ import annotations

import json
import sys
import time
from pathlib import Path
from typing import TextIO

from app.editor import commands as c
from app.editor.actions import ACTIONS
from app.editor.editor import Editor
from benchmarks.window.loop import Tick, run_watched

TASKS = "save", "export", "autosave"


class Busy:
    """What does the task once a frame, and writes down that it is done."""

    def __init__(self, task: str, lines: TextIO) -> None:
        self._task, self._lines = task, lines
        self._number = 0

    def act(self, editor: Editor) -> None:
        """Answers what is asked, renames the handle, and saves."""
        if editor.question is not None:
            command = editor.answer(editor.question.answers[0])
            if command is not None and type(command) in ACTIONS:
                editor.execute(command)
        if not editor.document.handles:
            editor.execute(c.AddHandle())
        self._number += 1
        editor.execute(c.RenameHandle(editor.document.handles[0].key, str(self._number)))
        editor.history.seal()
        if self._task != "autosave":
            editor.execute(c.SaveSession() if self._task == "save" else c.Export())
        print(json.dumps([self._number, time.time()]), file=self._lines)


def run(task: str, log: Path, mesh: Path) -> None:
    """Until somebody ends it."""
    with log.open("w", encoding="utf-8", buffering=1) as lines:
        busy = Busy(task, lines)

        def ticked(editor: Editor | None, tick: Tick) -> None:
            tick()
            if editor:
                busy.act(editor)

        run_watched(ticked, mesh, None)


if __name__ == "__main__":
    run(sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3]))
