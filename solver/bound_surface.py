"""A surface bound to its handles: what moves it, linearly and with rotations."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from solver.arrays import as_floats
from solver.errors import ConstraintError
from solver.geometry.procrustes import rigid_motion
from solver.linear.binding import Binding, bind
from solver.linear.drag_model import DragModel, Transforms
from solver.linear.grab import Grab, Moments, make_grab
from solver.linear.reach import check_points
from solver.linear.response import Response, with_grabs
from solver.linear.rest_surface import RestSurface
from solver.rigid.half_way import half_way, squared
from solver.rigid.levels import RigidLevels, RigidPose
from solver.setup import FIXED, Setup
from solver.surface.embedding import Embedding
from solver.types import FloatArray


@dataclass(frozen=True, eq=False)
class BoundSurface:
    """A solved surface with its factorisation, its soft handles, and the mesh that hangs on it.

    setup: of the shown mesh.  grabs: soft handles, whose transforms come after those of handles.
    Displacements are changes of the rows of U, in normalised units.
    """

    embedding: Embedding
    setup: Setup
    binding: Binding
    grabs: tuple[Grab, ...] = ()

    @staticmethod
    def of(embedding: Embedding, setup: Setup) -> BoundSurface:
        """Bound for the first time. Raises ConstraintError or MaterialError."""
        rest = RestSurface(embedding.vertices, embedding.topology)
        return BoundSurface(embedding, setup, bind(rest, embedding.setup(setup)))

    def prepare(self) -> None:
        """See Deformer.prepare: the bind has found all there is."""

    def rebound(self, setup: Setup) -> BoundSurface:
        """Bound to another setup, sharing what is the same; grabs keep their weights."""
        binding = bind(self.rest, self.embedding.setup(setup), self.binding)
        bound = BoundSurface(self.embedding, setup, binding)
        for weights in self.grab_weights:
            bound = bound.with_grab(weights)
        return bound

    def grabbed(self, weights: ArrayLike) -> BoundSurface:
        """With one more soft handle, from weights (n',) on the shown mesh."""
        return self.with_grab(self.embedding.weights(weights))

    def with_grab(self, weights: ArrayLike, hanging: FloatArray | None = None) -> BoundSurface:
        """With one more soft handle, from weights (n,) on the solved surface.

        hanging: see `make_grab`.
        """
        binding = self.binding
        parts = binding.rest, binding.constraints, binding.system
        grab = make_grab(*parts, weights, binding.bending_length, hanging)
        if any(np.intersect1d(grab.carried, other.carried).size for other in self.grabs):
            raise ConstraintError("a component that nothing else holds takes one grab, got two")
        return replace(self, grabs=(*self.grabs, grab))

    @property
    def grab_weights(self) -> tuple[FloatArray, ...]:
        """(n,) of each soft handle on the solved surface."""
        return tuple(grab.weights for grab in self.grabs)

    @property
    def rest(self) -> RestSurface:
        """The solved surface at rest."""
        return self.binding.rest

    @property
    def handle_count(self) -> int:
        """Hard handles plus grabs."""
        return len(self.binding.constraints.handles) + len(self.grabs)

    @cached_property
    def moments(self) -> Moments:
        """The conditions of all grabs together, on the free rows."""
        none = np.empty((len(self.binding.system.free), 0))
        return Moments(
            np.hstack([none, *(grab.moments for grab in self.grabs)]),
            np.hstack([none, *(grab.influence for grab in self.grabs)]),
        )

    @cached_property
    def response(self) -> Response:
        """Basis and form of all handles."""
        binding = self.binding
        if not self.grabs:
            return binding.hard
        return with_grabs(binding.hard, self.grabs, self.moments, binding.rest, binding.system.free)

    @cached_property
    def drag_model(self) -> DragModel:
        """A drag at the linear level, alone."""
        rest = self.rest
        return DragModel.of(
            self.embedding.shown,
            rest.centre,
            rest.scale,
            self.embedding.apply(self.response.basis),
            self.response.form,
            self.binding.system.stiffness,
        )

    @cached_property
    def _levels(self) -> RigidLevels:
        binding = self.binding
        return RigidLevels(
            binding.rest, binding.constraints, binding.system, self.grabs, binding.bending_length
        )

    def posed(self, transforms: Sequence[ArrayLike], level: int) -> FloatArray:
        """The shown mesh (n', 3) for one transform (4, 4) a handle. Raises ConstraintError."""
        if level == 0:
            return self.drag_model.pose(transforms)
        return self.continued(transforms, level)[0]

    def continued(
        self, transforms: Sequence[ArrayLike], level: int, before: FloatArray | None = None
    ) -> tuple[FloatArray, FloatArray]:
        """The shown mesh (n', 3) at a level of 1 or more, and the rotations that it has.

        Rows (a, 3, 3) of R' of active triangles, as `before`, from which rounds start if given.
        Raises ConstraintError.
        """
        pose = self.refined(self.displacement(transforms), transforms, level, before)
        return self._rigid(pose), pose.rotations

    def solved(self, targets: ArrayLike, level: int) -> FloatArray:
        """The shown mesh (n', 3) for targets of the handles' vertices. Raises ConstraintError."""
        displacement, motions = self.respond(targets)
        if level == 0:
            return self._shown(self.embedding.apply(displacement))
        return self._rigid(self.refined(displacement, motions, level))

    def displacement(self, transforms: Transforms) -> FloatArray:
        """(n + 3m, 3) the linear change of U. Raises ConstraintError."""
        return self.response.basis @ self.drag_model.steps(transforms)

    def frames(self, transforms: Transforms) -> FloatArray:
        """G, (m, 3, 3): the linear frames of the solved surface's triangles."""
        n = len(self.rest.points)
        steps = self.drag_model.steps(transforms)
        rows = self.rest.affine_rows[n:, :3] + self.response.basis[n:] @ steps
        return rows.reshape(-1, 3, 3).transpose(0, 2, 1)

    def respond(self, targets: ArrayLike) -> tuple[FloatArray, list[FloatArray]]:
        """Displacement for any targets, and the rigid motion that best fits each handle's."""
        rest, constraints, system = self.rest, self.binding.constraints, self.binding.system
        shown = self.setup.handles
        X = as_floats(targets, "targets", ConstraintError)
        count = sum(map(len, shown))
        if X.shape != (count, 3):
            raise ConstraintError(f"targets must be ({count}, 3), got {X.shape}")
        check_points(X, rest.centre, rest.scale, "targets")
        U = np.zeros((rest.row_count, 3))
        splits = np.cumsum([len(h) for h in shown])[:-1]
        motions = [np.eye(4)] * self.handle_count
        parts = zip(shown, np.split(X, splits), strict=False)  # no handles: one empty part
        for number, (named, goals) in enumerate(parts):
            vertices = constraints.handles[number]
            start = rest.vertices[vertices]
            goal = self.embedding.targets(named, goals, vertices)
            motions[number] = rigid_motion(start, goal)
            held = constraints.row_group == 1 + number
            U[held] = rest.affine_rows[held, :3] @ (motions[number][:3, :3].T - np.eye(3))
            U[vertices] = (goal - start) / rest.scale
        U = system.respond(U)
        none = np.zeros((4 * len(self.grabs), 3))
        U[system.free] = self.moments.meet(U[system.free], none)
        return U, motions

    def refined(
        self,
        displacement: FloatArray,
        transforms: Sequence[ArrayLike],
        level: int,
        before: FloatArray | None = None,
    ) -> RigidPose:
        """The solved surface at a rigid level of 1 or more, from the linear displacement.

        before: see `continued`.
        """
        U = self.rest.affine_rows[:, :3] + displacement
        ambiguous = level > 1 and before is None
        others = self._other_rotations(transforms) if ambiguous else ()
        return self._levels.refine(U, level, others, before)

    def _rigid(self, pose: RigidPose) -> FloatArray:
        moved = self.embedding.apply_rigid(pose.positions - self.rest.points, pose.rotations)
        return self._shown(moved)

    def _other_rotations(self, transforms: Sequence[ArrayLike]) -> list[FloatArray]:
        """Rows of R', R the squared rotations of active triangles in each half-way pose."""
        anchored = bool((self.binding.constraints.row_group == FIXED).any())
        halves, M = half_way(transforms, anchored)
        return [squared(self.frames(H)[self.binding.system.active], M) for H in halves]

    def _shown(self, displacement: FloatArray) -> FloatArray:
        """World positions (n', 3); a zero displacement gives rest positions to the last bit."""
        return self.embedding.shown + self.rest.scale * displacement
