"""The programs that can show a dialog, best first: the desktop's own, else Python's toolkit.

Each prints the path that was chosen and ends with 0, or ends with 1 where nothing was.
"""

from __future__ import annotations

import json
import os
import shutil
import sys
from collections.abc import Callable
from importlib.util import find_spec
from pathlib import Path

from app.dialogs.question import Question

Program = Callable[[Question], list[str]]  # the command that asks a question

TK = Path(__file__).with_name("tk_dialog.py")


def zenity(question: Question) -> list[str]:
    """Of GNOME and what is akin to it."""
    command = ["zenity", "--file-selection", f"--title={question.title}"]
    command.append(f"--filename={_begin(question)}")
    command += [f"--file-filter={k.label} | {' '.join(k.patterns)}" for k in question.kinds]
    return command + (["--save", "--confirm-overwrite"] if question.saves else [])


def kdialog(question: Question) -> list[str]:
    """Of KDE. One filter for all kinds: how it takes several differs between its versions."""
    patterns = " ".join(pattern for kind in question.kinds for pattern in kind.patterns)
    ask = "--getsavefilename" if question.saves else "--getopenfilename"
    kinds = f"{question.kinds[0].label} ({patterns})"
    return ["kdialog", "--title", question.title, ask, _begin(question), kinds]


def tk(question: Question) -> list[str]:
    """Python's own. The script stands alone: this program need not be on its path."""
    asked = {
        "saves": question.saves,
        "title": question.title,
        "path": _begin(question),
        "kinds": [(kind.label, kind.patterns) for kind in question.kinds],
        "suffix": question.path.suffix,
    }
    return [sys.executable, "-P", str(TK), json.dumps(asked)]


def find_program() -> Program | None:
    """The best that this machine has, None where it has none."""
    if sys.platform == "linux":
        kde = "KDE" in os.environ.get("XDG_CURRENT_DESKTOP", "").upper()
        desktop = (kdialog, zenity) if kde else (zenity, kdialog)
        for program in desktop:
            if shutil.which(program.__name__):
                return program
    return tk if find_spec("_tkinter") else None


def _begin(question: Question) -> str:
    """Where a dialog begins; a folder ends with a separator, else it is taken for a file."""
    path = question.path.absolute()
    return f"{path}{os.sep}" if path.is_dir() else str(path)
