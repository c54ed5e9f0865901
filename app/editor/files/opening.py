"""What is asked when something is opened: to continue a session, to carry it to a changed mesh."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from datetime import datetime
from pathlib import Path

from app.bundled import writable
from app.editor import commands as c
from app.editor.files.replacing import whole
from app.editor.question import CANCEL, Answer, Question
from app.model.document import Document
from app.model.session.carrying import MeshChanged
from app.model.session.files import SUFFIX, is_session
from app.model.session.mesh import Change, farthest
from app.model.session.reading import Session, read_session
from app.telling import counted
from solver.errors import SolverError

SAVED = "%d %B %Y, %H:%M"
BECAME: dict[Change, str] = {
    "joined": "its vertices are where they were, but joined otherwise",
    "moved": "its vertices have moved",
    "other": "its vertices are others",
}


@dataclass(frozen=True)
class Beside:
    """What lies beside a mesh. sessions: on it, the last one saved first.

    fault: why one that is there cannot be read, None where all can.
    """

    sessions: tuple[Session, ...] = ()
    fault: SolverError | None = None


def sessions_beside(mesh: Path) -> Beside:
    """The session where saving would propose one, and those with a number behind that name."""
    if mesh.is_dir():  # which may have no name; reading it will say so
        return Beside()
    proposed = writable(mesh.with_suffix(SUFFIX))
    found, fault = list[Session](), None
    for path in _named_like(proposed):
        try:
            session = read_session(path)
        except SolverError as error:
            fault = fault or error
            continue
        if path == proposed or session.mesh_path.resolve() == mesh.resolve():
            found.append(session)
    return Beside(tuple(found), fault)


def _named_like(path: Path) -> list[Path]:
    """The sessions of a name, with or without a number behind it, the last one saved first."""
    name = re.compile(rf"{re.escape(path.stem)}(-\d+)?{re.escape(path.suffix)}")
    try:
        named = [file for file in path.parent.iterdir() if name.fullmatch(file.name)]
        found = [file for file in named if file.is_file() and is_session(file)]
        return sorted(found, key=lambda file: file.stat().st_mtime_ns, reverse=True)
    except (SolverError, OSError):  # the folder cannot be read, or something went away
        return []


def to_continue(sessions: Sequence[Session], mesh: Path, opened: bool = False) -> Question:
    """Whether to open the first of the sessions that lie beside a mesh.

    opened: whether the mesh is open already, as it is.
    """
    session, *others = sessions
    saved = datetime.fromtimestamp(session.path.stat().st_mtime).strftime(SAVED)
    text = f"{whole(session.path)} holds work of {saved}: {contents(session)}."
    if session.mesh_path.resolve() != mesh.resolve():
        text += f" It was saved of {whole(session.mesh_path)}."
    if others:
        text += f" Also there: {', '.join(other.path.name for other in others)}."
    go_on = Answer("Continue where you left off", c.OpenSession(session.path, mesh))
    if opened:
        return Question(text, (go_on, Answer("Start fresh")))
    return Question(text, (go_on, Answer("Start fresh", c.OpenMesh(mesh, fresh=True)), CANCEL))


def contents(session: Session) -> str:
    """What is in a session, in plain words."""
    data = session.data
    nouns = {"handles": "handle", "pins": "pin", "poses": "kept pose", "fixed": "fixed vertex"}
    found = [counted(len(data[key]), noun) for key, noun in nouns.items() if data.get(key)]
    if any(data.get("softness", [])):
        found.append("painted softness")
    return ", ".join(found) if found else "nothing painted"


def unusable(error: SolverError) -> str:
    """That the session beside a mesh was left alone."""
    return f"The session beside the mesh is left alone, it cannot be read: {error}"


def to_carry(changed: MeshChanged, command: c.OpenSession | c.ContinueWork) -> Question:
    """How a session gets onto its mesh, which has changed."""
    text = (
        f"{whole(changed.path)} has changed since {whole(changed.session.path)} was saved: "
        f"{BECAME[changed.change]}."
    )
    return Question(text + _how_far(changed), (*_ways(changed, command), CANCEL))


def _ways(changed: MeshChanged, command: c.OpenSession | c.ContinueWork) -> Iterator[Answer]:
    """The best first."""
    if changed.change != "other":
        yield Answer("Keep by vertex number", replace(command, mesh=changed.path, carry="numbers"))
    if "places" in changed.session.data and changed.change != "joined":
        yield Answer("Carry to the nearest", replace(command, mesh=changed.path, carry="nearest"))


def _how_far(changed: MeshChanged) -> str:
    if changed.change == "joined":
        return ""
    far = farthest(changed.session.data, changed.mesh)
    if far is None:
        return " The session does not say where they were: painting cannot be carried over."
    lost = " The rest shape cannot be carried." if "rest" in changed.session.data else ""
    return (
        "\n\nPainting can be carried over: each vertex takes what the nearest one of before had, "
        f"which is at most {far:.2%} of the mesh's size away.{lost}"
    )


def carried_over(document: Document) -> str:
    """What was carried over to a changed mesh, and what was not."""
    used = set(document.bound_keys)
    lost = [handle.name for handle in document.handles if handle.key not in used]
    text = f"Carried over to {whole(document.path)}; save to keep it"
    return f"{text}. Without vertices now: {', '.join(lost)}" if lost else text
