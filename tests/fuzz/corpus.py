"""What is damaged: small files by the project's own writers, and those of `kept/`."""

from __future__ import annotations

import json
import struct
import tempfile
from functools import cache
from pathlib import Path

import numpy as np

from app.model.document import Document
from app.model.session.writing import write_session
from solver import Material, Mesh, load_mesh
from solver.mesh.formats.table import FORMATS
from tests.solver import shapes

KEPT = Path(__file__).parent / "kept"


def small_mesh() -> Mesh:
    """Twelve vertices, which are no plane."""
    V, F = shapes.grid(4, 3)
    return Mesh.from_arrays(V + 0.1 * np.random.default_rng(0).normal(size=V.shape), F)


@cache
def mesh_files() -> dict[str, bytes]:
    """Whole files of every format by name; the suffix is the format's."""
    mesh = small_mesh()
    files = {path.name: path.read_bytes() for path in sorted(KEPT.iterdir())}
    with tempfile.TemporaryDirectory() as folder:
        for source in [mesh, *(load_mesh(path) for path in sorted(KEPT.glob("rich*")))]:
            for suffix in FORMATS:
                path = Path(folder) / f"{len(files)}{suffix}"
                poses = {"up": source.vertices + 1} if suffix in (".glb", ".gltf") else None
                source.save(path, source.vertices, poses)
                files[path.name] = path.read_bytes()
    return files


@cache
def session_file() -> bytes:
    """A session of `small_mesh` in which every key is written."""
    document = Document(small_mesh(), Path("mesh.obj"))
    document.change("role", 1, np.array([0, 4, 8]))
    for vertex, pin in ((3, False), (7, True), (11, False)):
        handle = document.new_handle(pin=pin)
        document.change("handles", (*document.handles, handle))
        document.change("role", handle.key, np.array([vertex]))
        T = np.eye(4)
        T[:3, 3] = 0.1 * vertex
        document.change("pose", document.pose.moved(handle.key, T, np.array([0.0, 0.0, 7.0])))
    document.change("poses", (document.new_pose(document.pose),))
    document.change("softness", np.linspace(0, 1, 12))
    document.change("material", Material(0.5, 2))
    document.change("rest", document.new_rest(document.mesh.vertices * 1.5))
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "session.json"
        write_session(path, document)
        return path.read_bytes()


def glb_json(data: bytes) -> bytes:
    """The JSON of a GLB."""
    (length,) = struct.unpack_from("<I", data, 12)
    return data[20 : 20 + length]


def with_glb_json(data: bytes, text: bytes) -> bytes:
    """A GLB with other JSON, its lengths right."""
    rest = data[20 + len(glb_json(data)) :]
    text += b" " * (-len(text) % 4)
    head = struct.pack("<4sII", b"glTF", 2, 20 + len(text) + len(rest))
    return head + struct.pack("<I4s", len(text), b"JSON") + text + rest


def is_json(name: str) -> bool:
    """Whether a file is JSON that can be parsed."""
    if not name.endswith(".gltf"):
        return False
    try:
        json.loads(mesh_files()[name])
    except (ValueError, RecursionError):
        return False
    return True
