"""The Deformer: factor once, then drag without solving."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from numpy.typing import ArrayLike

from solver.bound_surface import BoundSurface
from solver.coarse_surface import CoarseSurface, bind_surface, rebind_surface
from solver.drag import Drag, as_level
from solver.linear.drag_model import DragModel, Transforms
from solver.linear.system import System
from solver.setup import Setup
from solver.softness.material import Material
from solver.surface.embedding import embed
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
    attach: which pieces follow the larger ones that they touch or are near: True for all, False
        for none, or their numbers (see Mesh.pieces).
    coarse: None for the exact solution, or a number: frames are solved on a simplified surface of
        at most so many vertices, positions on the mesh itself. For meshes of more than 20000.

    Seams are welded for the solve. What nothing holds, by itself or through what it is attached
    to, stays at rest.
    Raises MeshError, ConstraintError, MaterialError, or FactorizationError where rounding would
    spoil the result. [Wang, Liu & Tong 2012; docs/math.md]

    >>> import solver
    >>> V = [[0, 0, 0], [1, 0, 0], [2, 0, 0], [0, 1, 0], [1, 1, 0], [2, 1, 0]]  # two squares
    >>> F = [[0, 1, 4], [0, 4, 3], [1, 2, 5], [1, 5, 4]]
    >>> deformer = solver.Deformer(V, F, fixed=[0, 3], handles=[[2, 5]])
    >>> T = np.eye(4)
    >>> T[:3, 3] = [1, 0, 0]
    >>> X = deformer.pose([T])
    >>> X[[0, 1, 2]].round(2)  # the middle follows half-way
    array([[0. , 0. , 0. ],
           [1.5, 0. , 0. ],
           [3. , 0. , 0. ]])
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
        edge_gains: tuple[ArrayLike, ArrayLike, ArrayLike] | None = None,
        attach: bool | ArrayLike = True,
        coarse: int | None = None,
    ) -> None:
        how = softness, material, bending_length, orientation, edge_gains, attach, coarse
        self._bound: BoundSurface | CoarseSurface = bind_surface(
            embed(V, F), Setup(fixed, handles, *how)
        )

    @classmethod
    def of(cls, V: ArrayLike, F: ArrayLike, setup: Setup) -> Deformer:
        """As the constructor, from a record of everything besides the mesh.

        >>> setup = solver.Setup(fixed=[0, 3], handles=[[2, 5]])
        >>> np.array_equal(solver.Deformer.of(V, F, setup).pose([T]), X)
        True
        """
        return _deformer(bind_surface(embed(V, F), setup))

    @property
    def setup(self) -> Setup:
        """What it is bound to."""
        return self._bound.setup

    @property
    def handle_count(self) -> int:
        """Hard handles plus grabs: the number of transforms that `pose` expects."""
        return self._bound.handle_count

    def pose(self, transforms: Sequence[ArrayLike], rigid: int = 0) -> FloatArray:
        """X, (n, 3), for one transform (4, 4) a handle (rest to target, world coordinates).

        rigid 0: the linear minimiser, one small dense product and no solve. rigid 1: the nearest
        rotation of every frame, then one Poisson solve. rigid k: k - 1 further rounds, each of
        lower energy; 4 is all but settled. docs/quality.md has what they are worth. Where a
        handle turns far they have other starts too, and the lowest end counts (see half_way).
        Raises ConstraintError.

        >>> over = [[-1, 0, 0, 2], [0, 1, 0, 0], [0, 0, -1, 0], [0, 0, 0, 1]]  # half a turn about y
        >>> deformer.pose([over], rigid=4)[[2, 5]].round(9) + 0.0
        array([[0., 0., 0.],
               [0., 1., 0.]])
        """
        return self._bound.posed(transforms, as_level(rigid))

    def solve(self, targets: ArrayLike, rigid: int = 0) -> FloatArray:
        """X, (n, 3), for any target positions (k, 3) of np.concatenate(handles).

        One back-substitution. Each handle's frames take the rotation that best fits its targets;
        grabs are held at rest. Raises ConstraintError.

        >>> deformer.solve([[2, 0, 1], [2, 1, 1]])[1].round(2)
        array([1. , 0. , 0.5])
        """
        return self._bound.solved(targets, as_level(rigid))

    def frames(self, transforms: Transforms) -> FloatArray:
        """G, (m, 3, 3): the linear frames, rest to deformed; the identity at rest.

        >>> np.allclose(deformer.frames([np.eye(4)]), np.eye(3))
        True
        """
        return self._bound.frames(transforms)

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

        >>> lifted = deformer.orient(0, [2, 0.5, 0], [1.5, 0.5, 1], [np.eye(4)])
        >>> (lifted @ [2, 0.5, 0, 1]).round(9)
        array([1.5, 0.5, 1. , 1. ])
        >>> np.degrees(np.arcsin(lifted[2, 0])).round(1)  # the end turns up
        np.float64(17.5)
        """
        return self.drag_model.orient(handle, grabbed, target, transforms)

    def drag(self) -> Drag:
        """A new drag: `move` and `orient` as `pose` and `orient`, each on from the last.

        >>> drag = deformer.drag()
        >>> for degrees in range(0, 361, 15):  # once about the x axis
        ...     c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
        ...     turn = [[1, 0, 0, 0], [0, c, -s, 0], [0, s, c, 0], [0, 0, 0, 1]]
        ...     X = drag.move([turn], rigid=4)
        >>> X[[2, 5]].round(9) + 0.0  # back where it was
        array([[2., 0., 0.],
               [2., 1., 0.]])
        """
        return Drag(self._bound)

    def rebind(self, **changes: Any) -> Deformer:
        """A Deformer with some of the constructor's options changed.

        Shares the mesh's connectivity, and the symbolic analysis where the same vertices are
        free. Giving softness or a material drops edge_gains, and the other way round; grabs are
        taken over with their weights. Raises what the constructor raises.

        >>> soft = deformer.rebind(softness=[0, 1, 0, 0, 1, 0], material="clay")
        >>> soft.setup.material
        Material(bending=0.1, stretching=0.1)
        """
        return self.rebound(self.setup.changed(**changes))

    def rebound(self, setup: Setup) -> Deformer:
        """A Deformer bound to `setup`, as `rebind`: this one where nothing differs by content.

        >>> np.array_equal(deformer.rebound(deformer.setup).pose([T]), X)
        True
        """
        return self if setup == self.setup else _deformer(rebind_surface(self._bound, setup))

    def prepare(self) -> None:
        """Find now what belongs to the mesh alone and is otherwise found when it is first needed.

        It serves all Deformers that are rebound from this one: for a mesh that was just opened.

        >>> deformer.prepare()
        """
        self._bound.prepare()

    def grab(self, weights: ArrayLike) -> Deformer:
        """A new Deformer with one more, soft, handle: the region where `weights` (n,) > 0.

        The weighted best affine fit of the region equals the handle's transform; the region
        itself stays elastic. Costs four back-substitutions on the shared factorisation. Its
        transform comes last in `pose`. Raises ConstraintError.

        >>> middle = deformer.grab([0, 1, 0, 0, 1, 0])
        >>> middle.pose([np.eye(4), T])[[1, 2]].round(9)
        array([[2., 0., 0.],
               [2., 0., 0.]])
        """
        return _deformer(self._bound.grabbed(weights))

    @property
    def drag_model(self) -> DragModel:
        """What `pose` at rigid 0 and `orient` need, alone: for a process that only draws."""
        return self._bound.drag_model

    @property
    def system(self) -> System:
        """The factorised system: to be read by studies and benchmarks."""
        return self._bound.binding.system


def _deformer(bound: BoundSurface | CoarseSurface) -> Deformer:
    """A Deformer of what is bound already."""
    deformer = object.__new__(Deformer)
    deformer._bound = bound
    return deformer
