"""The window with a clock: `python -m benchmarks.window.ticks LOG SESSION` logs every frame."""

from __future__ import annotations

import json
import sys
import time
from pathlib import Path

from app.editor.editor import Editor
from benchmarks.window.loop import Tick, run_watched


def run(log: Path, session: Path) -> None:
    """One line a frame: begin (epoch, s), seconds, binding, dragging."""
    with log.open("w", encoding="utf-8", buffering=1) as lines:

        def timed(editor: Editor | None, tick: Tick) -> None:
            state = (editor.worker.binding, editor.dragging) if editor else (False, False)
            begin = time.time()
            tick()
            if editor:
                print(json.dumps([begin, time.time() - begin, *state]), file=lines)

        run_watched(timed, None, session)


if __name__ == "__main__":
    run(Path(sys.argv[1]), Path(sys.argv[2]))
