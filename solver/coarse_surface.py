"""A surface bound with coarse frames and fine positions. [docs/coarse.md]"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from solver.arrays import as_floats
from solver.bound_surface import BoundSurface
from solver.coarse.carrier import Carrier
from solver.coarse.fine_poisson import FinePoisson
from solver.coarse.held import Held
from solver.coarse.restriction import restrict
from solver.coarse.targets import Goal, coarse_targets
from solver.coarse.vertex_rotations import VertexRotations
from solver.errors import ConstraintError
from solver.geometry.rotations import nearest_rotations
from solver.linear.binding import Binding, bind, gains_of
from solver.linear.drag_model import DragModel, Transforms
from solver.linear.grab import as_grab_weights, relative
from solver.linear.reach import check_points
from solver.linear.rest_surface import RestSurface
from solver.setup import FREE, Setup
from solver.surface.embedding import Embedding, Identity
from solver.types import FloatArray


@dataclass(frozen=True, eq=False)
class CoarseSurface:
    """A shown mesh on a fine surface, whose frames are those of a coarse one. See BoundSurface.

    embedding: of the shown mesh on the fine surface.  carrier: of the fine on the coarse one.
    coarse: the coarse surface, bound.  rotations: from the coarse to the fine one.
    grab_weights: (n,) of each soft handle on the fine surface.
    """

    embedding: Embedding
    setup: Setup
    carrier: Carrier
    held: Held
    coarse: BoundSurface
    rotations: VertexRotations
    grab_weights: tuple[FloatArray, ...] = ()

    @staticmethod
    def of(embedding: Embedding, setup: Setup, count: int) -> CoarseSurface:
        """Bound for the first time, with at most `count` coarse vertices."""
        carrier = Carrier(RestSurface(embedding.vertices, embedding.topology), count)
        held = Held(carrier, embedding.setup(setup))
        coarse = _coarse(carrier, held)
        return CoarseSurface(embedding, setup, carrier, held, coarse, VertexRotations(carrier))

    def prepare(self) -> None:
        """See Deformer.prepare."""
        self.carrier.prepare()

    def rebound(self, setup: Setup) -> CoarseSurface:
        """Bound to another setup, sharing what is the same; grabs keep their weights."""
        fine = self.embedding.setup(setup)
        same = fine.holds_as(self.held.setup)
        held = self.held.with_material(fine) if same else Held(self.carrier, fine)
        coarse = _coarse(self.carrier, held, self.coarse)
        parts = self.carrier, held, coarse, self.rotations
        bound = CoarseSurface(self.embedding, setup, *parts)
        for weights in self.grab_weights:
            bound = bound.with_grab(weights)
        return bound

    def grabbed(self, weights: ArrayLike) -> CoarseSurface:
        """With one more soft handle, from weights (n',) on the shown mesh."""
        w = as_floats(self.embedding.weights(weights), "grab weights", ConstraintError)
        return self.with_grab(as_grab_weights(w, len(self.carrier.fine.vertices)))

    def with_grab(self, weights: FloatArray) -> CoarseSurface:
        """With one more soft handle, from weights (n,) on the fine surface."""
        hanging = self.carrier.gather(self._moment_rows(weights))
        coarse = self.coarse.with_grab(self.carrier.weights.T @ weights, hanging)
        return replace(self, coarse=coarse, grab_weights=(*self.grab_weights, weights))

    def _moment_rows(self, weights: FloatArray) -> FloatArray:
        """diag(omega) J, (n, 4), of the fine vertices that are free, in coarse units."""
        points = self.carrier.coarse.normalise(self.carrier.fine.vertices)
        omega = np.where(self.held.group == FREE, relative(weights), 0.0)
        return omega[:, None] * np.column_stack([points, np.ones(len(points))])

    @property
    def binding(self) -> Binding:
        """The coarse surface's."""
        return self.coarse.binding

    @property
    def handle_count(self) -> int:
        """Hard handles plus grabs."""
        return self.coarse.handle_count

    @cached_property
    def _basis(self) -> FloatArray:
        """(n, 4h) B of the fine vertices, in coarse units."""
        carried = self.carrier.carry(self.coarse.response.basis)
        return self.held.border.meet(carried, self.held.goals(self.handle_count))

    @cached_property
    def drag_model(self) -> DragModel:
        """A drag at the linear level, alone."""
        model = self.coarse.drag_model
        basis = self.embedding.apply(self._basis)
        parts = model.centre, model.scale, basis, model.form, model.stiffness
        return DragModel.of(self.embedding.shown, *parts)

    @cached_property
    def _poisson(self) -> FinePoisson:
        sigma = gains_of(self.carrier.fine, self.held.setup)[1]
        structure = self.held.structure
        moments = [self._moment_rows(weights)[structure.free] for weights in self.grab_weights]
        C = np.hstack([np.empty((len(structure.free), 0)), *moments])
        return FinePoisson(structure, sigma, C)

    def posed(self, transforms: Sequence[ArrayLike], level: int) -> FloatArray:
        """The shown mesh (n', 3) for one transform (4, 4) a handle. Raises ConstraintError."""
        if level == 0:
            return self.drag_model.pose(transforms)
        return self.continued(transforms, level)[0]

    def continued(
        self, transforms: Sequence[ArrayLike], level: int, before: FloatArray | None = None
    ) -> tuple[FloatArray, FloatArray]:
        """See BoundSurface.continued; the rotations are those of the coarse surface."""
        displacement = self.coarse.displacement(transforms)
        moved = self._basis @ self.drag_model.steps(transforms)
        R = self.coarse.refined(displacement, transforms, level, before).rotations
        return self._fine(displacement, moved, transforms, R), R

    def solved(self, targets: ArrayLike, level: int) -> FloatArray:
        """The shown mesh (n', 3) for targets of the handles' vertices. Raises ConstraintError."""
        goals = self._goals(targets)
        displacement, motions = self.coarse.respond(
            coarse_targets(self.carrier, goals, self.coarse.setup.handles)
        )
        held = self.held.border.held
        fine = self.carrier.fine.vertices
        wanted = np.zeros((len(held), 3))
        for vertices, goal in goals:
            wanted[np.searchsorted(held, vertices)] = (goal - fine[vertices]) / self._scale
        moved = self.held.border.meet(self.carrier.carry(displacement), wanted)
        if level == 0:
            return self._shown(moved)
        R = self.coarse.refined(displacement, motions, level).rotations
        return self._fine(displacement, moved, motions, R)

    def frames(self, transforms: Transforms) -> FloatArray:
        """G, (m, 3, 3): the linear frames of the fine surface's triangles."""
        count, fine = len(self.carrier.coarse.vertices), self.carrier.fine
        change = self.coarse.displacement(transforms)[count:]
        at_corners = self.carrier.vertex_frames(change).reshape(count, 9)
        rows = np.eye(3) + (self.carrier.interpolation @ at_corners).reshape(-1, 3, 3)
        for number, T in enumerate(self._held_frames(transforms)):
            rows[self.held.group == number] = T
        return rows[fine.faces].mean(axis=1).transpose(0, 2, 1)

    def _held_frames(self, transforms: Transforms) -> list[FloatArray]:
        """The rows of the frames that the fixed region and each handle hold, if they hold any."""
        if not self.setup.orientation:
            return []
        hard = transforms[: len(self.setup.handles)]
        return [np.eye(3), *(np.asarray(T, dtype=np.float64)[:3, :3].T for T in hard)]

    @property
    def _scale(self) -> float:
        return self.carrier.coarse.scale

    def _goals(self, targets: ArrayLike) -> list[Goal]:
        """Each handle's fine vertices and where they go."""
        handles = self.setup.handles
        X, count = as_floats(targets, "targets", ConstraintError), sum(map(len, handles))
        if X.shape != (count, 3):
            raise ConstraintError(f"targets must be ({count}, 3), got {X.shape}")
        check_points(X, self.carrier.fine.centre, self.carrier.fine.scale, "targets")
        splits = np.split(X, np.cumsum([len(handle) for handle in handles])[:-1])
        parts = zip(handles, self.held.setup.handles, splits, strict=False)  # none: one empty split
        return [(own, self.embedding.targets(named, goal, own)) for named, own, goal in parts]

    def _fine(
        self,
        displacement: FloatArray,
        moved: FloatArray,
        transforms: Sequence[ArrayLike],
        rotations: FloatArray,
    ) -> FloatArray:
        """The shown mesh at a rigid level of 1 or more.

        displacement: the linear change of the coarse U.  moved: (n, 3) of the fine vertices.
        rotations: rows (a, 3, 3) of R' of the active coarse triangles.
        """
        fine, vertices = self.carrier.fine, self.held.structure.vertices
        means = self.rotations.means(self._coarse_rotations(displacement, rotations))
        for number, T in enumerate(self._held_frames(transforms)):
            means[self.held.coarse_group == number] = T
        R = self.rotations.at(means, vertices)
        X = fine.points + moved * (self._scale / fine.scale)
        X = self._poisson.positions(X, R, self._poisson.moments(X))
        return self._shown((X - fine.points) * (fine.scale / self._scale))

    def _coarse_rotations(self, displacement: FloatArray, rotations: FloatArray) -> FloatArray:
        """Rows (k, 3, 3) of R' of every coarse triangle, from those of the active ones."""
        rest, active = self.carrier.coarse, self.binding.system.active
        count = len(rest.vertices)
        R = (rest.affine_rows[count:, :3] + displacement[count:]).reshape(-1, 3, 3)
        still = np.ones(len(R), dtype=bool)
        still[active] = False
        R[still] = nearest_rotations(R[still])
        R[active] = rotations
        return R

    def _shown(self, displacement: FloatArray) -> FloatArray:
        """World positions (n', 3); a zero displacement gives rest positions to the last bit."""
        return self.embedding.shown + self._scale * self.embedding.apply(displacement)


def _coarse(carrier: Carrier, held: Held, earlier: BoundSurface | None = None) -> BoundSurface:
    """The coarse surface bound as the fine one is held; shares with `earlier` what it can."""
    setup = restrict(carrier, held.setup, held.coarse_group)
    shown = Identity(carrier.coarse.vertices, carrier.coarse.topology)
    binding = bind(carrier.coarse, setup, earlier.binding if earlier else None)
    return BoundSurface(shown, setup, binding)


def bind_surface(embedding: Embedding, setup: Setup) -> BoundSurface | CoarseSurface:
    """Bound exactly, or with coarse frames where the setup asks for fewer vertices than there are.

    Raises ConstraintError or MaterialError.
    """
    if setup.coarse is None or setup.coarse >= len(embedding.vertices):
        return BoundSurface.of(embedding, setup)
    return CoarseSurface.of(embedding, setup, setup.coarse)


def rebind_surface(
    bound: BoundSurface | CoarseSurface, setup: Setup
) -> BoundSurface | CoarseSurface:
    """Bound to another setup, sharing what is the same; grabs keep their weights."""
    if setup.coarse == bound.setup.coarse:
        return bound.rebound(setup)
    other = bind_surface(bound.embedding, setup)
    for weights in bound.grab_weights:
        other = other.with_grab(weights)
    return other
