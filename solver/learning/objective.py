"""What a softness is judged by: how far the equilibria are from the poses.

    J(s) = mean over poses sqrt(||X(s) - X*||_W^2 + FRAMES ||R(s) - R*||_W^2 + NEAR^2)
           + SMOOTH / 2 (s' L s + SMALL ||s||_W^2)

X(s), R(s) minimise the energy of the levels (SmoothRotationEnergy) while handles are where the
pose X* has them; R* are the rotations nearest to its deformation gradients. W weights by area.
"""

from __future__ import annotations

from itertools import islice

import numpy as np

from solver.geometry.cross_products import triangle_areas, vertex_areas
from solver.geometry.frames import triangle_frames
from solver.geometry.laplacian import cotangent_laplacian
from solver.geometry.motions import moved
from solver.geometry.procrustes import rigid_motion
from solver.geometry.rotations import nearest_rotations
from solver.learning.material_slope import MaterialSlope
from solver.learning.sensitivity import Change, Sensitivity
from solver.linear.constraints import build_constraints
from solver.linear.rest_surface import RestSurface
from solver.linear.system import Structure, System
from solver.rigid.levels import RigidLevels, RigidPose
from solver.rigid.smooth_rotations import ROTATION_LENGTH
from solver.setup import FIXED, FREE, Setup
from solver.softness.material import softness_gains
from solver.types import FloatArray

# Of how far rotations are from the pose's, in radians, against positions in diagonals.
FRAMES = 2e-3
# Distances and not their squares, which would have one extreme pose decide; squares below this.
NEAR = 3e-3
# Of the prior: how smooth, and how small where examples say nothing. docs/animals.md has what
# other weights find.
SMOOTH, SMALL = 1e-5, 40.0
# Rounds until the first softness is at rest, and until the next one is, which is near it.
FIRST_ROUNDS, ROUNDS = 80, 6


class Objective:
    """J and its gradient for softness (n,) on one surface.

    poses: (n, 3) each, in the units of the surface's `points`. They come with the handles that
    `setup` names. What was found for one softness is where the next one starts from.
    Raises ConstraintError.
    """

    def __init__(self, rest: RestSurface, setup: Setup, poses: list[FloatArray]) -> None:
        self._rest, self._material = rest, setup.material
        self._constraints = build_constraints(rest, setup)
        self._structure = Structure(rest, self._constraints)
        self._length = rest.energy.resolved(setup.bending_length)
        self._ratio = (ROTATION_LENGTH / self._length) ** 2
        active = self._structure.active
        self._slope = MaterialSlope(rest, active, setup.material)
        self._laplacian = cotangent_laplacian(rest.points, rest.faces)
        area = triangle_areas(rest.points, rest.faces)
        self._mass = vertex_areas(area, rest.faces, len(rest.points)) / area.sum()
        free = self._constraints.row_group == FREE
        self._vertex_weight = self._mass * free[: len(rest.points)]
        self._frame_weight = FRAMES * (area / area.sum() * free[len(rest.points) :: 3])[active]
        self._goals = [RigidPose(X, self._rotations(X)) for X in poses]
        self._found = [self._held(goal) for goal in self._goals]
        self._rounds = FIRST_ROUNDS

    def __call__(self, softness: FloatArray) -> tuple[float, FloatArray]:
        """J, and its gradient (n,)."""
        rest = self._rest
        gains = softness_gains(rest.topology, softness, self._material)
        weights = rest.energy.weights(self._length, gains)
        system = System(rest, self._structure, weights, self._length)
        levels = RigidLevels(rest, self._constraints, system, (), self._length)
        self._found = [self._settled(levels, pose) for pose in self._found]
        self._rounds = ROUNDS
        total, slope = 0.0, np.zeros(len(softness))
        for pose, goal in zip(self._found, self._goals, strict=True):
            distance, load = self._distance(pose, goal)
            total += distance
            change = Sensitivity(levels, pose).answer(load)
            slope -= self._slope.along(pose, change, weights, self._ratio)
        smooth = self._laplacian @ softness + SMALL * self._mass * softness
        count = len(self._goals)
        return (
            total / count + 0.5 * SMOOTH * float(softness @ smooth),
            slope / count + SMOOTH * smooth,
        )

    def _distance(self, pose: RigidPose, goal: RigidPose) -> tuple[float, Change]:
        """How far a pose is from the one that it should be, and the slope of that by the pose."""
        X, R = pose.positions - goal.positions, pose.rotations - goal.rotations
        by_X, by_R = self._vertex_weight[:, None] * X, self._frame_weight[:, None, None] * R
        distance = float((by_X * X).sum() + (by_R * R).sum() + NEAR**2) ** 0.5
        return distance, Change(by_X / distance, by_R / distance)

    def _settled(self, levels: RigidLevels, start: RigidPose) -> RigidPose:
        """The equilibrium that rounds from `start` come to."""
        poisson = levels.poisson
        moments = poisson.moments(start.positions)
        X = poisson.positions(start.positions, start.rotations, moments)
        *_, last = islice(levels.descend(X, start.rotations, moments), self._rounds)
        return last

    def _rotations(self, X: FloatArray) -> FloatArray:
        """(a, 3, 3) rows of R' nearest to the deformation gradients of active triangles."""
        faces = self._rest.faces[self._structure.active]
        rest, posed = (triangle_frames(P[faces]).axes for P in (self._rest.points, X))
        edges = [P[faces[:, 1:]] - P[faces[:, :1]] for P in (self._rest.points, X)]
        own = [E @ A for E, A in zip(edges, (rest, posed), strict=True)]
        plane = np.linalg.pinv(own[0][:, :, :2]) @ own[1][:, :, :2]  # rows: G' in the two planes
        gradient = np.tile(np.eye(3), (len(faces), 1, 1))
        gradient[:, :2, :2] = plane
        return nearest_rotations(rest @ gradient @ posed.transpose(0, 2, 1))

    def _held(self, goal: RigidPose) -> RigidPose:
        """The pose with what is held where a rigid motion of each handle takes it."""
        group, points = self._constraints.row_group, self._rest.points
        count = len(points)
        of_faces = group[count::3][self._structure.active]
        X, R = goal.positions.copy(), goal.rotations.copy()
        for number in range(FIXED, 1 + len(self._constraints.handles)):
            own = group[:count] == number
            T = np.eye(4) if number == FIXED else rigid_motion(points[own], X[own])
            X[own] = moved(T, points[own])
            R[of_faces == number] = T[:3, :3].T
        return RigidPose(X, R)
