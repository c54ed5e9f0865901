"""Everything that can be done is undone exactly, however long the history is."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from app.editor import commands as c
from app.model.history import Entry
from tests.app.person import Person, state

Act = Callable[[Person, np.random.Generator], None]


def stroke(tool: str) -> Act:
    def act(person: Person, rng: np.random.Generator) -> None:
        person.use(tool, 1.2)
        x = rng.uniform(2, 18)
        person.stroke([x, 1, 0], [x, 3, 0], shift=bool(rng.random() < 0.3))

    return act


def ask(*commands: c.Command) -> Act:
    return lambda person, rng: person.do(commands[rng.integers(len(commands))])


def drag(person: Person, rng: np.random.Generator) -> None:
    person.use("drag")
    x = rng.uniform(1, 19)
    person.stroke([x, 2, 0], [x - 1, 3, 0], [x - 1, 4, 0])


def click(person: Person, rng: np.random.Generator) -> None:
    """A pin with the drag tool, else a double click on a part."""
    person.use(("drag", "fixed")[rng.integers(2)])
    person.click([rng.uniform(1, 19), 2, 0], count=int(rng.integers(1, 3)))


def blend(person: Person, rng: np.random.Generator) -> None:
    if person.editor.document.poses:
        kept = person.editor.document.poses[-1].key
        person.do(c.BlendPoses(0, kept, float(rng.random())))


ACTS: tuple[Act, ...] = (
    *(stroke(tool) for tool in ("fixed", "handle", "softness")),
    drag,
    drag,
    click,
    blend,
    ask(c.AddHandle(), c.KeepPose(), c.ResetPose(), c.MakeRest(), c.RestoreRest()),
    ask(c.FillSoftness(), c.SmoothSoftness(), c.ClearPins(), c.ClearSoftness(), c.ClearFixed()),
    ask(c.SetSetting("rigid", 0), c.SetSetting("bending_length", 0.05), c.SetMaterial("clay")),
    ask(c.SetSymmetry("x"), c.SetSymmetry("off"), c.MirrorRegions(), c.MirrorPose()),
    ask(c.SetPosition(0, 1.0), c.SetRotation(2, (0.0, 0.0, 30.0)), c.SetKeep()),
    ask(c.ChangeMarks("grow"), c.ChangeMarks("shrink"), c.ChangeMarks("invert")),
)


def test_a_thousand_undos_and_redos_end_where_all_began(bar: Person) -> None:
    rng, history = np.random.default_rng(4), bar.editor.history
    before = state(bar.editor.document)
    while len(history.done) < 120:
        ACTS[rng.integers(len(ACTS))](bar, rng)
    after, entries = state(bar.editor.document), len(history.done)
    assert after != before
    assert len({entry.label.split()[0] for entry in history.done}) > 12, "of many kinds"
    for _ in range(1000):
        bar.do(c.Undo() if rng.random() < 0.5 else c.Redo())
    while history.undone:
        bar.do(c.Redo())
    assert state(bar.editor.document) == after
    assert len(history.done) == entries
    while history.done:
        bar.do(c.Undo())
    assert state(bar.editor.document) == before


class Watched(list[Entry]):
    """Counts how often anybody goes through all of it."""

    walks = 0

    def __iter__(self):  # type: ignore[no-untyped-def]
        Watched.walks += 1
        return super().__iter__()


def test_no_frame_goes_through_the_history(ready: Person) -> None:
    history = ready.editor.history
    history.done, history.undone = Watched(history.done), Watched(history.undone)
    Watched.walks = 0
    for _ in ready.hold([[19, 2, 0], [18, 3, 0], [17, 4, 0]]):
        ready.editor.scene()
    ready.frame([17, 4, 0], "r")
    ready.frame([10, 2, 0])
    ready.editor.scene()
    assert ready.editor.dirty
    assert Watched.walks == 0
