"""Everything between a mesh with its constraints and a surface that can be dragged."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from solver.errors import MaterialError
from solver.linear.constraints import Constraints, build_constraints
from solver.linear.response import Response, hard_response
from solver.linear.rest_surface import RestSurface
from solver.linear.system import Structure, System
from solver.softness.material import EdgeGains, Material, explicit_gains, softness_gains


@dataclass(frozen=True)
class Options:
    """What a Deformer is built from besides the mesh; see there."""

    fixed: ArrayLike = ()
    handles: Sequence[ArrayLike] = ()
    softness: ArrayLike | None = None
    material: str | Material = "hinge"
    bending_length: float = 0.01
    orientation: bool = True
    edge_gains: EdgeGains | None = None

    def __post_init__(self) -> None:
        if self.softness is not None and self.edge_gains is not None:
            raise MaterialError("give softness or edge_gains, got both")
        length = self.bending_length
        numeric = isinstance(length, int | float | np.number) and not isinstance(length, bool)
        if not (numeric and np.isfinite(length) and length > 0):
            raise MaterialError(f"bending_length must be a positive number, got {length!r}")


@dataclass(frozen=True)
class Binding:
    """One factorisation and what hangs on it.

    options: with the bending length that the mesh resolves, see RestEnergy.resolved.
    """

    shape: RestSurface
    options: Options
    constraints: Constraints
    structure: Structure
    system: System
    hard: Response


def bind(shape: RestSurface, options: Options, earlier: Binding | None = None) -> Binding:
    """Assemble, factorise and find the basis. Raises ConstraintError or MaterialError.

    earlier: a binding of the same shape; what has not changed since then is shared.
    """
    topology = shape.topology
    options = replace(options, bending_length=shape.energy.resolved(options.bending_length))
    if options.edge_gains is not None:
        gains = explicit_gains(topology, options.edge_gains)
    else:
        gains = softness_gains(topology, options.softness, options.material)
    if earlier is not None and _same_constraints(options, earlier.options):
        constraints, structure = earlier.constraints, earlier.structure
    else:
        constraints = build_constraints(shape, options.fixed, options.handles, options.orientation)
        structure = Structure(shape, constraints)
    weights = shape.energy.weights(options.bending_length, gains)
    system = System(shape, structure, weights)
    hard = hard_response(shape, constraints, system)
    return Binding(shape, options, constraints, structure, system, hard)


def _same_constraints(one: Options, two: Options) -> bool:
    return (
        one.fixed is two.fixed and one.handles is two.handles and one.orientation == two.orientation
    )
