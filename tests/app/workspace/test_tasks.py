"""What takes longer than a frame: one at a time, taken back when asked, ended with the program."""

from __future__ import annotations

import threading
from collections.abc import Callable

import pytest

from app.workspace.tasks import Steps, Tasks, in_background
from solver.errors import MeshError
from solver.mesh.progress import Progress

WAIT = 30.0


@pytest.fixture
def said() -> list[str]:
    return []


@pytest.fixture
def tasks(said: list[str]) -> Tasks:
    return Tasks(said.append)


def finish(tasks: Tasks) -> None:
    while tasks.now is not None:
        tasks.advance()


def run(tasks: Tasks, steps: Steps[None]) -> None:
    tasks.begin("Working", steps)
    finish(tasks)


def counting(done: list[str], end: str = "end") -> Steps[None]:
    try:
        yield None
        yield 0.5
        done.append(end)
    finally:
        done.append("over")


def test_steps_go_on_one_a_frame_and_tell_how_far_they_are(tasks: Tasks) -> None:
    done: list[str] = []
    tasks.begin("Counting", counting(done))
    assert tasks.now is not None
    assert tasks.now.fraction is None
    tasks.advance()
    assert tasks.now.fraction == 0.5
    assert done == []
    tasks.advance()
    assert tasks.now is None
    assert done == ["end", "over"]
    tasks.advance()


def test_what_needs_no_frame_is_done_at_once(tasks: Tasks) -> None:
    def steps(ready: bool) -> Steps[None]:
        if not ready:
            yield None

    tasks.begin("Counting", steps(True))
    assert tasks.now is None


def test_there_is_one_at_a_time_and_of_those_that_wait_the_newest_of_a_name(
    tasks: Tasks,
) -> None:
    done: list[str] = []
    for name, end in (("a", "1"), ("b", "2"), ("c", "3"), ("b", "4")):
        tasks.begin(name, counting(done, end))
    names: list[str] = []
    while tasks.now is not None:
        names.append(tasks.now.name)
        tasks.advance()
    assert sorted(set(names)) == ["a", "b", "c"]
    assert names == sorted(names)
    assert done == ["1", "over", "4", "over", "3", "over"]


def test_what_waits_begins_when_the_first_is_cancelled_or_goes_wrong(tasks: Tasks) -> None:
    done: list[str] = []

    def wrong() -> Steps[None]:
        yield None
        raise MeshError("no")

    for name, steps in (("a", counting([])), ("b", wrong()), ("c", counting(done))):
        tasks.begin(name, steps)
    tasks.cancel()
    with pytest.raises(MeshError, match="no"):
        finish(tasks)
    finish(tasks)
    assert done == ["end", "over"]


def test_one_that_is_cancelled_is_over_and_says_so(tasks: Tasks, said: list[str]) -> None:
    done: list[str] = []
    tasks.begin("Counting", counting(done))
    tasks.cancel()
    assert tasks.now is None
    assert done == ["over"]
    assert said == ["Counting was cancelled"]
    tasks.cancel()
    assert len(said) == 1


def test_what_goes_wrong_is_raised_and_the_next_can_begin(tasks: Tasks) -> None:
    def wrong() -> Steps[None]:
        yield None
        raise MeshError("no")

    tasks.begin("Counting", wrong())
    with pytest.raises(MeshError, match="no"):
        tasks.advance()
    tasks.begin("Counting", counting([]))
    finish(tasks)


class Held:
    """Work that goes on until it may end."""

    def __init__(self) -> None:
        self.may_end = threading.Event()
        self.done = False

    def __call__(self, tell: Progress) -> str:
        tell(0.25)
        assert self.may_end.wait(WAIT)
        tell(0.5)
        self.done = True
        return "result"


def background(work: Callable[[Progress], str], results: list[str]) -> Steps[None]:
    results.append((yield from in_background(work, 0.6)))


def test_frames_go_on_while_a_thread_works(tasks: Tasks) -> None:
    held, results = Held(), list[str]()
    tasks.begin("Working", background(held, results))
    while tasks.now is not None and tasks.now.fraction == 0.6:
        tasks.advance()
    assert tasks.now is not None
    assert tasks.now.fraction == pytest.approx(0.6 + 0.4 * 0.25)
    held.may_end.set()
    finish(tasks)
    assert results == ["result"]


def test_a_thread_that_is_cancelled_ends_where_it_next_tells_how_far_it_is(
    tasks: Tasks, said: list[str]
) -> None:
    held, results = Held(), list[str]()
    tasks.begin("Working", background(held, results))
    tasks.cancel()
    assert tasks.now is not None, "nobody can stop it in the middle of a write"
    held.may_end.set()
    finish(tasks)
    assert said == ["Working was cancelled"]
    assert not held.done
    assert results == []


def test_an_error_of_a_thread_is_the_task_s(tasks: Tasks) -> None:
    def wrong(tell: Progress) -> str:
        raise MeshError("no room")

    with pytest.raises(MeshError, match="no room"):
        run(tasks, background(wrong, []))


def test_the_end_of_the_program_waits_for_a_file_and_for_nothing_else(tasks: Tasks) -> None:
    done: list[str] = []
    tasks.begin("Counting", counting(done))
    tasks.begin("Waiting", counting(done))
    assert tasks.close() == ["Counting", "Waiting"]
    assert done == ["over"]
    assert tasks.close() == []
    held, results = Held(), list[str]()
    tasks.begin("Working", background(held, results))
    held.may_end.set()
    assert tasks.close() == []
    assert results == ["result"]


def test_a_wait_after_a_file_is_given_up_too(tasks: Tasks) -> None:
    held, results = Held(), list[str]()

    def steps() -> Steps[None]:
        yield from background(held, results)
        yield None

    tasks.begin("Working", steps())
    held.may_end.set()
    assert tasks.close() == ["Working"]
    assert results == ["result"]


def test_one_that_was_cancelled_just_before_the_end_is_nothing_to_tell(tasks: Tasks) -> None:
    gate = threading.Event()

    def work(tell: Progress) -> None:
        gate.wait(WAIT)
        tell(0.5)

    def steps() -> Steps[None]:
        yield from in_background(work)

    tasks.begin("Working", steps())
    tasks.begin("Counting", counting([]))
    tasks.cancel()
    gate.set()
    assert tasks.close() == ["Counting"]
