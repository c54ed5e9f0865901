"""Puts a session on a mesh that has changed since it was saved."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from scipy.spatial import cKDTree

from app.model.document import Document
from app.model.handles import FREE
from app.model.schema import SessionError
from app.model.session.mesh import Carry, Change, mesh_change, read_places
from app.model.session.reading import Session, to_document
from app.model.settings import SETTINGS
from solver.mesh.mesh import Mesh
from solver.types import FloatArray, IntArray

PAINTED = "role", "softness", "pinned"  # fields with a value a vertex


class MeshChanged(SessionError):
    """A session was saved of another state of its mesh, and nobody has said how to carry it over.

    change: see mesh_change.
    """

    def __init__(self, session: Session, mesh: Mesh, path: Path, change: Change) -> None:
        super().__init__(f"{path}: has changed since {session.path} was saved of it")
        self.session, self.mesh, self.path, self.change = session, mesh, path, change


def on_mesh(session: Session, mesh: Mesh, path: Path, carry: Carry | None = None) -> Document:
    """The document of a session on a mesh. Raises MeshChanged, SessionError."""
    if carry == "numbers":
        return by_numbers(session, mesh, path)
    if carry == "nearest":
        return by_nearest(session, mesh, path)
    change = mesh_change(session.data, mesh)
    if change is not None:
        raise MeshChanged(session, mesh, path, change)
    return to_document(session, mesh, path)


def by_numbers(session: Session, mesh: Mesh, path: Path) -> Document:
    """Every vertex keeps what the one of its number had. Raises SessionError."""
    return to_document(_on_any_mesh(session), mesh, path)


def by_nearest(session: Session, mesh: Mesh, path: Path) -> Document:
    """Every vertex takes what the one had that was nearest to where it is now.

    A handle that was nearest to none gets the free vertices nearest to it, no farther away than an
    edge is long. The rest shape is the file's, and all pieces follow where some did: both are told
    by numbers. Raises SessionError.
    """
    if "places" not in session.data:
        raise SessionError(f"{session.path}: places: missing, where the vertices were is not known")
    places = read_places(session.data["places"])
    before = _on_places(session, places, path)
    document = Document(mesh, path)
    for handle in before.handles:  # in the same order: they get the same keys
        document.change(
            "handles", (*document.handles, document.new_handle(handle.name, handle.pin))
        )
    poses = tuple(document.new_pose(kept.pose, kept.name) for kept in before.poses)
    document.change("poses", poses)
    for name in ("pose", "material", *SETTINGS):
        document.change(name, getattr(before, name))
    nearest = cKDTree(places).query(mesh.vertices)[1]
    for name in PAINTED:
        document.change(name, getattr(before, name)[nearest])
    _keep_handles(document, before, places)
    return document


def _on_places(session: Session, places: FloatArray, path: Path) -> Document:
    """The document of a session, over points that nobody needs to know the faces of."""
    if len(places) < 3:
        raise SessionError(f"{session.path}: places: expected three or more, got {len(places)}")
    data = {key: value for key, value in session.data.items() if key != "rest"}
    settings = data.get("settings", {})
    data["settings"] = {k: v for k, v in settings.items() if not isinstance(v, list)}
    cloud = Mesh.from_arrays(places, np.arange(3)[None])
    return to_document(_on_any_mesh(Session(session.path, data)), cloud, path)


def _on_any_mesh(session: Session) -> Session:
    """The same, not saying how many vertices and faces there are."""
    mesh = {"path": session.data["mesh"]["path"]}
    return Session(session.path, {**session.data, "mesh": mesh})


def _keep_handles(document: Document, before: Document, places: FloatArray) -> None:
    mesh = document.mesh
    tree, corners = cKDTree(mesh.vertices), mesh.vertices[mesh.faces]
    edge = float(np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).mean())
    for handle in before.handles:
        old: IntArray = before.vertices_of(handle.key)
        if not len(old) or len(document.vertices_of(handle.key)):
            continue
        distances, near = tree.query(places[old])
        found = np.unique(near[distances <= edge])
        document.change("role", handle.key, found[document.role[found] == FREE])
