"""Keeps what a person made and did not save, when another file is opened or the window closes."""

from __future__ import annotations

import sys

from app.editor.editor import Editor
from app.editor.file_actions import default_session_path
from app.model.free_path import free_path
from app.model.session import write_session
from solver.errors import SolverError


def keep_unsaved(editor: Editor) -> None:
    """Write what no session file holds to one beside it, so that nothing made is ever lost."""
    if not editor.dirty:
        return
    session = default_session_path(editor)
    spare = free_path(session.with_name(f"{session.stem}-unsaved.json"))
    try:
        write_session(spare, editor.document)
    except SolverError as error:
        print(f"unsaved work could not be kept: {error}", file=sys.stderr)
    else:
        print(f"unsaved work is kept in {spare}")
