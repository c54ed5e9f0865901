"""What a surface is bound to: its handles, its softness and how it bends, as one record."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from solver.arrays import as_floats, as_indices, as_integers, locked
from solver.errors import ConstraintError, MaterialError, MeshError
from solver.limits import LONGEST_BEND, SHORTEST_BEND, within
from solver.softness.material import EdgeGains, Material, as_edge_gains, resolve_material
from solver.types import BoolArray, FloatArray, IntArray

FREE = -1
FIXED = 0  # handle number h is group 1 + h


@dataclass(frozen=True, eq=False, init=False)
class Setup:
    """What a Deformer is built from besides the mesh, compared by content; see there.

    Holds read-only copies: what the caller does to its arrays later does not reach it. Whether
    it fits a mesh is found out when it is bound.

    fixed: (k,).  handles: one (k,) array each.  softness: (n,) or None.  attach: True, False, or
    the numbers of the pieces that follow.  coarse: None, or how many vertices frames are for.
    Raises ConstraintError (fixed, handles), MeshError (coarse) or MaterialError (the rest).

    >>> import solver
    >>> setup = solver.Setup(fixed=[0], handles=[[1, 2]])
    >>> setup == solver.Setup(fixed=np.array([0]), handles=[np.array([1, 2])])
    True
    >>> setup.changed(material="clay").material
    Material(bending=0.1, stretching=0.1)
    """

    fixed: IntArray
    handles: tuple[IntArray, ...]
    softness: FloatArray | None
    material: Material
    bending_length: float
    orientation: bool
    edge_gains: EdgeGains | None
    attach: bool | tuple[int, ...]
    coarse: int | None

    def __init__(
        self,
        fixed: ArrayLike = (),
        handles: Sequence[ArrayLike] = (),
        softness: ArrayLike | None = None,
        material: str | Material = "hinge",
        bending_length: float = 0.01,
        orientation: bool = True,
        edge_gains: tuple[ArrayLike, ArrayLike, ArrayLike] | None = None,
        attach: bool | ArrayLike = True,
        coarse: int | None = None,
    ) -> None:
        if softness is not None and edge_gains is not None:
            raise MaterialError("give softness or edge_gains, got both")
        if softness is not None:
            softness = locked(as_floats(softness, "softness", MaterialError))
        named = [as_integers(h, f"handle {number}") for number, h in enumerate(handles)]
        values = {
            "fixed": locked(as_integers(fixed, "fixed")),
            "handles": tuple(map(locked, named)),
            "softness": softness,
            "material": resolve_material(material),
            "bending_length": _as_length(bending_length),
            "orientation": bool(orientation),
            "edge_gains": None if edge_gains is None else as_edge_gains(edge_gains),
            "attach": attach if isinstance(attach, bool) else _as_pieces(attach),
            "coarse": None if coarse is None else _as_count(coarse),
        }
        for name, value in values.items():
            object.__setattr__(self, name, value)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Setup):
            return NotImplemented
        return all(_same(getattr(self, f.name), getattr(other, f.name)) for f in fields(self))

    def holds_as(self, other: Setup) -> bool:
        """Whether both hold the same vertices in the same way, whatever their material."""
        names = ("fixed", "handles", "orientation", "attach")
        return all(_same(getattr(self, name), getattr(other, name)) for name in names)

    def groups(self, vertex_count: int) -> IntArray:
        """(n,) FREE, FIXED or 1 + h for each vertex of a mesh.

        Raises ConstraintError for an index out of range, an empty handle, or a vertex with two
        roles.
        """
        n = vertex_count
        handles = [as_indices(h, n, f"handle {number}") for number, h in enumerate(self.handles)]
        group = np.full(n, FREE, dtype=np.int64)
        group[as_indices(self.fixed, n, "fixed")] = FIXED
        for number, vertices in enumerate(handles):
            _claim(group, vertices, number)
        return group

    def follows(self, piece: IntArray, count: int) -> BoolArray:
        """Which of some pieces (k,) follow the larger ones that they are near.

        count: of all pieces. Raises ConstraintError where `attach` names another one.
        """
        if isinstance(self.attach, bool):
            return np.full(len(piece), self.attach)
        wrong = [number for number in self.attach if not 0 <= number < count]
        if wrong:
            raise ConstraintError(f"attach names piece {wrong[0]}, expected 0 to {count - 1}")
        return np.isin(piece, self.attach)

    def changed(self, **changes: Any) -> Setup:
        """Another one with some values replaced.

        Giving softness or a material drops edge_gains, and the other way round.
        """
        if "edge_gains" in changes:
            changes = {"softness": None, **changes}
        elif "softness" in changes or "material" in changes:
            changes = {"edge_gains": None, **changes}
        return Setup(**{f.name: getattr(self, f.name) for f in fields(self)} | changes)


def _claim(group: IntArray, vertices: IntArray, number: int) -> None:
    if len(vertices) == 0:
        raise ConstraintError(f"handle {number} has no vertices")
    if len(np.unique(vertices)) != len(vertices):
        raise ConstraintError(f"handle {number} names a vertex twice")
    taken = vertices[group[vertices] != FREE]
    if len(taken):
        other = group[taken[0]]
        name = "fixed" if other == FIXED else f"in handle {other - 1}"
        raise ConstraintError(f"vertex {taken[0]} is both {name} and in handle {number}")
    group[vertices] = 1 + number


def _as_length(length: float) -> float:
    numeric = isinstance(length, int | float | np.number) and not isinstance(length, bool)
    if not (numeric and within(length, SHORTEST_BEND, LONGEST_BEND)):
        bounds = f"{SHORTEST_BEND:g} to {LONGEST_BEND:g}"
        raise MaterialError(f"bending_length must be a number from {bounds}, got {length!r}")
    return float(length)


def _as_pieces(attach: ArrayLike) -> tuple[int, ...]:
    return tuple(np.unique(as_integers(attach, "attach")).tolist())


def _as_count(coarse: int) -> int:
    whole = isinstance(coarse, int | np.integer) and not isinstance(coarse, bool)
    if not (whole and coarse > 0):
        raise MeshError(f"coarse must be None or a positive integer, got {coarse!r}")
    return int(coarse)


def _same(one: Any, two: Any) -> bool:
    if isinstance(one, tuple) and isinstance(two, tuple):
        return len(one) == len(two) and all(map(np.array_equal, one, two))
    if isinstance(one, np.ndarray) and isinstance(two, np.ndarray):
        return bool(np.array_equal(one, two))
    return type(one) is type(two) and bool(one == two)
