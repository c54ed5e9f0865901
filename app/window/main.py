"""The window: the order of a frame."""

from __future__ import annotations

import itertools
import sys
import time
import traceback
from pathlib import Path

import polyscope as ps
import polyscope.imgui as psim

from app.editor import commands as c
from app.editor.editor import Editor
from app.editor.file_actions import default_session_path, load_document, open_command
from app.model.session import write_session
from app.window.input import WindowAction, read_mouse, read_shortcuts
from app.window.panel import ERROR_COLOR, WIDTH, Panel
from app.window.view import View, open_window
from app.worker.client import ProcessWorker, Worker
from solver.errors import SolverError

FRAME_SECONDS = 1 / 60
MESSAGE_SECONDS = {"info": 4.0, "error": 10.0}
# Commands that take their time: a frame that says so is drawn before they run.
OPENING = (c.OpenMesh, c.OpenSession)
SLOW = (*OPENING, c.FillSoftness, c.SmoothSoftness)
OVERLAY = (
    psim.ImGuiWindowFlags_NoDecoration
    | psim.ImGuiWindowFlags_NoInputs
    | psim.ImGuiWindowFlags_AlwaysAutoResize
    | psim.ImGuiWindowFlags_NoSavedSettings
)


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
    open_window()
    ps.set_user_callback(lambda: _overlay("loading", "Loading ..."))
    for _ in range(2):  # the first frame of a window may come before it is shown
        ps.frame_tick()
    window = Window(Editor(load_document(mesh, session), worker, session, export))
    ps.set_user_callback(window.frame)
    ps.set_files_dropped_callback(window.drop)
    try:
        _loop()
    finally:
        window.close()


def _loop() -> None:
    """Sixty frames a second and no more: Polyscope's own limit burns the time in between."""
    while not ps.window_requests_close():
        start = time.perf_counter()
        ps.frame_tick()
        time.sleep(max(FRAME_SECONDS - (time.perf_counter() - start), 0.0))


class Window:
    """Connects input, panel, editor and view, once a frame."""

    def __init__(self, editor: Editor) -> None:
        self._editor = editor
        self._view = View(inset=WIDTH)
        self._panel = Panel()
        self._waiting: list[c.Command] = []
        self._drops: list[Path] = []
        self._document = editor.document.serial
        self._message_until = 0.0
        self._message_number = 0

    def frame(self) -> None:
        """One frame. Whatever goes wrong becomes a message: an exception would end the window."""
        try:
            self._frame()
        except Exception as error:
            traceback.print_exc()
            self._editor.say(f"Internal error: {error}", "error")

    def drop(self, files: list[str]) -> None:
        """Files were dropped on the window: open the first."""
        self._drops = [Path(file) for file in files[:1]]

    def close(self) -> None:
        """End the worker and keep what was not saved."""
        self._editor.close()
        keep_unsaved(self._editor)

    def _frame(self) -> None:
        editor, view = self._editor, self._view
        mouse = read_mouse(view.camera())
        slow, self._waiting = self._waiting, []
        asked = [*read_shortcuts(editor.brush), *self._panel.draw(editor)]
        asked += [open_command(path) for path in self._drops]
        self._drops = []
        for command in [*slow, *asked]:
            self._do(command, now=command in slow)
        editor.step(mouse)
        ps.set_do_default_mouse_interaction(not editor.captures)
        view.sync(editor)
        view.show_edges(self._panel.show_edges)
        if editor.hover is not None:
            view.draw_brush(editor, editor.hover, mouse.shift)
        self._messages()

    def _do(self, command: c.Command, now: bool) -> None:
        if isinstance(command, WindowAction):
            self._act(command.name)
        elif isinstance(command, SLOW) and not now:
            self._waiting.append(command)
        else:
            if isinstance(command, OPENING):
                keep_unsaved(self._editor)
            self._editor.execute(command)
        if self._document != self._editor.document.serial:
            self._document = self._editor.document.serial
            self._panel.files.forget()

    def _act(self, name: str) -> None:
        if name == "frame":
            self._view.frame_mesh(self._editor.positions)
        elif name == "help":
            self._panel.show_help = not self._panel.show_help
        else:
            self._panel.files.use(name)

    def _messages(self) -> None:
        if self._waiting:
            loads = any(isinstance(command, OPENING) for command in self._waiting)
            _overlay("loading", "Loading ..." if loads else "Working ...")
            return
        message = self._editor.message
        if message is None:
            return
        if message.number != self._message_number:
            self._message_number = message.number
            self._message_until = time.perf_counter() + MESSAGE_SECONDS[message.kind]
        if time.perf_counter() < self._message_until:
            _overlay("message", message.text, error=message.kind == "error")


def keep_unsaved(editor: Editor) -> None:
    """Write what no session file holds to one beside it, so that nothing made is ever lost."""
    if not editor.dirty:
        return
    session = default_session_path(editor)
    numbers = itertools.chain([""], (f"-{number}" for number in itertools.count(2)))
    paths = (session.with_name(f"{session.stem}-unsaved{number}.json") for number in numbers)
    spare = next(path for path in paths if not path.exists())
    try:
        write_session(spare, editor.document)
    except SolverError as error:
        print(f"unsaved work could not be kept: {error}", file=sys.stderr)
    else:
        print(f"unsaved work is kept in {spare}")


def _overlay(name: str, text: str, error: bool = False) -> None:
    """A message over the scene, at the bottom."""
    width, height = psim.GetIO().DisplaySize
    psim.SetNextWindowPos((0.5 * (width + WIDTH), height - 30.0), 0, (0.5, 1.0))
    psim.SetNextWindowBgAlpha(0.9)
    psim.Begin(f"##{name}", OVERLAY)
    psim.PushTextWrapPos(max(width - WIDTH - 60.0, 100.0))
    try:
        if error:
            psim.TextColored(ERROR_COLOR, text)
        else:
            psim.Text(text)
    finally:
        psim.PopTextWrapPos()
        psim.End()
