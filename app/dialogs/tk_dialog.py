"""A program of its own: one dialog of Python's toolkit. Started with a question as JSON.

Prints the path that was chosen; ends with 1 where nothing was, with 2 where no dialog can be shown.
It ends too when its standard input is closed: whoever started it is gone.
"""

from __future__ import annotations

import json
import os
import sys
import threading
from typing import Any

CHOSEN, CANCELLED, FAILED = 0, 1, 2


def main() -> int:
    """Ask, print the answer."""
    threading.Thread(target=_leave_with_parent, daemon=True).start()
    try:
        path = _ask(json.loads(sys.argv[1]))
    except Exception as error:
        print(error, file=sys.stderr)
        return FAILED
    sys.stdout.buffer.write(os.fsencode(path))
    return CHOSEN if path else CANCELLED


def _ask(question: dict[str, Any]) -> str:
    import tkinter  # here: where it is missing, that is a failure and no cancelling
    from tkinter import filedialog

    root = tkinter.Tk()
    root.withdraw()
    root.attributes("-topmost", True)  # before the window that asks
    folder, name = os.path.split(question["path"])
    kinds = [(label, tuple(patterns)) for label, patterns in question["kinds"]]
    options: Any = {"parent": root, "title": question["title"], "filetypes": kinds}
    options |= {"initialdir": folder, "initialfile": name}
    if question["saves"]:
        path = filedialog.asksaveasfilename(**options, defaultextension=question["suffix"])
    else:
        path = filedialog.askopenfilename(**options)
    return path if isinstance(path, str) else ""  # Tk answers () to some cancellations


def _leave_with_parent() -> None:
    os.read(sys.stdin.fileno(), 1)  # a buffered read would hold up the end of the program
    os._exit(CANCELLED)


if __name__ == "__main__":
    sys.exit(main())
