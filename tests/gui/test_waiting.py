"""The solver's process stands still: the window does not."""

from __future__ import annotations

import os
import signal

import numpy as np
import psutil
import pytest

from app.demo import DRAG

from .person import Person, wait_until
from .scene import Scene, positions

pytestmark = pytest.mark.skipif(os.name != "posix", reason="stops a process as POSIX systems do")
CANCEL = "Cancel (Esc)"


def solver(person: Person) -> psutil.Process:
    """The process that binds."""
    children = psutil.Process(person.process.pid).children(recursive=True)
    (found,) = (child for child in children if "spawn_main" in " ".join(child.cmdline()))
    return found


def test_an_export_can_be_cancelled_while_the_solver_stands_still_and_is_done_after(
    ready: Scene,
) -> None:
    scene, person = ready, ready.person
    scene.export.unlink()
    stopped = solver(person)
    stopped.send_signal(signal.SIGSTOP)
    person.key("5")
    person.wait_still()
    scene.stroke(*DRAG[:3], steps=15)
    person.key("ctrl+e")
    button = person.widget(CANCEL)
    before = scene.view()
    person.drag([(1100, 650), (1160, 640)])  # the camera goes around
    wait_until(lambda: (scene.view() != before).mean() > 0.01, what="another view")
    person.click(*button)
    wait_until(lambda: not person.shows(CANCEL), what="the end of the export")
    assert not scene.export.exists()
    stopped.send_signal(signal.SIGCONT)
    X = positions(scene.save_mesh())
    assert np.abs(X - scene.rest).max() > 0.1


def test_esc_folds_up_a_menu_before_it_cancels_an_export(ready: Scene) -> None:
    scene, person = ready, ready.person
    solver(person).send_signal(signal.SIGSTOP)
    person.key("5")
    person.wait_still()
    scene.stroke(*DRAG[:3], steps=15)
    scene.export.unlink()
    person.key("ctrl+e")
    person.widget(CANCEL)
    person.choose("Rest ...")
    person.widget("Make this the rest shape")
    person.key("Escape")
    wait_until(lambda: not person.shows("Make this the rest shape"), what="the menu to fold up")
    person.widget(CANCEL)
    person.key("Escape")
    wait_until(lambda: not person.shows(CANCEL), what="the end of the export")
    assert not scene.export.exists()


def test_a_solver_that_does_not_answer_is_replaced_and_closing_never_waits_for_it(
    ready: Scene,
) -> None:
    scene, person = ready, ready.person
    stopped = solver(person)
    stopped.send_signal(signal.SIGSTOP)
    person.key("5")
    person.wait_still()
    scene.stroke(*DRAG[:3], steps=15)
    X = positions(scene.save_mesh())  # by another process, once that one has been silent long
    assert np.abs(X - scene.rest).max() > 0.1
    assert not stopped.is_running() or stopped.status() == psutil.STATUS_ZOMBIE
    stopped = solver(person)
    stopped.send_signal(signal.SIGSTOP)
    person.wait_still()
    scene.stroke(*DRAG[2:4], steps=15)
    scene.export.unlink()
    person.key("ctrl+e")
    person.widget(CANCEL)
    assert person.quit() == 0
    assert not psutil.pid_exists(stopped.pid)
    assert "Exporting out.obj was not finished" in person.output()
    assert not scene.export.exists()
