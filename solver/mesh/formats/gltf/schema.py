"""The JSON of a glTF file, checked before use: a wrong type or a number of nothing is refused.

Only what is read later is checked. Everything else is kept as it is, right or wrong.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from solver.errors import MeshError

Json = dict[str, Any]
# A check takes a value, the words for its place, and the whole JSON.
Check = Callable[[Any, str, Json], None]


def check_schema(root: Any, name: str) -> None:
    """Raises MeshError, in one line that names the file and the place."""
    _FILE(root, f"{name}: the JSON", root)


def _refuse(value: Any, where: str, expected: str) -> MeshError:
    # A list may be as long as the file.
    text = f"a {type(value).__name__}" if isinstance(value, list | dict) else repr(value)[:60]
    return MeshError(f"{where}: expected {expected}, got {text}")


def _is_count(value: Any) -> bool:
    return isinstance(value, int) and not isinstance(value, bool) and 0 <= value < 2**53


def _count(value: Any, where: str, root: Json) -> None:
    if not _is_count(value):
        raise _refuse(value, where, "a count")


def _text(value: Any, where: str, root: Json) -> None:
    if not isinstance(value, str):
        raise _refuse(value, where, "text")


def _flag(value: Any, where: str, root: Json) -> None:
    if not isinstance(value, bool):
        raise _refuse(value, where, "true or false")


def _number_of(key: str) -> Check:
    """The number of an entry of a list at the top."""

    def check(value: Any, where: str, root: Json) -> None:
        entries = root.get(key)
        size = len(entries) if isinstance(entries, list) else 0
        if not _is_count(value) or value >= size:
            raise _refuse(value, where, f"the number of one of {size} {key}")

    return check


def _numbers(size: int | None = None) -> Check:
    """A list of finite numbers."""

    def finite(value: Any) -> bool:
        real = isinstance(value, int | float) and not isinstance(value, bool)
        return real and abs(value) < 1e300 and math.isfinite(value)

    def check(value: Any, where: str, root: Json) -> None:
        right = isinstance(value, list) and len(value) == (len(value) if size is None else size)
        if not right or not all(map(finite, value)):
            raise _refuse(value, where, f"{'' if size is None else f'{size} '}finite numbers")

    return check


def _each(check: Check) -> Check:
    def check_all(value: Any, where: str, root: Json) -> None:
        if not isinstance(value, list):
            raise _refuse(value, where, "a list")
        for i, entry in enumerate(value):
            check(entry, f"{where}[{i}]", root)

    return check_all


def _values(check: Check) -> Check:
    """An object whose every value passes."""

    def check_all(value: Any, where: str, root: Json) -> None:
        if not isinstance(value, dict):
            raise _refuse(value, where, "an object")
        for key, entry in value.items():
            check(entry, f"{where}.{key}", root)

    return check_all


def _object(required: tuple[str, ...] = (), **checks: Check) -> Check:
    """An object that has what is required, and whose known members pass."""

    def check(value: Any, where: str, root: Json) -> None:
        if not isinstance(value, dict):
            raise _refuse(value, where, "an object")
        missing = [key for key in required if key not in value]
        if missing:
            raise MeshError(f"{where}: {missing[0]!r} is missing")
        for key, inner in checks.items():
            if key in value:
                inner(value[key], f"{where}.{key}", root)

    return check


_anything = _object()
_attributes = _values(_number_of("accessors"))
_sparse = _object(
    ("count", "indices", "values"),
    count=_count,
    indices=_object(
        ("bufferView", "componentType"),
        bufferView=_number_of("bufferViews"),
        byteOffset=_count,
        componentType=_count,
    ),
    values=_object(("bufferView",), bufferView=_number_of("bufferViews"), byteOffset=_count),
)
_accessor = _object(
    ("componentType", "count", "type"),
    bufferView=_number_of("bufferViews"),
    byteOffset=_count,
    componentType=_count,
    count=_count,
    type=_text,
    normalized=_flag,
    sparse=_sparse,
)
_buffer_view = _object(
    ("buffer", "byteLength"),
    buffer=_number_of("buffers"),
    byteOffset=_count,
    byteLength=_count,
    byteStride=_count,
    extensions=_anything,
)
_primitive = _object(
    ("attributes",),
    attributes=_attributes,
    indices=_number_of("accessors"),
    mode=_count,
    targets=_each(_attributes),
    extensions=_anything,
)
_node = _object(
    name=_text,
    mesh=_number_of("meshes"),
    skin=_number_of("skins"),
    children=_each(_number_of("nodes")),
    matrix=_numbers(16),
    translation=_numbers(3),
    rotation=_numbers(4),
    scale=_numbers(3),
    weights=_numbers(),
)
_channel = _object(
    ("sampler", "target"),
    sampler=_count,
    target=_object(node=_number_of("nodes"), path=_text),
)
_sampler = _object(
    ("input", "output"),
    input=_number_of("accessors"),
    output=_number_of("accessors"),
    interpolation=_text,
)
_FILE = _object(
    ("asset",),
    asset=_object(("version",), version=_text),
    accessors=_each(_accessor),
    animations=_each(
        _object(("channels", "samplers"), channels=_each(_channel), samplers=_each(_sampler))
    ),
    bufferViews=_each(_buffer_view),
    buffers=_each(_object(("byteLength",), byteLength=_count, uri=_text)),
    extensionsRequired=_each(_text),
    images=_each(_object(uri=_text, bufferView=_number_of("bufferViews"))),
    materials=_each(_anything),
    meshes=_each(
        _object(("primitives",), name=_text, primitives=_each(_primitive), weights=_numbers())
    ),
    nodes=_each(_node),
    scene=_number_of("scenes"),
    scenes=_each(_object(nodes=_each(_number_of("nodes")))),
    skins=_each(
        _object(
            ("joints",),
            joints=_each(_number_of("nodes")),
            inverseBindMatrices=_number_of("accessors"),
        )
    ),
)
