"""Everything undoable about one open mesh: roles, handles, softness, material, settings.

Nothing here changes except through an Edit, which knows how to be applied and reverted. A new
undoable field is a line in FIELDS, a default, and (if the solver depends on it) one in BIND_FIELDS.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np

from solver.mesh.mesh import Mesh
from solver.softness.material import Material
from solver.types import BoolArray, FloatArray, IntArray

FREE, FIXED, FIRST_HANDLE = 0, 1, 2


@dataclass(frozen=True)
class Setting:
    """One number or switch of the solver: its default, and what values it takes."""

    default: Any
    accepts: Callable[[Any], bool]
    expected: str


def is_number(value: Any) -> bool:
    """A finite real number; a boolean is none."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        return False
    try:
        return math.isfinite(value)
    except OverflowError:  # an integer beyond every float
        return False


SETTINGS: Mapping[str, Setting] = MappingProxyType(
    {
        "bending_length": Setting(0.01, lambda v: is_number(v) and v > 0, "a positive number"),
        "orientation": Setting(True, lambda v: isinstance(v, bool), "true or false"),
        "rigid": Setting(1, lambda v: type(v) is int and v >= 0, "an integer, 0 or more"),
    }
)
FIELDS = ("role", "handles", "softness", "pinned", "material", *SETTINGS)
BIND_FIELDS = ("role", "softness", "material", "bending_length", "orientation")

# One clock for all documents: a revision never comes back, not even after opening another mesh.
clock = itertools.count(1)


@dataclass(frozen=True, eq=False)
class Handle:
    """A named region that moves rigidly. `key` is its identity for as long as the mesh is open.

    transform: (4, 4) from the rest position to where the handle is, world coordinates.
    """

    key: int
    name: str
    transform: FloatArray


@dataclass(frozen=True, eq=False)
class Edit:
    """One reversible change. index None: the whole value; else `before` and `after` are (k,)."""

    field: str
    index: IntArray | None
    before: Any
    after: Any


class Document:
    """One open mesh and what a person decided about it.

    role: (n,) 0 free, 1 fixed, 2 + h the handle number h.  handles: tuple of Handle.
    softness: (n,) in [0, 1].  pinned: (n,) whose softness a fill keeps; no session holds it.
    material: a preset's name or a Material.
    bending_length, orientation, rigid: the solver's settings (SETTINGS).
    revision: for each field a number that grows whenever the field changes.
    """

    def __init__(self, mesh: Mesh, path: Path) -> None:
        self.mesh = mesh
        self.path = path
        self.serial = next(clock)
        self.role: IntArray = np.zeros(len(mesh.vertices), dtype=np.int64)
        self.handles: tuple[Handle, ...] = ()
        self.softness: FloatArray = np.zeros(len(mesh.vertices))
        self.pinned: BoolArray = np.zeros(len(mesh.vertices), dtype=bool)
        self.material: str | Material = "hinge"
        self.bending_length: float = SETTINGS["bending_length"].default
        self.orientation: bool = SETTINGS["orientation"].default
        self.rigid: int = SETTINGS["rigid"].default
        self.revision = {name: next(clock) for name in FIELDS}

    def change(self, field: str, value: Any, index: IntArray | None = None) -> Edit:
        """Set a field, or field[index] (indices without repetition), and return what was done."""
        if index is None:
            edit = Edit(field, None, getattr(self, field), value)
        else:
            before = getattr(self, field)[index]
            after = np.broadcast_to(np.asarray(value, dtype=before.dtype), before.shape)
            differs = before != after
            edit = Edit(field, index[differs], before[differs], after[differs])
        self.apply(edit)
        return edit

    def apply(self, edit: Edit) -> None:
        """Make the change."""
        self._set(edit.field, edit.index, edit.after)

    def revert(self, edit: Edit) -> None:
        """Take the change back."""
        self._set(edit.field, edit.index, edit.before)

    def _set(self, field: str, index: IntArray | None, value: Any) -> None:
        if field not in FIELDS:
            raise KeyError(f"no undoable field {field!r}, expected one of {', '.join(FIELDS)}")
        if index is None:
            setattr(self, field, value)
        else:
            getattr(self, field)[index] = value
        if index is None or len(index):
            self.revision[field] = next(clock)

    @property
    def bind_version(self) -> int:
        """Grows whenever something changes that the solver has to be bound to."""
        return max(self.revision[name] for name in BIND_FIELDS)

    @property
    def fixed(self) -> IntArray:
        """The fixed vertices, ascending."""
        return np.flatnonzero(self.role == FIXED)

    def vertices_of(self, key: int) -> IntArray:
        """The vertices of a handle, ascending."""
        return np.flatnonzero(self.role == self.role_of(key))

    def role_of(self, key: int) -> int:
        """The role that marks the vertices of a handle. Raises KeyError if it is gone."""
        for number, handle in enumerate(self.handles):
            if handle.key == key:
                return FIRST_HANDLE + number
        raise KeyError(key)

    def handle_of_role(self, role: int) -> Handle | None:
        """The handle a role stands for, None for free and fixed."""
        return self.handles[role - FIRST_HANDLE] if role >= FIRST_HANDLE else None

    def find(self, key: int | None) -> Handle | None:
        """The handle with this key, if there is one."""
        return next((handle for handle in self.handles if handle.key == key), None)

    def new_handle(self, name: str = "") -> Handle:
        """A handle at rest, not yet part of the document; without a name it gets a free one."""
        taken = {handle.name for handle in self.handles}
        free = (f"handle {k}" for k in itertools.count(1) if f"handle {k}" not in taken)
        return Handle(next(clock), name or next(free), np.eye(4))

    def with_handle(self, key: int, **changes: Any) -> tuple[Handle, ...]:
        """The handles, with what `changes` names different in one of them."""
        return tuple(replace(h, **changes) if h.key == key else h for h in self.handles)

    @cached_property
    def diagonal(self) -> float:
        """Length of the bounding box's diagonal at rest, over the vertices that faces use."""
        used = self.mesh.vertices[np.unique(self.mesh.faces)]
        return float(np.linalg.norm(np.ptp(used, axis=0)))
