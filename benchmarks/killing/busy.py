"""The window, busy: `python -m benchmarks.killing.busy TASK LOG MESH` renames a handle each frame.

TASK: "save" or "export" does that each time, "autosave" leaves it to the program. A line of LOG for
each time that it is done: its number, which is the handle's name, and when (epoch, s).
"""

from __future__ import annotations

import json
import sys
import time
from pathlib import Path
from typing import Any, TextIO

from app.editor import commands as c
from app.editor.actions import ACTIONS
from app.editor.editor import Editor

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
    """The app's own loop, until somebody ends it."""
    # Here, because the solver's process imports this module too and must not load a window.
    import polyscope as ps

    from app.window import main

    editors: list[Editor] = []
    adopt, tick = Editor.adopt, ps.frame_tick

    def watched(editor: Editor, *arguments: Any) -> None:
        adopt(editor, *arguments)
        editors[:] = [editor]

    with log.open("w", encoding="utf-8", buffering=1) as lines:
        busy = Busy(task, lines)

        def ticked() -> None:
            tick()
            for editor in editors:
                busy.act(editor)

        vars(ps)["frame_tick"] = ticked
        setattr(Editor, "adopt", watched)  # noqa: B010 - a method is not to be assigned
        main.run_window(mesh, None, None)


if __name__ == "__main__":
    run(sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3]))
