"""Writing session files: what a document says under each key, see app/model/session/reading.py."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from app.model.document import Document
from app.model.handles import Handle
from app.model.session.mesh import written_mesh, written_places
from app.model.session.pieces import json_pieces
from app.model.session.poses import handle_names, written_poses, written_turn
from app.model.settings import SETTINGS
from solver.softness.material import Material
from solver.storage import write_atomically

FORMAT = "surface-deformation-session"
VERSION = 1


def write_session(path: Path, document: Document) -> None:
    """Write the document as a session file, the mesh relative to it. Raises FileError."""
    pieces = session_pieces(document, {"path": _relative(document.path, path)})
    write_atomically(path, b"".join(pieces))


def session_pieces(
    document: Document, mesh: Mapping[str, Any], **more: Mapping[str, Any]
) -> Iterator[bytes]:
    """What a session file holds, a thousand numbers or so at a time.

    mesh, more: what it says under these keys besides. The document must not change meanwhile.
    """
    start = "{\n"
    for key, value in _content(document, mesh, more).items():
        yield f"{start} {json.dumps(key)}: ".encode()
        for piece in json_pieces(value):
            yield piece.encode()
        start = ",\n"
    yield b"\n}\n"


def _content(
    document: Document, file: Mapping[str, Any], more: Mapping[str, Any]
) -> dict[str, Any]:
    material, names = document.material, handle_names(document)
    painted, pins = ([h for h in document.handles if h.pin is pin] for pin in (False, True))
    data: dict[str, Any] = {
        "format": FORMAT,
        "version": VERSION,
        **more,
        "mesh": {**file, **written_mesh(document.mesh)},
        "fixed": document.fixed,
        "handles": (_handle(document, handle, names) for handle in painted),
        "material": vars(material) if isinstance(material, Material) else material,
        "settings": _settings(document),
    }
    if pins:
        data["pins"] = (_handle(document, handle, names) for handle in pins)
    if document.rest is not None:
        data["rest"] = document.rest_positions
    if document.poses:
        data["poses"] = written_poses(document)
    if document.softness.any():
        data["softness"] = document.softness
    if places := written_places(document):
        data["places"] = places
    return data


def _handle(document: Document, handle: Handle, names: dict[int, str]) -> dict[str, Any]:
    entry = {
        "name": names[handle.key],
        "vertices": document.vertices_of(handle.key),
        "transform": document.pose.of(handle.key),
    }
    turn = written_turn(document.pose, handle.key)
    return entry if turn is None else {**entry, "turn": turn}


def _settings(document: Document) -> dict[str, Any]:
    values = {name: getattr(document, name) for name in SETTINGS}
    return {k: v for k, v in values.items() if SETTINGS[k].written or v != SETTINGS[k].default}


def _relative(mesh_path: Path, session_path: Path) -> str:
    """With forward slashes; absolute where no relative path leads there (another drive)."""
    mesh = mesh_path.resolve()
    try:
        return Path(os.path.relpath(mesh, session_path.resolve().parent)).as_posix()
    except ValueError:
        return mesh.as_posix()
