"""Session files: everything a person decided about a mesh, as JSON.

Reading is strict: what is unknown or of the wrong type is refused by name. What a session is to
hold is a line in SESSION, one in `to_document` and one in writing.py.
"""

from __future__ import annotations

import itertools
from pathlib import Path
from typing import Any

import numpy as np

from app.model import schema
from app.model.document import Document
from app.model.handles import FIXED, FREE, NO_TURN
from app.model.reach import Reach
from app.model.schema import SessionError
from app.model.session.mesh import MESH, PLACES
from app.model.session.poses import POSES, kept_poses, turned
from app.model.session.unsaved import UNSAVED
from app.model.session.writing import FORMAT, VERSION
from app.model.settings import SETTINGS
from solver.errors import SolverError
from solver.mesh.mesh import Mesh
from solver.mesh.sizes import check_sizes
from solver.softness.material import PRESETS, Material
from solver.storage import read_bytes

# Each takes four columns of the basis; more than some hundred fit into no memory.
MOST_HANDLES = 2000


def _material(value: Any, where: str) -> str | Material:
    if isinstance(value, dict):
        gains = {"bending": schema.gain, "stretching": schema.gain}
        return Material(**schema.fields(gains, required=("bending", "stretching"))(value, where))
    if not isinstance(value, str) or value not in PRESETS:
        raise schema.refuse(where, f"one of {', '.join(PRESETS)} or two gains", value)
    return value


_HANDLE = schema.fields(
    {
        "name": schema.text,
        "vertices": schema.list_of(schema.count),
        "transform": schema.transform,
        "turn": schema.turn,
    }
)
SESSION = schema.fields(
    {
        "format": schema.that(lambda v: v == FORMAT, f'"{FORMAT}"'),
        "version": schema.that(lambda v: type(v) is int and v == VERSION, str(VERSION)),
        "mesh": MESH,
        "places": PLACES,
        "fixed": schema.list_of(schema.count),
        "handles": schema.list_of(_HANDLE, MOST_HANDLES),
        "pins": schema.list_of(_HANDLE, MOST_HANDLES),
        "rest": schema.list_of(schema.point),
        "poses": POSES,
        "softness": schema.list_of(schema.share),
        "material": _material,
        "unsaved": UNSAVED,
        "settings": schema.fields(
            {name: schema.that(s.accepts, s.expected) for name, s in SETTINGS.items()}
        ),
    },
    required=("format", "version", "mesh"),
)


class Session:
    """A session file that is right in itself; whether it fits a mesh, `to_document` says.

    path: of the file. mesh_path: of the mesh it names. data: checked, absent keys absent.
    """

    def __init__(self, path: Path, data: dict[str, Any]) -> None:
        self.path = path
        self.data = data
        self.mesh_path = path.parent / data["mesh"]["path"]


def read_session(path: Path) -> Session:
    """Read and check a session file. Raises FileError or SessionError."""
    try:
        return Session(path, SESSION(schema.parse(read_bytes(path)), ""))
    except SessionError as error:
        raise SessionError(f"{path}: {error}") from error


def to_document(session: Session, mesh: Mesh, mesh_path: Path) -> Document:
    """The document a session describes. Raises SessionError where it does not fit the mesh."""
    document = Document(mesh, mesh_path)
    data = session.data
    try:
        _check_counts(data["mesh"], mesh)
        _give_role(document, data.get("fixed", []), FIXED, "fixed")
        for kind in ("handles", "pins"):
            for number, entry in enumerate(data.get(kind, [])):
                _add_handle(document, entry, kind == "pins", f"{kind}[{number}]")
        _set_rest(document, data.get("rest"))
        document.change("poses", kept_poses(document, data.get("poses", [])))
        _check_reach(document)
        _set_softness(document, data.get("softness"))
        _check_pieces(data.get("settings", {}).get("attach", True), mesh)
    except SolverError as error:
        raise SessionError(f"{session.path}: {error}") from error
    document.change("material", data.get("material", document.material))
    for name, value in data.get("settings", {}).items():
        document.change(name, value)
    return document


def _add_handle(document: Document, entry: dict[str, Any], pin: bool, where: str) -> None:
    handle = document.new_handle(entry.get("name", ""), pin)
    document.change("handles", (*document.handles, handle))
    if "transform" in entry:
        document.change("pose", document.pose.moved(handle.key, entry["transform"], NO_TURN))
    if "turn" in entry:
        pose = turned(document.pose, handle.key, entry["turn"], f"{where}.turn")
        document.change("pose", pose)
    _give_role(document, entry.get("vertices", []), handle.key, f"{where}.vertices")


def _check_reach(document: Document) -> None:
    """Raises ConstraintError where a handle goes too far for the size of the mesh."""
    reach, number = Reach(document), {False: itertools.count(), True: itertools.count()}
    for handle in document.handles:
        where = f"{'pins' if handle.pin else 'handles'}[{next(number[handle.pin])}].transform"
        reach.check(document.pose.of(handle.key), where)
    for place, kept in enumerate(document.poses):
        for key, T in kept.pose.transforms.items():
            found = document.find(key)
            reach.check(
                T, f"poses[{place}].transforms.{schema.escaped(found.name if found else '')}"
            )


def _check_counts(expected: dict[str, Any], mesh: Mesh) -> None:
    for name, found in (("vertices", len(mesh.vertices)), ("faces", len(mesh.faces))):
        if expected.get(name, found) != found:
            raise SessionError(
                f"mesh.{name}: expected {found}, as the mesh has, got {expected[name]}"
            )


def _check_pieces(attach: bool | list[int], mesh: Mesh) -> None:
    if isinstance(attach, bool):
        return
    count = int(mesh.pieces.max()) + 1
    for i, number in enumerate(attach):
        if number >= count:
            raise SessionError(f"settings.attach[{i}]: expected 0 to {count - 1}, got {number}")


def _give_role(document: Document, vertices: list[int], role: int, where: str) -> None:
    size = len(document.role)
    seen: set[int] = set()
    for i, vertex in enumerate(vertices):
        if vertex >= size:
            raise SessionError(f"{where}[{i}]: expected 0 to {size - 1}, got {vertex}")
        if vertex in seen:
            raise SessionError(f"{where}[{i}]: expected each vertex once, got {vertex} twice")
        if document.role[vertex] != FREE:
            raise SessionError(
                f"{where}[{i}]: expected one role a vertex, got {vertex}, which has one already"
            )
        seen.add(vertex)
    document.change("role", role, np.array(vertices, dtype=np.int64))


def _set_rest(document: Document, rest: list[list[float]] | None) -> None:
    if rest is None:
        return
    count = len(document.mesh.vertices)
    if len(rest) != count:
        raise SessionError(f"rest: expected {count} positions, one a vertex, got {len(rest)}")
    positions = np.array(rest, dtype=np.float64)
    check_sizes(positions, document.mesh.faces, "rest")
    document.change("rest", document.new_rest(positions))


def _set_softness(document: Document, softness: list[float] | None) -> None:
    if softness is None:
        return
    if len(softness) != len(document.softness):
        raise SessionError(
            f"softness: expected {len(document.softness)} numbers, one a vertex, "
            f"got {len(softness)}"
        )
    document.change("softness", np.array(softness, dtype=np.float64))
