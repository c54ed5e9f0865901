"""The Deformer: factor once, then drag without solving."""

from __future__ import annotations

from collections.abc import Sequence
from copy import deepcopy
from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from solver.arrays import as_floats
from solver.errors import ConstraintError
from solver.geometry.procrustes import rigid_motion
from solver.linear.binding import Binding, Options, bind
from solver.linear.constraints import FIXED
from solver.linear.drag_model import DragModel, Transforms
from solver.linear.grab import Grab, Moments, make_grab
from solver.linear.response import soften
from solver.linear.rest_surface import RestSurface
from solver.rigid.half_way import half_way, squared
from solver.rigid.levels import Rigidity
from solver.softness.material import EdgeGains, Material
from solver.types import FloatArray


class Deformer:
    """The surface that minimises E = l^2 E_f + E_x while handles move.

        E_f = 1/2 sum w_e^-1  beta_e  ||G_j - G_i||^2                      (bending)
        E_x = 1/2 sum w_eT    sigma_e ||x_b - x_a - G_T (p_b - p_a)||^2    (stretching)

    over positions x and one 3x3 frame G for each triangle. A Deformer is factorised when it is
    built and never changes afterwards; `rebind` and `grab` return new ones that share what
    they can.

    V: (n, 3) rest positions.  F: (m, 3) triangles.
    fixed: vertices that stay.  handles: a list of vertex lists, each moved by its transform.
    softness: (n,) in [0, 1], None for rigid everywhere.  material: a preset's name or a Material.
    bending_length: l in bounding-box diagonals; at least the length of a typical edge is taken.
    orientation: whether handles hold the frames of their triangles too, not positions alone.
        Without it, frames are still held where positions leave them open (a planar handle).
    edge_gains: (edges (k, 2), bending (k,), stretching (k,)) in place of softness and material.

    A connected component without any constraint stays at rest.
    Raises MeshError, ConstraintError or MaterialError. [Wang, Liu & Tong 2012; docs/math.md]
    """

    def __init__(
        self,
        V: ArrayLike,
        F: ArrayLike,
        fixed: ArrayLike = (),
        handles: Sequence[ArrayLike] = (),
        softness: ArrayLike | None = None,
        material: str | Material = "hinge",
        bending_length: float = 0.01,
        orientation: bool = True,
        edge_gains: EdgeGains | None = None,
    ) -> None:
        options = Options(
            fixed, handles, softness, material, bending_length, orientation, edge_gains
        )
        # A copy: what the caller does to its arrays later must not reach a later rebind.
        self._attach(bind(RestSurface(V, F), deepcopy(options)), ())

    def _attach(self, binding: Binding, grabs: tuple[Grab, ...]) -> None:
        self._binding = binding
        self._shape = binding.shape
        self._system = binding.system
        self._handles = binding.constraints.handles
        self._grabs = grabs
        self._moments = _stack(grabs, len(self._system.free))
        self._response = soften(
            binding.hard, grabs, self._moments, binding.shape, self._system.free
        )

    @classmethod
    def _of(cls, binding: Binding, grabs: tuple[Grab, ...]) -> Deformer:
        deformer = object.__new__(cls)
        deformer._attach(binding, grabs)
        return deformer

    @property
    def handle_count(self) -> int:
        """Hard handles plus grabs: the number of transforms that `pose` expects."""
        return len(self._handles) + len(self._grabs)

    def pose(self, transforms: Sequence[ArrayLike], rigid: int = 0) -> FloatArray:
        """X, (n, 3), for one transform (4, 4) a handle (rest to target, world coordinates).

        rigid 0: the linear minimiser, one small dense product and no solve. rigid 1: the nearest
        rotation of every frame, then one Poisson solve. rigid k: k - 1 further rounds, each of
        lower energy; 4 is all but settled. docs/quality.md has what they are worth. Where a
        handle turns far they have other starts too, and the lowest end counts (see half_way).
        Raises ConstraintError.
        """
        if _as_level(rigid) == 0:
            return self.drag_model.pose(transforms)
        displacement = self._response.basis @ self.drag_model.steps(transforms)
        return self._refine(displacement, rigid, self._others(transforms) if rigid > 1 else ())

    def solve(self, targets: ArrayLike, rigid: int = 0) -> FloatArray:
        """X, (n, 3), for any target positions (k, 3) of np.concatenate(handles).

        One back-substitution. Each handle's frames take the rotation that best fits its targets;
        grabs are held at rest. Raises ConstraintError.
        """
        rigid = _as_level(rigid)
        shape = self._shape
        X = as_floats(targets, "targets", ConstraintError)
        count = sum(map(len, self._handles))
        if X.shape != (count, 3):
            raise ConstraintError(f"targets must be ({count}, 3), got {X.shape}")
        U = np.zeros((shape.row_count, 3))
        splits = np.cumsum([len(h) for h in self._handles])[:-1]
        parts = zip(self._handles, np.split(X, splits), strict=False)  # no handles: one empty part
        motions = [np.eye(4)] * self.handle_count
        for number, (vertices, goal) in enumerate(parts):
            rest = shape.vertices[vertices]
            motions[number] = rigid_motion(rest, goal)
            held = self._binding.constraints.row_group == 1 + number
            U[held] = shape.affine_rows[held, :3] @ (motions[number][:3, :3].T - np.eye(3))
            U[vertices] = (goal - rest) / shape.scale
        U = self._system.respond(U)
        free = self._system.free
        U[free] = self._moments.meet(U[free], np.zeros((4 * len(self._grabs), 3)))
        if rigid == 0:
            return shape.displace(U[: len(shape.points)])
        return self._refine(U, rigid, self._others(motions) if rigid > 1 else ())

    def frames(self, transforms: Transforms) -> FloatArray:
        """G, (m, 3, 3): the linear frames, rest to deformed; the identity at rest."""
        n = len(self._shape.points)
        rows = self._shape.affine_rows[n:, :3] + (
            self._response.basis[n:] @ self.drag_model.steps(transforms)
        )
        return rows.reshape(-1, 3, 3).transpose(0, 2, 1)

    def orient(
        self,
        handle: int,
        grabbed: ArrayLike,
        target: ArrayLike,
        transforms: Sequence[ArrayLike],
    ) -> FloatArray:
        """T, (4, 4), for handle number `handle` so that rest point `grabbed` reaches `target`.

        Among all such rigid motions, the one of least energy while the other handles stay where
        `transforms` puts them: closed form, independent of the size of the mesh. Where nothing
        resists a turn the handle keeps the rotation it has. Raises ConstraintError.
        """
        return self.drag_model.orient(handle, grabbed, target, transforms)

    def rebind(self, **changes: Any) -> Deformer:
        """A new Deformer with some of the constructor's options changed.

        Shares the mesh's connectivity, and the symbolic analysis where the same vertices are
        free. Giving softness or a material drops edge_gains, and the other way round; grabs are
        taken over with their weights. Raises what the constructor raises.
        """
        if "edge_gains" in changes:
            changes = {"softness": None, **changes}
        elif "softness" in changes or "material" in changes:
            changes = {"edge_gains": None, **changes}
        options = replace(self._binding.options, **deepcopy(changes))
        deformer = Deformer._of(bind(self._shape, options, self._binding), ())
        for grab in self._grabs:
            deformer = deformer.grab(grab.weights)
        return deformer

    def grab(self, weights: ArrayLike) -> Deformer:
        """A new Deformer with one more, soft, handle: the region where `weights` (n,) > 0.

        The weighted best affine fit of the region equals the handle's transform; the region
        itself stays elastic. Costs four back-substitutions on the shared factorisation. Its
        transform comes last in `pose`. Raises ConstraintError.
        """
        binding = self._binding
        grab = make_grab(
            binding.shape,
            binding.constraints,
            binding.system,
            weights,
            binding.options.bending_length,
        )
        if any(np.intersect1d(grab.carried, other.carried).size for other in self._grabs):
            raise ConstraintError("a component that nothing else holds takes one grab, got two")
        return Deformer._of(binding, (*self._grabs, grab))

    @cached_property
    def drag_model(self) -> DragModel:
        """What `pose` at rigid 0 and `orient` need, alone: for a process that only draws."""
        shape = self._shape
        return DragModel.of(
            shape.vertices,
            shape.centre,
            shape.scale,
            self._response.basis[: len(shape.points)],
            self._response.form,
            self._system.stiffness,
        )

    @cached_property
    def _rigidity(self) -> Rigidity:
        binding = self._binding
        return Rigidity(
            binding.shape,
            binding.constraints,
            binding.system,
            self._grabs,
            binding.options.bending_length,
        )

    def _others(self, transforms: Sequence[ArrayLike]) -> list[FloatArray]:
        """Rows of R', R the squared rotations of active triangles in each half-way pose."""
        anchored = bool((self._binding.constraints.row_group == FIXED).any())
        halves, M = half_way(transforms, anchored)
        return [squared(self.frames(H)[self._system.active], M) for H in halves]

    def _refine(
        self, displacement: FloatArray, rounds: int, others: Sequence[FloatArray] = ()
    ) -> FloatArray:
        shape = self._shape
        U = shape.affine_rows[:, :3] + displacement
        X = self._rigidity.refine(U, rounds, others)
        return shape.displace(X - shape.points)


def _stack(grabs: Sequence[Grab], unknowns: int) -> Moments:
    none = np.empty((unknowns, 0))
    return Moments(
        np.hstack([none, *(grab.moments for grab in grabs)]),
        np.hstack([none, *(grab.influence for grab in grabs)]),
    )


def _as_level(rigid: int) -> int:
    if isinstance(rigid, bool) or not isinstance(rigid, int | np.integer) or rigid < 0:
        raise ConstraintError(f"rigid must be an integer of 0 or more, got {rigid!r}")
    return int(rigid)
