"""Accessors: typed arrays in the buffers of a glTF file, of any layout, as NumPy arrays."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from solver.mesh.formats.gltf.container import Bytes, Gltf
from solver.mesh.formats.gltf.schema import Json
from solver.mesh.formats.narrowing import widened
from solver.types import FloatArray, IntArray

COMPONENTS: Mapping[int, np.dtype[Any]] = {
    5120: np.dtype("<i1"),
    5121: np.dtype("<u1"),
    5122: np.dtype("<i2"),
    5123: np.dtype("<u2"),
    5125: np.dtype("<u4"),
    5126: np.dtype("<f4"),
}
FLOAT = 5126
WIDTHS: Mapping[str, int] = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
# An accessor needs no data of its own, so a short file may ask for any amount of memory.
MOST_ELEMENTS = 1 << 26
MOST_WITHOUT_DATA = 1 << 23


def read_floats(gltf: Gltf, number: int, kind: str) -> FloatArray:
    """An accessor of the given type as (count, width) float64; normalised integers in [-1, 1].

    Raises MeshError where its type is another or the file does not hold its data.
    """
    raw = _read(gltf, number, kind)
    values = widened(raw)
    if raw.dtype.kind != "f" and gltf.json["accessors"][number].get("normalized"):
        values = np.maximum(values / np.iinfo(raw.dtype).max, -1.0)
    return values


def read_integers(gltf: Gltf, number: int, kind: str) -> IntArray:
    """An accessor of the given type as (count, width) int64."""
    raw = _read(gltf, number, kind)
    if raw.dtype.kind == "f":
        raise gltf.error(f"accessor {number}: expected whole numbers, got floats")
    return raw.astype(np.int64)


def stored(buffer: Bytes, accessor: Json, view: Json) -> NDArray[Any]:
    """(count, width) window onto the data of an accessor within its buffer."""
    kind, width = COMPONENTS[accessor["componentType"]], WIDTHS[accessor["type"]]
    start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
    stride = view.get("byteStride") or kind.itemsize * width
    shape = (accessor["count"], width)
    return np.ndarray(shape, kind, buffer, start, (stride, kind.itemsize))


def _read(gltf: Gltf, number: int, kind: str) -> NDArray[Any]:
    accessor = gltf.json["accessors"][number]
    where = f"accessor {number}"
    if accessor["type"] != kind:
        raise gltf.error(f"{where}: expected type {kind}, got {accessor['type'][:20]!r}")
    if accessor["componentType"] not in COMPONENTS:
        raise gltf.error(f"{where}: unknown component type {accessor['componentType']}")
    if accessor["count"] > MOST_ELEMENTS:
        raise gltf.error(f"{where}: {accessor['count']} elements, expected {MOST_ELEMENTS} or less")
    if "bufferView" in accessor:
        values = _window(gltf, accessor, accessor["bufferView"], where)
    else:
        if accessor["count"] > MOST_WITHOUT_DATA:
            expected = f"expected {MOST_WITHOUT_DATA} or less"
            raise gltf.error(f"{where}: {accessor['count']} elements without data, {expected}")
        shape = (accessor["count"], WIDTHS[kind])
        values = np.zeros(shape, COMPONENTS[accessor["componentType"]])
    return _with_sparse(gltf, accessor, values, where) if "sparse" in accessor else values


def _with_sparse(gltf: Gltf, accessor: Json, values: NDArray[Any], where: str) -> NDArray[Any]:
    """The values with those that the accessor lists on their own put in place."""
    sparse = accessor["sparse"]
    count = sparse["count"]
    if count > accessor["count"] or sparse["indices"]["componentType"] not in (5121, 5123, 5125):
        raise gltf.error(f"{where}: sparse values that do not fit its {accessor['count']} elements")
    index_kind = {"count": count, "type": "SCALAR", **sparse["indices"]}
    value_kind = {
        "count": count,
        "type": accessor["type"],
        "componentType": accessor["componentType"],
        "byteOffset": sparse["values"].get("byteOffset", 0),
    }
    at = _window(gltf, index_kind, sparse["indices"]["bufferView"], f"{where}, sparse")[:, 0]
    if count and at.max() >= accessor["count"]:
        raise gltf.error(f"{where}: a sparse value for element {at.max()}, which it does not have")
    values = values.copy()
    values[at] = _window(gltf, value_kind, sparse["values"]["bufferView"], f"{where}, sparse")
    return values


def _window(gltf: Gltf, accessor: Json, number: int, where: str) -> NDArray[Any]:
    """`stored`, once its bytes are known to be there."""
    view = gltf.json["bufferViews"][number]
    buffer = gltf.buffers[view["buffer"]]
    size = COMPONENTS[accessor["componentType"]].itemsize * WIDTHS[accessor["type"]]
    stride = view.get("byteStride") or size
    count = accessor["count"]
    end = accessor.get("byteOffset", 0) + (count and stride * (count - 1) + size)
    if end > view["byteLength"]:
        raise gltf.error(
            f"{where}: ends at byte {end} of buffer view {number}, which has {view['byteLength']}"
        )
    if view.get("byteOffset", 0) + end > len(buffer):
        raise gltf.error(
            f"{where}: ends at byte {view.get('byteOffset', 0) + end} of buffer {view['buffer']}, "
            f"which has {len(buffer)}"
        )
    # NumPy does not place an empty window behind the end.
    return stored(buffer, accessor, view) if count else np.empty((0, WIDTHS[accessor["type"]]))
