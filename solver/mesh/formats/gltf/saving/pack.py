"""A glTF file as bytes: a GLB, or JSON with its data inside."""

from __future__ import annotations

import json
import mimetypes
import struct

from solver.errors import MeshError
from solver.mesh.formats.gltf.container import BINARY_CHUNK, JSON_CHUNK, MAGIC, Gltf
from solver.mesh.formats.gltf.saving.edit import Edit
from solver.mesh.formats.gltf.schema import Json
from solver.mesh.formats.gltf.uris import data_uri, is_data, read_uri

# The header has 32 bits for the length.
LARGEST = 2**32 - 1
_IMAGES = {".ktx2": "image/ktx2", ".dds": "image/vnd-ms.dds", ".webp": "image/webp"}


def take_in_images(edit: Edit) -> None:
    """Bring the images beside the file into it; one that is not there stays a name."""
    for image in edit.json.get("images", []):
        uri = image.get("uri", "data:")
        suffix = "." + uri.rpartition(".")[2].lower()
        mime = image.get("mimeType") or _IMAGES.get(suffix) or mimetypes.guess_type("a" + suffix)[0]
        if is_data(uri) or not mime:
            continue
        try:
            data = read_uri(uri, edit.gltf.folder)
        except ValueError:
            continue
        del image["uri"]
        image |= {"bufferView": edit.append_bytes(data), "mimeType": mime}


def has_all_buffers(gltf: Gltf) -> bool:
    """Whether no buffer is a file beside it."""
    return all(is_data(buffer.get("uri", "data:")) for buffer in gltf.entries("buffers"))


def to_gltf(gltf: Gltf, keeps_names: bool) -> bytes:
    """JSON with every buffer in it; keeps_names: but those that it names beside it."""
    root = dict(gltf.json)
    root["buffers"] = [_entry(gltf, i, keeps_names) for i in range(len(gltf.buffers))]
    if not gltf.buffers:
        del root["buffers"]
    return json.dumps(root, indent=2).encode()


def to_glb(gltf: Gltf, keeps_names: bool) -> bytes:
    """One file: JSON, the first buffer, and what else there was."""
    root, binary = dict(gltf.json), b""
    if gltf.buffers:
        first, buffer = gltf.json["buffers"][0], gltf.buffers[0]
        if len(buffer) and (is_data(first.get("uri", "data:")) or not keeps_names):
            first = {key: value for key, value in first.items() if key != "uri"}
            binary = _chunk(BINARY_CHUNK, buffer.tobytes(), b"\0")
        others = (_entry(gltf, i, keeps_names) for i in range(1, len(gltf.buffers)))
        root["buffers"] = [first, *others]
    text = json.dumps(root, separators=(",", ":")).encode()
    body = _chunk(JSON_CHUNK, text, b" ") + binary + gltf.chunks
    if len(body) + 12 > LARGEST:
        raise MeshError(f"{len(body)} bytes, expected less than 4 GiB in a GLB; save it as .gltf")
    return MAGIC + struct.pack("<II", 2, 12 + len(body)) + body


def _entry(gltf: Gltf, number: int, keeps_names: bool) -> Json:
    """The JSON of a buffer, with its data where it does not stay outside."""
    entry: Json = gltf.json["buffers"][number]
    buffer, uri = gltf.buffers[number], entry.get("uri")
    if not len(buffer) or (uri is not None and (is_data(uri) or keeps_names)):
        return entry
    return entry | {"uri": data_uri(buffer.tobytes())}


def _chunk(kind: bytes, data: bytes, filler: bytes) -> bytes:
    data += filler * (-len(data) % 4)
    return struct.pack("<I", len(data)) + kind + data
