"""Strict reading of JSON: each check returns the value, or refuses it by its place in the file."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from app.model.settings import is_number
from solver.errors import SolverError
from solver.geometry.turns import MOST, WHOLE
from solver.limits import LARGEST_GAIN, LARGEST_STRETCH, SMALLEST_GAIN, within
from solver.nesting import is_deep
from solver.types import FloatArray

Check = Callable[[Any, str], Any]  # (value, where) -> value
NESTED = "expected a session, got lists nested too deeply"
QUOTED = 50  # characters of what arrived
# Of names and paths: longer than any system's paths, short enough to be shown.
LONGEST_TEXT = 4096


class SessionError(SolverError):
    """A session file cannot be used."""


def parse(data: bytes) -> Any:
    """The JSON in a file. Raises SessionError with line and column."""
    try:
        text = data.decode("utf-8-sig")
        root = json.loads(text, parse_constant=_refuse_constant, object_pairs_hook=_object)
    except UnicodeDecodeError as error:
        raise SessionError(f"expected UTF-8 text, got byte {data[error.start]:#04x}") from error
    except json.JSONDecodeError as error:
        where = f"line {error.lineno}, column {error.colno}"
        raise SessionError(f"{where}: expected JSON, got an error: {error.msg}") from error
    except RecursionError as error:
        raise SessionError(NESTED) from error
    except SessionError:
        raise
    except ValueError as error:  # an integer of thousands of digits
        raise SessionError(f"expected numbers of a usual size: {error}") from error
    if is_deep(root):
        raise SessionError(NESTED)
    return root


def _refuse_constant(name: str) -> Any:
    raise SessionError(f"expected finite numbers, got {name}")


def _object(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    found = dict(pairs)
    if len(found) < len(pairs):
        names = Counter(name for name, _ in pairs)
        twice = next(name for name, number in names.items() if number > 1)
        raise SessionError(f"{escaped(twice)}: expected once, got it twice in one object")
    return found


def escaped(name: str) -> str:
    """A key as it stands in the file: without line breaks of its own, and not too long to read."""
    text = json.dumps(name)[1:-1]
    return text if len(text) <= 2 * QUOTED else f"{text[:QUOTED]}..."


def refuse(where: str, expected: str, value: Any) -> SessionError:
    """The error for a value that is not what was expected."""
    got = json.dumps(value)
    cut = "..." * (len(got) > QUOTED)
    return SessionError(f"{where}: expected {expected}, got {got[:QUOTED]}{cut}")


def fields(checks: Mapping[str, Check], required: tuple[str, ...] = ()) -> Check:
    """An object with these keys and no others; absent keys stay absent unless required."""

    def check(value: Any, where: str) -> dict[str, Any]:
        if not isinstance(value, dict):
            raise refuse(where or "the file", "an object", value)
        prefix = f"{where}." if where else ""
        for name in value:
            if name not in checks:
                known = ", ".join(checks)
                raise SessionError(f"{prefix}{escaped(name)}: unknown key, expected one of {known}")
        for name in required:
            if name not in value:
                raise SessionError(f"{prefix}{name}: missing")
        return {name: checks[name](item, prefix + name) for name, item in value.items()}

    return check


def list_of(item: Check, most: int | None = None) -> Check:
    """A list whose items pass `item`, of at most so many."""

    def check(value: Any, where: str) -> list[Any]:
        if not isinstance(value, list):
            raise refuse(where, "a list", value)
        if most is not None and len(value) > most:
            raise SessionError(f"{where}: expected at most {most} entries, got {len(value)}")
        return [item(one, f"{where}[{i}]") for i, one in enumerate(value)]

    return check


def named(item: Check) -> Check:
    """An object with any keys, whose values pass `item`."""

    def check(value: Any, where: str) -> dict[str, Any]:
        if not isinstance(value, dict):
            raise refuse(where, "an object", value)
        return {name: item(one, f"{where}.{escaped(name)}") for name, one in value.items()}

    return check


def that(accepts: Callable[[Any], bool], expected: str) -> Check:
    """A value that `accepts` is true for."""

    def check(value: Any, where: str) -> Any:
        if not accepts(value):
            raise refuse(where, expected, value)
        return value

    return check


text = that(
    lambda v: isinstance(v, str) and 0 < len(v) <= LONGEST_TEXT,
    f"a text that is not empty, of at most {LONGEST_TEXT} characters",
)
# Whatever is counted, no computer holds so many; a longer number fills a screen when it is told.
count = that(lambda v: type(v) is int and 0 <= v < 1 << 128, "an integer, 0 or more")
gain = that(
    lambda v: is_number(v) and within(v, SMALLEST_GAIN, LARGEST_GAIN),
    f"a number from {SMALLEST_GAIN:g} to {LARGEST_GAIN:g}",
)
point = that(
    lambda v: isinstance(v, list) and len(v) == 3 and all(map(is_number, v)), "three numbers"
)
share = that(lambda v: is_number(v) and 0 <= v <= 1, "a number from 0 to 1")


def turn(value: Any, where: str) -> FloatArray:
    """(3,) radians, see solver.geometry.turns."""
    found = np.array(point(value, where), dtype=np.float64)
    if np.abs(found).max() > MOST or np.linalg.norm(found) > MOST:
        raise refuse(where, f"at most {MOST / WHOLE:.0f} whole turns", value)
    return found


def transform(value: Any, where: str) -> FloatArray:
    """(4, 4), last row 0 0 0 1: an affine map.

    What the program makes is a rotation and a translation, and a file may also stretch, shear,
    mirror or flatten, by entries up to LARGEST_STRETCH. How far it may move depends on the size of
    the mesh, see `session.to_document`.
    """
    rows = value if isinstance(value, list) else []
    numbers = [x for row in rows if isinstance(row, list) and len(row) == 4 for x in row]
    if len(rows) != 4 or len(numbers) != 16 or not all(map(is_number, numbers)):
        raise refuse(where, "4x4 numbers", value)
    if rows[3] != [0, 0, 0, 1]:
        raise refuse(f"{where}[3]", "the last row 0 0 0 1", rows[3])
    T = np.array(rows, dtype=np.float64)
    if not np.abs(T[:3, :3]).max() <= LARGEST_STRETCH:
        expected = f"a linear part of entries up to {LARGEST_STRETCH:g}"
        raise refuse(where, expected, float(np.abs(T[:3, :3]).max()))
    return T
