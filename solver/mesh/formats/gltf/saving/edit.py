"""A glTF file under change: data is written in place where nobody else uses it, else appended."""

from __future__ import annotations

import copy
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from solver.mesh.formats.gltf.accessors import FLOAT, stored
from solver.mesh.formats.gltf.container import Bytes, Gltf
from solver.mesh.formats.gltf.saving.occupancy import Occupancy, references
from solver.mesh.formats.gltf.schema import Json
from solver.mesh.formats.narrowing import narrowed
from solver.types import BoolArray, FloatArray


class Edit:
    """A copy of a file that takes new values for accessors, and new accessors."""

    def __init__(self, gltf: Gltf) -> None:
        self.json: Json = copy.deepcopy(gltf.json)
        self.changed = False
        self.gltf = gltf
        self._copies: dict[int, Bytes] = {}
        self._references = references(gltf.json)
        self._occupancy = Occupancy(gltf.json)
        # New data goes behind the first buffer, which is the one inside a GLB.
        buffers = gltf.entries("buffers")
        whole = bool(buffers) and len(gltf.buffers[0]) >= buffers[0]["byteLength"]
        first = whole and "extensions" not in buffers[0]
        self._home = 0 if first else len(buffers)
        self._end = len(gltf.buffers[0]) if first else 0
        self._appended: list[bytes] = []

    def replace(self, number: int, users: int, rows: BoolArray, values: FloatArray) -> int:
        """Give an accessor new values in some rows, and return its number.

        users: how many references to it are meant. Where there are more, or where its data has
        another form than float32 of its own, they get an accessor to themselves.
        """
        self.changed = True
        if self._references[number] != users or not self._can_overwrite(number):
            return self.append(self.gltf.json["accessors"][number], values)
        accessor = self.json["accessors"][number]
        view = self.json["bufferViews"][accessor["bufferView"]]
        if view["buffer"] not in self._copies:
            self._copies[view["buffer"]] = self.gltf.buffers[view["buffer"]].copy()
        window = stored(self._copies[view["buffer"]], accessor, view)
        window[rows] = narrowed(values[rows], "<f4")
        _set_bounds(accessor, window)
        return number

    def append(self, like: Json, values: FloatArray, **members: int) -> int:
        """Add an accessor of float32 values (count, width), the rest as in another one; further
        members are for its buffer view."""
        data = narrowed(values, "<f4")
        form = ("bufferView", "byteOffset", "normalized", "sparse")
        accessor = {key: entry for key, entry in like.items() if key not in form}
        accessor["bufferView"] = self.append_bytes(data.tobytes(), **members)
        accessor |= {"componentType": FLOAT, "count": len(data)}
        _set_bounds(accessor, data)
        self.json.setdefault("accessors", []).append(accessor)
        return len(self.json["accessors"]) - 1

    def append_bytes(self, data: bytes, **members: int) -> int:
        """Add a buffer view of the data, with further members of its JSON."""
        self.changed = True
        padding = -self._end % 4
        self._appended += [bytes(padding), data]
        view = {"buffer": self._home, "byteOffset": self._end + padding, "byteLength": len(data)}
        self._end += padding + len(data)
        self.json.setdefault("bufferViews", []).append(view | members)
        return len(self.json["bufferViews"]) - 1

    def finished(self) -> Gltf:
        """The file as it is now. Buffers with changes lose their URI: what it names has others."""
        buffers = dict(enumerate(self.gltf.buffers)) | self._copies
        if self._appended:
            entries = self.json.setdefault("buffers", [])
            if self._home == len(entries):
                entries.append({"byteLength": 0})
            old = buffers.get(self._home, np.empty(0, np.uint8))
            new = np.frombuffer(b"".join(self._appended), np.uint8)
            buffers[self._home] = np.concatenate([old, new])
            entries[self._home]["byteLength"] = self._end
        for number, buffer in buffers.items():
            if number >= len(self.gltf.buffers) or buffer is not self.gltf.buffers[number]:
                self.json["buffers"][number].pop("uri", None)
        in_order = tuple(buffers[number] for number in range(len(buffers)))
        return replace(self.gltf, json=self.json, buffers=in_order)

    def _can_overwrite(self, number: int) -> bool:
        accessor = self.gltf.json["accessors"][number]
        if (
            accessor["componentType"] != FLOAT
            or "sparse" in accessor
            or "bufferView" not in accessor
        ):
            return False
        # An extension may hold the same data in another form, which would contradict.
        view = self.gltf.json["bufferViews"][accessor["bufferView"]]
        return "extensions" not in view and self._occupancy.is_private(number)


def _set_bounds(accessor: Json, values: NDArray[np.float32]) -> None:
    """Bring the bounds that an accessor states up to date."""
    for key, bound in (("min", np.min), ("max", np.max)):
        if key in accessor and len(values):
            accessor[key] = bound(values, axis=0).tolist()
