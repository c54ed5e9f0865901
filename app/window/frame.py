"""The order of a frame: input, panel, editor and view, once each."""

from __future__ import annotations

import traceback
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import replace
from pathlib import Path

import polyscope as ps

from app.dialogs.dialogs import Dialogs
from app.dialogs.programs import find_program
from app.editor import commands as c
from app.editor.editor import Editor
from app.editor.files.actions import open_command
from app.viewpoint.camera import Camera
from app.window.drawing.overlay import OverlayDrawer
from app.window.drawing.view import View
from app.window.file_dialogs import FileDialogs
from app.window.films.film import TakeFilm
from app.window.films.studio import PICTURES, Studio
from app.window.messages import Messages, draw_task, overlay
from app.window.mouse_and_keys import is_unfolded, read_mouse, read_shortcuts
from app.window.panel import WIDTH, Panel
from app.window.panel.file_rows import FileRows
from app.window.panel.looking import LookingRows
from app.window.progress_frames import ProgressFrames
from app.window.question_box import draw_question
from app.window.remembered import Remembered
from app.window.scaling import scaled
from app.window.shortcuts import SetInterface, WindowAction
from app.window.unsaved.work import QUESTIONS, UnsavedWork
from solver.errors import SolverError


class Window:
    """Connects input, panel, editor and view, once a frame."""

    def __init__(self, editor: Editor, remembered: Remembered) -> None:
        self._editor = editor
        self._remembered = remembered
        self._view, self._drawer = View(), OverlayDrawer()
        self._looked: Camera | None = None
        self._studio = Studio(editor, self._view)
        program = find_program() if remembered.file.values.dialogs else None
        self._dialogs = FileDialogs(Dialogs(program))
        self.unsaved = UnsavedWork(editor, self._dialogs, remembered.file.values.autosave)
        self._panel = Panel(
            FileRows(self._dialogs), LookingRows(self._studio, remembered.file, self._dialogs)
        )
        self._messages = Messages()
        self._waiting: list[c.Command] = []
        self._told = ProgressFrames("", lambda: self._panel.draw(editor))
        editor.progress = self._told
        self._drops: list[Path] = []
        self._rest = False  # whether this frame shows the rest shape
        self._unfolded = False  # a list or menu of the panel, in the last frame
        self._document = editor.document.serial
        remembered.attach(editor)
        with self._telling():
            self.unsaved.offer()

    def frame(self) -> None:
        """One frame."""
        with self._telling():
            self._frame()

    def work(self) -> None:
        """Carry out what takes its time, between two frames: the last one said so."""
        slow = self._waiting if self._editor.question is None else []  # else it would not be heard
        self._waiting = self._waiting[len(slow) :]
        for command in slow:
            self._told.notice = command.notice
            with self._telling():
                self._execute(command)
            ps.set_user_callback(self.frame)
        for work in (self._studio.work, *self.unsaved.steps):
            with self._telling():
                work()

    @contextmanager
    def _telling(self) -> Iterator[None]:
        """Whatever goes wrong becomes a message: an exception would end the window."""
        try:
            yield
        except (SolverError, OSError) as error:
            self._editor.say(str(error), "error")
        except Exception as error:
            traceback.print_exc()
            self.unsaved.hurry()
            self._editor.say(f"Internal error: {error}", "error")

    def drop(self, files: list[str]) -> None:
        """Files were dropped on the window: open the first."""
        self._drops = [Path(file) for file in files[:1]]

    def close(self) -> None:
        """Keep what was not saved, and end what was begun."""
        with ExitStack() as ends:  # all of them, whatever becomes of one
            for part in (self._studio, self._dialogs, self._editor):
                ends.callback(part.close)
            ends.callback(self._remembered.keep_window)
            self.unsaved.close()

    def leave(self) -> None:
        """A person wants to close the window."""
        with self._telling():
            self.unsaved.leave()

    def _frame(self) -> None:
        editor, view = self._editor, self._view
        editor.viewpoint.fit(ps.get_window_size(), scaled(WIDTH))
        self._rest = False
        for command in self._asked():
            self._do(command)
        mouse = read_mouse(editor.viewpoint.camera)
        # Nobody can paint or drag what is not seen: the mouse is the camera's meanwhile.
        editor.step(replace(mouse, alt=True) if self._rest else mouse)
        camera = self._studio.turning or editor.viewpoint.camera
        if self._looked is not camera:
            self._looked = camera
            view.look(self._looked, editor.viewpoint.reach)
        scene = editor.scene(self._rest)
        view.show(scene)
        self._drawer.draw(scene.overlay, camera)
        self._overlay()

    def _asked(self) -> list[c.Command]:
        """What a person asks for; where a question stands, no more than its answer does."""
        editor = self._editor
        asked = read_shortcuts(editor.brush, editor.hears, self._unfolded)
        asked += self._panel.draw(editor)
        self._unfolded = is_unfolded()
        if editor.question is not None:
            answer = draw_question(editor.question)
            command = None if answer is None else editor.answer(answer)
            return [] if command is None else [command]
        asked += [open_command(path) for path in self._drops]
        self._drops = []
        return asked + self._answered()

    def _answered(self) -> list[c.Command]:
        """What the dialog that was open asks for, once it was answered."""
        with self._telling():
            command = self._dialogs.poll(self._editor)
            return [command] if command is not None else []
        return []

    def _do(self, command: c.Command) -> None:
        if isinstance(command, WindowAction):
            with self._telling():
                self._act(command.name)
        elif isinstance(command, TakeFilm):
            with self._telling():
                self._studio.begin(command)
        elif isinstance(command, SetInterface):
            self._remembered.set_interface(command.scale)
        elif command.notice:
            self._waiting.append(command)
        else:
            self._execute(command)

    def _execute(self, command: c.Command) -> None:
        with self.unsaved.around(command):
            self._editor.execute(command)
        if self._document != self._editor.document.serial:
            self._document = self._editor.document.serial
            self._panel.file_rows.forget()
            self._dialogs.forget()

    def _act(self, name: str) -> None:
        """Raises SolverError."""
        if name == "help":
            self._panel.show_help = not self._panel.show_help
        elif name == "rest":
            self._rest = True
        elif name in QUESTIONS:
            self._follow_up(self.unsaved.act(name))
        elif name in (*PICTURES, "stop"):
            self._studio.ask(name)
        elif not self._dialogs.available:
            self._panel.file_rows.use(name)
        else:
            self._follow_up(self._dialogs.act(name, self._editor))

    def _follow_up(self, command: c.Command | None) -> None:
        if command is not None:
            self._do(command)

    def _overlay(self) -> None:
        """What is about to take its time, else what goes on and the last message."""
        if self._waiting:
            overlay("loading", self._waiting[0].notice)
            return
        task, above = self._editor.tasks.now, 0.0
        if task is not None:
            above, cancelled = draw_task(task)
            if cancelled:
                self._execute(c.CancelTask())
        self._messages.draw(self._editor.message, above)
