"""Everything undoable about one open mesh: roles, handles, pose, softness, material, settings.

Nothing here changes except through an Edit, which knows how to be applied and reverted. A new
undoable field is a line in FIELDS, a default, and (if the solver depends on it) one in BIND_FIELDS.
"""

from __future__ import annotations

import copy
import itertools
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from app.model.handles import FIRST_HANDLE, FIXED, GRAB, Handle, Pose
from app.model.names import free_name
from app.model.poses import FIRST_POSE, KeptPose
from app.model.rest import RestShape
from app.model.settings import SETTINGS, coarse_count
from solver import Setup
from solver.geometry.bounding_box import diagonal
from solver.mesh.mesh import Mesh
from solver.softness.material import Material
from solver.types import BoolArray, FloatArray, IntArray

FIELDS = (
    *("role", "handles", "rest", "pose", "poses", "softness", "pinned", "material", "grab"),
    *SETTINGS,
)
BIND_FIELDS = (
    *("role", "rest", "softness", "material", "grab"),
    *("bending_length", "orientation", "attach", "coarse"),
)

# One clock for all documents: a revision never comes back, not even after opening another mesh.
clock = itertools.count(1)


@dataclass(frozen=True, eq=False)
class Edit:
    """One reversible change. index None: the whole value; else `before` and `after` are (k,)."""

    field: str
    index: IntArray | None
    before: Any
    after: Any


class Document:
    """One open mesh and what a person decided about it.

    role: (n,) FREE, FIXED or the key of a handle.  handles: tuple of Handle, in the order shown.
    rest: where everything is at rest, None for where the file has it.
    pose: where they are.  poses: those that are kept, in the order shown, no two of one name.
    softness: (n,) in [0, 1].  pinned: (n,) whose softness a fill keeps; no session holds it.
    material: a preset's name or a Material.
    grab: (n,) the weights of what is grabbed softly now, None for nothing; no session holds it.
    bending_length, orientation, rigid, attach, coarse: the solver's settings (SETTINGS).
    revision: for each field a number that grows whenever the field changes.
    """

    def __init__(self, mesh: Mesh, path: Path) -> None:
        self.mesh = mesh
        self.path = path
        self.serial = next(clock)
        self.role: IntArray = np.zeros(len(mesh.vertices), dtype=np.int64)
        self.handles: tuple[Handle, ...] = ()
        self.rest: RestShape | None = None
        self.pose = Pose()
        self._keys = itertools.count(FIRST_HANDLE)
        self.poses: tuple[KeptPose, ...] = ()
        self._pose_keys = itertools.count(FIRST_POSE)
        self.softness: FloatArray = np.zeros(len(mesh.vertices))
        self.pinned: BoolArray = np.zeros(len(mesh.vertices), dtype=bool)
        self.material: str | Material = "hinge"
        self.grab: FloatArray | None = None
        self.bending_length: float = SETTINGS["bending_length"].default
        self.orientation: bool = SETTINGS["orientation"].default
        self.rigid: int = SETTINGS["rigid"].default
        self.attach: bool | list[int] = SETTINGS["attach"].default
        self.coarse: bool | int = SETTINGS["coarse"].default
        self.revision = {name: next(clock) for name in FIELDS}

    def frozen(self) -> Document:
        """As it is now: another document, which what is done to this one leaves alone."""
        copied = copy.copy(self)
        for name in ("role", "softness", "pinned"):  # all else is replaced, never written to
            setattr(copied, name, getattr(self, name).copy())
        return copied

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
    def rest_positions(self) -> FloatArray:
        """(n, 3) at rest; the same array for as long as the rest shape is the same."""
        return self.mesh.vertices if self.rest is None else self.rest.positions

    @property
    def surface_number(self) -> int:
        """Names the mesh with its rest shape; another one for another."""
        return self.serial if self.rest is None else self.rest.number

    def new_rest(self, positions: FloatArray) -> RestShape:
        """A rest shape (n, 3), not yet part of the document."""
        own = np.array(positions)
        own.setflags(write=False)
        return RestShape(own, next(clock))

    @property
    def fixed(self) -> IntArray:
        """The fixed vertices, ascending."""
        return np.flatnonzero(self.role == FIXED)

    def vertices_of(self, key: int) -> IntArray:
        """The vertices of a handle, ascending."""
        return np.flatnonzero(self.role == key)

    def find(self, key: int | None) -> Handle | None:
        """The handle with this key, if there is one."""
        return next((handle for handle in self.handles if handle.key == key), None)

    def new_handle(self, name: str = "", pin: bool = False) -> Handle:
        """A handle at rest, not yet part of the document; without a name it gets a free one."""
        taken = (handle.name for handle in self.handles)
        free = free_name("pin" if pin else "handle", taken)
        return Handle(next(self._keys), name or free, pin)

    def new_pose(self, pose: Pose, name: str = "") -> KeptPose:
        """A kept pose, not yet part of the document; without a name it gets a free one."""
        free = free_name("pose", (kept.name for kept in self.poses))
        return KeptPose(next(self._pose_keys), name or free, pose)

    def setup(self) -> Setup:
        """What the solver is bound to; handles without a vertex stay out."""
        return Setup(
            fixed=self.fixed,
            handles=[self.vertices_of(key) for key in self.bound_keys if key != GRAB],
            softness=self.softness,
            material=self.material,
            bending_length=self.bending_length,
            orientation=self.orientation,
            attach=self.attach,
            coarse=self.coarse_count,
        )

    @property
    def coarse_count(self) -> int | None:
        """How many vertices frames are solved on, None for all of them."""
        return coarse_count(self.coarse, len(self.mesh.vertices))

    def follows(self, piece: int) -> bool:
        """Whether a piece of the mesh follows the larger one that it is near."""
        return self.attach if isinstance(self.attach, bool) else piece in self.attach

    @property
    def bound_keys(self) -> tuple[int, ...]:
        """The keys of what can be posed: handles with vertices, in their order, then a grab."""
        used = np.unique(self.role)
        keys = [handle.key for handle in self.handles if handle.key in used]
        return (*keys, GRAB) if self.grab is not None else tuple(keys)

    def handle_centres(self) -> dict[int, FloatArray]:
        """(3,) the middle at rest of each handle that has vertices."""
        V = self.rest_positions
        keys = (key for key in self.bound_keys if key != GRAB)
        return {key: V[self.vertices_of(key)].mean(axis=0) for key in keys}

    @cached_property
    def diagonal(self) -> float:
        """Length of the bounding box's diagonal at rest, over the vertices that faces use."""
        return diagonal(self.mesh.vertices[self.mesh.pieces >= 0])
