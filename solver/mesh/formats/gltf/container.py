"""The two containers of glTF: GLB, one file of chunks, and .gltf, JSON with data beside it."""

from __future__ import annotations

import json
import struct
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from solver.errors import MeshError
from solver.mesh.formats.gltf.schema import Json, check_schema
from solver.mesh.formats.gltf.uris import read_uri
from solver.nesting import DEEPEST, is_deep

Bytes = NDArray[np.uint8]
MAGIC = b"glTF"
JSON_CHUNK, BINARY_CHUNK = b"JSON", b"BIN\0"


@dataclass(frozen=True, eq=False)
class Gltf:
    """A glTF file in memory.

    json: checked against the schema.  buffers: the bytes of each, none where the file has none.
    name: its path.  folder: where the files it names are.  data: the file as it was, empty for one
    made here.  chunks: what follows the two known chunks of a GLB.
    """

    json: Json
    buffers: tuple[Bytes, ...]
    name: str
    folder: Path
    data: bytes = b""
    chunks: bytes = b""

    @property
    def is_binary(self) -> bool:
        """Whether it was read from a GLB."""
        return self.data.startswith(MAGIC)

    def entries(self, key: str) -> list[Any]:
        """The list of that name at the top of the JSON."""
        entries: list[Any] = self.json.get(key, [])
        return entries

    def error(self, message: str) -> MeshError:
        """An error about this file."""
        return MeshError(f"{self.name}: {message}")


def open_gltf(data: bytes, name: str) -> Gltf:
    """Take a GLB or .gltf apart and read the buffers beside it.

    What the file is says its content, not its suffix. Raises MeshError in one line.
    """
    if not data.strip():
        raise MeshError(f"{name}: the file is empty, expected a glTF mesh")
    text, binary, rest = _chunks(data, name) if data.startswith(MAGIC) else (data, None, b"")
    root = _parsed(text, name)
    if isinstance(root, dict) and isinstance(root.get("asset"), dict):
        version = str(root["asset"].get("version", "2.0"))
        if not version.startswith("2."):
            raise MeshError(f"{name}: glTF of version {version[:20]!r}, expected 2.0")
    check_schema(root, name)
    gltf = Gltf(root, (), name, Path(name).resolve().parent, data, rest)
    buffers = (_buffer(gltf, i, binary) for i in range(len(gltf.entries("buffers"))))
    return replace(gltf, buffers=tuple(buffers))


def _parsed(text: bytes, name: str) -> Any:
    try:
        root = json.loads(text.decode("utf-8-sig"))
    except (ValueError, RecursionError) as error:
        reason = str(error).splitlines()[0]
        raise MeshError(f"{name}: not a glTF file, its JSON cannot be read: {reason}") from error
    if is_deep(root):
        raise MeshError(f"{name}: its JSON is nested too deeply, expected {DEEPEST} levels or less")
    return root


def _chunks(data: bytes, name: str) -> tuple[bytes, Bytes | None, bytes]:
    """The JSON, the binary chunk if there is one, and everything behind."""
    version, end = struct.unpack_from("<II", data.ljust(12, b"\0"), 4)
    if version != 2:
        raise MeshError(f"{name}: GLB of version {version}, expected 2")
    if end > len(data):
        raise MeshError(f"{name}: the file ends early, got {len(data)} bytes, expected {end}")
    text, at = _chunk(data, 12, end, name)
    if data[16:20] != JSON_CHUNK:
        raise MeshError(f"{name}: the first chunk is not JSON")
    if data[at + 4 : at + 8] != BINARY_CHUNK or at + 8 > end:
        return text.tobytes(), None, data[at:end]
    binary, at = _chunk(data, at, end, name)
    return text.tobytes(), binary, data[at:end]


def _chunk(data: bytes, at: int, end: int, name: str) -> tuple[Bytes, int]:
    """The content of the chunk at a place, and where the next one starts."""
    size = struct.unpack_from("<I", data, at)[0] if at + 8 <= end else end
    if at + 8 + size > end:
        raise MeshError(f"{name}: the file ends early, a chunk of {size} bytes starts at {at}")
    return np.frombuffer(data, np.uint8, size, at + 8), at + 8 + size


def _buffer(gltf: Gltf, number: int, binary: Bytes | None) -> Bytes:
    uri = gltf.json["buffers"][number].get("uri")
    if uri is None:
        # A buffer without data may stand in for compressed ones; whoever reads it is refused.
        return binary if number == 0 and binary is not None else np.empty(0, np.uint8)
    try:
        return np.frombuffer(read_uri(uri, gltf.folder), np.uint8)
    except ValueError as error:
        raise gltf.error(f"buffer {number}: {error}") from error
