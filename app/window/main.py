"""The window from its opening to its end."""

from __future__ import annotations

import signal
import time
from pathlib import Path

import polyscope as ps

from app.editor import commands as c
from app.editor.start import open_editor
from app.model.preferences import PreferencesFile, preferences_path
from app.signals import told_to_end
from app.window.frame import Window
from app.window.lost_display import display_lost
from app.window.messages import overlay
from app.window.progress_frames import ProgressFrames
from app.window.remembered import Remembered
from app.worker.client import ProcessWorker, Worker
from app.workspace.tasks import Cancelled

FRAME_SECONDS = 1 / 60


def run_window(mesh: Path | None, session: Path | None, export: Path | None) -> None:
    """Open a mesh, a session, or a session on another mesh, and stay until the window is closed.

    export: where Ctrl+E saves.
    Raises SolverError for a file that cannot be used, GraphicsError where there is no display.
    """
    worker = ProcessWorker()  # first: it loads while the window opens
    try:
        _run(worker, mesh, session, export)
    finally:
        worker.close()


def _run(worker: Worker, mesh: Path | None, session: Path | None, export: Path | None) -> None:
    remembered = Remembered(PreferencesFile(preferences_path()))
    remembered.open_window()
    ps.set_user_callback(lambda: overlay("loading", "Loading ..."))
    for _ in range(2):  # the first frame of a window may come before it is shown
        ps.frame_tick()
    told = ProgressFrames(c.OpenMesh.notice, lambda: None)
    try:
        editor = open_editor(mesh, session, worker, export, told)
    except Cancelled:  # before there was anything
        return
    if editor.document.handles:  # everything is ready for it
        editor.execute(c.SetTool("drag"))
    window = Window(editor, remembered)
    ps.set_user_callback(window.frame)
    ps.set_files_dropped_callback(window.drop)
    try:
        with display_lost(window.unsaved.keep):
            _loop(window)
    finally:
        window.close()


def _loop(window: Window) -> None:
    """Sixty frames a second and no more: Polyscope's own limit burns the time in between.

    Raises KeyboardInterrupt where Ctrl+C in a terminal ended it.
    """
    with told_to_end() as told:
        while not (told or window.unsaved.ended):
            start = time.perf_counter()
            ps.frame_tick()
            window.work()
            if ps.window_requests_close():  # only once for each press of the button
                window.leave()
            time.sleep(max(FRAME_SECONDS - (time.perf_counter() - start), 0.0))
    if signal.SIGINT in told:
        raise KeyboardInterrupt
