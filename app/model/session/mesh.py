"""What a session remembers of its mesh, so that it is never put on a changed one unseen.

Two hashes tell whether the vertices are where they were and joined as they were. Where something
is painted, the places of all vertices are kept too, to 1/65535 of the mesh's size: 8 letters a
vertex, with which painting finds its way to a mesh that is numbered anew.
"""

from __future__ import annotations

import base64
import binascii
import hashlib
from collections.abc import Callable
from typing import Any, Literal
from weakref import WeakKeyDictionary

import numpy as np
from scipy.spatial import cKDTree

from app.model import schema
from app.model.document import Document
from app.model.handles import FREE
from solver.geometry.bounding_box import diagonal
from solver.mesh.mesh import Mesh
from solver.types import FloatArray

Carry = Literal["numbers", "nearest"]  # painting goes by the vertices' numbers, or their places
Change = Literal["joined", "moved", "other"]
STEPS = 65535
DIGEST = 16  # bytes
_HASHES: WeakKeyDictionary[Mesh, dict[str, Any]] = WeakKeyDictionary()
_PLACES: WeakKeyDictionary[Mesh, dict[str, Any]] = WeakKeyDictionary()

_HASH = schema.fields(
    {"vertices": schema.text, "faces": schema.text}, required=("vertices", "faces")
)
MESH = schema.fields(
    {"path": schema.text, "vertices": schema.count, "faces": schema.count, "hash": _HASH},
    required=("path",),
)


def _points(value: Any, where: str) -> FloatArray:
    """(n, 3) integers from 0 to STEPS, as floats."""
    try:
        data = base64.b64decode(value if isinstance(value, str) else "?", validate=True)
    except (binascii.Error, ValueError):
        data = b"?"
    if len(data) % 6:
        raise schema.refuse(where, "three numbers of 16 bits a vertex, in base64", value)
    return np.frombuffer(data, dtype="<u2").reshape(-1, 3).astype(np.float64)


PLACES = schema.fields(
    {"low": schema.point, "high": schema.point, "points": _points},
    required=("low", "high", "points"),
)


def written_mesh(mesh: Mesh) -> dict[str, Any]:
    """What MESH passes again, but for the path."""
    return {"vertices": len(mesh.vertices), "faces": len(mesh.faces), "hash": mesh_hash(mesh)}


def written_places(document: Document) -> dict[str, Any] | None:
    """What PLACES passes again; None where nothing is painted."""
    if not ((document.role != FREE).any() or document.softness.any()):
        return None
    return mesh_places(document.mesh)


def mesh_places(mesh: Mesh) -> dict[str, Any]:
    """Where its vertices are; found once."""
    return _known(_PLACES, mesh, _placed)


def _placed(mesh: Mesh) -> dict[str, Any]:
    low, high = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
    shares = (mesh.vertices - low) / np.where(high > low, high - low, 1.0)
    points = np.rint(shares * STEPS).astype("<u2").tobytes()
    text = base64.b64encode(points).decode("ascii")
    return {"low": low.tolist(), "high": high.tolist(), "points": text}


def read_places(places: dict[str, Any]) -> FloatArray:
    """(n, 3) where the vertices were, from what PLACES has passed."""
    low, high = np.array(places["low"]), np.array(places["high"])
    return np.asarray(low + places["points"] / STEPS * (high - low))


def mesh_hash(mesh: Mesh) -> dict[str, Any]:
    """Of the positions, in single precision, and of the polygons over them."""
    return _known(_HASHES, mesh, _hashed)


def _hashed(mesh: Mesh) -> dict[str, Any]:
    positions = mesh.vertices.astype("<f4") + np.float32(0.0)  # no zero is negative
    outlines = mesh.outlines
    polygons = outlines.sizes.astype("<i4").tobytes() + outlines.corners.astype("<i4").tobytes()
    return {"vertices": _digest(positions.tobytes()), "faces": _digest(polygons)}


def mesh_change(data: dict[str, Any], mesh: Mesh) -> Change | None:
    """What has become of the mesh of a session.

    joined: only how its vertices are joined is different.  moved: only where they are.
    other: both.  None: nothing, or an older file does not say.
    """
    before, now = data["mesh"].get("hash"), mesh_hash(mesh)
    if before is None or before == now:
        return None
    if before["vertices"] == now["vertices"]:
        return "joined"
    return "moved" if before["faces"] == now["faces"] else "other"


def farthest(data: dict[str, Any], mesh: Mesh) -> float | None:
    """How far a vertex is at most from the nearest one of before, as a share of the mesh's size.

    None where a session does not say where they were.
    """
    if "places" not in data:
        return None
    distances, _ = cKDTree(read_places(data["places"])).query(mesh.vertices)
    return float(distances.max() / diagonal(mesh.vertices))


def _known(
    known: WeakKeyDictionary[Mesh, dict[str, Any]],
    mesh: Mesh,
    compute: Callable[[Mesh], dict[str, Any]],
) -> dict[str, Any]:
    """Computed once a mesh: its session is saved again and again."""
    if mesh not in known:
        known[mesh] = compute(mesh)
    return known[mesh]


def _digest(data: bytes) -> str:
    return hashlib.blake2b(data, digest_size=DIGEST).hexdigest()
