"""Who uses which bytes of a glTF file, so that nothing else changes with what is written."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

import numpy as np

from solver.mesh.formats.gltf.accessors import COMPONENTS, WIDTHS
from solver.mesh.formats.gltf.schema import Json


def references(root: Json) -> Counter[int]:
    """How often each accessor is used."""
    return Counter(_references(root))


class Occupancy:
    """The bytes of every accessor, and of every buffer view that serves something else."""

    def __init__(self, root: Json) -> None:
        rows = list(_accessor_bytes(root))
        owned = {accessor.get("bufferView") for accessor in root.get("accessors", [])}
        free = set(range(len(root.get("bufferViews", [])))) - owned
        rows += [_view_bytes(root, view) for view in free]
        self._bytes = np.array(rows, dtype=np.int64).reshape(-1, 6)

    def is_private(self, accessor: int) -> bool:
        """Whether its bytes are no other's; interleaved ones lie between each other's."""
        own = self._bytes[self._bytes[:, 0] == accessor]
        if not len(own):
            return False
        _, buffer, start, stop, stride, size = own[0].tolist()
        others = self._bytes[self._bytes[:, 0] != accessor]
        meets = (others[:, 1] == buffer) & (others[:, 2] < stop) & (others[:, 3] > start)
        others = others[meets]
        ahead = (others[:, 2] - start) % max(stride, 1)
        between = (others[:, 4] == stride) & (ahead >= size) & (ahead + others[:, 5] <= stride)
        return stride >= size and bool(between.all())


def _references(root: Json) -> Iterator[int]:
    for mesh in root.get("meshes", []):
        for primitive in mesh["primitives"]:
            yield from primitive["attributes"].values()
            for target in primitive.get("targets", []):
                yield from target.values()
            if "indices" in primitive:
                yield primitive["indices"]
    for skin in root.get("skins", []):
        if "inverseBindMatrices" in skin:
            yield skin["inverseBindMatrices"]
    for animation in root.get("animations", []):
        for sampler in animation["samplers"]:
            yield from (sampler["input"], sampler["output"])


def _accessor_bytes(root: Json) -> Iterator[tuple[int, ...]]:
    """Accessor, buffer, start, stop, stride and size of an element, where there is data."""
    for number, accessor in enumerate(root.get("accessors", [])):
        if "bufferView" in accessor:
            view = root["bufferViews"][accessor["bufferView"]]
            kind, width = COMPONENTS.get(accessor["componentType"]), WIDTHS.get(accessor["type"])
            if kind is None or width is None:
                yield (number, *_view_bytes(root, accessor["bufferView"])[1:])
                continue
            size = kind.itemsize * width
            stride = view.get("byteStride") or size
            start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
            stop = start + stride * (accessor["count"] - 1) + size
            yield number, view["buffer"], start, stop, stride, size


def _view_bytes(root: Json, number: int) -> tuple[int, ...]:
    """The same for a whole buffer view, which belongs to no accessor."""
    view = root["bufferViews"][number]
    start = view.get("byteOffset", 0)
    return -1, view["buffer"], start, start + view["byteLength"], 0, view["byteLength"]
