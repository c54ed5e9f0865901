"""What is asked about unsaved work, one at a time, and what becomes of each answer."""

from __future__ import annotations

import os
import time
from pathlib import Path

import pytest

from app.editor import commands as c
from app.unsaved.keeper import Keeper
from app.unsaved.places import PLACE, kept_work
from app.window.unsaved.offers import Offers
from tests.app.person import Person, slab


@pytest.fixture
def kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> dict[str, Path]:
    """Unsaved work on meshes a and b, that on b the last; by the names of the meshes."""
    monkeypatch.setenv(PLACE, str(tmp_path / "state"))
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path / "temporary"))
    found = {}
    for number, name in enumerate("ab"):
        mesh = slab(20, 4, 2.0)
        mesh.save(tmp_path / f"{name}.obj", mesh.vertices)
        person = Person(mesh, tmp_path / f"{name}.obj")
        person.do(c.AddHandle(f"of {name}"))
        keeper = Keeper(person.editor, 3600)
        path = keeper.keep()
        keeper.close()
        assert path is not None
        os.utime(path, (time.time() + number,) * 2)
        found[name] = path
    return found


@pytest.fixture
def person(tmp_path: Path) -> Person:
    return Person(slab(3, 3, 1.0), tmp_path / "c.obj")


def released() -> list[Path]:
    """What the next start would ask about."""
    found = kept_work()
    for one in found:
        one.lock.release()
    return [one.path for one in found]


def asked(person: Person) -> str:
    assert person.editor.question is not None
    return person.editor.question.text


def test_the_last_work_is_asked_about_first_and_all_in_turn(
    person: Person, kept: dict[str, Path]
) -> None:
    offers = Offers(person.editor)
    offers.look()
    offers.step()
    assert asked(person).startswith("Unsaved work on b.obj of ")
    assert "(1 handle)" in asked(person)
    assert kept_work() == [], "no other window asks about it meanwhile"
    person.editor.question = None
    offers.act("discard unsaved")
    offers.step()
    assert asked(person).startswith("Unsaved work on a.obj of ")
    assert not kept["b"].exists()
    person.editor.question = None
    offers.act("leave unsaved")
    offers.step()
    assert person.editor.question is None
    assert kept["a"].exists()
    assert released() == [kept["a"]], "the next start asks again"


def test_that_of_the_mesh_that_is_open_goes_before(
    person: Person, kept: dict[str, Path], tmp_path: Path
) -> None:
    person.do(c.OpenMesh(tmp_path / "a.obj"))
    offers = Offers(person.editor)
    offers.look()
    offers.step()
    assert asked(person).startswith("Unsaved work on a.obj of ")
    offers.look(tmp_path / "c.obj")
    person.editor.question = None
    offers.step()
    assert person.editor.question is None, "there is none on that mesh"
    assert len(released()) == len(kept)


def test_a_mesh_that_is_gone_is_named(
    person: Person, kept: dict[str, Path], tmp_path: Path
) -> None:
    (tmp_path / "b.obj").unlink()
    offers = Offers(person.editor)
    offers.look()
    offers.step()
    assert f"Its mesh is gone: {(tmp_path / 'b.obj').resolve()}" in asked(person)
    offers.close()
    assert kept["b"].exists()


def test_going_on_takes_the_work_and_leaves_the_rest(person: Person, kept: dict[str, Path]) -> None:
    offers = Offers(person.editor)
    offers.look()
    command = offers.act("continue unsaved")
    assert command == c.ContinueWork(kept["b"])
    person.do(command)
    taken = offers.gone_on_with(command)
    assert taken is not None
    assert taken.path == kept["b"]
    assert [handle.name for handle in person.editor.document.handles] == ["of b"]
    assert released() == [kept["a"]]
    taken.lock.release()


def test_another_question_goes_before(person: Person, kept: dict[str, Path]) -> None:
    offers = Offers(person.editor)
    offers.look()
    assert offers.gone_on_with(c.SetTool("drag")) is None
    person.do(c.SaveSession(Path("/nowhere/at/all.json")))
    first = asked(person)
    offers.step()
    assert asked(person) == first
    person.editor.question = None
    offers.step()
    assert asked(person).startswith("Unsaved work on b.obj")
    offers.close()
    assert all(path.exists() for path in kept.values())
